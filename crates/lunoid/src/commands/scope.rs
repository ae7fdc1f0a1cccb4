//! Waveforms of one sweep as a picture, against ground range.

use std::path::Path;

use plots::{Axis, Lane, Panel, Trace, TraceLook, trace_picture};
use signal::{Unit, Waveform};

use crate::Failure;

/// The signal that the picture is drawn against.
pub const RANGE: &str = "sweep.range";

/// Draws the waveforms of one sweep that are sampled like `sweep.range`, one panel a unit, gates as digital lines.
pub fn write_picture(path: &Path, waveforms: &[Waveform], wanted: &[&str]) -> Result<(), Failure> {
    let range = waveforms.iter().find(|waveform| waveform.signal.name == RANGE);
    let Some(range) = range else { return Err(nothing_to_draw(path)) };
    let drawn: Vec<&Waveform> = waveforms
        .iter()
        .filter(|waveform| waveform.signal.name != RANGE && wanted.contains(&waveform.signal.name))
        .filter(|waveform| waveform.signal.axis == range.signal.axis)
        .collect();
    let x = &range.values;
    let (gates, curves): (Vec<&Waveform>, Vec<&Waveform>) =
        drawn.into_iter().partition(|waveform| waveform.signal.unit == Unit::Gate);
    let states: Vec<Vec<bool>> =
        gates.iter().map(|gate| gate.values[1..].iter().map(|&value| value > 0.5).collect()).collect();
    let lanes: Vec<Lane<'_>> =
        gates.iter().zip(&states).map(|(gate, high)| Lane { name: gate.signal.name, x, high }).collect();
    let panels = panels(&curves, x);
    if panels.is_empty() && lanes.is_empty() {
        return Err(nothing_to_draw(path));
    }
    let title = format!("frame {}, sweep {}", range.frame, range.sweep);
    let axis = Axis::new("ground range (m)").logarithmic();
    let picture = trace_picture(&axis, &panels, &lanes, &TraceLook::titled(title)).map_err(Failure::input)?;
    picture.write(path).map_err(Failure::output)
}

/// One panel a unit, in the order of the signal table.
fn panels<'a>(curves: &[&'a Waveform], x: &'a [f64]) -> Vec<Panel<'a>> {
    let mut panels: Vec<(Unit, Panel<'a>)> = Vec::new();
    for waveform in curves {
        let trace = Trace { name: waveform.signal.name, x, y: &waveform.values };
        let unit = waveform.signal.unit;
        match panels.iter_mut().find(|(known, _)| *known == unit) {
            Some((_, panel)) => panel.traces.push(trace),
            None => panels.push((unit, Panel { axis: Axis::new(unit.quantity()), traces: vec![trace] })),
        }
    }
    panels.into_iter().map(|(_, panel)| panel).collect()
}

fn nothing_to_draw(path: &Path) -> Failure {
    Failure::usage(format!(
        "--out {}: no signal on the sweep clock is asked for; a picture needs one, beside {RANGE}",
        path.display()
    ))
}
