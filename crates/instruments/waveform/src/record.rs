//! What the wires are, in words: the record beside a file, comments, the head of a document.

use std::path::Path;

use serde_json::{Map, Value, json};
use signal::{Axis, Wire};

use crate::Format;
use crate::Header;
use crate::header::has_volts;
use crate::tree::DISPLAY;

/// A wire as an object: name, unit, kind, axis, full scale, volts there, value at 0 V, block, figure, meaning.
pub fn wire_record(wire: &Wire) -> Value {
    let signal = &wire.signal;
    json!({
        "name": signal.name,
        "unit": signal.unit.symbol(),
        "kind": signal.kind.name(),
        "axis": signal.axis.name(),
        "full_scale": wire.full_scale,
        "volts": wire.volts,
        "datum": wire.datum,
        "block": signal.block(),
        "figure": signal.figure,
        "meaning": signal.meaning,
    })
}

/// A wire in a line.
pub fn remark(wire: &Wire) -> String {
    let signal = &wire.signal;
    let scale = if has_volts(wire) {
        let Wire { full_scale, volts, datum, .. } = wire;
        format!(", full scale {full_scale} = {volts} V, {datum} = 0 V")
    } else {
        String::new()
    };
    format!("{} [{}]{scale}: {} ({})", signal.name, signal.unit, signal.meaning, signal.figure)
}

/// What a document of `schema` says of a header.
pub fn head(schema: &str, header: &Header) -> Value {
    let clocks = &header.timebase;
    let provenance: Map<String, Value> =
        header.provenance.iter().map(|(key, words)| (key.clone(), words.as_str().into())).collect();
    json!({
        "schema": schema,
        "title": header.title,
        "provenance": provenance,
        "frame": header.frame,
        "sweeps": [header.sweeps.start, header.sweeps.end],
        "clock": {
            "sample_rate": clocks.sample_rate().to_string(),
            "sample_rate_hz": clocks.sample_rate().hertz(),
            "samples": clocks.active_samples,
            "retrace_samples": clocks.retrace_samples,
            "sweeps_per_frame": clocks.sweeps,
            "lines": header.lines,
        },
        "signals": header.wires.iter().map(wire_record).collect::<Vec<_>>(),
    })
}

/// The record that stands beside the file at `path`.
pub fn text(format: Format, path: &Path, header: &Header) -> String {
    let mut record = head("lunoid.waveform-record/1", header);
    record["file"] = path.file_name().unwrap_or_default().to_string_lossy().into();
    record["format"] = format.name().into();
    record["values"] = values(format).into();
    if header.wires.iter().any(|wire| wire.signal.axis == Axis::Display) {
        record["display"] = display(format).into();
    }
    format!("{record:#}\n")
}

fn values(format: Format) -> &'static str {
    match format {
        Format::Raw | Format::Sr => {
            "volts: (value - datum) / full_scale * volts; buses as they are, events as pulses, gates as bits in sr"
        }
        _ => "in the unit of each signal",
    }
}

fn display(format: Format) -> String {
    match format {
        Format::Vcd | Format::Fst => {
            format!("scope {DISPLAY}: line k of a sweep stands at k / lines of its active samples")
        }
        Format::Raw | Format::Sr | Format::Csv => {
            "sample n shows the line n * lines / samples, rounded down".into()
        }
        Format::Npz | Format::Json => "a value a line".into(),
    }
}
