//! Several named arrays in one NPZ file (a zip of NPY files).

use std::fs::File;
use std::io::{self, BufWriter};
use std::path::Path;

use crate::atomic::write_atomic_file;
use crate::error::FileError;
use crate::npy::Npy;
use crate::npy_error::NpyError;

/// Writes the arrays in the order given, stored without compression and dated 1980-01-01, so that the bytes
/// depend on names and values alone. Whole or not at all.
///
/// # Errors
/// [`FileError`]; a name given twice is one too.
pub fn write_npz<'a>(
    path: impl AsRef<Path>,
    arrays: impl IntoIterator<Item = (&'a str, &'a Npy)>,
) -> Result<(), FileError> {
    write_atomic_file(path.as_ref(), |file| write_arrays(file, arrays))
}

#[cfg(not(target_family = "wasm"))]
fn write_arrays<'a>(
    file: &mut BufWriter<File>,
    arrays: impl IntoIterator<Item = (&'a str, &'a Npy)>,
) -> io::Result<()> {
    use std::io::Write;

    let mut zip = zip::ZipWriter::new(&mut *file);
    for (name, array) in arrays {
        zip.start_file(format!("{name}.npy"), options(array))?;
        array.write(&mut zip)?;
    }
    zip.finish()?.flush()
}

/// A page has no file to write a zip to.
#[cfg(target_family = "wasm")]
fn write_arrays<'a>(
    _file: &mut BufWriter<File>,
    _arrays: impl IntoIterator<Item = (&'a str, &'a Npy)>,
) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

/// Reads the bytes of an NPZ file whose arrays are stored without compression: their names and values, in the order of the file.
///
/// # Errors
/// [`NpyError`], if the bytes are no zip archive or an entry is no array.
#[cfg(not(target_family = "wasm"))]
pub fn parse_npz(bytes: &[u8]) -> Result<Vec<(String, Npy)>, NpyError> {
    use std::io::{Cursor, Read};

    let mut zip = zip::ZipArchive::new(Cursor::new(bytes)).map_err(not_npz)?;
    let entries = 0..zip.len();
    let one = |index| {
        let mut entry = zip.by_index(index).map_err(not_npz)?;
        let name = entry.name().map_err(not_npz)?.trim_end_matches(".npy").to_owned();
        let mut array = Vec::new();
        entry.read_to_end(&mut array).map_err(not_npz)?;
        Ok((name, Npy::parse(&array)?))
    };
    entries.map(one).collect()
}

#[cfg(not(target_family = "wasm"))]
fn not_npz(error: impl std::fmt::Display) -> NpyError {
    NpyError::NotNpz { reason: error.to_string() }
}

/// A page reads no zip.
///
/// # Errors
/// [`NpyError::NotNpz`] always.
#[cfg(target_family = "wasm")]
pub fn parse_npz(_bytes: &[u8]) -> Result<Vec<(String, Npy)>, NpyError> {
    Err(NpyError::NotNpz { reason: "this program has no reader of zip".into() })
}

#[cfg(not(target_family = "wasm"))]
fn options(array: &Npy) -> zip::write::SimpleFileOptions {
    // The size fields of a plain zip entry end at 4 GiB; no value is wider than 8 bytes.
    let is_large = array.data().len() as u64 * 8 >= u64::from(u32::MAX) - 65_536;
    zip::write::SimpleFileOptions::default()
        .compression_method(zip::CompressionMethod::Stored)
        .last_modified_time(zip::DateTime::default())
        .unix_permissions(0o644)
        .large_file(is_large)
}
