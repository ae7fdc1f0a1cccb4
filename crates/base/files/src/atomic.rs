//! Writing a file whole or not at all.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::error::{Action, FileError, folder_of};
use crate::temporary::Temporary;

/// Larger than the usual 8 KiB: frames and waveforms are megabytes.
const BUFFER_BYTES: usize = 1 << 16;

/// Writes a file so that a reader, or a run that is killed, sees the old content or the new one.
///
/// The content goes to a temporary file in the same folder, is brought to the disk, renamed, and the folder
/// is brought to the disk. On failure the temporary file is removed and the old file stays. A device or a
/// pipe (`/dev/null`) is written directly. A symbolic link stays: what it leads to is written, as without a rename.
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
    match fs::metadata(path) {
        Ok(found) if found.is_dir() => {
            Err(FileError::IsFolder { path: path.to_owned(), action: Action::Write })
        }
        // Renaming over a device would replace the device.
        Ok(found) if !found.is_file() => write_device(path, write),
        _ => write_and_rename(&behind_links(path)?, write),
    }
}

/// Where `path` leads: renaming over a link would replace the link, and leave the file behind it as it was.
fn behind_links(path: &Path) -> Result<PathBuf, FileError> {
    /// As many as Linux itself follows.
    const MOST: usize = 40;
    let mut at = path.to_owned();
    for _ in 0..MOST {
        match fs::read_link(&at) {
            Ok(next) => at = folder_of(&at).join(next),
            Err(_) => return Ok(at),
        }
    }
    let source = io::Error::other(format!("more than {MOST} symbolic links in a row; name the file itself"));
    Err(FileError::new(path, Action::Write, source))
}

fn write_device(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), FileError> {
    let failed = |source| FileError::new(path, Action::Write, source);
    let mut buffer = BufWriter::new(fs::OpenOptions::new().write(true).open(path).map_err(failed)?);
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

/// Removes the temporary files that killed runs left in a folder; tells how many. No run may be writing
/// into the folder.
///
/// # Errors
/// [`FileError`] when the folder cannot be read or a file not be removed.
pub fn remove_leftovers(folder: impl AsRef<Path>) -> Result<usize, FileError> {
    let folder = folder.as_ref();
    let unreadable = |source| FileError::new(folder, Action::Read, source);
    let mut removed = 0;
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        let entry = entry.map_err(unreadable)?;
        if is_temporary_name(&entry.file_name().to_string_lossy()) {
            let failed = |source| FileError::new(&entry.path(), Action::Remove, source);
            fs::remove_file(entry.path()).map_err(failed)?;
            removed += 1;
        }
    }
    Ok(removed)
}

fn is_temporary_name(name: &str) -> bool {
    let Some(inner) = name.strip_prefix('.').and_then(|name| name.strip_suffix(".tmp")) else { return false };
    let Some((_, tag)) = inner.rsplit_once('.') else { return false };
    let digits = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    tag.split_once('-').is_some_and(|(process, count)| digits(process) && digits(count))
}
