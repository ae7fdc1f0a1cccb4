//! Why no folder is written.

use std::io;
use std::path::PathBuf;

use files::{FileError, FolderError};

/// What keeps a site from being built.
#[derive(Debug, thiserror::Error)]
pub enum SiteError {
    /// A file that cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A folder that cannot be made.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// A failure of the system.
    #[error("{path}: cannot {doing}: {source}")]
    System {
        /// File or folder that it happened to.
        path: PathBuf,
        /// What was tried, as words after `cannot`.
        doing: &'static str,
        /// What the system says.
        source: io::Error,
    },
    /// The folder is something else.
    #[error(
        "{0}: found a folder that is no site, expected one of an earlier build or a new name; choose another --out"
    )]
    NoSite(PathBuf),
    /// The target of the module is not installed.
    #[error("the target {0} is not installed; `rustup target add {0}` installs it")]
    NoTarget(&'static str),
    /// What MkDocs says where it fails: among it the page, and what is wrong there.
    #[error("MkDocs cannot make the books:\n{0}")]
    Books(String),
    /// Cargo has failed, or cannot be started.
    #[error("cargo cannot {0}; its own message stands above")]
    Cargo(&'static str),
}
