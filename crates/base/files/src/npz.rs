//! Several named arrays in one NPZ file (a zip of NPY files).

use std::fs::File;
use std::io::{self, BufWriter};
use std::path::Path;

use crate::atomic::write_atomic_file;
use crate::error::FileError;
use crate::npy::Npy;

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
