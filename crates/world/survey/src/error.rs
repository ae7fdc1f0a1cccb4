//! Everything that can be wrong with an elevation file or with what is asked of it.

use std::io;
use std::path::PathBuf;

use landscape::BankError;
use limits::Limit;

use crate::read::listed;

/// Each message names the file, the place in it, what was found and expected, and what to do.
#[derive(Debug, thiserror::Error)]
pub enum SurveyError {
    /// The file cannot be read.
    #[error("{path}: cannot be read ({source}); expected an elevation file; check the name and permissions", path = .path.display())]
    Read {
        /// Path of the file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// A file that cannot be opened, or a folder or a device in place of one.
    #[error(transparent)]
    File(#[from] files::FileError),
    /// More heights than may be in memory.
    #[error("{path}: {lines} x {columns} samples take {bytes} bytes of memory; expected at most {most}; survey a smaller area of it (--area, or --centre with --size-m); {advice}", path = .path.display(), advice = Limit::ElevationBytes)]
    TooLarge {
        /// Path of the file.
        path: PathBuf,
        /// Lines that were asked for.
        lines: usize,
        /// Samples of a line that were asked for.
        columns: usize,
        /// Bytes that their heights take.
        bytes: u64,
        /// Largest number of bytes that is allowed.
        most: u64,
    },
    /// None of the formats read here.
    #[error("{path}: starts with {found}; expected a TIFF, a label of PDS3, PDS4 or ISIS, an ENVI header, an Arc ASCII grid, a DTED cell, an SRTM tile (NAME.hgt) or a NumPy array; convert it with gdal_translate -of GTiff", path = .path.display())]
    UnknownFormat {
        /// Path of the file.
        path: PathBuf,
        /// First bytes of the file, as text for the message.
        found: String,
    },
    /// The TIFF decoder gives up.
    #[error("{path}, {place}: {source}; expected a whole TIFF of a kind that is read here; if the file is complete, convert it with gdal_translate -of GTiff -co COMPRESS=DEFLATE", path = .path.display())]
    Tiff {
        /// Path of the file.
        path: PathBuf,
        /// Part of the file.
        place: String,
        /// What the decoder says.
        source: tiff::TiffError,
    },
    /// A field of a header has an unusable value.
    #[error("{path}, {place}: found {found}; expected {expected}; {advice}", path = .path.display())]
    Field {
        /// Path of the file.
        path: PathBuf,
        /// Tag, key or label line and keyword.
        place: String,
        /// Value that the field has.
        found: String,
        /// What could stand there.
        expected: String,
        /// Advice: what the user can do.
        advice: String,
    },
    /// The file has fewer bytes than its header asks for.
    #[error("{path}, {place}: the file has {found} bytes; expected at least {expected}; it is truncated, or its header is wrong: fetch it again", path = .path.display())]
    Truncated {
        /// Path of the file.
        path: PathBuf,
        /// What needs the bytes.
        place: String,
        /// Number of bytes in the file.
        found: u64,
        /// Number of bytes that its header asks for.
        expected: u64,
    },
    /// Raster with fewer than 2 lines or 2 columns.
    #[error("{path}: the raster has {lines} lines of {columns} samples; expected at least 2 x 2; it holds no ground", path = .path.display())]
    Empty {
        /// Path of the file.
        path: PathBuf,
        /// Number of lines in the raster.
        lines: u64,
        /// Number of samples a line.
        columns: u64,
    },
    /// Several bands and none chosen.
    #[error("{path}: has {count} bands, none chosen: {list}; expected the number of the band with heights; give --band N", path = .path.display())]
    BandNotChosen {
        /// Path of the file.
        path: PathBuf,
        /// Bands in the file.
        count: usize,
        /// Number and description of each.
        list: String,
    },
    /// A band was chosen that the file does not have.
    #[error("{path}: band {chosen} chosen; expected 1 to {count}: {list}", path = .path.display())]
    NoSuchBand {
        /// Path of the file.
        path: PathBuf,
        /// Number of the band that was asked for.
        chosen: usize,
        /// Bands in the file.
        count: usize,
        /// Number and description of each.
        list: String,
    },
    /// Sample that is no height on the Moon and not the no-data value.
    #[error("{path}, line {line}, column {column} (from 0): found {value:?}; expected a height within half a lunar radius of the lunoid, a radius as the other samples have, or the no-data value; if it marks voids, give --no-data {list}", path = .path.display(), list = listed(.voids))]
    NotFinite {
        /// Path of the file.
        path: PathBuf,
        /// Line of the sample, counted from 0.
        line: usize,
        /// Column of the sample, counted from 0.
        column: usize,
        /// Value of the sample that was found.
        value: f64,
        /// Marks of voids that are known already, and this value.
        voids: Vec<f64>,
    },
    /// All samples of a file or an area are voids.
    #[error(
        "{what}: all {count} samples are void; expected heights; check the no-data value, the band and the area"
    )]
    AllVoid {
        /// Name of the file or the area.
        what: String,
        /// Number of samples in it.
        count: usize,
    },
    /// The spacing of a file without one was not given.
    #[error("{path}: a .npy array does not say how far its samples are apart; expected a spacing; give --spacing-m METRES", path = .0.display())]
    NoSpacing(PathBuf),
    /// An option has an unusable value.
    #[error("{option}: found {found}; expected {expected}")]
    Option {
        /// Name of the option.
        option: &'static str,
        /// Value that the option was given.
        found: String,
        /// Values that can be.
        expected: String,
    },
    /// The area does not lie in the file.
    #[error(
        "area {found}: expected it inside {extent} of the file; give a smaller area or one in the file's own coordinates"
    )]
    AreaOutside {
        /// Area that was asked for, as text.
        found: String,
        /// Extent of the file.
        extent: String,
    },
    /// The kind of area does not go with the file.
    #[error("area {found}: {reason}; {advice}")]
    AreaKind {
        /// Kind of area that was asked for.
        found: &'static str,
        /// Reason why that kind does not go with the file.
        reason: &'static str,
        /// Advice: what the user can do.
        advice: &'static str,
    },
    /// Far more words than samples.
    #[error(
        "region size {size} m: {coefficients} coefficients for {samples} samples; expected at most {most}; give larger regions"
    )]
    TooManyRegions {
        /// Side of a region that was asked for (m).
        size: f64,
        /// Words of the level.
        coefficients: usize,
        /// Samples in the area.
        samples: usize,
        /// Most coefficients that are allowed for so many samples.
        most: usize,
    },
    /// A `.npy` file is missing or damaged.
    #[error(transparent)]
    Npy(#[from] files::NpyFileError),
    /// The fit cannot be a bank.
    #[error("the fit is not a bank: {0}")]
    Bank(#[from] BankError),
}
