//! CSV: a row a sample, to look at.

use std::io::{self, BufWriter, Write};

use crate::clock::seconds;
use crate::encoder::Encoder;
use crate::header::Form;
use crate::held::{hold, pulses};
use crate::output::Output;
use crate::{Header, SweepTraces};

/// Rows of numbers under names with units; no cell of a pulse is filled but where there is one.
pub struct CsvFile {
    header: Header,
    columns: Vec<Column>,
    out: BufWriter<Box<dyn Output>>,
}

enum Column {
    Held(Vec<f64>),
    Pulses(Vec<Option<f64>>),
}

impl CsvFile {
    /// Writes the heading: frame, sweep or line, index, time, and every wire with its unit.
    pub fn new(header: &Header, output: Box<dyn Output>) -> io::Result<Self> {
        let mut out = BufWriter::new(output);
        write!(out, "frame,{},index,time [s]", header.row_name())?;
        for wire in &header.wires {
            write!(out, ",{} [{}]", wire.signal.name, wire.signal.unit)?;
        }
        writeln!(out)?;
        let column = |form| match form {
            Form::Pulse => Column::Pulses(Vec::new()),
            _ => Column::Held(Vec::new()),
        };
        let columns = header.wires.iter().map(|wire| column(Form::of(&wire.signal))).collect();
        Ok(Self { header: header.clone(), columns, out })
    }

    fn row(&mut self, traces: &SweepTraces<'_>, index: usize) -> io::Result<()> {
        let time = seconds(&self.header, traces.sweep, index as f64);
        write!(self.out, "{},{},{index},{time}", traces.frame, traces.sweep)?;
        for column in &self.columns {
            let value = match column {
                Column::Held(values) => Some(values[index]),
                Column::Pulses(values) => values[index],
            };
            match value {
                Some(value) => write!(self.out, ",{value}")?,
                None => write!(self.out, ",")?,
            }
        }
        writeln!(self.out)
    }
}

impl Encoder for CsvFile {
    fn sweep(&mut self, traces: &SweepTraces<'_>) -> io::Result<()> {
        let samples = self.header.samples();
        for (column, waveform) in self.columns.iter_mut().zip(traces.waveforms) {
            match column {
                Column::Held(values) => hold(waveform, samples, values),
                Column::Pulses(values) => pulses(waveform, samples, values),
            }
        }
        (0..samples).try_for_each(|index| self.row(traces, index))
    }

    fn finish(mut self: Box<Self>) -> io::Result<()> {
        self.out.flush()
    }
}
