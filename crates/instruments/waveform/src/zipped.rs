//! Zips whose bytes depend on names and values alone.

use std::io::{self, BufWriter, Seek, SeekFrom, Write};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

use crate::output::Output;

/// A zip that is being written.
pub type Zip = ZipWriter<BufWriter<Once>>;

/// Begins an empty zip on `output`.
pub fn begin(output: Box<dyn Output>) -> Zip {
    ZipWriter::new(BufWriter::new(Once { output, failed: false }))
}

/// Fails once, and then takes everything: a zip that is dropped ends itself, and would print that it cannot.
pub struct Once {
    output: Box<dyn Output>,
    failed: bool,
}

impl Once {
    fn note<T>(&mut self, result: io::Result<T>) -> io::Result<T> {
        result.inspect_err(|error| self.failed |= error.kind() != io::ErrorKind::Interrupted)
    }
}

impl Write for Once {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.failed {
            return Ok(bytes.len());
        }
        let result = self.output.write(bytes);
        self.note(result)
    }

    fn flush(&mut self) -> io::Result<()> {
        if self.failed {
            return Ok(());
        }
        let result = self.output.flush();
        self.note(result)
    }
}

impl Seek for Once {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        if self.failed {
            return Ok(0);
        }
        let result = self.output.seek(to);
        self.note(result)
    }
}

/// Stored, dated 1980-01-01; of at most `bytes` bytes and a header.
pub fn options(bytes: u64) -> SimpleFileOptions {
    // The size fields of a plain member end at 4 GiB.
    let is_large = bytes >= u64::from(u32::MAX) - 65_536;
    SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .last_modified_time(DateTime::default())
        .unix_permissions(0o644)
        .large_file(is_large)
}
