//! Waveforms of a sweep as curves, lanes, crossings and a picture column.

use generator::{Along, Scan};
use picture::{Depth, Encoder, Transfer};
use plots::{
    Clock, Crossing, Curve, Curves, Line, Logic, LogicLane, PictureColumn, RegisterColour, Scope, Upright,
    Volts,
};
use signal::{Axis, Kind, Signal, Unit, Waveform, Wire};
use sweep_program::Colour;

use crate::{Recorded, ScopeError};

/// A page that borrows what was recorded.
pub struct Page<'a> {
    recorded: &'a Recorded<'a>,
    line: Line,
    /// Where the samples lie along it.
    range: &'a Waveform,
    /// Signals that are shown, in the order of the signal table.
    shown: Vec<&'a Waveform>,
    grey: Vec<f64>,
}

impl<'a> Page<'a> {
    /// Finds what can be shown along a sweep, or along a row.
    pub fn new(recorded: &'a Recorded<'a>) -> Result<Self, ScopeError> {
        let scan = &recorded.scan;
        let is_shown = |waveform: &&Waveform| {
            recorded.wanted.contains(&waveform.signal.name) && runs_along(&waveform.signal, scan)
        };
        let shown: Vec<&Waveform> = recorded.waveforms.iter().filter(is_shown).collect();
        let (Some(range), false) = (find(recorded, scan.place), shown.is_empty()) else {
            return Err(ScopeError::NothingAlong { line: scan.line, place: scan.place });
        };
        Ok(Self { recorded, line: line_of(scan.along), range, shown, grey: grey(recorded)? })
    }

    /// What its samples follow one another along.
    pub fn line(&self) -> Line {
        self.line
    }

    /// What stands below the title.
    pub fn facts(&self) -> Vec<String> {
        match self.line {
            Line::Sweep => self.facts_of_sweep(),
            Line::Row => self.facts_of_row(),
            Line::ScanLine => self.facts_of_scan_line(),
        }
    }

    fn facts_of_scan_line(&self) -> Vec<String> {
        let (frame, line, lines) = (self.range.frame, self.range.sweep, self.recorded.scan.timebase.sweeps);
        vec![format!("frame {frame}, scan line {line} of {lines}; {} samples", self.range.values.len())]
    }

    fn facts_of_row(&self) -> Vec<String> {
        let (frame, row, across) = (self.range.frame, self.range.sweep, &self.range.values);
        let (points, rows) = (across.len(), self.recorded.scan.timebase.sweeps);
        let step = across.get(1).map_or(0.0, |second| second - across[0]);
        let ahead = self.recorded.scan.ahead().and_then(|along| find(self.recorded, along));
        let ahead = ahead.and_then(|along| along.values.first()).copied().unwrap_or(0.0);
        vec![format!(
            "frame {frame}, row {row} of {rows}, {ahead:.1} m along the line of sight; {points} points, one every {step:.2} m"
        )]
    }

    fn facts_of_sweep(&self) -> Vec<String> {
        let clocks = &self.recorded.scan.timebase;
        let (frame, sweep, sweeps) = (self.range.frame, self.range.sweep, clocks.sweeps);
        let period = 1e9 / clocks.sample_rate().hertz();
        let samples = self.range.values.len();
        vec![format!("frame {frame}, sweep {sweep} of {sweeps}; {samples} samples, one every {period:.2} ns")]
    }

    /// Returns what the page shows: clock, panels, lanes and picture column.
    pub fn scope(&self) -> Scope<'_> {
        let period = match self.line {
            Line::Sweep => 1e6 / self.recorded.scan.timebase.sample_rate().hertz(),
            Line::Row | Line::ScanLine => 1.0,
        };
        let line = find(self.recorded, "dpp.y").map(|waveform| &waveform.values[..]);
        let column = PictureColumn { grey: &self.grey, line };
        Scope {
            clock: Clock { ranges: &self.range.values, period, line: self.line },
            panels: self.panels(),
            lanes: self.lanes(),
            crossings: self.crossings("sweep"),
            coarse: self.crossings("sweep.coarse"),
            blanked: find(self.recorded, "dpp.blank").map_or(Vec::new(), |gate| stretches(&gate.values)),
            column: (!self.grey.is_empty()).then_some(column),
        }
    }

    /// One panel a unit and scale.
    fn panels(&self) -> Vec<Curves<'_>> {
        let mut panels: Vec<(Unit, Curves<'_>)> = Vec::new();
        for waveform in self.shown.iter().filter(|waveform| waveform.signal.kind == Kind::Analog) {
            let (unit, volts) = (waveform.signal.unit, self.volts(waveform));
            let curve = Curve { name: waveform.signal.name, values: &waveform.values };
            match panels.iter_mut().find(|(known, curves)| *known == unit && curves.volts == volts) {
                Some((_, curves)) => curves.curves.push(curve),
                None => panels.push((unit, self.panel(waveform, volts, curve))),
            }
        }
        panels.into_iter().map(|(_, curves)| curves).collect()
    }

    fn panel<'c>(&self, waveform: &Waveform, volts: Option<Volts>, curve: Curve<'c>) -> Curves<'c> {
        let unit = waveform.signal.unit;
        let upright = match (unit, self.line) {
            (Unit::Line, Line::Sweep) => Upright::Lines(self.grey.len().max(1) as u32),
            (Unit::Line, Line::Row | Line::ScanLine) => {
                Upright::Lines(self.wire(waveform).map_or(1, |wire| wire.full_scale as u32))
            }
            _ => Upright::Values,
        };
        let symbol = if unit.symbol() == "1" { "" } else { unit.symbol() };
        Curves { label: unit.quantity().into(), unit: symbol.into(), upright, volts, curves: vec![curve] }
    }

    fn volts(&self, waveform: &Waveform) -> Option<Volts> {
        let Wire { full_scale, volts, datum, .. } = *self.wire(waveform)?;
        (full_scale > 0.0 && volts > 0.0).then_some(Volts { full_scale, volts, datum })
    }

    fn wire(&self, waveform: &Waveform) -> Option<&Wire> {
        self.recorded.wires.iter().find(|wire| wire.signal.name == waveform.signal.name)
    }

    fn lanes(&self) -> Vec<LogicLane<'_>> {
        let digital = self.shown.iter().filter(|waveform| waveform.signal.kind != Kind::Analog);
        digital
            .map(|waveform| LogicLane { name: waveform.signal.name, logic: self.logic(waveform) })
            .collect()
    }

    fn logic(&self, waveform: &Waveform) -> Logic {
        let changes = || instants(waveform).into_iter();
        match (waveform.signal.axis, waveform.signal.kind) {
            (Axis::Ground, _) => Logic::sampled(&waveform.values),
            (_, Kind::Gate) => Logic::Levels(changes().map(|(at, value)| (at, value > 0.5)).collect()),
            (_, Kind::Event) => {
                Logic::Pulses(changes().map(|(at, value)| (at, format!("{value}"))).collect())
            }
            _ => {
                let name = waveform.signal.name;
                let word = |value: f64| match waveform.signal.unit {
                    Unit::Corner => (value >= 0.0).then(|| self.corner(name, value as usize)),
                    _ => Some(format!("{value:.4}")),
                };
                Logic::Words(changes().map(|(at, value)| (at, word(value))).collect(), colour(name))
            }
        }
    }

    /// A corner by its north and east index.
    fn corner(&self, register: &str, number: usize) -> String {
        let columns =
            self.recorded.columns.get(usize::from(register.contains(".coarse."))).filter(|count| **count > 0);
        columns.map_or_else(|| number.to_string(), |count| format!("{},{}", number / count, number % count))
    }

    /// What each fold of a ramp loads: the corners on the side that the sweep comes to (section 6.3).
    fn crossings(&self, ramps: &str) -> Vec<Crossing> {
        use RegisterColour::{Black, Green, Red, Yellow};
        let axes = [("fold.x", [[Red, Green], [Yellow, Black]]), ("fold.y", [[Red, Black], [Green, Yellow]])];
        let of_axis = |(name, loads): (&str, [[RegisterColour; 2]; 2])| {
            let folds = find(self.recorded, &format!("{ramps}.{name}")).map_or(Vec::new(), instants);
            folds.into_iter().map(move |(at, stop)| Crossing { at, loads: loads[usize::from(stop > 0.5)] })
        };
        axes.into_iter().flat_map(of_axis).collect()
    }
}

/// The line of a page for what its samples follow one another along.
fn line_of(along: Along) -> Line {
    match along {
        Along::Range => Line::Sweep,
        Along::Across { .. } => Line::Row,
        Along::Raster => Line::ScanLine,
    }
}

/// Whether a signal can be drawn along a sweep or a row, and is not its axis or the same all along.
pub fn runs_along(signal: &Signal, scan: &Scan) -> bool {
    signal.axis != Axis::Display && signal.name != scan.place && Some(signal.name) != scan.ahead()
}

pub fn find<'a>(recorded: &Recorded<'a>, name: &str) -> Option<&'a Waveform> {
    recorded.waveforms.iter().find(|waveform| waveform.signal.name == name)
}

/// The column as the display shows it.
fn grey(recorded: &Recorded<'_>) -> Result<Vec<f64>, ScopeError> {
    let Some(written) = find(recorded, "sm.write") else { return Ok(Vec::new()) };
    let display = &recorded.display;
    let transfer = Transfer::new(display.white as f32, display.gamma as f32)?;
    let lines: Vec<f32> = written.values.iter().map(|&value| value as f32).collect();
    let picture = Encoder::new(transfer, Depth::Eight).encode(&lines, 1, lines.len())?;
    Ok(picture.levels().collect())
}

fn instants(waveform: &Waveform) -> Vec<(f64, f64)> {
    waveform.times.iter().copied().zip(waveform.values.iter().copied()).collect()
}

/// The colour whose registers a signal is of, by its name.
fn colour(name: &str) -> Option<RegisterColour> {
    let place = Colour::ALL.iter().position(|colour| name.split('.').any(|word| word == colour.name()))?;
    RegisterColour::ALL.get(place).copied()
}

/// Where a gate is high, from its first high sample to the next low one.
fn stretches(gate: &[f64]) -> Vec<[f64; 2]> {
    let (mut found, mut from) = (Vec::new(), None);
    for (sample, &value) in gate.iter().enumerate() {
        match (from, value > 0.5) {
            (None, true) => from = Some(sample as f64),
            (Some(begin), false) => {
                found.push([begin, sample as f64]);
                from = None;
            }
            _ => {}
        }
    }
    found.extend(from.map(|begin| [begin, gate.len().saturating_sub(1) as f64]));
    found
}

#[cfg(test)]
mod tests {
    use super::{colour, line_of, stretches};
    use generator::Along;
    use plots::{Line, RegisterColour};

    #[test]
    fn a_line_is_what_its_places_are() {
        let found = [Along::Range, Along::Across { ahead: "y" }, Along::Raster].map(line_of);
        assert_eq!(found, [Line::Sweep, Line::Row, Line::ScanLine]);
    }

    #[test]
    fn gates_are_high_from_sample_to_sample() {
        assert_eq!(stretches(&[0.0, 1.0, 1.0, 0.0, 0.0, 1.0]), [[1.0, 3.0], [5.0, 5.0]]);
        assert_eq!(stretches(&[1.0, 0.0]), [[0.0, 1.0]]);
        assert!(stretches(&[]).is_empty());
    }

    #[test]
    fn registers_have_the_colour_of_their_name() {
        assert_eq!(colour("tg.coarse.red.hold"), Some(RegisterColour::Red));
        assert_eq!(colour("tg.yellow.xfirst"), Some(RegisterColour::Yellow));
        assert_eq!(colour("tg.height"), None);
    }
}
