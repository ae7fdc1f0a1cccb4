//! What can go wrong with a file, and what to do about it.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use limits::Limit;

use crate::kind::Kind;

/// A file that could not be read or written. Every message begins with the path.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// There is no file of this name.
    #[error("{path}: no such file; check the spelling")]
    Missing {
        /// The path as given.
        path: PathBuf,
    },
    /// A folder stands where a file is needed.
    #[error("{path}: {action}: this is a folder, expected a file; name a file inside it")]
    IsFolder {
        /// The path as given.
        path: PathBuf,
        /// Step that was being tried.
        action: Action,
    },
    /// A link, a pipe or a device stands where a file is needed.
    #[error("{path}: {action}: this is {}, expected a file{}", kind.phrase(), remedy(*kind, *action))]
    NoFile {
        /// The path as given.
        path: PathBuf,
        /// Step that was being tried.
        action: Action,
        /// What stands there instead.
        kind: Kind,
    },
    /// A file of the program's own that another name leads to as well.
    #[error(
        "{path}: {action}: this file has another name too (a hard link), expected a file with one name; remove it, or \
         choose another place"
    )]
    OtherNames {
        /// The path as given.
        path: PathBuf,
        /// Step that was being tried.
        action: Action,
    },
    /// The file is larger than the reader allows.
    #[error("{path}: the file has {bytes} bytes, expected at most {limit}; is it the right file?{}", advice(.raised_by))]
    TooLarge {
        /// The path as given.
        path: PathBuf,
        /// Size found; a lower bound for files that do not tell their size.
        bytes: u64,
        /// Largest size that is allowed (bytes).
        limit: u64,
        /// What would allow more.
        raised_by: Option<Limit>,
    },
    /// The folder in which to write does not exist.
    #[error("{path}: {action}: there is no folder {folder}; make it first")]
    MissingFolder {
        /// The path as given.
        path: PathBuf,
        /// The folder that is missing.
        folder: PathBuf,
        /// Step that was being tried.
        action: Action,
    },
    /// Permission denied, or a read-only file system.
    #[error("{path}: {action}: not allowed ({source}); change the permissions or choose another place")]
    Denied {
        /// The path as given.
        path: PathBuf,
        /// Step that was being tried.
        action: Action,
        /// Error that the operating system reports.
        source: io::Error,
    },
    /// The disk or the quota is full.
    #[error("{path}: {action}: no space left ({source}); free some or choose another place")]
    NoSpace {
        /// The path as given.
        path: PathBuf,
        /// Step that was being tried.
        action: Action,
        /// Error that the operating system reports.
        source: io::Error,
    },
    /// Any other failure of the system.
    #[error("{path}: {action}: {source}")]
    Io {
        /// The path as given.
        path: PathBuf,
        /// Step that was being tried.
        action: Action,
        /// Error that the operating system reports.
        source: io::Error,
    },
}

/// What was tried when it failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Open or read the file.
    Read,
    /// Open a file of the program's own.
    Open,
    /// Make the temporary file beside the target.
    Create,
    /// Write the content of the file.
    Write,
    /// Bring the content to the disk.
    Sync,
    /// Give the file its final name.
    Rename,
    /// Remove a file that an interrupted run left.
    Remove,
}

impl fmt::Display for Action {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Read => "cannot read",
            Self::Open => "cannot open",
            Self::Create => "cannot create",
            Self::Write => "cannot write",
            Self::Sync => "cannot bring to the disk",
            Self::Rename => "cannot give the file its name",
            Self::Remove => "cannot remove",
        })
    }
}

impl FileError {
    /// Sorts a failure of the system into the cases a user would treat differently.
    pub(crate) fn new(path: &Path, action: Action, source: io::Error) -> Self {
        use io::ErrorKind as Kind;
        let owned = path.to_owned();
        match source.kind() {
            Kind::NotFound | Kind::NotADirectory if action == Action::Read => Self::Missing { path: owned },
            Kind::NotFound | Kind::NotADirectory if action == Action::Create => {
                Self::MissingFolder { path: owned, folder: folder_of(path).to_owned(), action }
            }
            Kind::IsADirectory => Self::IsFolder { path: owned, action },
            Kind::PermissionDenied | Kind::ReadOnlyFilesystem => Self::Denied { path: owned, action, source },
            Kind::StorageFull | Kind::QuotaExceeded => Self::NoSpace { path: owned, action, source },
            _ => Self::Io { path: owned, action, source },
        }
    }

    /// The path the error is about.
    pub fn path(&self) -> &Path {
        match self {
            Self::Missing { path }
            | Self::IsFolder { path, .. }
            | Self::NoFile { path, .. }
            | Self::OtherNames { path, .. }
            | Self::TooLarge { path, .. }
            | Self::MissingFolder { path, .. }
            | Self::Denied { path, .. }
            | Self::NoSpace { path, .. }
            | Self::Io { path, .. } => path,
        }
    }
}

fn remedy(kind: Kind, action: Action) -> &'static str {
    match (kind, action) {
        (Kind::Link, _) => "; links are never written through: name the file itself, or remove the link",
        (_, Action::Read) => "; copy its content to a file and name that file",
        _ => "; name another file",
    }
}

fn advice(raised_by: &Option<Limit>) -> String {
    raised_by.map_or(String::new(), |limit| format!(" {limit}"))
}

/// The folder a path lies in; the current one for a bare name.
pub fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder.as_os_str().is_empty() => Path::new("."),
        Some(folder) => folder,
        None => path,
    }
}
