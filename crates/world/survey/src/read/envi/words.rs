//! Keys of ENVI headers, and what becomes of each (ENVI documentation, "ENVI Header Files").

use crate::read::words::Fate::{Harmless, Only, Refused, Used, Void};
use crate::read::words::{Vocabulary, named};

/// Text for keys about origin and history.
const ORIGIN: &str = "origin of the file";
/// Text for keys that serve a screen.
const SHOWN: &str = "how a picture is shown";
/// Text for keys about spectra.
const SPECTRA: &str = "light of an image";
/// Text for keys that give a place of another kind.
const PLACE: &str = "a place of the samples of a kind that is not read";
/// Text for keys of classes.
const CLASSES: &str = "samples that are numbers of classes";

/// Keys of a header.
pub const KEYS: Vocabulary = Vocabulary {
    kind: "key of an ENVI header",
    prefix: "",
    words: &[
        named("description", Harmless("text")),
        named("samples", Used("samples of a line")),
        named("lines", Used("lines of samples")),
        named("bands", Used("bands, of which --band chooses")),
        named("header offset", Used("bytes in front of the samples")),
        named("file type", Only(&["ENVI Standard"], "a file that ENVI reads by another driver, or classes")),
        named("data type", Used("1, 2, 3, 4, 5, 12, 13, 14 or 15; complex numbers are refused")),
        named(
            "interleave",
            Used("whether bands lie one after the other (bsq), line by line (bil) or sample by sample (bip)"),
        ),
        named("byte order", Used("0: the lowest byte first, 1: the highest")),
        named("file compression", Only(&["0"], "packed samples")),
        named("major frame offsets", Only(&["0", "0, 0"], "bytes around lines")),
        named("minor frame offsets", Only(&["0", "0, 0"], "bytes around lines")),
        named("x start", Only(&["0", "1"], "a part of a greater image")),
        named("y start", Only(&["0", "1"], "a part of a greater image")),
        named("map info", Used("place and spacing of the samples; a rotation is refused")),
        named("coordinate system string", Used("well-known text, decided by its own table")),
        named("projection info", Harmless("figures of the map, which coordinate system string has")),
        named("data ignore value", Void("stored number that is a void")),
        named("data gain values", Used("units of height a stored unit, one a band")),
        named("data offset values", Used("height of the stored number 0, one a band")),
        named("band names", Used("title of the bank, and names in a message about bands")),
        named("pixel size", Harmless("spacing of the samples, which map info has")),
        named("default bands", Harmless(SHOWN)),
        named("default stretch", Harmless(SHOWN)),
        named("z plot *", Harmless(SHOWN)),
        named("sensor type", Harmless(ORIGIN)),
        named("product type", Harmless(ORIGIN)),
        named("acquisition time", Harmless(ORIGIN)),
        named("collection *", Harmless(ORIGIN)),
        named("security tag", Harmless(ORIGIN)),
        named("timestamp", Harmless(ORIGIN)),
        named("cloud cover", Harmless(ORIGIN)),
        named("sun azimuth", Harmless(ORIGIN)),
        named("sun elevation", Harmless(ORIGIN)),
        named("dem file", Harmless("a file that is not read")),
        named("dem band", Harmless("a file that is not read")),
        named("read procedures", Harmless("programs of ENVI")),
        named("wavelength", Harmless(SPECTRA)),
        named("wavelength units", Harmless(SPECTRA)),
        named("fwhm", Harmless(SPECTRA)),
        named("bbl", Harmless(SPECTRA)),
        named("solar irradiance", Harmless(SPECTRA)),
        named("spectra names", Harmless(SPECTRA)),
        named("reflectance scale factor", Refused("samples that are a share of light")),
        named("data reflectance *", Refused("samples that are a share of light")),
        named("complex function", Refused("complex numbers")),
        named("rpc info", Refused(PLACE)),
        named("geo points", Refused(PLACE)),
        named("class lookup", Refused(CLASSES)),
        named("class names", Refused(CLASSES)),
        named("classes", Refused(CLASSES)),
    ],
};
