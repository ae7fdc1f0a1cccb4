//! NPZ: an array a signal, for numpy.

use std::io::{self, BufWriter, Read, Seek, SeekFrom, Write};

use signal::Axis;

use crate::clock::seconds;
use crate::encoder::Encoder;
use crate::output::{Output, Store};
use crate::zipped::{Zip, begin, options};
use crate::{Header, SweepTraces};

/// The signal that says where the samples lie on the ground: the same for every sweep.
const RANGE: &str = "sweep.range";

/// Sweeps come one after another, arrays are written one after another: the values wait in a store, and nothing is held
/// but where they lie.
pub struct NpzFile {
    header: Header,
    store: BufWriter<Box<dyn Store>>,
    /// Bytes in the store.
    end: u64,
    /// One a sweep and wire.
    pieces: Vec<Piece>,
    sweeps: Vec<u32>,
    arrays: Arrays,
}

/// The instants of a waveform in the store, then its values.
#[derive(Debug, Clone, Copy)]
struct Piece {
    at: u64,
    times: u64,
    values: u64,
}

/// Which numbers of a piece.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    Times,
    Values,
}

impl NpzFile {
    /// Begins a file; nothing is written to `output` yet.
    pub fn new(header: &Header, output: Box<dyn Output>, store: Box<dyn Store>) -> Self {
        let (pieces, sweeps, store) = (Vec::new(), Vec::new(), BufWriter::new(store));
        let arrays = Arrays { zip: begin(output) };
        Self { header: header.clone(), store, end: 0, pieces, sweeps, arrays }
    }

    fn write_wires(&mut self) -> io::Result<()> {
        let (wires, rows) = (self.header.wires.clone(), self.sweeps.len() as u64);
        for (place, wire) in wires.iter().enumerate() {
            let pieces: Vec<Piece> = self.pieces.iter().skip(place).step_by(wires.len()).copied().collect();
            let name = wire.signal.name;
            match wire.signal.axis {
                Axis::Ground | Axis::Line => {
                    let shape = [rows, self.header.samples() as u64];
                    self.copy(name, &shape, &pieces, Part::Values)?;
                }
                Axis::Display => {
                    let shape = [rows, u64::from(self.header.lines)];
                    self.copy(name, &shape, &pieces, Part::Values)?;
                }
                Axis::Changes => self.copy_changes(name, &pieces)?,
            }
            if name == RANGE {
                let shape = [self.header.samples() as u64];
                self.copy("range_m", &shape, &pieces[..pieces.len().min(1)], Part::Values)?;
            }
        }
        Ok(())
    }

    fn copy_changes(&mut self, name: &str, pieces: &[Piece]) -> io::Result<()> {
        let shape = [pieces.iter().map(|piece| piece.times).sum::<u64>()];
        self.copy(&format!("{name}.times"), &shape, pieces, Part::Times)?;
        self.copy(&format!("{name}.values"), &shape, pieces, Part::Values)?;
        self.arrays.begin(&format!("{name}.sweep"), "<u4", &shape)?;
        for (piece, sweep) in pieces.iter().zip(&self.sweeps) {
            (0..piece.times).try_for_each(|_| self.arrays.zip.write_all(&sweep.to_le_bytes()))?;
        }
        Ok(())
    }

    fn copy(&mut self, name: &str, shape: &[u64], pieces: &[Piece], part: Part) -> io::Result<()> {
        self.arrays.begin(name, "<f8", shape)?;
        let store = self.store.get_mut();
        for piece in pieces {
            let (at, count) = match part {
                Part::Times => (piece.at, piece.times),
                Part::Values => (piece.at + 8 * piece.times, piece.values),
            };
            store.seek(SeekFrom::Start(at))?;
            io::copy(&mut store.take(8 * count), &mut self.arrays.zip)?;
        }
        Ok(())
    }

    /// Numbers of the rows, instants of the samples in their sweep, and of the sweeps in the frame.
    fn write_axes(&mut self) -> io::Result<()> {
        self.arrays.begin("sweeps", "<u4", &[self.sweeps.len() as u64])?;
        self.sweeps.iter().try_for_each(|sweep| self.arrays.zip.write_all(&sweep.to_le_bytes()))?;
        let samples = self.header.samples();
        self.arrays.begin("time_s", "<f8", &[samples as u64])?;
        let within = |sample: usize| seconds(&self.header, 0, sample as f64);
        (0..samples).try_for_each(|sample| self.arrays.zip.write_all(&within(sample).to_le_bytes()))?;
        self.arrays.begin("sweep_start_s", "<f8", &[self.sweeps.len() as u64])?;
        let start = |sweep: u32| seconds(&self.header, sweep, 0.0);
        self.sweeps.iter().try_for_each(|sweep| self.arrays.zip.write_all(&start(*sweep).to_le_bytes()))
    }
}

/// The zip of arrays.
struct Arrays {
    zip: Zip,
}

impl Arrays {
    /// Begins an array; its numbers follow.
    fn begin(&mut self, name: &str, kind: &str, shape: &[u64]) -> io::Result<()> {
        let bytes = 8 * shape.iter().product::<u64>();
        self.zip.start_file(format!("{name}.npy"), options(bytes))?;
        self.zip.write_all(&npy_header(kind, shape))
    }
}

/// The header that numpy itself would write: version 1, padded so that the numbers begin at a multiple of 64 bytes.
fn npy_header(kind: &str, shape: &[u64]) -> Vec<u8> {
    let sizes: String = shape.iter().map(|size| format!("{size}, ")).collect();
    let dictionary = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({sizes}), }}");
    let length = (10 + dictionary.len() + 1).next_multiple_of(64) - 10;
    let mut header = b"\x93NUMPY\x01\x00".to_vec();
    header.extend((length as u16).to_le_bytes());
    header.extend(format!("{dictionary:<width$}\n", width = length - 1).into_bytes());
    header
}

impl Encoder for NpzFile {
    fn sweep(&mut self, traces: &SweepTraces<'_>) -> io::Result<()> {
        self.sweeps.push(traces.sweep);
        for waveform in traces.waveforms {
            let (times, values) = (waveform.times.len() as u64, waveform.values.len() as u64);
            self.pieces.push(Piece { at: self.end, times, values });
            self.end += 8 * (times + values);
            let mut numbers = waveform.times.iter().chain(&waveform.values);
            numbers.try_for_each(|number| self.store.write_all(&number.to_le_bytes()))?;
        }
        Ok(())
    }

    fn finish(mut self: Box<Self>) -> io::Result<()> {
        self.store.flush()?;
        self.write_wires()?;
        self.write_axes()?;
        self.arrays.zip.finish()?.flush()
    }
}
