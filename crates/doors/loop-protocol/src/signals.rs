//! The requests `probe`, `signals` and `blocks`.

use std::ops::Range;

use diagnostics::Problem;
use drive::{BlockRow, Drive, DriveError, Link, SignalRow, Trace, Traces};
use limits::Limit;
use serde_json::{Value, json};

use crate::digital::omission_json;
use crate::keys::{Keys, NAME};
use crate::poses::Which;
use crate::session::Reply;
use crate::{Home, Plane, Session};

impl<H: Home> Session<H> {
    pub(crate) fn probe(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        let signals = keys.texts("signals");
        let sweeps = keys.needed_sweeps("sweeps");
        let which = Which::of(&keys);
        keys.finish()?;
        let held = self.held()?;
        let sweeps = sweeps.unwrap_or_default();
        expect_room(&held.drive, &signals, &sweeps)?;
        let traces = which.at(held)?.probe(&signals, sweeps)?;
        Ok(traced(traces))
    }

    pub(crate) fn signals(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        keys.finish()?;
        let rows = self.held()?.drive.signals();
        Ok(json!({ "signals": rows.iter().map(signal_json).collect::<Vec<_>>() }).into())
    }

    pub(crate) fn blocks(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        keys.finish()?;
        let rows = self.held()?.drive.blocks();
        Ok(json!({ "blocks": rows.iter().map(block_json).collect::<Vec<_>>() }).into())
    }
}

/// Sees that the answer is no longer than a message may be.
fn expect_room(drive: &Drive, patterns: &[String], sweeps: &Range<u32>) -> Result<(), DriveError> {
    let is_asked = |row: &&SignalRow| patterns.iter().any(|pattern| row.signal.matches(pattern));
    let signals = drive.signals().iter().filter(is_asked).count() as u64;
    let raster = drive.raster();
    // Sweeps that are not there are refused as such, and no limit would make room for them.
    let count = sweeps.end.min(raster.sweeps).saturating_sub(sweeps.start);
    let bytes = 8 * signals * u64::from(count) * u64::from(raster.samples);
    if Limit::PlaneBytes.allows(bytes) {
        return Ok(());
    }
    let problem = Problem::of_file(NAME, "the waveforms are too many for a message").key("sweeps");
    let problem = problem.found(format!("{bytes} bytes")).help(Limit::PlaneBytes.to_string());
    Err(problem.expected(format!("at most {} bytes", Limit::PlaneBytes.value())).into())
}

/// Waveforms: a plane for each signal, one for the instants of those that are told when they change, and the places.
fn traced(traces: Traces) -> Reply {
    let Traces { frame, sweeps, signals, left_out, places, place } = traces;
    let rows: Vec<Value> = signals.iter().map(trace_json).collect();
    let mut planes = Vec::new();
    for Trace { signal, values, times, .. } in signals {
        planes.push(Plane::of(signal.name, &[values.len()], &values));
        if !times.is_empty() {
            planes.push(Plane::of(format!("times:{}", signal.name), &[times.len()], &times));
        }
    }
    planes.push(Plane::of("places", &[places.len()], &places));
    let sweeps = [sweeps.start, sweeps.end];
    let ok =
        json!({ "frame": frame, "sweeps": sweeps, "signals": rows, "left_out": left_out, "place": place });
    Reply { ok, planes }
}

fn trace_json(trace: &Trace) -> Value {
    let Trace { signal, full_scale, counts, .. } = trace;
    json!({ "name": signal.name, "unit": signal.unit.symbol(), "kind": signal.kind.name(), "axis": signal.axis.name(),
            "full_scale": full_scale, "counts": counts })
}

fn signal_json(SignalRow { signal, wire }: &SignalRow) -> Value {
    json!({
        "name": signal.name,
        "block": signal.block(),
        "unit": signal.unit.symbol(),
        "kind": signal.kind.name(),
        "axis": signal.axis.name(),
        "meaning": signal.meaning,
        "is_wired": wire.is_some(),
        "full_scale": wire.map(|wire| wire.full_scale),
        "volts": wire.map(|wire| wire.volts),
        "datum": wire.map(|wire| wire.datum),
    })
}

fn block_json(row: &BlockRow) -> Value {
    let BlockRow { name, left_out, signals, omissions, links, parts, tables } = row;
    let omissions: Vec<Value> = omissions.iter().map(omission_json).collect();
    let links: Vec<Value> = links.iter().map(|link| link_json(link)).collect();
    json!({ "name": name, "left_out": left_out, "signals": signals, "omissions": omissions, "links": links,
            "parts": parts, "tables": tables })
}

fn link_json(Link { to, carries, signals, .. }: &Link) -> Value {
    json!({ "to": to, "carries": carries, "signals": signals })
}
