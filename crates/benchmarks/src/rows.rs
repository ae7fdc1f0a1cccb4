//! Frames whose time is told by the binary `speed`.

use scenario::Scalar;

use crate::Choice;

/// One row of the table.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// Its name.
    pub name: &'static str,
    /// The shipped scenario.
    pub scenario: &'static str,
    /// What is measured of it.
    pub choice: Choice,
}

/// Raster that real time is counted by: 525 sweeps of 1000 samples.
pub const STANDARD: [u32; 2] = [525, 1000];

/// Samples a second of the machine itself: the standard raster, 30 frames a second.
pub const REAL_TIME: f64 = 30.0 * (STANDARD[0] * STANDARD[1]) as f64;

const fn row(
    name: &'static str,
    scenario: &'static str,
    model: &'static str,
    scalar: Scalar,
    raster: [u32; 2],
) -> Row {
    Row { name, scenario, choice: Choice { model: Some(model), scalar: Some(scalar), raster: Some(raster) } }
}

/// All of them.
pub const ROWS: &[Row] = &[
    row("showpiece, ideal, f32", "showpiece", "ideal", Scalar::F32, STANDARD),
    row("showpiece, ideal, f64", "showpiece", "ideal", Scalar::F64, STANDARD),
    row("showpiece, modern-analog, f32", "showpiece", "modern-analog", Scalar::F32, STANDARD),
    row("showpiece, pra-wires, f32", "showpiece", "pra-wires", Scalar::F32, STANDARD),
    row("craters, ideal, f32", "craters", "ideal", Scalar::F32, STANDARD),
    row("first light, ideal, f32", "first-light", "ideal", Scalar::F32, STANDARD),
    row("first light, ideal, f64", "first-light", "ideal", Scalar::F64, STANDARD),
    row("lunar horizon, ideal, f32", "lunar-horizon", "ideal", Scalar::F32, STANDARD),
    row("nominal drive, ideal, f32", "nominal-drive", "ideal", Scalar::F32, STANDARD),
    row("nominal drive, ideal, f64", "nominal-drive", "ideal", Scalar::F64, STANDARD),
    row("nominal drive, pra-wires, f32", "nominal-drive", "pra-wires", Scalar::F32, STANDARD),
    row("nominal drive, pra-nominal, f32", "nominal-drive", "pra-nominal", Scalar::F32, STANDARD),
];
