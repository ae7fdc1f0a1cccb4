//! JSON: one document, `lunoid.waveforms/1`.

use std::io::{self, BufWriter, Write};

use serde_json::{Map, Value, json};
use signal::{Axis, Waveform};

use crate::clock::seconds;
use crate::encoder::Encoder;
use crate::output::Output;
use crate::record::head;
use crate::{Header, SweepTraces};

/// The head of the document, then an object a sweep.
pub struct JsonFile {
    header: Header,
    separator: &'static str,
    out: BufWriter<Box<dyn Output>>,
}

impl JsonFile {
    /// Begins a file and writes the head of its document.
    pub fn new(header: &Header, output: Box<dyn Output>) -> io::Result<Self> {
        let mut out = BufWriter::new(output);
        let head = head("lunoid.waveforms/1", header).to_string();
        // The document stays open for its sweeps.
        write!(out, "{},\"traces\":[", head.strip_suffix('}').unwrap_or(&head))?;
        Ok(Self { header: header.clone(), separator: "\n", out })
    }
}

fn member(waveform: &Waveform) -> Value {
    match waveform.signal.axis {
        Axis::Ground | Axis::Line | Axis::Display => json!({ "values": waveform.values }),
        Axis::Changes => json!({ "times": waveform.times, "values": waveform.values }),
    }
}

impl Encoder for JsonFile {
    fn sweep(&mut self, traces: &SweepTraces<'_>) -> io::Result<()> {
        let members = traces.waveforms.iter().map(|waveform| (waveform.signal.name.into(), member(waveform)));
        let start = seconds(&self.header, traces.sweep, 0.0);
        let signals: Map<String, Value> = members.collect();
        self.out.write_all(self.separator.as_bytes())?;
        self.separator = ",\n";
        let sweep = json!({ (self.header.row_name()): traces.sweep, "start_s": start, "signals": signals });
        serde_json::to_writer(&mut self.out, &sweep).map_err(io::Error::from)
    }

    fn finish(mut self: Box<Self>) -> io::Result<()> {
        self.out.write_all(b"\n]}\n")?;
        self.out.flush()
    }
}
