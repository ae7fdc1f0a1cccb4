//! Why a landscape cannot be exported.

use std::io;
use std::path::PathBuf;

use files::{FileError, FolderError};
use landscape::bank_file::BankFileError;
use picture::PictureError;
use solids::SolidError;
use survey::SurveyError;
use terrain_database::Unfit;

/// A landscape that cannot be exported, or a folder that cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// Posts that make no terrain database.
    #[error("terrain database: {0}")]
    Database(#[from] Unfit),
    /// Heights to which no bank can be fitted.
    #[error(transparent)]
    Survey(#[from] SurveyError),
    /// A boulder whose polyhedron does not close.
    #[error("boulder {number}: {source}; give its feature another `seed`")]
    Boulder {
        /// Number of the boulder in the landscape, from 0.
        number: usize,
        /// What is wrong with the polyhedron.
        source: SolidError,
    },
    /// A picture of the albedo that cannot be made.
    #[error("albedo.png: {0}")]
    Albedo(#[from] PictureError),
    /// A bank that cannot be written.
    #[error(transparent)]
    Bank(#[from] BankFileError),
    /// An array that cannot be written.
    #[error(transparent)]
    Array(#[from] files::NpyFileError),
    /// A file that cannot be written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A folder that cannot be made.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// Something that an export does not replace.
    #[error("{path}: a link or a file; expected a folder, or a new name; name the folder itself", path = .path.display())]
    NoFolder {
        /// Path that was named.
        path: PathBuf,
    },
    /// A folder with files that no export has written.
    #[error("{path}: a folder with {found:?} in it; expected an empty folder, or one from an export; choose another --out", path = .path.display())]
    Strange {
        /// Path of the folder.
        path: PathBuf,
        /// First file that is not of an export.
        found: String,
    },
    /// A failure of the system.
    #[error("{path}: cannot {doing}: {source}", path = .path.display())]
    System {
        /// The folder at fault.
        path: PathBuf,
        /// What was tried, as words after `cannot`.
        doing: &'static str,
        /// What the system says.
        source: io::Error,
    },
}
