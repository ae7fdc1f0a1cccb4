//! What a stroke leaves on the target: levels of a store, or charge of a tube.

use fearless_simd::prelude::{Select, SimdBase, SimdCvtTruncate, SimdFloat, SimdFrom};
use fearless_simd::{Simd, f32x8, u32x8};
use hardware_model::WriteCompensation;
use signal::Comparable;

use crate::aim::Dots;
use crate::stroke::{Stroke, line_mean};

/// Level of the whole charge, as a share of white: white is what the charge of a line at the nominal speed comes to,
/// `1 - 1/e` of the whole (our choice).
pub(crate) const SATURATED: f32 = 1.581_976_7;

/// Strokes shorter than this stay in one line (lines).
const POINT: f32 = 1e-3;

/// More than any signal is: what is summed stays finite.
const LARGEST: f64 = 1e6;

/// `artanh s / s` by `s^2`, of s up to 0.47.
const ARTANH: [f64; 10] = [
    1.0,
    1.0 / 3.0,
    1.0 / 5.0,
    1.0 / 7.0,
    1.0 / 9.0,
    1.0 / 11.0,
    1.0 / 13.0,
    1.0 / 15.0,
    1.0 / 17.0,
    1.0 / 19.0,
];

/// How strokes are kept in a row of lines.
pub(crate) trait Target {
    /// What the beam is driven with to show an intensity; below 0 it is off.
    fn drive<V: Comparable>(&self, intensity: V) -> V;
    /// What whole steps leave, from places and drives at two samples, where they touch at most two of `lines` lines.
    fn dots<L: Simd>(&self, simd: L, places: [f32x8<L>; 2], drives: [f32x8<L>; 2], lines: f32) -> Dots;
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
    #[inline(always)]
    fn drive<V: Comparable>(&self, intensity: V) -> V {
        intensity.within(intensity.like(-LARGEST), intensity.like(LARGEST))
    }

    /// What a step leaves depends on what is there.
    #[inline(always)]
    fn dots<L: Simd>(&self, _: L, _: [f32x8<L>; 2], _: [f32x8<L>; 2], _: f32) -> Dots {
        Dots::NONE
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
    /// `-ln (1 - y) = 2 artanh (y / (2 - y))`.
    #[inline(always)]
    fn drive<V: Comparable>(&self, intensity: V) -> V {
        let [zero, one] = [0.0, 1.0].map(|value| intensity.like(value));
        let y = intensity.within(zero, one) * intensity.like(1.0 / f64::from(SATURATED));
        let s = y / (intensity.like(2.0) - y);
        let (square, mut sum) = (s * s, intensity.like(ARTANH[ARTANH.len() - 1]));
        for &power in ARTANH[..ARTANH.len() - 1].iter().rev() {
            sum = sum * square + intensity.like(power);
        }
        s * sum * intensity.like(2.0) + zero.at_most(intensity)
    }

    #[inline(always)]
    fn dots<L: Simd>(
        &self,
        simd: L,
        [before, now]: [f32x8<L>; 2],
        [start, end]: [f32x8<L>; 2],
        lines: f32,
    ) -> Dots {
        let splat = |value: f32| f32x8::simd_from(simd, value);
        let (zero, half, one, two) = (splat(0.0), splat(0.5), splat(1.0), splat(2.0));
        let (top, bottom) = (before.min(now), before.max(now));
        let line = top.floor();
        // What is not a number passes no comparison.
        let is_dot = before.simd_ge(zero)
            & now.simd_ge(zero)
            & bottom.simd_le(line + two)
            & (line + two).simd_le(splat(lines))
            & start.simd_ge(zero)
            & end.simd_ge(zero);
        let length = bottom - top;
        let whole = half * length.max(splat(self.slowest)).min(splat(self.fastest));
        // How much of the step is in the upper line, and the drive where it leaves it.
        let divided = bottom.simd_gt(line + one) & length.simd_gt(splat(POINT));
        let share = divided.select((line + one - top) / length, one);
        let falls = now.simd_gt(before);
        let (upper, lower) = (falls.select(start, end), falls.select(end, start));
        let between = upper + (lower - upper) * share;
        let line = u32x8::truncate_from(is_dot.select(line, zero));
        let line = is_dot.select(line, u32x8::simd_from(simd, u32::MAX));
        let charges = [whole * (upper + between) * share, whole * (between + lower) * (one - share)];
        Dots { lines: line.into(), charges: [charges[0].into(), charges[1].into()] }
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

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, SimdBase, dispatch, f32x8};
    use hardware_model::WriteCompensation;
    use quantities::unit_interval;
    use signal::LANES;

    use super::{Charge, SATURATED, Target};
    use crate::aim::Dots;
    use crate::stroke::Stroke;

    const LINES: usize = 12;

    fn charge() -> Charge {
        Charge::new(WriteCompensation::Ratio(100.0), 0.5).expect("no exact compensation")
    }

    #[test]
    fn the_current_is_what_is_left_of_saturation_taken_back() {
        for intensity in (0..=2000).map(|k| k as f32 / 1600.0) {
            let right = -libm::log1p(f64::from(-intensity.min(1.0)) / f64::from(SATURATED));
            let own = f64::from(charge().drive(intensity));
            assert!((own - right).abs() <= 3e-7 * right, "{intensity}: {own}, {right}");
        }
        assert_eq!(
            [-0.0, -0.7, f32::NEG_INFINITY].map(|dark| charge().drive(dark)),
            [0.0, -0.7, f32::NEG_INFINITY]
        );
        assert!(charge().drive(f32::NAN).is_nan());
    }

    /// Steps of all lengths, about the edges of lines and of the picture, black and beyond at their ends.
    #[test]
    fn dots_are_what_the_strokes_leave() {
        let mut found = 0;
        for round in 0..4000 {
            let drawn = |what: u64, lane: usize| unit_interval(5, &[round, what, lane as u64]) as f32;
            let places = |lane: usize| {
                let before = (16.0 * drawn(0, lane) - 2.0) * 4.0;
                let before = if drawn(1, lane) < 0.3 { before.round() } else { before } / 4.0;
                let step = [0.0, 1e-4, 0.6, 4.0][(4.0 * drawn(2, lane)) as usize] * (drawn(3, lane) - 0.5);
                [before, if drawn(4, lane) < 0.05 { f32::NAN } else { before + step }]
            };
            let drives = |lane: usize| [5, 6].map(|what| drawn(what, lane) - 0.05);
            let lanes =
                |of: &dyn Fn(usize) -> [f32; 2], end: usize| std::array::from_fn(|lane| of(lane)[end]);
            let ends = |of| [0, 1].map(|end| lanes(of, end));
            let (place, drive): ([[f32; LANES]; 2], [[f32; LANES]; 2]) = (ends(&places), ends(&drives));
            let Dots { lines, charges } = dispatch!(Level::new(), simd => {
                let [a, b, c, d] =
                    [&place[0], &place[1], &drive[0], &drive[1]].map(|ends| f32x8::from_slice(simd, ends));
                charge().dots(simd, [a, b], [c, d], LINES as f32)
            });
            for lane in (0..LANES).filter(|&lane| (lines[lane] as usize) < LINES) {
                let ([from, to], [start, end]) = (places(lane), drives(lane));
                let (mut row, mut dot) = ([0.0; LINES], [0.0; LINES]);
                charge().leave(Stroke { from, to, start, end }, 1.0, (to - from).abs(), &mut row);
                (dot[lines[lane] as usize], dot[lines[lane] as usize + 1]) =
                    (charges[0][lane], charges[1][lane]);
                for (dot, right) in dot.into_iter().zip(row) {
                    assert!((dot - right).abs() <= 2e-5, "{from}, {to}: {dot}, {right}");
                }
                found += 1;
            }
        }
        assert!(found > 8000, "{found}");
    }
}
