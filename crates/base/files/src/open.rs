//! The one place where files are opened, so that nothing is opened that is no file.

use std::fs::{self, File, OpenOptions};
use std::path::Path;

use crate::error::{Action, FileError};
use crate::given::is_given;
use crate::kind::{Kind, has_other_names, is_descriptor};

/// Opens a file that a user names for reading. A link is followed: the user may read whatever they can. A named pipe or a device
/// is refused, since it may have no end or never begin; an open file of this process (`/dev/stdin`) is taken.
///
/// # Errors
/// [`FileError::Missing`], [`FileError::IsFolder`], [`FileError::NoFile`], and failures of the system.
pub fn open(path: &Path) -> Result<File, FileError> {
    let failed = |source| FileError::new(path, Action::Read, source);
    if is_given(path) {
        return Err(FileError::NoFile { path: path.to_owned(), action: Action::Read, kind: Kind::Given });
    }
    let mut options = OpenOptions::new();
    options.read(true);
    if !is_descriptor(path) {
        expect_file(path, fs::metadata(path).map_err(failed)?.file_type())?;
        // What has become a pipe since then does not keep us waiting.
        without_waiting(&mut options);
    }
    let file = options.open(path).map_err(failed)?;
    let found = file.metadata().map_err(failed)?;
    if found.is_dir() {
        return Err(FileError::IsFolder { path: path.to_owned(), action: Action::Read });
    }
    if !is_descriptor(path) {
        expect_file(path, found.file_type())?;
    }
    Ok(file)
}

fn expect_file(path: &Path, found: fs::FileType) -> Result<(), FileError> {
    match Kind::of_type(found) {
        Kind::File => Ok(()),
        Kind::Folder => Err(FileError::IsFolder { path: path.to_owned(), action: Action::Read }),
        kind => Err(FileError::NoFile { path: path.to_owned(), action: Action::Read, kind }),
    }
}

/// Opens a file of the program's own for reading and writing, and makes it if it is not there. Never through a link, and nothing that
/// another name leads to.
///
/// # Errors
/// [`FileError::NoFile`], [`FileError::OtherNames`], and failures of the system.
pub fn open_own(path: &Path) -> Result<File, FileError> {
    opened_own(path, OpenOptions::new().read(true).write(true).create(true).truncate(false))
}

/// Opens a file of the program's own to write at its end. Never through a link, and nothing that another name leads to.
///
/// # Errors
/// As [`open_own`]; a missing file is refused.
pub fn append_own(path: &Path) -> Result<File, FileError> {
    opened_own(path, OpenOptions::new().append(true))
}

fn opened_own(path: &Path, options: &mut OpenOptions) -> Result<File, FileError> {
    let failed = |source| FileError::new(path, Action::Open, source);
    match Kind::of(path).map_err(failed)? {
        Kind::Nothing | Kind::File => {}
        Kind::Folder => return Err(FileError::IsFolder { path: path.to_owned(), action: Action::Open }),
        kind => return Err(FileError::NoFile { path: path.to_owned(), action: Action::Open, kind }),
    }
    never_through_links(options);
    let file = options.open(path).map_err(failed)?;
    let found = file.metadata().map_err(failed)?;
    let (path, action) = (path.to_owned(), Action::Open);
    match Kind::of_type(found.file_type()) {
        Kind::File if has_other_names(&found) => Err(FileError::OtherNames { path, action }),
        Kind::File => Ok(file),
        kind => Err(FileError::NoFile { path, action, kind }),
    }
}

/// Opens what a user names to be written directly: a [`Kind::Stream`].
///
/// # Errors
/// Failures of the system.
pub fn open_stream(path: &Path) -> Result<File, FileError> {
    let opened = OpenOptions::new().write(true).open(path);
    opened.map_err(|source| FileError::new(path, Action::Write, source))
}

/// What may be written at `path`, told before any work. Anything but a file, a stream or a new name is refused.
///
/// # Errors
/// [`FileError::IsFolder`], [`FileError::NoFile`], and failures of the system.
pub fn expect_output(path: &Path) -> Result<Kind, FileError> {
    let action = Action::Write;
    match Kind::of(path).map_err(|source| FileError::new(path, action, source))? {
        kind @ (Kind::Nothing | Kind::File | Kind::Stream) => Ok(kind),
        Kind::Folder => Err(FileError::IsFolder { path: path.to_owned(), action }),
        kind => Err(FileError::NoFile { path: path.to_owned(), action, kind }),
    }
}

#[cfg(unix)]
fn without_waiting(options: &mut OpenOptions) {
    use std::os::unix::fs::OpenOptionsExt;
    options.custom_flags(libc::O_NONBLOCK);
}

#[cfg(not(unix))]
fn without_waiting(_options: &mut OpenOptions) {}

#[cfg(unix)]
pub(crate) fn never_through_links(options: &mut OpenOptions) {
    use std::os::unix::fs::OpenOptionsExt;
    options.custom_flags(libc::O_NOFOLLOW | libc::O_NONBLOCK);
}

#[cfg(not(unix))]
pub(crate) fn never_through_links(_options: &mut OpenOptions) {}
