"""GDAL through rasterio, for the tests in gdal.rs.

gdal.py all FOLDER
    Writes files of every format, and beside each what GDAL reads: heights in metres (.npy; the band with the scale, offset
    and unit that GDAL reports, NaN for voids) and place (.json). `list.json` has them all: a folder is a format.
gdal.py tell FILE FOLDER
    What GDAL reads of a file, into a folder.
gdal.py translate FROM TO [NAME=VALUE]...
    What gdal_translate does: a copy by GDALCreateCopy with creation options. `ot=TYPE` and `a_ullr=X,Y,X,Y` are -ot and
    -a_ullr.
gdal.py warp FROM TO CRS
    What gdalwarp -t_srs CRS does: a copy on a grid north up. CRS `same` keeps the file's own.
gdal.py packed TO PACKING
    A file packed in a way that the reader does not know.
"""

import json
import sys
from pathlib import Path

import numpy as np
import rasterio
import rasterio.shutil
import rasterio.vrt
import rasterio.warp
from rasterio.crs import CRS
from rasterio.transform import Affine

import gdal_formats
import gdal_hand

FOLDER = Path(sys.argv[2]) / "geotiff"
WIDTH, HEIGHT = 70, 50
GROUND = np.add.outer(-7 * np.arange(HEIGHT), 3 * np.arange(WIDTH)).astype("f8")
METRES = Affine(10, 0, 1000, 0, -10, 5000)
DEGREES = Affine(0.01, 0, 5, 0, -0.01, 40)
UNITS = {"": 1.0, "m": 1.0, "metre": 1.0, "ft": 0.3048, "US survey foot": 1200 / 3937, "km": 1000.0}
HOLES = np.arange(WIDTH * HEIGHT).reshape(HEIGHT, WIDTH) % 7 != 0


def moon(words):
    return CRS.from_proj4(words + " +R=1737400 +no_defs")


EQUIRECTANGULAR = moon("+proj=eqc +lat_ts=20 +lon_0=30 +units=m")


def write(name, dtype="float32", crs=EQUIRECTANGULAR, transform=METRES, data=GROUND, after=None, env=None, **options):
    """One file; `after` changes the open file before it is closed."""
    options = dict(count=1, width=WIDTH, height=HEIGHT) | options
    with rasterio.Env(**(env or {})):
        with rasterio.open(
            FOLDER / f"{name}.tif", "w", driver="GTiff", dtype=dtype, crs=crs, transform=transform, **options
        ) as file:
            if data is not None:
                file.write(data.astype(dtype), 1)
            if after:
                after(file)


def units(name):
    def after(file):
        file.units = [name]

    return after


def scaled(file):
    file.scales, file.offsets, file.units = [0.5], [100.0], ["m"]


def alpha(file):
    file.write(np.where(HOLES, 255, 0).astype(file.dtypes[1]), 2)


def mask(file):
    file.write_mask(HOLES)


def write_all():
    for kind in ["uint8", "int8", "uint16", "int16", "uint32", "int32", "int64", "uint64", "float32", "float64"]:
        data = np.abs(GROUND) % 100 if kind.startswith("u") or kind == "int8" else GROUND
        write(f"type-{kind}", kind, data=data)
        write(f"big-{kind}", kind, data=data, BIGTIFF="YES", tiled=True, blockxsize=32, blockysize=16, ENDIANNESS="BIG")
    for packing in ["LZW", "DEFLATE", "PACKBITS", "ZSTD", "NONE"]:
        tiles = dict(COMPRESS=packing, tiled=True, blockxsize=32, blockysize=32)
        write(f"packed-{packing}", "int16", **tiles)
        if packing in ("LZW", "DEFLATE", "ZSTD"):
            write(f"packed-{packing}-2", "int16", PREDICTOR=2, **tiles)
            write(f"packed-{packing}-3", "float32", PREDICTOR=3, **tiles)
    for bits in (1, 2, 4, 7, 12):
        write(f"bits-{bits}", "uint8" if bits < 8 else "uint16", NBITS=bits, data=np.abs(GROUND) % 2**bits)
    write("half", NBITS=16, data=GROUND % 64)
    holed = np.where(HOLES, GROUND, -32768)
    write("void-integer", "int16", nodata=-32768, data=holed)
    lowest = float(np.finfo("f4").min)
    write("void-real", nodata=lowest, data=np.where(HOLES, GROUND, lowest))
    write("void-nan", nodata=float("nan"), data=np.where(HOLES, GROUND, np.nan))
    write("scaled", "int16", after=scaled)
    for unit in ["m", "metre", "ft", "US survey foot", "km"]:
        write(f"unit-{unit.replace(' ', '-')}", after=units(unit))
    inside = dict(GDAL_TIFF_INTERNAL_MASK="YES")
    write("mask", after=mask, env=inside)
    write("mask-packed", "int16", after=mask, env=inside, COMPRESS="DEFLATE", tiled=True, blockxsize=32, blockysize=32)
    write("mask-beside", "int16", after=mask, env=dict(GDAL_TIFF_INTERNAL_MASK="NO"))
    # GDAL takes alpha bands of 8 and 16 bits without a sign as masks.
    positive = np.abs(GROUND)
    write("alpha", "uint16", data=positive, count=2, after=alpha, ALPHA="NON-PREMULTIPLIED")
    write("alpha-planes", "uint8", data=positive % 100, count=2, after=alpha, ALPHA="YES", INTERLEAVE="BAND")
    corner = lambda file: file.write(GROUND[:32, :32].astype("f4"), 1, window=((0, 32), (0, 32)))
    write("sparse", data=None, nodata=-9999, after=corner, SPARSE_OK="TRUE", tiled=True, blockxsize=32, blockysize=32)
    code = CRS.from_epsg
    for name, crs, transform in [
        ("pole", moon("+proj=stere +lat_0=-90 +lat_ts=-90 +lon_0=0 +units=m"), METRES),
        ("pole-70", moon("+proj=stere +lat_0=90 +lat_ts=70 +lon_0=10 +units=m"), METRES),
        ("view", moon("+proj=ortho +lat_0=8 +lon_0=-38 +units=m"), METRES),
        ("sinusoidal", moon("+proj=sinu +units=m"), METRES),
        ("cone", moon("+proj=lcc +lat_1=10 +lat_2=30 +units=m"), METRES),
        ("feet", moon("+proj=eqc +units=us-ft"), METRES),
        ("degrees", moon("+proj=longlat"), DEGREES),
        ("wgs84", code(4326), DEGREES),
        ("nad83", code(4269), DEGREES),
        ("paris", code(4807), DEGREES),
        ("zone", code(32633), METRES),
        ("mercator", code(3857), METRES),
        ("california", code(2226), METRES),
        ("mars", CRS.from_proj4("+proj=eqc +R=3396190 +units=m"), METRES),
        ("moon-2000", CRS.from_authority("ESRI", "104903"), DEGREES),
        ("meridian", moon("+proj=longlat +pm=12.5"), DEGREES),
    ]:
        write(f"crs-{name}", crs=crs, transform=transform)
    write("point", after=lambda file: file.update_tags(AREA_OR_POINT="Point"))
    write("turned", transform=Affine(10, 1, 1000, 1, -10, 5000))
    write("south-first", transform=Affine(10, 0, 1000, 0, 10, 5000))
    write("named", after=lambda file: file.update_tags(1, STATISTICS_MEAN="3", AUTHOR="me"))
    write("strange", after=lambda file: file.update_tags(1, BIAS="3"))
    write("overviews", "int16")
    with rasterio.open(FOLDER / "overviews.tif", "r+") as file:
        file.build_overviews([2, 4])
    sources = ["mask", "void-real", "crs-degrees", "scaled", "unit-ft", "crs-pole", "crs-view", "alpha", "overviews"]
    sources += [f"type-{kind}" for kind in ["uint8", "int8", "uint16", "int16", "uint32", "int32", "float32", "float64"]]
    for name in sources:
        rasterio.shutil.copy(FOLDER / f"{name}.tif", FOLDER / f"cloud-{name}.tif", driver="COG")
    # Large enough for copies of less detail and several tiles.
    wide = np.add.outer(-7 * np.arange(700), 3 * np.arange(900)).astype("f8")
    wide[wide % 13 == 0] = -32768
    for name, kind, options in [
        ("wide", "int16", dict(nodata=-32768)),
        ("wide-real", "float32", dict(nodata=-32768)),
        ("wide-mask", "int16", dict(env=inside, after=lambda file: file.write_mask(wide % 5 != 0))),
    ]:
        write(name, kind, data=wide, width=900, height=700, **options)
        for packing in ["DEFLATE", "LZW"]:
            target = FOLDER / f"cloud-{name}-{packing}.tif"
            rasterio.shutil.copy(FOLDER / f"{name}.tif", target, driver="COG", BLOCKSIZE=256, COMPRESS=packing)
    huge = dict(BIGTIFF="YES")
    for name in ["void-real", "crs-degrees", "scaled", "unit-km", "crs-pole-70", "alpha", "packed-LZW-2", "wide", "wide-mask"]:
        rasterio.shutil.copy(FOLDER / f"{name}.tif", FOLDER / f"big-{name}.tif", driver="GTiff", **huge)


def write_cells():
    """Cells of one degree by other drivers, with heights of both signs and voids; posts stand on their edges."""
    (FOLDER.parent / "dted").mkdir()
    (FOLDER.parent / "hgt").mkdir()
    corners = [(45, 6), (-44, -121), (0, 0), (-1, -1), (20, -180), (-60, 179), (9, 99), (-12, 100), (33, -33), (-70, 40)]
    cells = [(f"dted/level-0-{south}-{west}.dt0", "DTED", 121, south, west, -32767) for south, west in corners]
    cells += [(f"dted/empty-{south}-{west}.dt0", "DTED", 121, south, west, None) for south, west in corners[:8]]
    cells += [("dted/level-1.dt1", "DTED", 1201, -44, -121, -32767), ("dted/level-1-e.dt1", "DTED", 1201, 9, 99, -32767)]
    cells += [("dted/level-2.dt2", "DTED", 3601, -44, 121, -32767)]
    degrees = [(k * 5 - 50, k * 17 - 170) for k in range(19)]
    for south, west in degrees:
        name = f"{'S' if south < 0 else 'N'}{abs(south):02}{'W' if west < 0 else 'E'}{abs(west):03}"
        cells.append((f"hgt/{name}.hgt", "SRTMHGT", 1201, south, west, -32768))
    cells.append(("hgt/N61E010.hgt", "SRTMHGT", 3601, 61, 10, -32768))
    for name, driver, side, south, west, void in cells:
        line, column = np.mgrid[0:side, 0:side]
        data = (line * 3 % 8000 - column * 2 - 50).astype("i2")
        if void:
            data[(line + column) % 13 == 0] = void
        step = 1 / (side - 1)
        corner = Affine(step, 0, west - step / 2, 0, -step, south + 1 + step / 2)
        plain = dict(driver="GTiff", dtype="int16", count=1, width=side, height=side, nodata=void)
        source = FOLDER.parent / "plain.tmp"
        with rasterio.open(source, "w", crs=CRS.from_epsg(4326), transform=corner, **plain) as file:
            file.write(data, 1)
        rasterio.shutil.copy(source, FOLDER.parent / name, driver=driver)


def tell(path, target=None):
    """What GDAL reads of a file: beside it, or in a folder."""
    target = target / path.name if target else path
    with rasterio.Env(AAIGRID_DATATYPE="Float64"), rasterio.open(path) as file:
        heights = file.read(1).astype("f8") * file.scales[0] + file.offsets[0]
        heights[file.read_masks(1) == 0] = np.nan
        heights = heights * UNITS[file.units[0] or ""]
        np.save(f"{target}.npy", heights.astype("f4") if file.dtypes[0] == "int16" and heights.size > 1e6 else heights)
        is_geographic = bool(file.crs and file.crs.is_geographic)
        unit = np.pi / 180 if is_geographic else (file.crs.linear_units_factor[1] if file.crs else 1.0)
        # GDAL leaves longitudes as they count from the file's own prime meridian.
        east = 12.5 if path.stem == "crs-meridian" else 0.0
        place = dict(transform=list(file.transform)[:6], unit=unit, geographic=is_geographic, east=east)
        if file.crs and not is_geographic and file.crs.to_dict().get("R") == 1737400:
            x, y = file.xy(0, 0)
            longitude, latitude = rasterio.warp.transform(file.crs, moon("+proj=longlat"), [x], [y])
            place["first"] = [latitude[0], longitude[0]]
        Path(f"{target}.json").write_text(json.dumps(place))


def translate(source, target, options):
    options = dict(option.split("=", 1) for option in options)
    kind, edges = options.pop("ot", None), options.pop("a_ullr", None)
    if not kind and not edges:
        rasterio.shutil.copy(source, target, driver="GTiff", **options)
        return
    with rasterio.open(source) as file:
        profile, samples = file.profile, file.read()
    for key in ("nbits", "NBITS"):
        profile.pop(key, None)
    profile.update(driver="GTiff", dtype=kind or profile["dtype"], **options)
    if edges:
        west, north, east, south = map(float, edges.split(","))
        profile["transform"] = rasterio.transform.from_bounds(west, south, east, north, profile["width"], profile["height"])
    with rasterio.open(target, "w", **profile) as file:
        file.write(samples.astype(profile["dtype"]))


def warp(source, target, name):
    with rasterio.open(source) as file:
        own = file.crs or file.gcps[1]
        crs = own if name == "same" else CRS.from_user_input(name)
        with rasterio.vrt.WarpedVRT(file, src_crs=own, crs=crs, nodata=-9999.0) as turned:
            rasterio.shutil.copy(turned, target, driver="GTiff")


# What is read of each format: a label or a header, or the file itself.
PATTERNS = dict(
    geotiff="*.tif", dted="*.dt?", hgt="*.hgt", pds3="*.lbl", pds4="*.xml", isis="*.[cl][ub][bl]", envi="*.hdr", ascii="*.asc"
)


def write_and_tell_all():
    FOLDER.mkdir()
    write_all()
    write_cells()
    gdal_formats.write_all(FOLDER)
    gdal_hand.write_all(FOLDER.parent)
    listed = []
    for kind, pattern in PATTERNS.items():
        for path in sorted((FOLDER.parent / kind).glob(pattern)) + sorted((FOLDER.parent / f"{kind}-hand").glob(pattern)):
            if path.suffix == ".cub" and path.with_suffix(".lbl").exists():
                continue  # samples of a label
            if kind != "geotiff":
                path.with_name(path.name + ".aux.xml").unlink(missing_ok=True)
            # GDAL wants the samples of an ENVI header.
            tell(gdal_formats.samples_of(path) if kind == "envi" else path, path.parent)
            listed.append(str(path.relative_to(FOLDER.parent)))
    (FOLDER.parent / "list.json").write_text(json.dumps(listed))


match sys.argv[1:]:
    case ["all", _]:
        write_and_tell_all()
    case ["tell", source, folder]:
        tell(Path(source), Path(folder))
    case ["translate", source, target, *options]:
        translate(source, target, options)
    case ["warp", source, target, crs]:
        warp(source, target, crs)
    case ["packed", target, packing]:
        FOLDER = Path(target).parent
        write(Path(target).stem, COMPRESS=packing)
    case other:
        raise SystemExit(f"{other}: expected all, translate, warp or packed")
