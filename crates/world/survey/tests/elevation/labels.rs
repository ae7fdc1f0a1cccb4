//! Labels and headers of the made heights (see `made`): 24 x 24 quarter metres, 10 m apart, equirectangular on the Moon. One
//! element, keyword or key stands on a line, so that it can be replaced.

use crate::made::{Made, SIDE, heights, quarters, words};

/// A PDS4 label, whose samples stand in `made.dat`.
pub const PDS4: &str = include_str!("ground.xml");

/// An ISIS label, whose samples stand from byte 4097 on.
pub const ISIS: &str = include_str!("ground.pvl");

/// An ENVI header, whose samples stand in `made.dat`.
pub const ENVI: &str = include_str!("ground.hdr");

/// A coordinate system as a `.prj` has it.
pub const PRJ: &str = include_str!("ground.prj");

/// The head of an Arc ASCII grid.
pub const HEAD: &str = "ncols 24
nrows 24
xllcorner 10000
yllcorner 19760
cellsize 10
NODATA_value -1
";

/// A PDS4 label with the made samples, and more behind them.
pub fn pds4(label: &str) -> Made {
    let samples = [words(&quarters()), vec![0; 2048]].concat();
    Made::new(&[("made.xml", label.as_bytes()), ("made.dat", &samples)])
}

/// A cube with the made samples.
pub fn isis(label: &str) -> Made {
    Made::new(&[("made.cub", &cube(label, &words(&quarters())))])
}

/// The bytes of a cube whose core stands from byte 4097 on.
pub fn cube(label: &str, core: &[u8]) -> Vec<u8> {
    let mut bytes = label.as_bytes().to_vec();
    bytes.resize(4096, b' ');
    [bytes, core.to_vec(), vec![0; 2048]].concat()
}

/// A header with the made samples, and more behind them.
pub fn envi(header: &str) -> Made {
    let samples = [words(&quarters()), vec![0; 2048]].concat();
    Made::new(&[("made.hdr", header.as_bytes()), ("made.dat", &samples)])
}

/// A grid with the made heights as text, and its coordinate system.
pub fn ascii(head: &str, prj: &str) -> Made {
    Made::new(&[("made.asc", format!("{head}{}", numbers()).as_bytes()), ("made.prj", prj.as_bytes())])
}

/// The made heights as lines of text.
pub fn numbers() -> String {
    let line = |line: &[f64]| line.iter().map(f64::to_string).collect::<Vec<_>>().join(" ") + "\n";
    heights().chunks(SIDE).map(line).collect()
}

/// `text` with one part replaced, which it must have once.
pub fn replaced(text: &str, old: &str, new: &str) -> String {
    assert_eq!(text.matches(old).count(), 1, "{old}");
    text.replace(old, new)
}
