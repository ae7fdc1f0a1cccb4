//! Writing a file whole or not at all.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

#[cfg(unix)]
use crate::error::folder_of;
use crate::error::{Action, FileError};
use crate::kind::Kind;
use crate::open::{expect_output, open_stream};
use crate::temporary::Temporary;

/// Larger than the usual 8 KiB: frames and waveforms are megabytes.
const BUFFER_BYTES: usize = 1 << 16;

/// Writes a file so that a reader, or a run that is killed, sees the old content or the new one.
///
/// The content goes to a temporary file in the same folder, is brought to the disk, renamed, and the folder
/// is brought to the disk. On failure the temporary file is removed and the old file stays. An open file of this process or a
/// character device (`/dev/stdout`, `/dev/null`) is written directly. A link is never followed, and a named pipe is refused.
///
/// # Errors
/// A [`FileError`] with the path; what `write` returns is its source.
pub fn write_atomic(
    path: impl AsRef<Path>,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), FileError> {
    write_atomic_file(path.as_ref(), |file| write(file))
}

/// The same for writers that go back in the file.
pub(crate) fn write_atomic_file(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), FileError> {
    match expect_output(path)? {
        // Renaming over a device would replace the device.
        Kind::Stream => write_stream(path, write),
        _ => write_and_rename(path, write),
    }
}

fn write_stream(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), FileError> {
    let failed = |source| FileError::new(path, Action::Write, source);
    let mut buffer = BufWriter::new(open_stream(path)?);
    write(&mut buffer).and_then(|()| buffer.flush()).map_err(failed)
}

fn write_and_rename(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), FileError> {
    let failed = |action| move |source| FileError::new(path, action, source);
    let (temporary, file) = Temporary::beside(path).map_err(failed(Action::Create))?;
    let mut buffer = BufWriter::with_capacity(BUFFER_BYTES, file);
    write(&mut buffer).and_then(|()| buffer.flush()).map_err(failed(Action::Write))?;
    buffer.get_ref().sync_all().map_err(failed(Action::Sync))?;
    temporary.rename(path).map_err(failed(Action::Rename))?;
    sync_folder(path)
}

#[cfg(unix)]
fn sync_folder(path: &Path) -> Result<(), FileError> {
    let folder = File::open(folder_of(path)).and_then(|folder| folder.sync_all());
    folder.map_err(|source| FileError::new(path, Action::Sync, source))
}

/// A folder cannot be opened as a file there.
#[cfg(not(unix))]
fn sync_folder(_path: &Path) -> Result<(), FileError> {
    Ok(())
}
