//! The third video switch made of real parts.
//!
//! ```text
//! what the sweep left ─▶ C ┐
//! face reflectivity ───▶ S ┴ fade ─▶ line        its gate: presence, by a comparator
//! ```
//!
//! **Law.** Bodies are drawn along each sweep at an even rate of lines, from the foot of the picture up, in the active part of
//! the sweep. The gate is late by its comparator's delay, and the switch fades over its transition, centred on that
//! ([`parts::Fade`]): in lines, both times the rate. What it takes from S is off by gain and level ([`parts::Switch`]).
//! A line shows its mean.
//! **Parameters.** `video_switch`, `comparator.delay`, `spread`.
//! **State and timing.** None between sweeps.
//! **Elaboration.** With ideal figures the block lays its spans as they are, and nothing of this is there.
//! **Our choices.** The reflectivity stands in its register until the next face's comes, so a late gate leaves no seam.
//! **Not modelled.** Crosstalk and differential delay of this switch; [`scenario::PixelRule::Centre`].

use hardware_model::AnalogParts;
use parts::{Fade, Spread, Switch, SwitchLaw, Tolerance, relative_sigma};

use crate::Run;

/// The switch, drawn once from the seed of the model.
#[derive(Debug, Clone, Copy)]
pub struct PartsSwitch {
    part: Switch<f64>,
    /// Length of the transition (lines).
    transition: f64,
    late: f64,
}

/// Fade of a sweep; used again from sweep to sweep.
#[derive(Debug, Clone, Default)]
pub struct BodyFade {
    fade: Fade,
    toggles: Vec<f64>,
    cuts: Vec<f64>,
}

impl PartsSwitch {
    /// The switch for `rate` lines a second; `seed` is the model's.
    pub fn new(rate: f64, parts: &AnalogParts, seed: u64) -> Self {
        let (figures, spread) = (&parts.video_switch, Spread::new(seed));
        let sigma = if parts.spread { relative_sigma::SWITCH_DELAY } else { 0.0 };
        let draw = |part: &str, nominal: f64| spread.figure(part, 0, &Tolerance { nominal, sigma });
        let law = SwitchLaw {
            gain_mismatch: spread.error("mu.vs3.gain", 0, figures.gain_mismatch),
            level_mismatch: spread.error("mu.vs3.level", 0, figures.level_mismatch),
        };
        Self {
            part: Switch::new(&law),
            transition: rate * draw("mu.vs3.time", figures.time),
            late: rate * draw("pg.comparator", parts.comparator.delay),
        }
    }

    /// Lays `runs`, disjoint and from the top, over a row of lines.
    pub fn write(&self, runs: &[Run], work: &mut BodyFade, row: &mut [f32]) {
        self.write_through(runs, 0.0, work, row);
    }

    /// Lays runs that let a share of what is behind them through: their input S is that share of C, and their own light.
    pub fn write_through(&self, runs: &[Run], translucency: f64, work: &mut BodyFade, row: &mut [f32]) {
        let on = |face: f64| self.part.output(1.0, 0.0, face);
        let opacity = 1.0 - (on(translucency) - on(0.0));
        let lines = row.len() as f64;
        // Upwards from the foot of the picture.
        let begin = |run: &Run| lines - f64::from(run.bottom);
        work.follow(runs, lines, self);
        let mut line = Line::default();
        let mut run = runs.len();
        for pair in work.cuts.windows(2) {
            let [from, to] = [pair[0].max(0.0), pair[1].min(lines)];
            while run > 1 && begin(&runs[run - 2]) <= pair[0] {
                run -= 1;
            }
            if from < to {
                let ends = [work.fade.at(pair[0])[1], work.fade.at(pair[1])[0]];
                let g = |time: f64| ends[0] + (ends[1] - ends[0]) * ((time - pair[0]) / (pair[1] - pair[0]));
                match runs.get(run.wrapping_sub(1)) {
                    Some(run) if run.ramp != 0.0 => {
                        let face = |time: f64| on(run.reflectivity_at(lines - time));
                        line.lay_ramp([from, to], g, (opacity, face), row);
                    }
                    run => {
                        let face = run.map_or(0.0, |run| f64::from(run.reflectivity));
                        line.lay([from, to], g, [opacity, on(face)], row);
                    }
                }
            }
        }
        line.mix(row);
    }
}

impl BodyFade {
    /// The gate over a sweep, and the instants between which it is straight and the face the same.
    fn follow(&mut self, runs: &[Run], lines: f64, switch: &PartsSwitch) {
        self.toggles.clear();
        for (index, run) in runs.iter().enumerate().rev() {
            let [begin, end] = [run.bottom, run.top].map(|line| lines - f64::from(line) + switch.late);
            match self.toggles.last_mut() {
                // The face goes on where the one below it ended.
                Some(last) if runs[index + 1].top == run.bottom => *last = end,
                _ => self.toggles.extend([begin, end]),
            }
        }
        self.fade.follow(false, self.toggles.iter().copied(), switch.transition);
        self.cuts.clear();
        self.cuts.extend(self.fade.knots().iter().map(|knot| knot[0]));
        self.cuts.extend(runs.iter().map(|run| lines - f64::from(run.bottom)));
        let ramps = runs.iter().filter(|run| run.ramp != 0.0);
        self.cuts.extend(ramps.map(|run| lines - f64::from(run.top)));
        self.cuts.sort_by(f64::total_cmp);
        self.cuts.dedup();
    }
}

/// A line being covered, counted from the foot.
#[derive(Debug, Clone, Copy, Default)]
struct Line {
    index: usize,
    cover: f64,
    sum: f64,
}

impl Line {
    /// Adds a stretch over which `g` is straight. The open switch hides the share `opacity` of the line and adds `face`.
    fn lay(&mut self, ends: [f64; 2], g: impl Fn(f64) -> f64, [opacity, face]: [f64; 2], row: &mut [f32]) {
        self.each(ends, row, |line, [begin, end]| {
            let cover = (end - begin).max(0.0) * g(0.5 * (begin + end));
            line.cover += cover * opacity;
            line.sum += cover * face;
        });
    }

    /// The same where `face` is a ramp: its product with `g` is a parabola, whose mean Simpson's rule has.
    fn lay_ramp(
        &mut self,
        ends: [f64; 2],
        g: impl Fn(f64) -> f64,
        (opacity, face): (f64, impl Fn(f64) -> f64),
        row: &mut [f32],
    ) {
        self.each(ends, row, |line, [begin, end]| {
            let (length, middle) = ((end - begin).max(0.0), 0.5 * (begin + end));
            let lit = |time: f64| g(time) * face(time);
            line.cover += length * g(middle) * opacity;
            line.sum += length * (lit(begin) + 4.0 * lit(middle) + lit(end)) / 6.0;
        });
    }

    /// Hands the part of each line that a stretch covers to `add`, and mixes each line that is done.
    fn each(&mut self, [from, to]: [f64; 2], row: &mut [f32], add: impl Fn(&mut Self, [f64; 2])) {
        for index in from as usize..(to.ceil() as usize).min(row.len()) {
            if index != self.index {
                self.mix(row);
                *self = Self { index, ..Self::default() };
            }
            add(self, [from.max(index as f64), to.min(index as f64 + 1.0)]);
        }
    }

    fn mix(&self, row: &mut [f32]) {
        if self.cover != 0.0 || self.sum != 0.0 {
            let value = &mut row[row.len() - 1 - self.index];
            *value = (f64::from(*value) * (1.0 - self.cover).max(0.0) + self.sum).clamp(0.0, 1.0) as f32;
        }
    }
}

#[cfg(test)]
mod tests;
