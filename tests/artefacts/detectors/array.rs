//! What the array bends (A6 to A12, A25), and what two of them make of one another (A27).

use std::f64::consts::PI;
use std::ops::Range;

use crate::artefacts::detectors::late::of_rows;
use crate::artefacts::look::{Look, between, largest, mean, median};
use crate::artefacts::scenes::{LIFT, OVER, SLOPE, WAVE, row_height};

/// Full scale of the machine (V).
const VOLTS: f64 = 10.0;

/// Height of the rows and waves at full scale (m): the power of two above their highest word.
pub const FULL_SCALE: f64 = 32.0;

/// A6: by how much crests are lowered and troughs filled (m).
pub fn ridge_smear(look: &Look<'_>) -> f64 {
    let lost = look.own().flat_map(|sweep| {
        let [found, right] =
            [look.run, look.clean].map(|run| amplitude(look, sweep, run.wave(sweep, "tg.height")));
        [right - found]
    });
    mean(&lost.collect::<Vec<_>>())
}

/// A6: by how much crests are displaced away from the viewer (m), by the phases of the waves.
pub fn ridge_displacement(look: &Look<'_>) -> f64 {
    let moved = look.own().map(|sweep| {
        let [found, right] = [look.run, look.clean].map(|run| {
            let [cos, sin] = harmonic(look, sweep, run.wave(sweep, "tg.height"));
            libm::atan2(sin, cos)
        });
        let turn = found - right;
        let turn = turn - (turn / (2.0 * PI)).round() * 2.0 * PI;
        turn / (2.0 * PI) * WAVE[0] / look.direction(sweep)[0]
    });
    median(&moved.collect::<Vec<_>>())
}

/// Height of the waves of the clean run (m).
pub fn wave_height(look: &Look<'_>) -> f64 {
    amplitude(look, 0, look.clean.wave(0, "tg.height"))
}

/// Height of the waves in a profile (m), over the whole waves of the sweep.
fn amplitude(look: &Look<'_>, sweep: u32, wave: &[f64]) -> f64 {
    let [cos, sin] = harmonic(look, sweep, wave);
    libm::hypot(cos, sin)
}

/// The first harmonic of a signal over the whole waves of a sweep: cosine and sine, by place to the north.
pub fn harmonic(look: &Look<'_>, sweep: u32, wave: &[f64]) -> [f64; 2] {
    let north = |sample: usize| look.place(sweep, sample as f64)[0] * look.scene.region();
    let from = north(0) + 0.5 * WAVE[0];
    let inside = |&(sample, _): &(usize, &f64)| north(sample) >= from && north(sample) < from + 3.0 * WAVE[0];
    let (mut sums, mut count) = ([0.0; 2], 0.0);
    for (sample, value) in wave.iter().enumerate().filter(inside) {
        let turn = 2.0 * PI * north(sample) / WAVE[0];
        sums = [sums[0] + value * libm::cos(turn), sums[1] + value * libm::sin(turn)];
        count += 1.0;
    }
    sums.map(|sum| 2.0 * sum / count)
}

/// Rates of height (V/µs), sample by sample.
pub fn rates(look: &Look<'_>, sweep: u32) -> Vec<f64> {
    let scale = VOLTS / FULL_SCALE / look.run.sample();
    let height = look.run.wave(sweep, "tg.height");
    height.windows(2).map(|pair| (pair[1] - pair[0]).abs() * scale).collect()
}

/// A7: share of the sweep in which the height runs at its fastest rate, of either sign.
pub fn slew_flattening(look: &Look<'_>) -> f64 {
    let shares = look.own().map(|sweep| {
        let rates = rates(look, sweep);
        let fastest = largest(rates.iter().copied());
        mean(&rates.iter().map(|&rate| f64::from(rate > 0.995 * fastest)).collect::<Vec<_>>())
    });
    mean(&shares.collect::<Vec<_>>())
}

/// Where the ramp of the north axis is off, around its crossings (m of ground along the sweep): the middle value of all
/// crossings, at whole samples before and behind.
struct Around {
    /// From one sample before on backwards.
    before: Vec<f64>,
    /// From one sample behind on.
    behind: Vec<f64>,
}

/// Samples before a crossing that are looked at, and those behind it that a late strobe may take.
const REACHES: [usize; 2] = [40, 30];

/// Samples before a crossing between two folds: more than the lead of the ramps, 0.48 µs with a smoother of 300 ns.
pub const BETWEEN: Range<usize> = 32..38;

/// Heights of the plane within which no part saturates (m).
const CLEAR: f64 = 100.0;

impl Around {
    fn of(look: &Look<'_>) -> Self {
        let [back, ahead] = REACHES.map(|reach| reach as f64);
        let mut found = REACHES.map(|reach| vec![Vec::new(); reach]);
        for sweep in look.own() {
            let (error, height) = (look.error(sweep), look.clean.wave(sweep, "tg.height"));
            let north = look.direction(sweep)[0];
            for crossing in look.crossings(sweep).into_iter().filter(|crossing| crossing.axis == 0) {
                let at = crossing.time;
                let is_inside = at > back + 1.0 && at + ahead + 1.0 < error.len() as f64;
                if !is_inside || between(height, at).abs() > CLEAR {
                    continue;
                }
                for (side, values) in [-1.0, 1.0].into_iter().zip(&mut found) {
                    for (k, values) in (1..).zip(values) {
                        values.push(between(&error, at + side * f64::from(k)) / SLOPE / north);
                    }
                }
            }
        }
        let [before, behind] = found.map(|side| side.iter().map(|values| median(values)).collect());
        Self { before, behind }
    }

    /// Between two folds, when the last one is over and the next one has not begun.
    fn middle(&self) -> f64 {
        mean(&self.before[BETWEEN])
    }
}

/// What a signal comes to a sample before it begins.
fn led_back(signal: &[f64]) -> f64 {
    2.0 * signal[0] - signal[1]
}

/// A8: by how much the ramp is behind before a fold and ahead of it after one, alike (m).
pub fn fold_shortfall(look: &Look<'_>) -> f64 {
    let around = Around::of(look);
    let middle = around.middle();
    let [before, behind] = [middle - led_back(&around.before), led_back(&around.behind) - middle];
    before.min(behind).max(0.0)
}

/// A9: height of the line behind a crossing (m of ground), beyond what is before it and in the middle of a region.
pub fn bright_fringe(look: &Look<'_>) -> f64 {
    let around = Around::of(look);
    let elsewhere = around.before[0].abs().max(around.middle().abs());
    (largest(around.behind.iter().map(|error| error.abs())) - 2.0 * elsewhere).max(0.0)
}

/// A10: the line of two regions in the height of the plateau (m), beyond its neighbours.
pub fn quilting(look: &Look<'_>) -> f64 {
    let found = look.own().map(|sweep| {
        let error = look.error(sweep);
        let line = |waves: f64| line_of(look, sweep, &error, waves);
        line(7.0) - line(6.0).max(line(8.0))
    });
    median(&found.collect::<Vec<_>>()).max(0.0)
}

/// Amplitude of a signal at so many waves in fourteen regions to the north.
pub fn line_of(look: &Look<'_>, sweep: u32, signal: &[f64], waves: f64) -> f64 {
    let north = |sample: usize| look.place(sweep, sample as f64)[0];
    let (from, regions) = (north(0), 14.0);
    let (mut sums, mut count) = ([0.0; 2], 0.0);
    for (sample, value) in signal.iter().enumerate().filter(|(sample, _)| north(*sample) < from + regions) {
        let turn = 2.0 * PI * (north(sample) - from) * waves / regions;
        sums = [sums[0] + value * libm::cos(turn), sums[1] + value * libm::sin(turn)];
        count += 1.0;
    }
    2.0 * libm::hypot(sums[0], sums[1]) / count
}

/// Segments of the function generators that are looked for.
pub const SEGMENTS: f64 = 6.0;

/// A11: breaks of slope at the ends of the first and of the last segment, beyond the bend in their middles (regions; a
/// rise of 1 in height).
pub fn facets(look: &Look<'_>) -> f64 {
    let mut breaks = Vec::new();
    for sweep in look.own() {
        let wave = look.run.wave(sweep, "tg.height");
        let [first, last] = [0.0, wave.len() as f64 - 1.0].map(|time| look.place(sweep, time)[0]);
        let height = |place: f64| between(wave, (place - first) / (last - first) * (wave.len() as f64 - 1.0));
        for row in first.ceil() as usize..last as usize {
            let rise = row_height(row + 1) - row_height(row);
            let bend = |z: f64| {
                let place = row as f64 + z;
                let bend = height(place - REACH) - 2.0 * height(place) + height(place + REACH);
                bend / (rise * REACH)
            };
            let broken = |knee: f64, side: f64| {
                let beside = [-0.5, 0.5].map(|half| side * bend((knee + half) / SEGMENTS));
                side * bend(knee / SEGMENTS) - 0.5 * (beside[0].abs() + beside[1].abs())
            };
            breaks.push(0.5 * (broken(1.0, 1.0) + broken(SEGMENTS - 1.0, -1.0)));
        }
    }
    median(&breaks).max(0.0)
}

/// Half of the length over which a bend is taken (regions).
pub const REACH: f64 = 0.06;

/// Step of a word of six bits, with its sign, in the height of the rows (m).
pub const LEAST: f64 = FULL_SCALE / 32.0;

/// A12: error of the heights of the rows (m, rms), as far as they stand on the steps of a word, each on the nearest.
pub fn coefficient_steps(look: &Look<'_>) -> f64 {
    let (mut errors, mut beside) = (Vec::new(), Vec::new());
    for [found, right] in row_heights(look) {
        if (found - right).abs() > 0.52 * LEAST {
            return 0.0;
        }
        errors.push((found - right) * (found - right));
        let place = found / LEAST;
        beside.push((place - place.round()).abs());
    }
    let on_steps = 1.0 - mean(&beside) / 0.02;
    mean(&errors).sqrt() * on_steps.max(0.0)
}

/// Heights at the rows of all sweeps, found and right (m).
pub fn row_heights(look: &Look<'_>) -> Vec<[f64; 2]> {
    let rows = look.own().flat_map(|sweep| {
        let crossings = look.crossings(sweep).into_iter();
        let rows = crossings.filter(|crossing| crossing.axis == 0 && crossing.time > 1.0);
        let wave = look.run.wave(sweep, "tg.height");
        rows.map(move |crossing| [between(wave, crossing.time), of_rows(crossing.line as f64)])
    });
    rows.collect()
}

/// A25: length of the tops that are flat at one height (m), beyond what the clean ground has, where they are lower.
pub fn saturation(look: &Look<'_>) -> f64 {
    let flat = |wave: &[f64]| {
        let top = largest(wave.iter().copied());
        let tops = wave.split(|&height| height < top - 1e-3 * FULL_SCALE);
        (top, tops.map(<[f64]>::len).max().unwrap_or(0) as f64 * look.pace())
    };
    let beyond = look.own().map(|sweep| {
        let [(top, length), (right, usual)] =
            [look.run, look.clean].map(|run| flat(run.wave(sweep, "tg.height")));
        if top < right - 0.05 * FULL_SCALE { length - usual } else { 0.0 }
    });
    median(&beyond.collect::<Vec<_>>()).max(0.0)
}

/// Slope along the sweep that a blend of both levels adds to theirs (m/m) at a share of its way, by the rate of the quintic weight.
pub fn slope_of_blend(share: f64) -> f64 {
    30.0 * share * share * (1.0 - share) * (1.0 - share) * LIFT / OVER.blend
}

/// A27: what the slope along the sweep lacks of the rise of the height in the middle of the blend (% of slope): the part of the
/// difference, over the whole blend, that goes as the slope that a blend adds.
pub fn blend_band(look: &Look<'_>) -> f64 {
    let lacks = look.own().map(|sweep| {
        let [height, north, east] =
            ["tg.height", "tg.slope.u", "tg.slope.v"].map(|name| look.run.wave(sweep, name));
        let [cos, sin] = look.direction(sweep);
        let (mut lacking, mut whole) = (0.0, 0.0);
        for sample in 1..height.len() - 1 {
            let share = (look.range_at(sample as f64) - (OVER.range - OVER.blend)) / OVER.blend;
            if !(0.0..=1.0).contains(&share) {
                continue;
            }
            let rise = (height[sample + 1] - height[sample - 1]) / (2.0 * look.pace());
            let added = slope_of_blend(share);
            lacking += (rise - north[sample] * cos - east[sample] * sin) * added;
            whole += added * added;
        }
        lacking / whole
    });
    100.0 * slope_of_blend(0.5) * median(&lacks.collect::<Vec<_>>()).abs()
}
