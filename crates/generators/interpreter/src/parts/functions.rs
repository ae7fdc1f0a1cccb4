//! Function generators of one axis: values and slopes of the three orders, fed with the ramp and with its complement.

use super::drawn::Drawn;
use super::figures::{FunctionFigures, PEAKS, UNITS};
use super::series::LagMap;

/// The function generators of one axis along a sweep, shares of full scale.
#[derive(Debug, Clone)]
pub struct FunctionCircuits<'a> {
    figures: [FunctionFigures; UNITS],
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

    /// What the circuits make of a ramp before their lags.
    fn inputs(&self, ramp: f64) -> [f64; UNITS] {
        std::array::from_fn(|unit| {
            let fed = if unit / 3 % 2 == 0 { ramp } else { 1.0 - ramp };
            let curve = 3 * (unit / 6) + unit % 3;
            let value = match self.broken_lines.get(curve) {
                Some(points) => on_the_line(points, fed),
                None => exact(curve, fed) / PEAKS[curve],
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

/// The basis functions of section 5.2 and their slopes.
fn exact(curve: usize, z: f64) -> f64 {
    let rest = 1.0 - z;
    match curve {
        0 => rest * rest * rest * (1.0 + 3.0 * z + 6.0 * z * z),
        1 => z * rest * rest * rest * (1.0 + 3.0 * z),
        2 => 0.5 * z * z * rest * rest * rest,
        3 => -30.0 * z * z * rest * rest,
        4 => rest * rest * (1.0 + 2.0 * z - 15.0 * z * z),
        _ => 0.5 * z * rest * rest * (2.0 - 5.0 * z),
    }
}

/// Ascending powers of the same: what `exact` is when it is multiplied out.
pub fn exact_powers(curve: usize) -> [f64; 6] {
    match curve {
        0 => [1.0, 0.0, 0.0, -10.0, 15.0, -6.0],
        1 => [0.0, 1.0, 0.0, -6.0, 8.0, -3.0],
        2 => [0.0, 0.0, 0.5, -1.5, 1.5, -0.5],
        3 => [0.0, 0.0, -30.0, 60.0, -30.0, 0.0],
        4 => [1.0, 0.0, -18.0, 32.0, -15.0, 0.0],
        _ => [0.0, 1.0, -4.5, 6.0, -2.5, 0.0],
    }
}
