//! What stands at a path, before anything is opened there.

use std::fs::{self, FileType, Metadata};
use std::io;
use std::path::{Path, PathBuf};

use crate::given::is_given;

/// What a path names. A link counts as itself, whatever it leads to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Nothing stands there yet.
    Nothing,
    /// A regular file stands there.
    File,
    /// A folder stands there.
    Folder,
    /// A symbolic link stands there.
    Link,
    /// An open file of this process or a character device, such as `/dev/stdout` and `/dev/null`. Only a user can mean it.
    Stream,
    /// A named pipe stands there.
    Pipe,
    /// A path of the store of given files, be there one or not.
    Given,
    /// A socket, a disk, or another thing that is no file.
    Device,
}

impl Kind {
    /// What stands at `path`.
    ///
    /// # Errors
    /// If the system refuses to look; a missing file is no error.
    pub fn of(path: &Path) -> io::Result<Self> {
        if is_descriptor(path) {
            return Ok(Self::Stream);
        }
        if is_given(path) {
            return Ok(Self::Given);
        }
        match fs::symlink_metadata(itself(path)) {
            Ok(found) => Ok(Self::of_type(found.file_type())),
            // Below a file there is nothing either.
            Err(error) if is_absence(&error) => Ok(Self::Nothing),
            Err(error) => Err(error),
        }
    }

    /// The kind of what has this type.
    pub fn of_type(found: FileType) -> Self {
        match found {
            found if found.is_file() => Self::File,
            found if found.is_dir() => Self::Folder,
            found if found.is_symlink() => Self::Link,
            found => special(found),
        }
    }

    /// The kind in words for a sentence, as "a link".
    pub fn phrase(self) -> &'static str {
        match self {
            Self::Nothing => "nothing",
            Self::File => "a file",
            Self::Folder => "a folder",
            Self::Link => "a link",
            Self::Stream => "a device",
            Self::Pipe => "a pipe",
            Self::Given => "a given file, which is held in memory alone",
            Self::Device => "a device or a socket",
        }
    }
}

fn is_absence(error: &io::Error) -> bool {
    matches!(error.kind(), io::ErrorKind::NotFound | io::ErrorKind::NotADirectory)
}

#[cfg(unix)]
fn special(found: FileType) -> Kind {
    use std::os::unix::fs::FileTypeExt;
    match found {
        found if found.is_fifo() => Kind::Pipe,
        found if found.is_char_device() => Kind::Stream,
        _ => Kind::Device,
    }
}

#[cfg(not(unix))]
fn special(_found: FileType) -> Kind {
    Kind::Device
}

/// Whether the path names an open file of this process.
pub(crate) fn is_descriptor(path: &Path) -> bool {
    let named = ["/dev/stdin", "/dev/stdout", "/dev/stderr"].iter().any(|name| path == Path::new(name));
    let numbered = path
        .parent()
        .is_some_and(|folder| ["/dev/fd", "/proc/self/fd"].iter().any(|name| folder == Path::new(name)));
    named || numbered && path.file_name().is_some()
}

/// The path without a slash or `.` behind it: with one, the system looks through a link.
pub(crate) fn itself(path: &Path) -> PathBuf {
    let clean: PathBuf = path.components().collect();
    if clean.as_os_str().is_empty() { PathBuf::from(".") } else { clean }
}

/// Whether more than one name leads to this file: whoever changes it changes what another name shows.
#[cfg(unix)]
pub(crate) fn has_other_names(found: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    found.is_file() && found.nlink() > 1
}

#[cfg(not(unix))]
pub(crate) fn has_other_names(_found: &Metadata) -> bool {
    false
}

/// Where `path` leads if that is outside `folder`: through a link on the way, since neither `path` nor `folder` need say so.
/// Nothing if the path stays inside, or if nothing stands there yet.
pub fn leads_outside(folder: &Path, path: &Path) -> Option<PathBuf> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let (folder, found) = (fs::canonicalize(folder).ok()?, fs::canonicalize(path).ok()?);
    (!found.starts_with(folder)).then_some(found)
}
