"""Files that GDAL writes in formats other than TIFF: copies of TIFFs with every number type, with voids, in all quarters of
the Moon and in several maps."""

import numpy as np
import rasterio
import rasterio.shutil
from rasterio.crs import CRS
from rasterio.transform import Affine

WIDTH, HEIGHT = 30, 20
RADIUS = 1737400
GROUND = np.add.outer(-7 * np.arange(HEIGHT), 3 * np.arange(WIDTH)).astype("f8")
HOLES = np.arange(WIDTH * HEIGHT).reshape(HEIGHT, WIDTH) % 7 == 0
QUARTERS = [(40, 5), (40, -75), (-40, 5), (-40, -75)]
REALS, INTEGERS = ["float32", "float64"], ["uint8", "int8", "uint16", "int16", "uint32", "int32", "uint64", "int64"]


def moon(words):
    return CRS.from_proj4(f"{words} +R={RADIUS} +no_defs")


MAPS = {
    "eqc": "+proj=eqc +lat_ts=20 +lon_0=30 +units=m",
    "north": "+proj=stere +lat_0=90 +lon_0=10 +units=m",
    "south": "+proj=stere +lat_0=-90 +lon_0=0 +units=m",
    "view": "+proj=ortho +lat_0=8 +lon_0=-38 +units=m",
    "sinusoidal": "+proj=sinu +lon_0=5 +units=m",
}


def samples_of(header):
    """The file of the samples of an ENVI header."""
    found = [header.with_suffix(""), *(header.with_suffix(ending) for ending in [".dat", ".img", ".bil", ".bin", ".raw"])]
    return next(path for path in found if path.exists())


class Writer:
    """Writes copies in one format."""

    def __init__(self, folder, kind, driver, ending, **options):
        self.source = folder / "plain.tif"
        self.folder = folder.parent / kind
        self.folder.mkdir(exist_ok=True)
        self.driver, self.ending, self.options = driver, ending, options

    def write(self, name, dtype="float32", crs=None, transform=Affine(10, 0, 1000, 0, -10, 5000), data=GROUND, void=None, count=1, scale=None, **options):
        """One file; `void` marks every seventh sample."""
        crs = crs or moon(MAPS["eqc"])
        if dtype.startswith("u") or dtype == "int8":
            # Also without the special pixels of small integers.
            data = np.abs(data) % 90 + 10
        if void is not None:
            data = np.where(HOLES, void, data)
        profile = dict(driver="GTiff", width=WIDTH, height=HEIGHT, count=count, dtype=dtype, nodata=void)
        with rasterio.open(self.source, "w", crs=crs, transform=transform, **profile) as file:
            for band in range(count):
                file.write((data + band).astype(dtype), band + 1)
            if scale:
                file.scales, file.offsets = [scale[0]] * count, [scale[1]] * count
        target = self.folder / f"{name}{self.ending}"
        rasterio.shutil.copy(self.source, target, driver=self.driver, **(self.options | options))
        self.source.unlink()

    def types(self, kinds):
        for kind in kinds:
            void = 77 if kind == "uint8" else (np.iinfo(kind).min if kind[0] == "i" else 250)
            self.write(f"type-{kind}", kind)
            self.write(f"void-{kind}", kind, void=-1e30 if kind in REALS else int(void) if kind != "int64" else -9)

    def places(self, degrees):
        for name, words in MAPS.items():
            self.write(f"map-{name}", crs=moon(words))
            self.write(f"map-{name}-void", "int16", crs=moon(words), void=-32768)
        for latitude, longitude in QUARTERS:
            x, y = np.radians(longitude) * RADIUS, np.radians(latitude) * RADIUS
            at = f"{latitude}-{longitude}"
            self.write(f"eqc-{at}", transform=Affine(25, 0, x, 0, -25, y))
            self.write(f"eqc-{at}-void", "int16", void=-7, transform=Affine(20, 0, x, 0, -20, y))
            self.write(f"degrees-{at}", crs=moon("+proj=longlat"), transform=Affine(0.01, 0, longitude, 0, -0.01, latitude))
            if degrees:
                self.write(f"degrees-{at}-void", "int16", crs=moon("+proj=longlat"), void=-1, transform=Affine(0.02, 0, longitude, 0, -0.02, latitude))


def pds4(folder):
    writer = Writer(folder, "pds4", "PDS4", ".xml", VAR_TARGET="Moon")
    # The driver writes no integers of 64 bits.
    writer.types(INTEGERS[:6] + REALS)
    writer.places(True)
    writer.write("geotiff", "int16", IMAGE_FORMAT="GEOTIFF")
    writer.write("scaled", "int16", scale=(0.5, 100))
    writer.write("graphic", LATITUDE_TYPE="Planetographic")
    writer.write("west", LONGITUDE_DIRECTION="Positive West")
    for order in ["BSQ", "BIL", "BIP"]:
        writer.write(f"bands-{order}", "int16", count=3, INTERLEAVE=order)


def isis(folder):
    # The driver writes no integers of 32 bits.
    kinds = ["uint8", "uint16", "int16", "float32"]
    attached = Writer(folder, "isis", "ISIS3", ".cub", DATA_LOCATION="LABEL")
    attached.types(kinds)
    attached.places(False)
    for kind in kinds:
        attached.write(f"tile-{kind}", kind, TILED="YES", BLOCKXSIZE=16, BLOCKYSIZE=16)
    attached.write("tile-bands", "int16", count=3, TILED="YES", BLOCKXSIZE=16, BLOCKYSIZE=8)
    attached.write("bands", "float32", count=2)
    attached.write("scaled", "int16", scale=(0.5, 100), void=-32768)
    attached.write("domain", FORCE_360="YES", crs=moon("+proj=longlat"), transform=Affine(0.01, 0, -75, 0, -0.01, 40))
    attached.write("graphic", LATITUDE_TYPE="Planetographic")
    attached.write("west", LONGITUDE_DIRECTION="PositiveWest")
    attached.write("target", TARGET_NAME="Moon", COMMENT="made")
    detached = Writer(folder, "isis", "ISIS3", ".lbl")
    detached.write("detached", "int16", DATA_LOCATION="EXTERNAL")
    detached.write("detached-tiles", "float32", DATA_LOCATION="EXTERNAL", TILED="YES", BLOCKXSIZE=16, BLOCKYSIZE=16)
    detached.write("detached-tiff", "int16", DATA_LOCATION="GEOTIFF")


def envi(folder):
    writer = Writer(folder, "envi", "ENVI", ".dat")
    writer.types([kind for kind in INTEGERS if kind != "int8"] + REALS)
    writer.places(True)
    for order in ["BSQ", "BIL", "BIP"]:
        writer.write(f"bands-{order}", "int16", count=3, void=-5, INTERLEAVE=order)
    writer.write("added", "int16", SUFFIX="ADD")
    writer.write("zone", "int16", crs=CRS.from_epsg(32633))
    writer.write("zone-south", "int16", crs=CRS.from_epsg(32733))
    writer.write("earth", crs=CRS.from_epsg(4326), transform=Affine(0.01, 0, 5, 0, -0.01, 40))
    writer.write("feet", crs=moon("+proj=eqc +units=us-ft"))


def ascii(folder):
    writer = Writer(folder, "ascii", "AAIGrid", ".asc")
    for kind in ["uint8", "int16", "int32", "float32", "float64"]:
        void = 250 if kind == "uint8" else -9999
        writer.write(f"type-{kind}", kind)
        writer.write(f"void-{kind}", kind, void=void)
    writer.places(True)
    writer.write("oblong", transform=Affine(10, 0, 1000, 0, -20, 5000), FORCE_CELLSIZE="NO")
    writer.write("oblong-void", "int16", void=-32768, transform=Affine(20, 0, -1000, 0, -10, -5000))
    writer.write("digits", "float64", data=GROUND / 3, SIGNIFICANT_DIGITS=15)
    writer.write("decimals", "float64", data=GROUND / 4, DECIMAL_PRECISION=2)
    writer.write("zone", "int16", crs=CRS.from_epsg(32633))
    writer.write("earth", crs=CRS.from_epsg(4326), transform=Affine(0.01, 0, 5, 0, -0.01, 40))


def write_all(folder):
    """Files of all formats, in folders beside `folder`."""
    for write in (pds4, isis, envi, ascii):
        write(folder)
