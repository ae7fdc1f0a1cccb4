//! Sinks: what takes sweeps, and how many bytes they will be.

use std::io::{self, Cursor};
use std::path::{Path, PathBuf};

use files::{Action, FileError, write_atomic};

use crate::csv_file::CsvFile;
use crate::encoder::Encoder;
use crate::error::file_error;
use crate::fst_file::FstFile;
use crate::json_file::JsonFile;
#[cfg(not(target_family = "wasm"))]
use crate::npz_file::NpzFile;
use crate::output::{Counter, Destination, Output, Store};
use crate::raw_file::RawFile;
#[cfg(not(target_family = "wasm"))]
use crate::sigrok_file::SigrokFile;
use crate::vcd_file::VcdFile;
use crate::{Format, Header, SweepTraces, WaveformError, gtkwave, record};

/// Takes the sweeps of a frame, one after another. Dropped before it is finished, it leaves nothing.
pub trait Sink {
    /// Writes a sweep: the next of the header.
    ///
    /// # Errors
    /// If it is not the next, if it does not have the waveforms of the header, if a value is not finite, or if the file
    /// cannot be written.
    fn sweep(&mut self, traces: &SweepTraces<'_>) -> Result<(), WaveformError>;

    /// Ends the file and gives it its name; tells which files there are now, the one that was asked for first.
    ///
    /// # Errors
    /// If sweeps of the header are missing, or if a file cannot be written.
    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, WaveformError>;
}

/// Begins a file of waveforms; a device or a pipe is written directly.
///
/// # Errors
/// If it cannot be made.
pub fn open(format: Format, path: &Path, header: Header) -> Result<Box<dyn Sink>, WaveformError> {
    let file = Destination::new(path)?;
    let waiting = if format == Format::Npz { Some(Destination::waiting(path)?) } else { None };
    let store: Box<dyn Store> = match &waiting {
        Some(waiting) => Box::new(waiting.handle()?),
        None => Box::new(Cursor::new(Vec::new())),
    };
    let encoder = encoder(format, &header, Box::new(file.handle()?), store)
        .map_err(|source| file_error(path, Action::Write, source))?;
    Ok(Box::new(FileSink { format, path: path.to_owned(), header, taken: 0, encoder, file, waiting }))
}

/// About how many bytes the file of `header` will have, judged by a `specimen`: some of its sweeps in a row. What the
/// second half of them adds, every other sweep is taken to add; so what is written once, and what a format saves where
/// sweeps are alike, is counted as it comes. Without a specimen, what the file has without sweeps.
///
/// # Errors
/// If the specimen holds a value that is not finite, or waveforms that are not the header's.
pub fn estimate(format: Format, header: &Header, specimen: &[SweepTraces<'_>]) -> Result<u64, WaveformError> {
    let name = Path::new(format.name());
    for traces in specimen {
        header.check(name, traces.sweep, traces)?;
    }
    let size = |traces| -> Result<u64, FileError> {
        size(format, header, traces).map_err(|source| file_error(name, Action::Write, source))
    };
    let half = specimen.len() / 2;
    let whole = size(specimen)?;
    let added = u128::from(whole.saturating_sub(size(&specimen[..half])?));
    let others = u128::from(header.count()).saturating_sub(specimen.len() as u128);
    let more = added * others / (specimen.len() - half).max(1) as u128;
    Ok(whole.saturating_add(u64::try_from(more).unwrap_or(u64::MAX)))
}

fn size(format: Format, header: &Header, specimen: &[SweepTraces<'_>]) -> io::Result<u64> {
    let counter = Counter::default();
    let mut encoder = encoder(format, header, Box::new(counter.clone()), Box::new(Cursor::new(Vec::new())))?;
    specimen.iter().try_for_each(|traces| encoder.sweep(traces))?;
    encoder.finish()?;
    Ok(counter.end())
}

/// The encoder of a format; those that need not wait leave `store` alone.
fn encoder(
    format: Format,
    header: &Header,
    output: Box<dyn Output>,
    store: Box<dyn Store>,
) -> io::Result<Box<dyn Encoder>> {
    Ok(match format {
        Format::Csv => Box::new(CsvFile::new(header, output)?),
        Format::Vcd => Box::new(VcdFile::new(header, output)?),
        Format::Fst => Box::new(FstFile::new(header, output)?),
        Format::Json => Box::new(JsonFile::new(header, output)?),
        Format::Raw => Box::new(RawFile::new(header, output)?),
        Format::Npz | Format::Sr => zipped(format, header, output, store)?,
    })
}

/// The encoder of a format that is a zip.
#[cfg(not(target_family = "wasm"))]
fn zipped(
    format: Format,
    header: &Header,
    output: Box<dyn Output>,
    store: Box<dyn Store>,
) -> io::Result<Box<dyn Encoder>> {
    match format {
        Format::Npz => Ok(Box::new(NpzFile::new(header, output, store))),
        _ => Ok(Box::new(SigrokFile::new(header, output)?)),
    }
}

/// A page has no file to write a zip to.
#[cfg(target_family = "wasm")]
fn zipped(
    _format: Format,
    _header: &Header,
    _output: Box<dyn Output>,
    _store: Box<dyn Store>,
) -> io::Result<Box<dyn Encoder>> {
    Err(io::ErrorKind::Unsupported.into())
}

/// A sink that writes a file, and what stands beside it.
struct FileSink {
    format: Format,
    path: PathBuf,
    header: Header,
    taken: u32,
    encoder: Box<dyn Encoder>,
    file: Destination,
    /// Held so that it is removed with the sink.
    waiting: Option<Destination>,
}

impl Sink for FileSink {
    fn sweep(&mut self, traces: &SweepTraces<'_>) -> Result<(), WaveformError> {
        self.header.check(&self.path, self.header.sweeps.start + self.taken, traces)?;
        self.encoder.sweep(traces).map_err(|source| file_error(&self.path, Action::Write, source))?;
        self.taken += 1;
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, WaveformError> {
        let Self { format, path, header, taken, encoder, file, waiting } = *self;
        if taken != header.count() {
            return Err(WaveformError::Unfinished { path, found: taken, expected: header.count() });
        }
        encoder.finish().map_err(|source| file_error(&path, Action::Write, source))?;
        drop(waiting);
        let beside = if file.is_device() { Vec::new() } else { beside(format, &path, &header) };
        for (place, (name, text)) in beside.iter().enumerate() {
            let written = write_atomic(name, |out| out.write_all(text.as_bytes()));
            written.inspect_err(|_| remove(&beside[..place]))?;
        }
        file.keep().inspect_err(|_| remove(&beside))?;
        Ok([path].into_iter().chain(beside.into_iter().map(|(name, _)| name)).collect())
    }
}

/// What stands beside a file: names and contents.
fn beside(format: Format, path: &Path, header: &Header) -> Vec<(PathBuf, String)> {
    let record = record_beside(format, path).map(|name| (name, record::text(format, path, header)));
    let saved = view_beside(format, path).map(|name| (name, gtkwave::text(path, header)));
    record.into_iter().chain(saved).collect()
}

/// The files that are written beside one of `format` at `path`.
pub fn companions(format: Format, path: &Path) -> Vec<PathBuf> {
    record_beside(format, path).into_iter().chain(view_beside(format, path)).collect()
}

fn record_beside(format: Format, path: &Path) -> Option<PathBuf> {
    format.needs_record().then(|| path.with_added_extension("json"))
}

fn view_beside(format: Format, path: &Path) -> Option<PathBuf> {
    format.is_of_gtkwave().then(|| path.with_added_extension("gtkw"))
}

fn remove(files: &[(PathBuf, String)]) {
    for (name, _) in files {
        // The failure to tell is another one.
        let _ = std::fs::remove_file(name);
    }
}
