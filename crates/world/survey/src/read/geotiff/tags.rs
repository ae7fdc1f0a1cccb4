//! Tags of a TIFF, and what becomes of each (TIFF 6.0; TIFF Technical Notes; OGC GeoTIFF 1.1; GDAL's own tags).

use std::path::Path;

use tiff::decoder::ifd::Value;
use tiff::tags::Tag;

use super::file::Tiff;
use crate::error::SurveyError;
use crate::read::words::Fate::{Harmless, Only, Refused, Used, Void};
use crate::read::words::{Decider, Met, Vocabulary, numbered};

/// Text for tags about origin.
const ORIGIN: &str = "origin of the file";
/// Text for tags that serve a screen or a printer.
const SHOWN: &str = "how a picture is shown or printed";
/// Text for tags of raw camera files and the like.
const ELSEWHERE: &str = "data that lie elsewhere in the file and are not read";
/// Text for tags that give a place of another kind.
const PLACE: &str = "a place of the samples of a kind that is not read";

/// Tags of the first directory.
pub const TAGS: Vocabulary = Vocabulary {
    kind: "TIFF tag",
    prefix: "tag:",
    words: &[
        numbered(254, "NewSubfileType", Only(&["0", "2"], "the first picture is no copy and no mask")),
        numbered(255, "SubfileType", Only(&["1", "3"], "the first picture is no copy")),
        numbered(256, "ImageWidth", Used("samples of a line")),
        numbered(257, "ImageLength", Used("lines of samples")),
        numbered(258, "BitsPerSample", Used("1, 2, 4, 8, 16, 32 or 64 bits; others are refused")),
        numbered(
            259,
            "Compression",
            Only(
                &["1", "5", "8", "32773", "32946", "50000"],
                "how samples are packed; gdal_translate -co COMPRESS=DEFLATE packs them again",
            ),
        ),
        numbered(
            262,
            "PhotometricInterpretation",
            Only(
                &["1"],
                "0 is white that is zero, 2 and 6 are colours, 3 is a palette: a picture; heights are written again with \
                 gdal_translate -co PHOTOMETRIC=MINISBLACK",
            ),
        ),
        numbered(263, "Threshholding", Harmless(SHOWN)),
        numbered(264, "CellWidth", Harmless(SHOWN)),
        numbered(265, "CellLength", Harmless(SHOWN)),
        numbered(266, "FillOrder", Only(&["1"], "bits of a byte in the other order")),
        numbered(269, "DocumentName", Harmless(ORIGIN)),
        numbered(270, "ImageDescription", Harmless("text")),
        numbered(271, "Make", Harmless(ORIGIN)),
        numbered(272, "Model", Harmless(ORIGIN)),
        numbered(273, "StripOffsets", Used("where strips begin; one without a place is void, with a note")),
        numbered(
            274,
            "Orientation",
            Only(&["1"], "a turned or mirrored picture; gdal_translate leaves the tag out"),
        ),
        numbered(277, "SamplesPerPixel", Used("bands, of which --band chooses")),
        numbered(278, "RowsPerStrip", Used("lines of a strip")),
        numbered(279, "StripByteCounts", Used("bytes of strips; one without bytes is void, with a note")),
        numbered(280, "MinSampleValue", Used("least stored number; a note if there is a lower one")),
        numbered(281, "MaxSampleValue", Used("greatest stored number; a note if there is a higher one")),
        numbered(282, "XResolution", Harmless(SHOWN)),
        numbered(283, "YResolution", Harmless(SHOWN)),
        numbered(
            284,
            "PlanarConfiguration",
            Used("whether bands lie sample by sample or one after the other"),
        ),
        numbered(285, "PageName", Harmless(ORIGIN)),
        numbered(286, "XPosition", Harmless(SHOWN)),
        numbered(287, "YPosition", Harmless(SHOWN)),
        numbered(288, "FreeOffsets", Harmless("unused bytes of the file")),
        numbered(289, "FreeByteCounts", Harmless("unused bytes of the file")),
        numbered(290, "GrayResponseUnit", Harmless(SHOWN)),
        numbered(291, "GrayResponseCurve", Harmless(SHOWN)),
        numbered(296, "ResolutionUnit", Harmless(SHOWN)),
        numbered(297, "PageNumber", Harmless(ORIGIN)),
        numbered(301, "TransferFunction", Harmless(SHOWN)),
        numbered(305, "Software", Harmless(ORIGIN)),
        numbered(306, "DateTime", Harmless(ORIGIN)),
        numbered(315, "Artist", Harmless(ORIGIN)),
        numbered(316, "HostComputer", Harmless(ORIGIN)),
        numbered(317, "Predictor", Only(&["1", "2", "3"], "differences between samples")),
        numbered(318, "WhitePoint", Harmless(SHOWN)),
        numbered(319, "PrimaryChromaticities", Harmless(SHOWN)),
        numbered(320, "ColorMap", Refused("samples that are numbers of colours")),
        numbered(321, "HalftoneHints", Harmless(SHOWN)),
        numbered(322, "TileWidth", Used("samples of a line of a tile")),
        numbered(323, "TileLength", Used("lines of a tile")),
        numbered(324, "TileOffsets", Used("where tiles begin; one without a place is void, with a note")),
        numbered(325, "TileByteCounts", Used("bytes of tiles; one without bytes is void, with a note")),
        numbered(330, "SubIFDs", Used("pictures below this one, masks too, are not read, with a note")),
        numbered(338, "ExtraSamples", Used("which bands are alpha: voids where it is 0")),
        numbered(339, "SampleFormat", Only(&["1", "2", "3"], "complex numbers, or none that are said")),
        numbered(340, "SMinSampleValue", Used("as MinSampleValue")),
        numbered(341, "SMaxSampleValue", Used("as MaxSampleValue")),
        numbered(532, "ReferenceBlackWhite", Harmless(SHOWN)),
        numbered(700, "XMP", Harmless("text")),
        numbered(32781, "ImageID", Harmless(ORIGIN)),
        numbered(32995, "Matteing", Refused("an alpha band of an old kind")),
        numbered(32996, "DataType", Refused("a sample type of an old kind")),
        numbered(32997, "ImageDepth", Only(&["1"], "several layers of samples")),
        numbered(32998, "TileDepth", Only(&["1"], "several layers of samples")),
        numbered(33432, "Copyright", Harmless(ORIGIN)),
        numbered(
            33550,
            "ModelPixelScaleTag",
            Used("spacing of the samples; the third number must be 0 or 1"),
        ),
        numbered(33723, "IPTC", Harmless("text")),
        numbered(33918, "INGRPacketDataTag", Refused(PLACE)),
        numbered(33919, "INGRFlagRegisters", Refused(PLACE)),
        numbered(33920, "IntergraphMatrixTag", Refused(PLACE)),
        numbered(
            33922,
            "ModelTiepointTag",
            Used("place of a sample; further ones must lie on the same grid"),
        ),
        numbered(
            34264,
            "ModelTransformationTag",
            Used("place and spacing of the samples; turned grids are refused"),
        ),
        numbered(34377, "Photoshop", Harmless(SHOWN)),
        numbered(34665, "EXIF", Harmless(ORIGIN)),
        numbered(34675, "ICCProfile", Harmless(SHOWN)),
        numbered(34735, "GeoKeyDirectoryTag", Used("geo keys, each decided by its own table")),
        numbered(34736, "GeoDoubleParamsTag", Used("numbers of geo keys")),
        numbered(34737, "GeoAsciiParamsTag", Harmless("names of geo keys, for people")),
        numbered(34853, "GPSInfo", Harmless("where a camera stood")),
        numbered(37724, "ImageSourceData", Harmless(SHOWN)),
        numbered(42112, "GDAL_METADATA", Used("items, each decided by its own table")),
        numbered(42113, "GDAL_NODATA", Used("stored number that is a void")),
        numbered(50838, "IJMetadataByteCounts", Harmless(ELSEWHERE)),
        numbered(50839, "IJMetadata", Harmless(ELSEWHERE)),
        numbered(50844, "RPCCoefficient", Refused(PLACE)),
        numbered(50908, "TIFF_RSID", Harmless(ORIGIN)),
        numbered(50909, "GEO_METADATA", Harmless("text")),
    ],
};

/// Name of a tag for messages: `tag 258 (BitsPerSample)`.
pub fn place(number: u16) -> String {
    match TAGS.of_number(number) {
        Some(word) => format!("tag {number} ({})", word.name),
        None => format!("tag {number}"),
    }
}

/// Decides every tag of the first directory.
///
/// # Errors
/// If one is refused or unknown.
pub fn decide(path: &Path, tiff: &mut Tiff, decider: &mut Decider) -> Result<(), SurveyError> {
    let numbers: Vec<u16> = tiff.image_ifd().directory().iter().map(|(tag, _)| tag.to_u16()).collect();
    for number in numbers {
        let (word, place) = (TAGS.of_number(number), place(number));
        let value = match word.map(|word| word.fate) {
            // The value of an unknown tag may be of any kind and size.
            None | Some(Used(_) | Void(_) | Harmless(_)) => "a value".into(),
            Some(Only(..) | Refused(_)) => {
                let failed = |source| SurveyError::Tiff { path: path.into(), place: place.clone(), source };
                text(tiff.find_tag(Tag::from_u16_exhaustive(number)).map_err(failed)?)
            }
        };
        decider.decide(Met { of: &TAGS, word, place: &place, name: &number.to_string(), value: &value })?;
    }
    Ok(())
}

/// A value of a tag as text: one number if all are equal.
fn text(value: Option<Value>) -> String {
    let numbers = value.and_then(numbers).unwrap_or_default();
    match numbers.split_first() {
        Some((first, rest)) if rest.iter().all(|number| number == first) => first.to_string(),
        Some(_) => format!("{numbers:?}"),
        None => "a value that is no number".into(),
    }
}

/// The numbers of a value, whole or not; `None` for text and the like.
pub fn numbers(value: Value) -> Option<Vec<f64>> {
    match value {
        Value::List(values) => values.into_iter().map(number).collect(),
        value => Some(vec![number(value)?]),
    }
}

fn number(value: Value) -> Option<f64> {
    Some(match value {
        Value::Byte(number) => number.into(),
        Value::SignedByte(number) => number.into(),
        Value::Short(number) => number.into(),
        Value::SignedShort(number) => number.into(),
        Value::Unsigned(number) => number.into(),
        Value::Signed(number) => number.into(),
        Value::UnsignedBig(number) => number as f64,
        Value::SignedBig(number) => number as f64,
        Value::Float(number) => number.into(),
        Value::Double(number) => number,
        _ => return None,
    })
}
