//! What a stroke leaves on the target: levels of a store, or charge of a tube.

use hardware_model::WriteCompensation;

use crate::stroke::{Stroke, line_mean};

/// Level of the whole charge, as a share of white: white is what the charge of a line at the nominal speed comes to,
/// `1 - 1/e` of the whole (our choice).
pub(crate) const SATURATED: f32 = 1.581_976_7;

/// Strokes shorter than this stay in one line (lines).
const POINT: f32 = 1e-3;

/// More than any signal is: what is summed stays finite.
const LARGEST: f32 = 1e6;

/// How strokes are kept in a row of lines.
pub(crate) trait Target {
    /// What the beam is driven with to show an intensity; below 0 it is off.
    fn drive(&self, intensity: f32) -> f32;
    /// The row is to be written.
    fn begin(&mut self, row: &mut [f32]);
    /// A stroke in either direction over `share` of a step; the beam runs at `speed` (lines a step).
    fn leave(&mut self, stroke: Stroke, share: f32, speed: f32, row: &mut [f32]);
    /// A stroke as it should be, at any speed.
    fn leave_exactly(&mut self, stroke: Stroke, row: &mut [f32]);
    /// All strokes are in the row: it shall hold levels.
    fn finish(&self, row: &mut [f32]);
}

/// A store of levels: what is written again is written over.
#[derive(Debug)]
pub(crate) struct Levels<'a> {
    /// Part of each line that has been written, 0..=1.
    pub covered: &'a mut Vec<f32>,
}

impl Levels<'_> {
    /// Takes away what the stroke writes over. A line that is not full yet is taken to be written where it is empty.
    fn cover(&mut self, stroke: Stroke, row: &mut [f32]) {
        let (bottom, top) = (stroke.from.min(row.len() as f32), stroke.to.max(0.0));
        if bottom <= top {
            return;
        }
        for line in top as usize..(bottom.ceil() as usize).min(row.len()) {
            let part = bottom.min((line + 1) as f32) - top.max(line as f32);
            let before = self.covered[line];
            let again = before + part - 1.0;
            if again > 0.0 {
                row[line] *= (1.0 - again / before).max(0.0);
            }
            self.covered[line] = (before + part).min(1.0);
        }
    }
}

impl Target for Levels<'_> {
    fn drive(&self, intensity: f32) -> f32 {
        intensity.clamp(-LARGEST, LARGEST)
    }

    fn begin(&mut self, row: &mut [f32]) {
        row.fill(0.0);
        self.covered.clear();
        self.covered.resize(row.len(), 0.0);
    }

    fn leave(&mut self, stroke: Stroke, _: f32, _: f32, row: &mut [f32]) {
        self.leave_exactly(stroke, row);
    }

    fn leave_exactly(&mut self, stroke: Stroke, row: &mut [f32]) {
        let stroke = upwards(stroke);
        self.cover(stroke, row);
        if let Some(lit) = stroke.lit() {
            line_mean(lit, row.len(), |line, value| row[line] += value);
        }
    }

    fn finish(&self, _: &mut [f32]) {}
}

/// Charge on the target of a storage tube: current times time, strokes add.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Charge {
    /// Speeds (lines a step) between which the current follows the speed of the beam.
    slowest: f32,
    fastest: f32,
}

impl Charge {
    /// The charge of a line under `compensation`, `nominal` lines a step being the speed at which exposure is right;
    /// `None` where it always is.
    pub fn new(compensation: WriteCompensation, nominal: f64) -> Option<Self> {
        let ratio = match compensation {
            WriteCompensation::Exact => return None,
            WriteCompensation::Ratio(ratio) => ratio.max(1.0).sqrt(),
            WriteCompensation::Off => 1.0,
        };
        Some(Self { slowest: (nominal / ratio) as f32, fastest: (nominal * ratio) as f32 })
    }
}

impl Target for Charge {
    /// The current that leaves the intensity after saturation, at the nominal speed. No beam has more than full.
    fn drive(&self, intensity: f32) -> f32 {
        if intensity > 0.0 { -libm::log1pf(-intensity.min(1.0) / SATURATED) } else { intensity }
    }

    fn begin(&mut self, row: &mut [f32]) {
        row.fill(0.0);
    }

    fn leave(&mut self, stroke: Stroke, share: f32, speed: f32, row: &mut [f32]) {
        let stroke = upwards(stroke);
        let length = stroke.from - stroke.to;
        let whole = share * speed.max(self.slowest).min(self.fastest);
        if length > POINT {
            let Stroke { from, to, start, end } = stroke;
            let density = whole / length;
            self.leave_exactly(Stroke { from, to, start: start * density, end: end * density }, row);
        } else if let Some(line) = line_of(stroke.to, row) {
            *line += whole * 0.5 * (stroke.start.max(0.0) + stroke.end.max(0.0));
        }
    }

    fn leave_exactly(&mut self, stroke: Stroke, row: &mut [f32]) {
        if let Some(lit) = stroke.lit() {
            line_mean(lit, row.len(), |line, value| row[line] += value);
        }
    }

    fn finish(&self, row: &mut [f32]) {
        for value in row {
            *value = -SATURATED * libm::expm1f(-*value);
        }
    }
}

/// The stroke of a falling beam as the rising one that leaves the same.
fn upwards(stroke: Stroke) -> Stroke {
    let Stroke { from, to, start, end } = stroke;
    if to <= from { stroke } else { Stroke { from: to, to: from, start: end, end: start } }
}

fn line_of(place: f32, row: &mut [f32]) -> Option<&mut f32> {
    if place >= 0.0 { row.get_mut(place as usize) } else { None }
}
