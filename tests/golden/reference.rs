//! Reference pictures: read, compared to the pixel, and made by one path only.

use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

use compare::{compare, triptych};
use picture::{GreyPicture, Limits, read_png, write_png};

/// Grey levels by which a difference is enlarged in the picture of a failure.
const FACTOR: u32 = 16;

/// Where references lie and where failures are shown.
#[derive(Debug)]
pub struct Shelf {
    references: PathBuf,
    failures: PathBuf,
    bless: bool,
}

/// Why a frame is not the reference.
#[derive(Debug, PartialEq)]
pub enum Differs {
    /// No reference of this name.
    Missing(PathBuf),
    /// The reference was written now, and nobody has looked at it.
    Blessed(PathBuf),
    /// The reference has another size.
    Size { found: [usize; 2], expected: [usize; 2] },
    /// Some pixels are not equal.
    Pixels { differing: usize, most: u32, worst: [usize; 2], shown: PathBuf },
}

impl Shelf {
    /// The references of the repository. Only `LUNOID_BLESS=1` lets them be written.
    pub fn of_repository() -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        Self {
            references: root.join("golden"),
            failures: Path::new(env!("CARGO_TARGET_TMPDIR")).join("golden"),
            bless: std::env::var("LUNOID_BLESS").is_ok_and(|value| value == "1"),
        }
    }

    /// References and failures in a folder of a test.
    pub fn in_folder(folder: &Path, bless: bool) -> Self {
        Self { references: folder.to_owned(), failures: folder.join("failures"), bless }
    }

    /// Where the reference `name` lies.
    pub fn path(&self, name: &str) -> PathBuf {
        self.references.join(format!("{name}.png"))
    }

    /// Holds `found` against the reference `name`: not one pixel may differ. A reference that is missing or not
    /// equal is written where blessing is on, and the test fails still: it passes once somebody ran it again.
    ///
    /// # Panics
    /// If a file of the reference or of the failure cannot be read or written.
    pub fn hold(&self, name: &str, found: &GreyPicture) -> Result<(), Differs> {
        let path = self.path(name);
        let differs = if path.exists() {
            let expected = read_png(&path, &Limits::default()).unwrap_or_else(|error| panic!("{error}"));
            self.difference(name, found, &expected)
        } else {
            Err(Differs::Missing(path.clone()))
        };
        if differs.is_err() && self.bless {
            write_png(&path, found, &[]).unwrap_or_else(|error| panic!("{error}"));
            return Err(Differs::Blessed(path));
        }
        differs
    }

    fn difference(&self, name: &str, found: &GreyPicture, expected: &GreyPicture) -> Result<(), Differs> {
        let size = |picture: &GreyPicture| [picture.columns(), picture.lines()];
        if size(found) != size(expected) || found.depth() != expected.depth() {
            return Err(Differs::Size { found: size(found), expected: size(expected) });
        }
        if found.codes() == expected.codes() {
            return Ok(());
        }
        let pairs = found.codes().iter().zip(expected.codes());
        let most = pairs.map(|(a, b)| u32::from(a.abs_diff(*b))).max().unwrap_or(0);
        let comparison = compare(found, expected, None, &[]).expect("pictures of one size");
        let worst = [comparison.worst.column, comparison.worst.line];
        let shown = self.show(name, found, expected);
        Err(Differs::Pixels { differing: comparison.differing, most, worst, shown })
    }

    /// Found, expected and their difference side by side.
    fn show(&self, name: &str, found: &GreyPicture, expected: &GreyPicture) -> PathBuf {
        fs::create_dir_all(&self.failures).expect("a folder below target");
        let shown = self.failures.join(format!("{name}.png"));
        let picture = triptych(found, expected, FACTOR).expect("pictures of one size");
        write_png(&shown, &picture, &[]).expect("a picture below target");
        shown
    }
}

impl fmt::Display for Differs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing(path) => {
                write!(f, "{}: no reference; LUNOID_BLESS=1 writes it, look at it, run again", path.display())
            }
            Self::Blessed(path) => {
                write!(f, "{}: written now; look at it, then run again without LUNOID_BLESS", path.display())
            }
            Self::Size { found, expected } => write!(f, "{found:?} pixels, expected {expected:?}"),
            Self::Pixels { differing, most, worst: [column, line], shown } => write!(
                f,
                "{differing} pixels differ, by up to {most} levels, most at column {column}, line {line}; \
                 found, expected and difference: {}",
                shown.display()
            ),
        }
    }
}
