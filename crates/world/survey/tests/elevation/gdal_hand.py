"""Files made by hand to the text of their format, for GDAL to read: both orders of bytes, gaps, tiles, other writings."""

import struct
import zlib

import numpy as np

WIDTH, HEIGHT = 30, 20
RADIUS = 1737400
GROUND = np.add.outer(-7 * np.arange(HEIGHT), 3 * np.arange(WIDTH)).astype("f8")
POSITIVE = np.abs(GROUND) % 90 + 10
HOLES = np.arange(WIDTH * HEIGHT).reshape(HEIGHT, WIDTH) % 7 == 0

PDS3 = """PDS_VERSION_ID = PDS3
RECORD_TYPE = FIXED_LENGTH
RECORD_BYTES = 10
^IMAGE = ("{name}.img", {start} <BYTES>)
OBJECT = IMAGE
  LINES = 20
  LINE_SAMPLES = 30
  SAMPLE_TYPE = {kind}
  SAMPLE_BITS = {bits}
{more}END_OBJECT = IMAGE
OBJECT = IMAGE_MAP_PROJECTION
{map}  A_AXIS_RADIUS = 1737.4 <KM>
  B_AXIS_RADIUS = 1737.4 <KM>
  C_AXIS_RADIUS = 1737.4 <KM>
  POSITIVE_LONGITUDE_DIRECTION = "EAST"
  LINE_PROJECTION_OFFSET = {line}
  SAMPLE_PROJECTION_OFFSET = {sample}
END_OBJECT = IMAGE_MAP_PROJECTION
END
"""
FLAT = '  MAP_PROJECTION_TYPE = "EQUIRECTANGULAR"\n  MAP_SCALE = 10 <M/PIXEL>\n  CENTER_LATITUDE = 20\n  CENTER_LONGITUDE = 30\n'
POLE = '  MAP_PROJECTION_TYPE = "POLAR STEREOGRAPHIC"\n  MAP_SCALE = 10 <M/PIXEL>\n  CENTER_LATITUDE = -90\n  CENTER_LONGITUDE = 0\n'


def pds3(folder):
    # Kind, bits, type of NumPy, statements, map, offsets, bytes in front. GDAL takes integers of 32 bits as reals.
    rows = [
        ("LSB_INTEGER", 16, "<i2", "", FLAT, (500, -100), 0),
        ("MSB_INTEGER", 16, ">i2", "", FLAT, (-500, -100), 0),
        ("LSB_UNSIGNED_INTEGER", 16, "<u2", "", FLAT, (500, 100), 50),
        ("MSB_UNSIGNED_INTEGER", 8, "u1", "", FLAT, (-500, 100), 7),
        ("PC_REAL", 32, "<f4", "  MISSING_CONSTANT = -32768\n", FLAT, (500, -100), 0),
        ("IEEE_REAL", 32, ">f4", "  MISSING_CONSTANT = -32768\n", POLE, (-20, -40), 0),
        ("LSB_INTEGER", 16, "<i2", "  MISSING_CONSTANT = -32768\n", POLE, (30, 60), 0),
        ("MSB_INTEGER", 16, ">i2", "  MISSING_CONSTANT = -32768\n", FLAT, (500.5, -100.5), 0),
        ("LSB_INTEGER", 16, "<i2", "  SCALING_FACTOR = 0.5\n  OFFSET = 100\n", FLAT, (500, -100), 0),
        ("MSB_INTEGER", 16, ">i2", "  SCALING_FACTOR = 2\n", POLE, (500, -100), 11),
        ("PC_REAL", 32, "<f4", "  BANDS = 1\n  BAND_STORAGE_TYPE = BAND_SEQUENTIAL\n", FLAT, (0, 0), 0),
        ("IEEE_REAL", 64, ">f8", "", FLAT, (500, 30), 0),
    ]
    for index, (kind, bits, stored, more, place, (line, sample), front) in enumerate(rows):
        data = POSITIVE if "UNSIGNED" in kind else GROUND
        data = np.where(HOLES, -32768, data) if "MISSING" in more else data
        text = PDS3.format(name=index, start=front + 1, kind=kind, bits=bits, more=more, map=place, line=line, sample=sample)
        (folder / f"{index}.lbl").write_text(text)
        (folder / f"{index}.img").write_bytes(bytes(front) + data.astype(stored).tobytes())


PDS4 = """<?xml version="1.0" encoding="UTF-8"?>
<Product_Observational xmlns="http://pds.nasa.gov/pds4/pds/v1" xmlns:cart="http://pds.nasa.gov/pds4/cart/v1">
  <Identification_Area><title>By hand</title></Identification_Area>
  <Observation_Area><Discipline_Area><cart:Cartography>
    <Local_Internal_Reference>
      <local_identifier_reference>heights</local_identifier_reference>
      <local_reference_type>cartography_parameters_to_image_object</local_reference_type>
    </Local_Internal_Reference>
    <cart:Spatial_Reference_Information><cart:Horizontal_Coordinate_System_Definition>
      <cart:Planar>
        <cart:Map_Projection>{map}</cart:Map_Projection>
        <cart:Planar_Coordinate_Information>
          <cart:planar_coordinate_encoding_method>Coordinate Pair</cart:planar_coordinate_encoding_method>
          <cart:Coordinate_Representation>
          <cart:pixel_resolution_x unit="m/pixel">10</cart:pixel_resolution_x>
          <cart:pixel_resolution_y unit="m/pixel">10</cart:pixel_resolution_y>
        </cart:Coordinate_Representation></cart:Planar_Coordinate_Information>
        <cart:Geo_Transformation>
          <cart:upperleft_corner_x unit="m">{x}</cart:upperleft_corner_x>
          <cart:upperleft_corner_y unit="m">{y}</cart:upperleft_corner_y>
        </cart:Geo_Transformation>
      </cart:Planar>
      <cart:Geodetic_Model>
        <cart:latitude_type>Planetocentric</cart:latitude_type>
        <cart:a_axis_radius unit="km">1737.4</cart:a_axis_radius>
        <cart:b_axis_radius unit="km">1737.4</cart:b_axis_radius>
        <cart:c_axis_radius unit="km">1737.4</cart:c_axis_radius>
        <cart:longitude_direction>Positive East</cart:longitude_direction>
      </cart:Geodetic_Model>
    </cart:Horizontal_Coordinate_System_Definition></cart:Spatial_Reference_Information>
  </cart:Cartography></Discipline_Area></Observation_Area>
  <File_Area_Observational>
    <File><file_name>{name}.dat</file_name></File>
    <{array}>
      <local_identifier>heights</local_identifier>
      <offset unit="byte">{offset}</offset>
      <axes>{count}</axes>
      <axis_index_order>Last Index Fastest</axis_index_order>
      <Element_Array><data_type>{kind}</data_type>{element}</Element_Array>
      {axes}{constants}
    </{array}>
  </File_Area_Observational>
</Product_Observational>
"""


def element(name, value, unit=None):
    unit = f' unit="{unit}"' if unit else ""
    return f"<cart:{name}{unit}>{value}</cart:{name}>"


def pds4(folder):
    flat = element("map_projection_name", "Equirectangular") + "<cart:Equirectangular>"
    flat += element("standard_parallel_1", 20, "deg") + element("longitude_of_central_meridian", 30, "deg")
    flat += element("latitude_of_projection_origin", 0, "deg") + "</cart:Equirectangular>"
    pole = element("map_projection_name", "Polar Stereographic") + "<cart:Polar_Stereographic>"
    pole += element("longitude_of_central_meridian", 10, "deg") + element("latitude_of_projection_origin", 90, "deg")
    pole += element("scale_factor_at_projection_origin", 1) + "</cart:Polar_Stereographic>"
    scaled = "<scaling_factor>0.5</scaling_factor><value_offset>100</value_offset>"
    missing = "<Special_Constants><missing_constant>-32768</missing_constant></Special_Constants>"
    plain, bands = ["Line", "Sample"], ["Band", "Line", "Sample"]
    rows = [
        ("SignedMSB2", ">i2", "Array_2D_Image", plain, "", "", flat, 0),
        ("UnsignedMSB2", ">u2", "Array_2D_Image", plain, "", "", flat, 100),
        ("SignedMSB4", ">i4", "Array_2D_Image", plain, "", missing, pole, 0),
        ("UnsignedMSB4", ">u4", "Array_2D_Image", plain, "", "", flat, 3),
        ("IEEE754MSBSingle", ">f4", "Array_2D_Image", plain, "", missing, pole, 0),
        ("IEEE754MSBDouble", ">f8", "Array_2D_Image", plain, "", missing, flat, 0),
        ("SignedLSB2", "<i2", "Array_2D_Image", plain, scaled, "", flat, 0),
        ("SignedByte", "i1", "Array_2D_Image", plain, "<unit>m</unit>", "", flat, 0),
        ("UnsignedByte", "u1", "Array_2D_Image", plain, "", "", pole, 1),
        ("UnsignedLSB4", "<u4", "Array_3D_Image", bands, "", "", flat, 0),
        ("SignedMSB2", ">i2", "Array_3D_Image", ["Line", "Band", "Sample"], "", missing, flat, 0),
        ("IEEE754LSBSingle", "<f4", "Array_3D_Image", ["Line", "Sample", "Band"], scaled, missing, pole, 8),
        ("SignedMSB4", ">i4", "Array_3D_Image", bands, scaled, missing, pole, 8),
        ("IEEE754LSBDouble", "<f8", "Array_2D_Image", plain, "", "", pole, 4096),
    ]
    sizes = dict(Line=HEIGHT, Sample=WIDTH, Band=2)
    for index, (kind, stored, array, axes, more, constants, place, offset) in enumerate(rows):
        data = POSITIVE if "Unsigned" in kind or kind == "SignedByte" else GROUND
        data = np.where(HOLES, -32768, data) if constants else data
        if "Band" in axes:
            data = np.stack([data, data + 1]).transpose([["Band", "Line", "Sample"].index(axis) for axis in axes])
        each = [
            f"<Axis_Array><axis_name>{name}</axis_name><elements>{sizes[name]}</elements>"
            f"<sequence_number>{number + 1}</sequence_number></Axis_Array>"
            for number, name in enumerate(axes)
        ]
        x, y = [(1000, 5000), (-1000, 5000), (1000, -5000), (-1000, -5000)][index % 4]
        names = dict(name=index, array=array, offset=offset, count=len(axes), kind=kind, element=more, axes="".join(each))
        (folder / f"{index}.xml").write_text(PDS4.format(map=place, x=x, y=y, constants=constants, **names))
        (folder / f"{index}.dat").write_bytes(bytes(offset) + data.astype(stored).tobytes())


ISIS = """Object = IsisCube
  # made by hand
  Object = Core
    StartByte = {start}
{pointer}    Format = {format}
{tiles}    Group = Dimensions
      Samples = 30
      Lines   = 20
      Bands   = {bands}
    End_Group
    Group = Pixels
      Type       = {kind}
      ByteOrder  = {order}
      Base       = {base}
      Multiplier = {multiplier}
    End_Group
  End_Object
  Group = Mapping
    ProjectionName     = {map}
    CenterLongitude    = {longitude}
    CenterLatitude     = {latitude} <degrees>
    TargetName         = Moon
    EquatorialRadius   = 1737400.0 <meters>
    PolarRadius        = 1737400.0 <meters>
    LatitudeType       = Planetocentric
    LongitudeDirection = PositiveEast
    LongitudeDomain    = 360
    UpperLeftCornerX   = {x} <meters>
    UpperLeftCornerY   = {y} <meters>
    PixelResolution    = 10.0 <meters/pixel>
    Scale              = 3032.335 <pixels/degree>
  End_Group
End_Object
End
"""


def tiled(data, side):
    """Samples in tiles of `side`; those beyond the image are 0."""
    lines, samples = (-(-size // side) for size in data.shape)
    whole = np.zeros((lines * side, samples * side), data.dtype)
    whole[: data.shape[0], : data.shape[1]] = data
    return whole.reshape(lines, side, samples, side).transpose(0, 2, 1, 3)


def isis(folder):
    maps = [("SimpleCylindrical", 0, 0), ("Equirectangular", 30, 20), ("PolarStereographic", 0, -90), ("Orthographic", -38, 8)]
    # GDAL does not read integers of 32 bits.
    kinds = [("UnsignedByte", "u1", 0), ("UnsignedWord", "u2", 0), ("SignedWord", "i2", -32768)]
    real = ("Real", "f4", np.array([0xFF7FFFFB], "u4").view("f4")[0])
    rows = [(kind, order, tile) for tile in (0, 16) for kind in [*kinds, real] for order in ("Lsb", "Msb")]
    for index, ((kind, stored, void), order, side) in enumerate(rows):
        data = POSITIVE if kind.startswith("Unsigned") else GROUND
        data = np.where(HOLES, void, data)
        data = data.astype(("<" if order == "Lsb" else ">") + stored)
        detached = index % 5 == 4
        place, longitude, latitude = maps[index % 4]
        x, y = [(1000, 5000), (-1000, 5000), (1000, -5000), (-1000, -5000)][index // 4 % 4]
        text = ISIS.format(
            start=17 if detached else 4097,
            pointer=f"    ^Core = {index}.dat\n" if detached else "",
            format="Tile" if side else "BandSequential",
            tiles=f"    TileSamples = {side}\n    TileLines = {side}\n" if side else "",
            bands=1, kind=kind, order=order, base=[0.0, 50.0][index % 2], multiplier=[1.0, 0.5, 2.0][index % 3],
            map=place, longitude=longitude, latitude=latitude, x=x, y=y,
        )
        core = (tiled(data, side) if side else data).tobytes()
        if detached:
            (folder / f"{index}.lbl").write_text(text)
            (folder / f"{index}.dat").write_bytes(bytes(16) + core)
        else:
            (folder / f"{index}.cub").write_bytes(text.encode().ljust(4096, b" ") + core)


ENVI = """ENVI
; made by hand
description = {{
  By hand, with = signs
  on two lines }}
Samples = 30
LINES = 20
bands = {bands}
header offset = {offset}
file type = ENVI Standard
data type = {kind}
interleave = {order}
byte order = 1
{more}map info = {{{info}}}
coordinate system string = {{{system}}}
"""
MOON = 'GEOGCS["Moon",DATUM["D_Moon",SPHEROID["Moon",1737400.0,0.0]],PRIMEM["Reference",0.0],UNIT["Degree",0.0174532925199433]]'
PLANE = f'PROJCS["Moon_plane",{MOON},PROJECTION["Equidistant_Cylindrical"],PARAMETER["Central_Meridian",30.0],PARAMETER["Standard_Parallel_1",20.0],UNIT["Meter",1.0]]'
SOUTH = f'PROJCS["Moon_south",{MOON},PROJECTION["Stereographic"],PARAMETER["Central_Meridian",0.0],PARAMETER["Scale_Factor",1.0],PARAMETER["Latitude_Of_Origin",-90.0],UNIT["Meter",1.0]]'


def envi(folder):
    infos = [
        ("Equirectangular, 1, 1, 1000, 5000, 10, 10", PLANE),
        ("Equirectangular, 1.5, 1.5, -1000, 5000, 20, 10, units=Meters", PLANE),
        ("Polar Stereographic, 11, 6, 1000, -5000, 10, 20", SOUTH),
        ("Geographic Lat/Lon, 1, 1, -75, -40, 0.01, 0.02, units=Degrees", MOON),
    ]
    kinds = [(1, "u1"), (2, ">i2"), (3, ">i4"), (4, ">f4"), (5, ">f8"), (12, ">u2"), (13, ">u4"), (14, ">i8"), (15, ">u8")]
    rows = [(kind, order) for order in ("bsq", "bip") for kind in kinds]
    for index, ((kind, stored), order) in enumerate(rows):
        bands, offset = (2 if order == "bip" else 1), [0, 64, 3][index % 3]
        data = POSITIVE if "u" in stored else GROUND
        data = np.where(HOLES, 99, data)
        data = np.stack([data, data + 1], axis=-1) if bands == 2 else data
        # GDAL does not take the void of integers of 64 bits as one.
        more = "data ignore value = 99\n" if index % 2 and kind < 14 else "wavelength units = Unknown\n"
        info, system = infos[index % 4]
        text = ENVI.format(kind=kind, order=order, bands=bands, offset=offset, more=more, info=info, system=system)
        (folder / f"{index}.hdr").write_text(text)
        (folder / f"{index}.dat").write_bytes(bytes(offset) + data.astype(stored).tobytes())


def ascii(folder):
    lines = ["  ".join(f"{height:g}" for height in line) for line in np.where(HOLES, -5, GROUND)]
    corner, centre = "xllcorner 1000\nyllcorner -5000\n", "xllcenter 1000.5\nyllcenter -5000.25\n"
    mixed = "xllcorner -1000\nyllcenter 5000\n"
    size, void = "ncols 30\nnrows 20\n", "NODATA_value -5\n"
    square, oblong = "cellsize 10\n", "dx 10\ndy 20\n"
    grids = [
        (size + corner + square + void, "\n"),
        (size + centre + square + void, "\n"),
        (size + centre + oblong + void, "\n"),
        (size + corner + square, "\n"),
        ((size + corner + square + void).upper(), "\n"),
        ((size + corner + square + void).replace("\n", "\r\n"), "\r\n"),
        ((size + corner + square + void).replace(" ", "\t   "), "\n"),
        ((size + corner + square).replace("cellsize 10", "cellsize 1.0e1") + void, "\n"),
        (size + corner + square + "nodata_value -5.0\n", "\n   "),
        (size + centre + square + void, "\n"),
        (size + corner + oblong, "\n"),
        (size + centre + "cellsize 0.25\n" + void, "\n"),
    ]
    for index, (head, end) in enumerate(grids):
        text = head + end.join(lines) + end
        (folder / f"{index}.asc").write_text(text, newline="")
        system = [PLANE, SOUTH][index % 2] if index % 3 else PLANE
        (folder / f"{index}.prj").write_text(system)


def directory(order, big, tags, front):
    """A TIFF: header, `front`, what does not fit into an entry, one directory. A tag is (number, type, values)."""
    size, count, room = ("Q", "Q", 8) if big else ("I", "H", 4)
    start = 16 if big else 8
    kinds = {2: "s", 3: "H", 4: "I", 12: "d", 16: "Q"}
    body, entries = front, b""
    for number, kind, values in sorted(tags):
        if kind == 2:
            stored, many = values.encode() + b"\0", len(values) + 1
        else:
            stored, many = struct.pack(f"{order}{len(values)}{kinds[kind]}", *values), len(values)
        if len(stored) > room:
            body += bytes(len(body) % 2)
            stored, body = struct.pack(order + size, start + len(body)), body + stored
        entries += struct.pack(f"{order}HH{size}", number, kind, many) + stored.ljust(room, b"\0")
    body += bytes(len(body) % 2)
    head = (b"II" if order == "<" else b"MM") + struct.pack(order + ("HHH" if big else "H"), *((43, 8, 0) if big else (42,)))
    head += struct.pack(order + size, start + len(body))
    return head + body + struct.pack(order + count, len(tags)) + entries + struct.pack(order + size, 0)


# Number of a key and its value: the Moon as a sphere, equirectangular about 30 degrees, or longitudes and latitudes.
SPHERE = {1025: 1, 2048: 32767, 2050: 32767, 2054: 9102, 2056: 32767, 2057: 1737400.0, 2058: 1737400.0}
EQUIRECTANGULAR = {**SPHERE, 1024: 1, 3072: 32767, 3074: 32767, 3075: 17, 3076: 9001, 3078: 20.0, 3088: 30.0, 3081: 0.0, 3082: 0.0, 3083: 0.0}
DEGREES = {**SPHERE, 1024: 2}


def keys(values):
    """The tags of a table of keys: whole numbers in it, reals beside it."""
    reals, rows = [], [1, 1, 0, len(values)]
    for number, value in sorted(values.items()):
        if isinstance(value, float):
            rows += [number, 34736, 1, len(reals)]
            reals.append(value)
        else:
            rows += [number, 0, 1, value]
    return [(34735, 3, rows), (34736, 12, reals)]


def blocks_of(data, tile, lines):
    """Samples cut into tiles of `tile` (0: none) or strips of `lines`."""
    if tile:
        return [part for row in tiled(data, tile) for part in row]
    return [data[at : at + lines] for at in range(0, HEIGHT, lines)]


def differences(block):
    """Predictor 2: each sample of a line less the one before."""
    ahead = block.copy()
    ahead[:, 1:] -= block[:, :-1]
    return ahead


def geotiff(folder):
    at = [(1000, 5000), (-1000, 5000), (1000, -5000), (-1000, -5000)]
    # Order, BigTIFF, type, tile, lines of a strip, packing, predictor, void, point, keys, step.
    rows = [
        ("<", False, "i2", 0, 20, 1, 1, None, False, EQUIRECTANGULAR, (10, 10)),
        (">", False, "i2", 0, 7, 1, 1, "-7777", True, EQUIRECTANGULAR, (10, 20)),
        ("<", False, "u1", 0, 1, 8, 1, None, False, EQUIRECTANGULAR, (25, 25)),
        (">", False, "u2", 16, 0, 8, 2, "9", False, EQUIRECTANGULAR, (10, 10)),
        ("<", False, "i4", 0, 6, 8, 2, "-7777", True, DEGREES, (0.01, 0.01)),
        (">", True, "f4", 16, 0, 1, 1, "-7777", False, EQUIRECTANGULAR, (10, 10)),
        ("<", True, "f8", 0, 5, 8, 1, "nan", False, DEGREES, (0.02, 0.01)),
        (">", True, "i2", 32, 0, 32946, 2, None, True, EQUIRECTANGULAR, (10, 10)),
        ("<", False, "f4", 0, 20, 32773, 1, "-1e30", False, EQUIRECTANGULAR, (5, 5)),
        (">", False, "f8", 16, 0, 8, 1, None, False, EQUIRECTANGULAR, (10, 10)),
        ("<", False, "u4", 0, 3, 1, 1, None, True, DEGREES, (0.01, 0.02)),
        ("<", True, "i1", 0, 4, 8, 2, "-77", False, EQUIRECTANGULAR, (10, 10)),
    ]
    for index, (order, big, kind, tile, lines, packing, predictor, void, point, place, step) in enumerate(rows):
        data = POSITIVE if kind[0] == "u" or kind == "i1" else GROUND
        data = np.where(HOLES, float(void), data) if void else data
        blocks = [block.astype(order + kind) for block in blocks_of(data.astype(order + kind), tile, lines)]
        blocks = [differences(block) if predictor == 2 else block for block in blocks]
        stored = [block.tobytes() for block in blocks]
        if packing in (8, 32946):
            stored = [zlib.compress(block) for block in stored]
        if packing == 32773:
            # As literals of 64 bytes.
            cut = [[block[at : at + 64] for at in range(0, len(block), 64)] for block in stored]
            stored = [b"".join(bytes([len(part) - 1]) + part for part in parts) for parts in cut]
        start = 16 if big else 8
        starts = [start + sum(map(len, stored[:count])) for count in range(len(stored))]
        lengths, far = list(map(len, stored)), 16 if big else 4
        x, y = (5, 40 - 80 * (index % 2)) if place is DEGREES else at[index % 4]
        tags = [
            (256, 3, [WIDTH]), (257, 3, [HEIGHT]), (258, 3, [8 * int(kind[1])]), (259, 3, [packing]), (262, 3, [1]),
            (277, 3, [1]), (339, 3, [dict(u=1, i=2, f=3)[kind[0]]]), *keys({**place, 1025: 2 if point else 1}),
        ]
        if index % 3:
            tags += [(33550, 12, [*step, 0]), (33922, 12, [0, 0, 0, x, y, 0])]
        else:
            tags += [(34264, 12, [step[0], 0, 0, x, 0, -step[1], 0, y, 0, 0, 0, 0, 0, 0, 0, 1])]
        tags += [(317, 3, [2])] if predictor == 2 else []
        tags += [(42113, 2, void)] if void else []
        if tile:
            tags += [(322, 3, [tile]), (323, 3, [tile]), (324, far, starts), (325, 4, lengths)]
        else:
            tags += [(278, 3, [lines]), (273, far, starts), (279, 4, lengths)]
        (folder / f"{index}.tif").write_bytes(directory(order, big, tags, b"".join(stored)))


def angle(degrees, letters):
    """DDDMMSSH of DTED."""
    seconds = round(abs(degrees) * 3600)
    return f"{seconds // 3600:03}{seconds // 60 % 60:02}{seconds % 60:02}{letters[degrees < 0]}"


def field(header, at, text):
    header[at : at + len(text)] = text.encode()


def dted(folder):
    # South, west, intervals (tenths of a second) of latitude and longitude, labels of a tape in front, voids.
    rows = [
        (45, 6, 300, 300, 0, False), (-44, -121, 300, 300, 0, True), (0, 0, 30, 30, 0, False), (-1, -1, 30, 30, 2, True),
        (60, 20, 30, 60, 0, True), (-72, 179, 30, 90, 1, False), (80, -180, 10, 60, 0, True), (12, 34, 10, 10, 2, False),
        (-33, -70, 10, 10, 0, True), (5.5, -6.25, 300, 300, 0, False),
    ]
    for index, (south, west, northwards, eastwards, labels, holes) in enumerate(rows):
        # GDAL exchanges the two lines in the middle of an even number.
        heights = (np.where(HOLES, -32767, GROUND) if holes else GROUND)[:-1]
        user, data, accuracy = (bytearray(b" " * size) for size in (80, 648, 2700))
        ends = angle(west, "EW"), angle(south, "NS")
        counts = f"{WIDTH:04}", f"{heights.shape[0]:04}"
        steps = f"{eastwards:04}", f"{northwards:04}"
        for at, text in enumerate(["UHL1", *ends, *steps, "0010", "U  ", " " * 12, *counts, "0"]):
            field(user, [0, 4, 12, 20, 24, 28, 32, 35, 47, 51, 55][at], text)
        # The second header has latitudes with tenths of a second and without the first digit.
        longitude, latitude = ends[0][:7] + ".0" + ends[0][7], ends[1][1:7] + ".0" + ends[1][7]
        fields = [(0, "DSIU"), (59, f"DTED{1 + index % 3}"), (141, "E96WGS84"), (185, latitude), (194, longitude)]
        fields += [(264, "0000000.0"), (273, steps[1]), (277, steps[0]), (281, counts[1]), (285, counts[0]), (289, "00")]
        for at, text in fields:
            field(data, at, text)
        field(accuracy, 0, "ACC0010NA  0010NA  ")
        whole = b"".join([b"VOL1".ljust(80), b"HDR1".ljust(80)][:labels]) + user + data + accuracy
        # A record is a meridian from south to north; a height is a sign and a magnitude.
        for meridian, record in enumerate(heights[::-1].T.astype(int)):
            words = [abs(height) | (0x8000 if height < 0 else 0) for height in record]
            begun = struct.pack(">IHH", 0xAA000000 | meridian, meridian, 0) + struct.pack(f">{len(words)}H", *words)
            whole += begun + struct.pack(">I", sum(begun))
        (folder / f"{index}.dt{index % 3}").write_bytes(whole)


def hgt(folder):
    names = ["N45E006", "S44W121", "N00E000", "S01W001", "N83W180", "S60E179", "N09E099", "S12E100", "N33W033", "S70E040"]
    for index, name in enumerate(names):
        lines, columns = (3601, 1801) if index == 9 else (3601, 3601) if index == 8 else (1201, 1201)
        heights = np.add.outer(-7 * (np.arange(lines) % 900), 3 * (np.arange(columns) % 700))
        if index % 2:
            heights[np.add.outer(5 * np.arange(lines), np.arange(columns)) % 7 == 0] = -32768
        (folder / f"{name}.hgt").write_bytes(heights.astype(">i2").tobytes())


def write_all(folder):
    """Files of all formats, in folders inside `folder`."""
    for write in (geotiff, dted, hgt, pds3, pds4, isis, envi, ascii):
        own = folder / f"{write.__name__}-hand"
        own.mkdir()
        write(own)
