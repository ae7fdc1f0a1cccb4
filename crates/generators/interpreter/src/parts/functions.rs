//! Function generators of one axis: values and slopes of the three orders, fed with the ramp and with its complement.

use super::drawn::Drawn;
use super::figures::{FunctionFigures, PEAKS, UNITS};
use super::series::LagMap;
use crate::terrain::generators;

/// The function generators of one axis along a sweep, shares of full scale.
#[derive(Debug, Clone)]
pub struct FunctionCircuits<'a> {
    figures: [FunctionFigures; UNITS],
    step: f64,
    lags: [LagMap; UNITS],
    broken_lines: &'a [Vec<f64>],
    input: [f64; UNITS],
    /// Outputs: `6 slope + 3 end + order`.
    pub outputs: [f64; UNITS],
}

impl<'a> FunctionCircuits<'a> {
    /// At rest under a ramp at `ramp`, for steps of `step` seconds.
    pub fn at_rest(figures: [FunctionFigures; UNITS], step: f64, ramp: f64, drawn: &Drawn<'a>) -> Self {
        let mut circuits = Self {
            lags: figures.map(|figures| LagMap::of(step, figures.tau)),
            figures,
            step,
            broken_lines: drawn.broken_lines,
            input: [0.0; UNITS],
            outputs: [0.0; UNITS],
        };
        circuits.input = circuits.inputs(ramp);
        circuits.outputs = circuits.input;
        circuits
    }

    /// A step later, with the ramp at `ramp`.
    pub fn step(&mut self, ramp: f64) {
        let now = self.inputs(ramp);
        for unit in 0..UNITS {
            self.outputs[unit] = self.lags[unit].step(self.outputs[unit], [self.input[unit], now[unit]]);
        }
        self.input = now;
    }

    /// Outputs a `share` of a step later, of which `after` is the end, with the ramp at `ramp`: what stands before the lags goes
    /// straight there. A generator without a lag follows the ramp.
    pub fn towards(&self, after: &Self, share: f64, ramp: f64) -> [f64; UNITS] {
        let now = self.inputs(ramp);
        std::array::from_fn(|unit| {
            if self.figures[unit].tau == 0.0 {
                return now[unit];
            }
            let (from, to) = (self.input[unit], after.input[unit]);
            let lag = LagMap::of(share * self.step, self.figures[unit].tau);
            lag.step(self.outputs[unit], [from, from + (to - from) * share])
        })
    }

    /// What the circuits make of a ramp before their lags.
    fn inputs(&self, ramp: f64) -> [f64; UNITS] {
        let ends = [ramp, 1.0 - ramp];
        let exact = ends.map(generators);
        std::array::from_fn(|unit| {
            let (slope, end, order) = (unit / 6, unit / 3 % 2, unit % 3);
            let (fed, curve) = (ends[end], 3 * slope + order);
            let value = match self.broken_lines.get(curve) {
                Some(points) => on_the_line(points, fed),
                None => [exact[end].value, exact[end].slope][slope][order] / PEAKS[curve],
            };
            value + 4.0 * self.figures[unit].bow * fed * (1.0 - fed)
        })
    }
}

/// A line through points at equal distances over 0..=1; its ends go on straight.
fn on_the_line(points: &[f64], z: f64) -> f64 {
    let cells = (points.len() - 1) as f64;
    let cell = (z * cells).floor().clamp(0.0, cells - 1.0);
    let [from, to] = [points[cell as usize], points[cell as usize + 1]];
    from + (to - from) * (z * cells - cell)
}
