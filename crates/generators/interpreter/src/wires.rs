//! The wires inside an array by the names that the machine gives them.

use crate::registers::CORNERS;
use crate::walk::Sample;

const AXES: [&str; 2] = ["x", "y"];
const FED: [&str; 4] = ["x", "cx", "y", "cy"];
const COLOURS: [&str; 4] = ["yellow", "green", "black", "red"];
/// Sums, as they stand in names: of the height nothing.
const SUMS: [&str; 3] = ["", "u.", "v."];

/// Every inner wire of a level over the samples of a sweep; `level` stands in its names. Regions have the side `region_size` (m).
pub fn of(level: &str, samples: &[Sample], region_size: f64) -> Vec<(String, Vec<f64>)> {
    let mut wires = Vec::new();
    let mut put = |name: String, value: &dyn Fn(&Sample) -> f64| {
        wires.push((name, samples.iter().map(value).collect::<Vec<f64>>()));
    };
    for (axis, name) in AXES.into_iter().enumerate() {
        put(format!("sweep.{level}accumulator.{name}"), &|sample| sample.accumulators[axis]);
        put(format!("sweep.{level}{name}"), &|sample| sample.ramps[axis]);
    }
    for (fed, name) in FED.into_iter().enumerate() {
        for order in 0..3 {
            put(format!("tg.{level}fn.{name}.g{order}"), &|sample| sample.sums.functions[fed][order]);
            put(format!("tg.{level}fn.{name}.d{order}"), &|sample| sample.sums.derivatives[fed][order]);
        }
    }
    for (sum, of_sum) in SUMS.into_iter().enumerate() {
        let scale = if sum == 0 { 1.0 } else { 1.0 / region_size };
        for (colour, [a, b]) in CORNERS.into_iter().enumerate() {
            for word in 0..9 {
                let (x, y) = (3 * a + word / 3, 3 * b + word % 3);
                put(format!("tg.{level}{of_sum}product.{x}{y}"), &|sample| {
                    sample.sums.products[sum][colour][word]
                });
                put(format!("tg.{level}{of_sum}{}.dac{word}", COLOURS[colour]), &|sample| {
                    sample.sums.sent[sum][colour][word] * scale
                });
            }
        }
    }
    for (colour, name) in COLOURS.into_iter().enumerate() {
        put(format!("tg.{level}{name}.height"), &|sample| sample.sums.colours[colour]);
    }
    put(format!("tg.{level}sum.height"), &|sample| sample.height);
    put(format!("tg.{level}sum.u"), &|sample| sample.slopes[0]);
    put(format!("tg.{level}sum.v"), &|sample| sample.slopes[1]);
    wires
}
