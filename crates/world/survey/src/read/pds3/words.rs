//! Keywords and objects of PDS3 labels, and what becomes of each (Planetary Data System Data Dictionary; Standards
//! Reference 3.8).

use crate::read::words::Fate::{Harmless, Only, Refused, Used, Void};
use crate::read::words::{Vocabulary, Word, named};

/// Text for a whole object that is not the image.
const OTHER_DATA: &str = "another piece of data, with statements of its own";
/// Text for keywords about origin, instrument and time.
const ORIGIN: &str = "origin of the product";
/// Text for numbers that were counted from the samples.
const STATISTICS: &str = "a figure counted from the samples";
/// Text for marks of voids.
const MARK: &str =
    "stored numbers that are voids: a number, bits as `16#FF7FFFFB#`, a range `1..5`, or a list";

/// Kinds of latitude, which are one on a sphere; a note tells of an ellipsoid.
const LATITUDES: &[&str] = &["PLANETOCENTRIC", "PLANETOGRAPHIC", "N/A"];

/// Objects and groups of a label.
pub const OBJECTS: Vocabulary = Vocabulary {
    kind: "object or group of a PDS3 label",
    prefix: "object:",
    words: &[
        named("IMAGE", Used("the samples; a label with two is refused")),
        named("IMAGE_MAP_PROJECTION", Used("place of the samples; a label with two is refused")),
        named("FILE", Used("the file of the image and its records")),
        named("UNCOMPRESSED_FILE", Used("the file of the image and its records")),
        named("COMPRESSED_FILE", Harmless("a packed copy beside the image")),
        named("*_IMAGE", Harmless(OTHER_DATA)),
        named("*TABLE", Harmless(OTHER_DATA)),
        named("*SERIES", Harmless(OTHER_DATA)),
        named("*SPECTRUM", Harmless(OTHER_DATA)),
        named("*HISTOGRAM", Harmless(OTHER_DATA)),
        named("*HEADER", Harmless(OTHER_DATA)),
        named("*PALETTE", Harmless(OTHER_DATA)),
        named("*TEXT", Harmless(OTHER_DATA)),
        named("*DOCUMENT", Harmless(OTHER_DATA)),
        named("*CATALOG", Harmless(OTHER_DATA)),
        named("*QUBE", Harmless(OTHER_DATA)),
        named("ARRAY", Harmless(OTHER_DATA)),
        named("COLLECTION", Harmless(OTHER_DATA)),
        named("DATA_SET_MAP_PROJECTION", Harmless("the archive's text about its maps")),
        named("VIEWING_PARAMETERS", Harmless("how the pictures were taken")),
        named("*PARAMETERS", Harmless("how the instrument worked")),
        named("*PARMS", Harmless("how the instrument worked")),
        named("*COORDINATE_SYSTEM", Harmless("axes of the spacecraft or instrument")),
        named("*CAMERA_MODEL", Harmless("geometry of a camera")),
        named("SOFTWARE", Harmless("programs of the producer")),
    ],
};

/// Keywords outside of the image and its projection.
pub const FILE: Vocabulary = Vocabulary {
    kind: "keyword of a PDS3 label",
    prefix: "",
    words: &[
        named("PDS_VERSION_ID", Only(&["PDS3"], "version of the label")),
        named("ODL_VERSION_ID", Harmless("version of the label's language")),
        named("CCSD3ZF*", Harmless("mark of the label's language")),
        named("NJPL*", Harmless("mark of the label's language")),
        named("^IMAGE", Used("file and first record or byte of the image")),
        named("RECORD_TYPE", Only(&["FIXED_LENGTH", "UNDEFINED", "STREAM"], "how a file is divided")),
        named("RECORD_BYTES", Used("bytes of a record, of the file object around ^IMAGE or of the label")),
        named("FILE_NAME", Used("the file of a pointer without a file name, in a file object")),
        named("FILE_RECORDS", Harmless("length of the file, which is checked against the image")),
        named("LABEL_RECORDS", Harmless("length of the label, whose end is found by itself")),
        named("INTERCHANGE_FORMAT", Only(&["BINARY"], "how numbers are written")),
        named("ENCODING_TYPE", Only(&["N/A", "NONE", "NULL"], "a packed image")),
        named("^IMAGE_MAP_PROJECTION", Refused("place of the samples in another file")),
        named("^STRUCTURE", Refused("statements in another file")),
        named("^*", Harmless("place of another piece of data or text")),
        named("MISSING_CONSTANT", Void(MARK)),
        named("INVALID_CONSTANT", Void(MARK)),
        named("NULL_CONSTANT", Void(MARK)),
        named("UNKNOWN_CONSTANT", Void(MARK)),
        named("NOT_APPLICABLE_CONSTANT", Void(MARK)),
        named("SOFTWARE_*", Harmless(ORIGIN)),
        named("PRODUCT_*", Harmless(ORIGIN)),
        named("PRODUCER_*", Harmless(ORIGIN)),
        named("SOURCE_*", Harmless(ORIGIN)),
        named("INSTRUMENT_*", Harmless(ORIGIN)),
        named("SPACECRAFT_*", Harmless(ORIGIN)),
        named("DATA_SET_*", Harmless(ORIGIN)),
        named("DATA_OBJECT_TYPE", Harmless(ORIGIN)),
        named("DATA_QUALITY_*", Harmless(ORIGIN)),
        named("MISSION_*", Harmless(ORIGIN)),
        named("ORBIT*", Harmless(ORIGIN)),
        named("*_ORBIT_NUMBER", Harmless(ORIGIN)),
        named("TARGET_NAME", Harmless("the body; its radius is A_AXIS_RADIUS")),
        named("TARGET_*", Harmless(ORIGIN)),
        named("OBSERVATION_*", Harmless(ORIGIN)),
        named("SEQUENCE_*", Harmless(ORIGIN)),
        named("*_DESC", Harmless("text")),
        named("*_NOTE", Harmless("text")),
        named("*_COMMENT", Harmless("text")),
        named("NOTE", Harmless("text")),
        named("DESCRIPTION", Harmless("text")),
        named("COMMENT", Harmless("text")),
        named("*_NAME", Harmless("text")),
        named("*_FLAG", Harmless("how the product was made")),
        named("*_ID", Harmless(ORIGIN)),
        named("*_TIME", Harmless(ORIGIN)),
        named("*_DATE", Harmless(ORIGIN)),
        named("*_COUNT", Harmless(ORIGIN)),
        named("*_DURATION", Harmless("how the picture was taken")),
        named("*_TEMPERATURE", Harmless("how the picture was taken")),
        named("*_ANGLE", Harmless("how the picture was taken")),
        named("*_AZIMUTH", Harmless("how the picture was taken")),
        named("*_DISTANCE", Harmless("how the picture was taken")),
        named("*_ALTITUDE", Harmless("how the picture was taken")),
        named("*_LATITUDE", Harmless("outline of the product; its place is the projection's")),
        named("*_LONGITUDE", Harmless("outline of the product; its place is the projection's")),
        named("*_RESOLUTION", Harmless("outline of the product; its place is the projection's")),
        named("*_VERSION", Harmless(ORIGIN)),
        named("*_TYPE", Harmless(ORIGIN)),
        named("*_CHECKSUM", Harmless("not checked")),
        named("*:*", Harmless("a mission's own keyword")),
    ],
};

/// Keywords of the object IMAGE.
pub const IMAGE: Vocabulary = Vocabulary {
    kind: "keyword of IMAGE in a PDS3 label",
    prefix: "",
    words: &[
        named("LINES", Used("lines of samples")),
        named("LINE_SAMPLES", Used("samples of a line")),
        named("SAMPLE_TYPE", Used("integer or real, signed or not, order of bytes")),
        named("SAMPLE_BITS", Used("bits of a sample: 8, 16 or 32 of integers, 32 or 64 of reals")),
        named("SAMPLE_BIT_MASK", Used("which bits hold the number: all, else refused")),
        named("LINE_PREFIX_BYTES", Used("bytes before the samples of a line")),
        named("LINE_SUFFIX_BYTES", Used("bytes behind the samples of a line")),
        named("BANDS", Used("bands, of which --band chooses")),
        named("BAND_STORAGE_TYPE", Used("order of bands: sequential, else refused if there are several")),
        named("SCALING_FACTOR", Used("units of height a stored unit: one number, or one a band")),
        named("OFFSET", Used("height of the stored number 0: one number, or one a band")),
        named("UNIT", Used("unit of the heights; metres without it, with a note")),
        named("NAME", Used("title of the bank")),
        named("CORE_NULL", Void(MARK)),
        named("CORE_LOW_REPR_SATURATION", Void(MARK)),
        named("CORE_LOW_INSTR_SATURATION", Void(MARK)),
        named("CORE_HIGH_INSTR_SATURATION", Void(MARK)),
        named("CORE_HIGH_REPR_SATURATION", Void(MARK)),
        named("NULL", Void(MARK)),
        named("LOW_REPR_SATURATION", Void(MARK)),
        named("LOW_INSTR_SATURATION", Void(MARK)),
        named("HIGH_INSTR_SATURATION", Void(MARK)),
        named("HIGH_REPR_SATURATION", Void(MARK)),
        named("LOW_REPR_SAT", Void(MARK)),
        named("LOW_INSTR_SAT", Void(MARK)),
        named("HIGH_INSTR_SAT", Void(MARK)),
        named("HIGH_REPR_SAT", Void(MARK)),
        named("SATURATION_CONSTANT", Void(MARK)),
        named("MISSING", Void(MARK)),
        named("MISSING_CONSTANT", Void(MARK)),
        named("INVALID", Void(MARK)),
        named("INVALID_CONSTANT", Void(MARK)),
        named("NULL_CONSTANT", Void(MARK)),
        named("UNKNOWN_CONSTANT", Void(MARK)),
        named("NOT_APPLICABLE_CONSTANT", Void(MARK)),
        named("ERROR_CONSTANT", Void(MARK)),
        named("VALID_MINIMUM", Used("least stored number that is a height; below it are voids, with a note")),
        named(
            "VALID_MAXIMUM",
            Used("greatest stored number that is a height; above it are voids, with a note"),
        ),
        named("CORE_VALID_MINIMUM", Used("as VALID_MINIMUM")),
        named("CORE_VALID_MAXIMUM", Used("as VALID_MAXIMUM")),
        named("MINIMUM", Used("least stored number; a note if there is a lower one")),
        named("MAXIMUM", Used("greatest stored number; a note if there is a higher one")),
        named("DERIVED_MINIMUM", Harmless(STATISTICS)),
        named("DERIVED_MAXIMUM", Harmless(STATISTICS)),
        named("MEAN", Harmless(STATISTICS)),
        named("MEDIAN", Harmless(STATISTICS)),
        named("STANDARD_DEVIATION", Harmless(STATISTICS)),
        named("CHECKSUM", Harmless("not checked")),
        named("MD5_CHECKSUM", Harmless("not checked")),
        named("SATURATED_PIXEL_COUNT", Harmless(STATISTICS)),
        named("DESCRIPTION", Harmless("text")),
        named("NOTE", Harmless("text")),
        named("INTERCHANGE_FORMAT", Only(&["BINARY"], "how numbers are written")),
        named("ENCODING_TYPE", Only(&["N/A", "NONE", "NULL"], "a packed image")),
        named("COMPRESSION_TYPE", Only(&["N/A", "NONE", "NULL"], "a packed image")),
        named("^STRUCTURE", Refused("statements in another file")),
        named("LINE_DISPLAY_DIRECTION", Only(&["DOWN"], "an image upside down")),
        named("SAMPLE_DISPLAY_DIRECTION", Only(&["RIGHT"], "a mirrored image")),
        named("FIRST_LINE", Only(&["1"], "a part of a greater image")),
        named("FIRST_LINE_SAMPLE", Only(&["1"], "a part of a greater image")),
        named("SAMPLING_FACTOR", Only(&["1"], "a thinned image")),
        named("SOURCE_LINES", Harmless("lines that the image was cut from")),
        named("SOURCE_LINE_SAMPLES", Harmless("samples that the image was cut from")),
        named("BAND_NAME", Harmless("text")),
        named("BAND_SEQUENCE", Harmless("text")),
        named("FILTER_NAME", Harmless("text")),
        named("CENTER_FILTER_WAVELENGTH", Harmless("light of an image")),
        named("BANDWIDTH", Harmless("light of an image")),
        named("DETECTOR_*", Harmless("how the picture was taken")),
    ],
};

/// Keywords of the object IMAGE_MAP_PROJECTION.
pub const MAP: Vocabulary = Vocabulary {
    kind: "keyword of IMAGE_MAP_PROJECTION in a PDS3 label",
    prefix: "",
    words: &[
        named("MAP_PROJECTION_TYPE", Used("simple cylindrical, equirectangular or polar stereographic")),
        named("MAP_SCALE", Used("length of a sample; km without a unit, as the data dictionary has it")),
        named("MAP_RESOLUTION", Used("samples a degree; refused if MAP_SCALE contradicts it")),
        named("LINE_PROJECTION_OFFSET", Used("lines from the first to the origin of the projection")),
        named("SAMPLE_PROJECTION_OFFSET", Used("samples from the first to the origin of the projection")),
        named("A_AXIS_RADIUS", Used("radius of the sphere; km without a unit")),
        named("B_AXIS_RADIUS", Used("a note if it is another than A_AXIS_RADIUS")),
        named("C_AXIS_RADIUS", Used("a note if it is another than A_AXIS_RADIUS")),
        named("CENTER_LATITUDE", Used("latitude of the origin, or the parallel that is true to scale")),
        named("CENTER_LONGITUDE", Used("longitude of the origin")),
        named("FIRST_STANDARD_PARALLEL", Used("refused if it is another than CENTER_LATITUDE")),
        named("SECOND_STANDARD_PARALLEL", Used("refused if it is another than CENTER_LATITUDE")),
        named("POSITIVE_LONGITUDE_DIRECTION", Only(&["EAST"], "longitudes that grow to the west")),
        named("MAP_PROJECTION_ROTATION", Only(&["0", "360", "N/A", "NULL"], "a turned grid")),
        named("REFERENCE_LATITUDE", Only(&["0", "N/A", "NULL", "NONE"], "an oblique projection")),
        named("REFERENCE_LONGITUDE", Only(&["0", "N/A", "NULL", "NONE"], "another prime meridian")),
        named("LINE_FIRST_PIXEL", Only(&["1", "N/A", "NULL"], "offsets that count from another line")),
        named("SAMPLE_FIRST_PIXEL", Only(&["1", "N/A", "NULL"], "offsets that count from another sample")),
        named("LINE_LAST_PIXEL", Used("a note if it is not the last line of the image")),
        named("SAMPLE_LAST_PIXEL", Used("a note if it is not the last sample of a line")),
        named("MAXIMUM_LATITUDE", Used("a note if the offsets of a simple cylindrical map say otherwise")),
        named(
            "WESTERNMOST_LONGITUDE",
            Used("a note if the offsets of a simple cylindrical map say otherwise"),
        ),
        named("MINIMUM_LATITUDE", Harmless("an edge that follows from the others")),
        named("EASTERNMOST_LONGITUDE", Harmless("an edge that follows from the others")),
        named("COORDINATE_SYSTEM_NAME", Used("a note if it is not the mean Earth system or planetocentric")),
        named(
            "COORDINATE_SYSTEM_TYPE",
            Only(&["BODY-FIXED ROTATING", "N/A"], "axes that are not the body's"),
        ),
        named("PROJECTION_LATITUDE_TYPE", Only(LATITUDES, "what a latitude is; the same on a sphere")),
        named("KEYWORD_LATITUDE_TYPE", Only(LATITUDES, "what a latitude is; the same on a sphere")),
        named("^DATA_SET_MAP_PROJECTION", Harmless("the archive's text about its maps")),
        named("^STRUCTURE", Refused("statements in another file")),
        named("MAP_PROJECTION_DESC", Harmless("text")),
        named("DESCRIPTION", Harmless("text")),
        named("NOTE", Harmless("text")),
        named("HORIZONTAL_FRAMELET_OFFSET", Harmless("place of the image in the archive's mosaic")),
        named("VERTICAL_FRAMELET_OFFSET", Harmless("place of the image in the archive's mosaic")),
        named("ROTATIONAL_ELEMENT_DESC", Harmless("text")),
    ],
};

/// The row of a statement outside of objects that are decided as a whole.
pub fn vocabulary(object: &str) -> &'static Vocabulary {
    match object {
        "IMAGE" => &IMAGE,
        "IMAGE_MAP_PROJECTION" => &MAP,
        _ => &FILE,
    }
}

/// Whether the values of a keyword mark voids.
pub fn is_void(word: Option<&Word>) -> bool {
    word.is_some_and(|word| matches!(word.fate, Void(_)))
}
