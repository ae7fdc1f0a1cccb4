//! Objects, groups and keywords of ISIS cube labels, and what becomes of each (ISIS 8, "Cube format" and "Label dictionary").

use crate::read::label::Dialect;
use crate::read::words::Fate::{Harmless, Only, Refused, Used};
use crate::read::words::{Vocabulary, named};

/// Text for groups about origin, instrument and time.
const ORIGIN: &str = "origin of the cube";
/// Text for a whole object that is not the core.
const OTHER_DATA: &str = "another piece of data, with keywords of its own";
/// Text for edges that follow from the corner and the size.
const OUTLINE: &str = "outline of the map, which follows from its corner";
/// Text for groups about instruments.
const TAKEN: &str = "how the picture was taken";

/// Objects and groups of a label.
pub const OBJECTS: Vocabulary = Vocabulary {
    kind: "object or group of an ISIS label",
    prefix: "object:",
    words: &[
        named("IsisCube", Used("the cube; its keywords are decided one by one")),
        named("Core", Used("the samples")),
        named("Dimensions", Used("lines, samples and bands")),
        named("Pixels", Used("how a sample is stored")),
        named("Mapping", Used("place of the samples")),
        named("BandBin", Used("names and unit of the bands")),
        named("Label", Harmless("length of the label, whose end is found by itself")),
        named("Table", Harmless(OTHER_DATA)),
        named("History", Harmless(OTHER_DATA)),
        named("OriginalLabel", Harmless(OTHER_DATA)),
        named("OriginalXmlLabel", Harmless(OTHER_DATA)),
        named("Polygon", Harmless(OTHER_DATA)),
        named("StretchPairs", Harmless(OTHER_DATA)),
        named("NaifKeywords", Harmless(TAKEN)),
        named("Instrument", Harmless(TAKEN)),
        named("Archive", Harmless(ORIGIN)),
        named("Kernels", Harmless(TAKEN)),
        named("Radiometry", Harmless(TAKEN)),
        named("RadiometricCalibration", Harmless(TAKEN)),
        named("Reseaus", Harmless(TAKEN)),
        named("CameraStatistics", Harmless(TAKEN)),
        named("Mosaic", Harmless(ORIGIN)),
        named("*Info", Harmless(ORIGIN)),
        named("CubeLabel", Harmless(ORIGIN)),
        named("AlphaCube", Refused("a cube that was cut from another one before it was placed")),
    ],
};

/// Keywords outside of the groups that have tables of their own.
pub const CUBE: Vocabulary = Vocabulary {
    kind: "keyword of an ISIS label",
    prefix: "",
    words: &[
        named("^Label", Harmless("place of another piece of data")),
        named("^History", Harmless("place of another piece of data")),
        named("^Table", Harmless("place of another piece of data")),
    ],
};

/// Keywords of the object Core.
pub const CORE: Vocabulary = Vocabulary {
    kind: "keyword of Core in an ISIS label",
    prefix: "",
    words: &[
        named("^Core", Used("file of the samples, in the folder of the label")),
        named("StartByte", Used("first byte of the samples, from 1")),
        named("Format", Used("BandSequential or Tile; another one is refused")),
        named("TileSamples", Used("samples of a line of a tile")),
        named("TileLines", Used("lines of a tile")),
        named("Bytes", Harmless("length of the core, which is checked against the file")),
    ],
};

/// Keywords of the group Dimensions.
pub const DIMENSIONS: Vocabulary = Vocabulary {
    kind: "keyword of Dimensions in an ISIS label",
    prefix: "",
    words: &[
        named("Samples", Used("samples of a line")),
        named("Lines", Used("lines of samples")),
        named("Bands", Used("bands, of which --band chooses")),
    ],
};

/// Keywords of the group Pixels.
pub const PIXELS: Vocabulary = Vocabulary {
    kind: "keyword of Pixels in an ISIS label",
    prefix: "",
    words: &[
        named("Type", Used("kind of a sample, which has its special pixels: they are voids")),
        named("ByteOrder", Used("Lsb or Msb")),
        named("Base", Used("height of the stored number 0")),
        named("Multiplier", Used("units of height a stored unit")),
    ],
};

/// Keywords of the group BandBin.
pub const BAND_BIN: Vocabulary = Vocabulary {
    kind: "keyword of BandBin in an ISIS label",
    prefix: "",
    words: &[
        named("Unit", Used("unit of the heights; metres without it, with a note")),
        named("Units", Used("as Unit")),
        named("Name", Used("title of the bank")),
        named("Filter*", Harmless(TAKEN)),
        named("OriginalBand", Harmless(ORIGIN)),
        named("Center", Harmless(TAKEN)),
        named("Width", Harmless(TAKEN)),
        named("*Number", Harmless(TAKEN)),
        named("BandSuffix*", Harmless(TAKEN)),
    ],
};

/// Keywords of the group Mapping.
pub const MAPPING: Vocabulary = Vocabulary {
    kind: "keyword of Mapping in an ISIS label",
    prefix: "",
    words: &[
        named(
            "ProjectionName",
            Used(
                "equirectangular, polar stereographic or orthographic; the metres of another are taken as they are, with a note",
            ),
        ),
        named("CenterLatitude", Used("latitude of the origin, or the parallel that is true to scale")),
        named("CenterLongitude", Used("longitude of the origin")),
        named("CenterLatitudeRadius", Used("radius of the sphere, in place of EquatorialRadius")),
        named("scaleFactor", Used("scale at the pole")),
        named("EquatorialRadius", Used("radius of the sphere")),
        named("PolarRadius", Used("a note if it is another than EquatorialRadius")),
        named("UpperLeftCornerX", Used("easting of the corner of the first sample")),
        named("UpperLeftCornerY", Used("northing of the corner of the first sample")),
        named("PixelResolution", Used("length of a sample; metres without a unit")),
        named("Scale", Used("samples a degree; refused if PixelResolution contradicts it")),
        named("Rotation", Only(&["0"], "a turned grid")),
        named("LongitudeDirection", Only(&["PositiveEast"], "longitudes that grow to the west")),
        named("LongitudeDomain", Only(&["180", "360"], "how longitudes are counted, which changes no place")),
        named(
            "LatitudeType",
            Only(&["Planetocentric", "Planetographic"], "what a latitude is; the same on a sphere"),
        ),
        named("TargetName", Harmless("the body, whose radius is EquatorialRadius")),
        named("MinimumLatitude", Harmless(OUTLINE)),
        named("MaximumLatitude", Harmless(OUTLINE)),
        named("MinimumLongitude", Harmless(OUTLINE)),
        named("MaximumLongitude", Harmless(OUTLINE)),
        named("TrueScaleLatitude", Refused("a parallel of another kind")),
        named("*Parallel", Refused("a parallel of another kind")),
        named("CenterAzimuth", Refused("a turned map")),
        named("Pole*", Refused("a turned map")),
    ],
};

/// The tables of a label.
pub const DIALECT: Dialect = Dialect {
    objects: &OBJECTS,
    counting: &[
        (super::CORE, &CORE),
        (super::DIMENSIONS, &DIMENSIONS),
        (super::PIXELS, &PIXELS),
        (super::BAND_BIN, &BAND_BIN),
        (super::MAPPING, &MAPPING),
    ],
    rest: &CUBE,
};
