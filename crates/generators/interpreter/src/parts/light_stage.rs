//! The stage that makes light of slopes, part after part over a whole sweep (sheet of the terrain generator, "Light of parts").
//!
//! Each part is a run of values at the samples of the machine; it is driven by straight lines between them, and what it makes of them is
//! told at every step. A loop has the gain of the middle of each sample, and a lag of its own for each.

use std::f64::consts::PI;

use super::kit::Kit;
use super::series::LagMap;
use crate::given::straight;

/// Names of the wires, behind `tg.light.`.
pub const NAMES: [&str; 9] =
    ["product.n", "product.e", "product.u", "facing", "square.n", "square.e", "squares", "root", "cosine"];

/// Leaks are given as shares of a sine wave of this frequency (Hz).
const LEAKS_AT: f64 = 1e6;
/// An amplifier without feedback has a gain of a thousand: no root and no divisor is less.
const LEAST: f64 = 1e-3;

/// Wires in their units, in the order of [`NAMES`], step by step.
pub type LightWires = [Vec<f64>; 9];

/// What ideal parts make of slopes to the north and to the east.
pub fn ideal(slopes: &[[f64; 2]], to_sun: [f64; 3]) -> LightWires {
    let mut wires = LightWires::default();
    for [hx, hy] in slopes {
        let facing = to_sun[2] - (hx * to_sun[0] + hy * to_sun[1]);
        let squares = hx * hx + hy * hy + 1.0;
        let normal = libm::hypot(1.0, libm::hypot(*hx, *hy));
        let now = [
            to_sun[0] * hx,
            to_sun[1] * hy,
            to_sun[2],
            facing,
            hx * hx,
            hy * hy,
            squares,
            normal,
            facing / normal,
        ];
        for (wire, value) in wires.iter_mut().zip(now) {
            wire.push(value);
        }
    }
    wires
}

/// A multiplier of the stage.
#[derive(Debug, Clone, Copy)]
pub struct MultiplierFigures {
    /// Scale error (share of the product).
    pub gain: f64,
    /// Feedthrough of both inputs.
    pub feed: [f64; 2],
    /// Offset of the output (share of full scale).
    pub offset: f64,
    /// Bend of the first input.
    pub bend: f64,
    /// What it makes of a change by 1 in a sample.
    pub leak: f64,
    /// Time constant of its lag (samples).
    pub tau: f64,
}

/// The stage of a model.
#[derive(Debug, Clone)]
pub struct LightStage {
    /// Slope at full scale (m/m).
    pub scale: f64,
    /// Length of the longest normal of slopes in scale.
    pub span: f64,
    /// Products with the sun's words for north, east and up.
    pub products: [MultiplierFigures; 3],
    /// Squarers of north and east.
    pub squarers: [MultiplierFigures; 2],
    /// Time constants of the summers (samples).
    pub summers: [f64; 2],
    /// Scale and offset of the squarer in the root's feedback, and the time constant at full scale (samples).
    pub root: [f64; 3],
    /// Scale, feedthrough of output and of divisor, offset, and the time constant at full scale (samples).
    pub divider: [f64; 5],
    /// Voltage of either sign at which wires clip (share of full scale).
    pub saturation: f64,
    /// By how many samples the slopes run ahead.
    pub ahead: f64,
    /// Steps of a sample.
    between: usize,
}

impl LightStage {
    /// As the seed drew it, with so many steps in each sample; none where its parts are ideal.
    pub fn of(kit: &Kit<'_>, between: usize) -> Option<Self> {
        let parts = &kit.analog.reflectivity;
        if parts.stage_is_ideal() {
            return None;
        }
        let error = |name: &str, sigma: f64| kit.drawn.error(&format!("tg.light.{name}"), 0, sigma);
        let lag =
            |name: &str, number: usize, band| kit.lag(&format!("tg.light.{name}.bandwidth"), number, band);
        let scale_error = parts.multiplier.scale_error;
        // A multiplier in feedback has a hundredth of its scale at least.
        let scale = |part: &str| (1.0 + error(&format!("{part}.eg"), scale_error)).max(0.01);
        let half = 0.5 * parts.divider.error;
        let span = (2.0 * parts.slope_full_scale * parts.slope_full_scale + 1.0).sqrt();
        let nominal = [parts.multiplier.bandwidth, parts.summer_bandwidth].map(|band| kit.nominal_lag(band));
        Some(Self {
            scale: parts.slope_full_scale,
            span,
            products: [0, 1, 2].map(|number| MultiplierFigures::of(kit, "product", number)),
            squarers: [0, 1].map(|number| MultiplierFigures::of(kit, "square", number)),
            summers: [0, 1].map(|number| lag("sum", number, parts.summer_bandwidth)),
            root: [scale("root"), error("root.eo", parts.root.error), lag("root", 0, parts.root.bandwidth)],
            divider: [
                scale("divider"),
                error("divider.ex", half),
                error("divider.ey", half),
                error("divider.eo", half),
                lag("divider", 0, parts.divider.bandwidth),
            ],
            saturation: parts.saturation.map_or(f64::INFINITY, |volts| kit.share(volts)),
            ahead: nominal[0] + nominal[1] + span * kit.nominal_lag(parts.divider.bandwidth),
            between,
        })
    }

    /// The wires over slopes to the north and to the east at every step.
    pub fn run(&self, slopes: &[[f64; 2]], to_sun: [f64; 3]) -> LightWires {
        let count = slopes.len();
        let samples: Vec<[f64; 2]> = slopes.iter().step_by(self.between).copied().collect();
        let seen = [0, 1].map(|axis| self.seen(&samples, axis));
        let none = vec![1.0; samples.len()];
        let word = |axis: usize| vec![to_sun[axis]; samples.len()];
        let product = |axis: usize, of: &[f64]| self.multiply(&self.products[axis], of, &word(axis), count);
        let [north, east, up] = [product(0, &seen[0]), product(1, &seen[1]), product(2, &none)];
        let [square_n, square_e] =
            [0, 1].map(|axis| self.multiply(&self.squarers[axis], &seen[axis], &seen[axis], count));
        let (s, r) = (self.scale, self.span);
        let at = |wire: &Vec<f64>, sample: usize| wire[sample * self.between];
        let each = |value: &dyn Fn(usize) -> f64| (0..samples.len()).map(value).collect::<Vec<f64>>();
        let facing = each(&|k| (at(&up, k) - s * (at(&north, k) + at(&east, k))) / r);
        let squares = each(&|k| (1.0 + s * s * (at(&square_n, k) + at(&square_e, k))) / (r * r));
        let facing = self.clipped(self.lagged(&facing, self.summers[0], count));
        let squares = self.clipped(self.lagged(&squares, self.summers[1], count));
        let [scale, offset, tau] = self.root;
        let rest = each(&|k| ((at(&squares, k) - offset) / scale).max(LEAST * LEAST).sqrt());
        let gain: Vec<f64> = rest.iter().map(|root| scale * root).collect();
        let root = self.clipped(self.looped(&rest, &gain, tau, count));
        let [scale, feed_output, feed_divisor, offset, tau] = self.divider;
        let divisor = each(&|k| (scale * at(&root, k) + feed_output).max(LEAST));
        let rest = each(&|k| (at(&facing, k) - feed_divisor * at(&root, k) - offset) / divisor[k]);
        let cosine = self.clipped(self.looped(&rest, &divisor, tau, count));
        let units = [s, s, 1.0, r, s * s, s * s, r * r, r, 1.0];
        let wires = [north, east, up, facing, square_n, square_e, squares, root, cosine];
        let mut number = 0;
        wires.map(|wire| {
            number += 1;
            wire.into_iter().map(|value| value * units[number - 1]).collect()
        })
    }

    /// Slopes of an axis in scale as the stage sees them: ahead of the beam, held behind the last, clipped.
    fn seen(&self, samples: &[[f64; 2]], axis: usize) -> Vec<f64> {
        let last = samples.len().saturating_sub(1);
        let whole = self.ahead.floor();
        let at = |sample: usize, on: f64| {
            let place = (sample as f64 + whole + on).min(last as f64);
            samples[place as usize][axis] / self.scale
        };
        let value = |sample: usize| {
            let (from, to, share) = (at(sample, 0.0), at(sample, 1.0), self.ahead - whole);
            (1.0 - share) * from + share * to
        };
        self.clipped((0..samples.len()).map(value).collect())
    }

    fn clipped(&self, wire: Vec<f64>) -> Vec<f64> {
        wire.into_iter().map(|value| value.clamp(-self.saturation, self.saturation)).collect()
    }

    /// A product at every step; the second factor of a squarer is the first.
    fn multiply(&self, part: &MultiplierFigures, a: &[f64], b: &[f64], count: usize) -> Vec<f64> {
        let MultiplierFigures { gain, feed, offset, bend, leak, tau } = *part;
        let raw = (0..a.len()).map(|k| {
            let (a, b, before) = (a[k], b[k], a[k.saturating_sub(1)]);
            let errors = feed[0] * a + feed[1] * b + offset + bend * (a - a * a * a);
            (1.0 + gain) * a * b + errors + leak * (a - before)
        });
        self.clipped(self.lagged(&raw.collect::<Vec<_>>(), tau, count))
    }

    /// A lag of `tau` samples behind values at the samples, at rest under the first.
    fn lagged(&self, input: &[f64], tau: f64, count: usize) -> Vec<f64> {
        let map = LagMap::of(1.0 / self.between as f64, tau);
        let mut input = straight(stretched(input, self.between, count), self.between);
        let Some(&first) = input.first() else { return input };
        let (mut before, mut output) = (first, first);
        for value in &mut input {
            output = map.step(output, [before, *value]);
            before = std::mem::replace(value, output);
        }
        input
    }

    /// The same of a loop that would rest at `rest` and whose feedback has a `gain`.
    fn looped(&self, rest: &[f64], gain: &[f64], tau: f64, count: usize) -> Vec<f64> {
        let Some(&first) = rest.first() else { return Vec::new() };
        let (mut out, mut output) = (vec![first], first);
        for (rest, gain) in rest.windows(2).zip(gain.windows(2)) {
            let tau = tau / (0.5 * (gain[0] + gain[1]));
            let begin = output;
            for step in 1..=self.between {
                let share = step as f64 / self.between as f64;
                let end = rest[0] + (rest[1] - rest[0]) * share;
                output = LagMap::of(share, tau).step(begin, [rest[0], end]);
                out.push(output);
            }
        }
        out.resize(count, output);
        out
    }
}

impl MultiplierFigures {
    fn of(kit: &Kit<'_>, part: &str, number: usize) -> Self {
        let figures = &kit.analog.reflectivity.multiplier;
        let error =
            |name: &str, sigma: f64| kit.drawn.error(&format!("tg.light.{part}.{name}"), number, sigma);
        let half = 0.5 * figures.error;
        Self {
            gain: error("eg", figures.scale_error),
            feed: [error("ex", half), error("ey", half)],
            offset: error("eo", half),
            bend: error("en", half),
            leak: error("feedthrough", figures.feedthrough) / (2.0 * PI * LEAKS_AT * kit.step),
            tau: kit.lag(&format!("tg.light.{part}.bandwidth"), number, figures.bandwidth),
        }
    }
}

/// Values at the samples, each for all its steps; what lies behind the last stays.
fn stretched(values: &[f64], between: usize, count: usize) -> Vec<f64> {
    let last = values.len().saturating_sub(1);
    (0..count).map(|step| values[(step / between).min(last)]).collect()
}
