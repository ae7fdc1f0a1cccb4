//! Raw: vectors of ngspice against time, in volts.

use std::io::{self, BufWriter, Write};

use signal::Wire;
use text::visible_line;

use crate::clock::seconds;
use crate::encoder::Encoder;
use crate::header::{Form, has_volts, volts};
use crate::held::{hold, pulses};
use crate::output::Output;
use crate::{Header, SweepTraces};

/// A point a sample, all vectors of a point together, f64.
pub struct RawFile {
    header: Header,
    columns: Vec<Vec<f64>>,
    told: Vec<Option<f64>>,
    out: BufWriter<Box<dyn Output>>,
}

impl RawFile {
    /// Writes names and classes.
    pub fn new(header: &Header, output: Box<dyn Output>) -> io::Result<Self> {
        let mut out = BufWriter::new(output);
        let points = u64::from(header.count()) * header.samples() as u64;
        writeln!(out, "Title: {}", one_line(&header.title))?;
        writeln!(out, "Plotname: Transient Analysis")?;
        writeln!(out, "Flags: real")?;
        writeln!(out, "No. Variables: {}", header.wires.len() + 1)?;
        writeln!(out, "No. Points: {points}")?;
        // Readers such as spicelib tell the layout by the name of the program.
        writeln!(out, "Command: lunoid, for ngspice")?;
        writeln!(out, "Variables:")?;
        writeln!(out, "\t0\ttime\ttime")?;
        for (place, wire) in header.wires.iter().enumerate() {
            writeln!(out, "\t{}\t{}\t{}", place + 1, vector_name(wire), class(wire))?;
        }
        writeln!(out, "Binary:")?;
        let columns = vec![Vec::new(); header.wires.len()];
        Ok(Self { header: header.clone(), columns, told: Vec::new(), out })
    }

    fn fill(&mut self, traces: &SweepTraces<'_>) {
        let samples = self.header.samples();
        let wires = self.header.wires.iter().zip(traces.waveforms);
        for (column, (wire, waveform)) in self.columns.iter_mut().zip(wires) {
            if Form::of(&wire.signal) == Form::Pulse {
                pulses(waveform, samples, &mut self.told);
                column.clear();
                column.extend(self.told.iter().map(|told| f64::from(u8::from(told.is_some()))));
            } else {
                hold(waveform, samples, column);
                column.iter_mut().for_each(|value| *value = volts(wire, *value));
            }
        }
    }
}

/// ngspice has small letters, and takes `-` for a minus.
fn vector_name(wire: &Wire) -> String {
    wire.signal.name.to_ascii_lowercase().replace('-', "_")
}

fn class(wire: &Wire) -> &'static str {
    if has_volts(wire) { "voltage" } else { "notype" }
}

fn one_line(text: &str) -> String {
    visible_line(&text.lines().collect::<Vec<_>>().join(" ")).into_owned()
}

impl Encoder for RawFile {
    fn sweep(&mut self, traces: &SweepTraces<'_>) -> io::Result<()> {
        self.fill(traces);
        for sample in 0..self.header.samples() {
            let time = seconds(&self.header, traces.sweep, sample as f64);
            self.out.write_all(&time.to_le_bytes())?;
            for column in &self.columns {
                self.out.write_all(&column[sample].to_le_bytes())?;
            }
        }
        Ok(())
    }

    fn finish(mut self: Box<Self>) -> io::Result<()> {
        self.out.flush()
    }
}
