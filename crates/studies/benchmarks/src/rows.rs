//! Frames whose time is told by the binary `speed`.

use hardware_model::Economy;
use scenario::Scalar;

use crate::Choice;

/// One row of the table.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// Name of the row.
    pub name: &'static str,
    /// Name of the shipped scenario.
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
    let (model, scalar, raster) = (Some(model), Some(scalar), Some(raster));
    Row { name, scenario, choice: Choice { model, scalar, raster, economy: Economy::Bounded } }
}

/// The same in preview.
const fn preview(name: &'static str, scenario: &'static str, model: &'static str, scalar: Scalar) -> Row {
    let Row { choice, .. } = row(name, scenario, model, scalar, STANDARD);
    Row { name, scenario, choice: Choice { economy: Economy::Instants(1), ..choice } }
}

/// The same at the default quality, with ideal parts in f32.
const fn normal(name: &'static str, scenario: &'static str) -> Row {
    let Row { choice, .. } = row(name, scenario, "ideal", Scalar::F32, STANDARD);
    Row { name, scenario, choice: Choice { economy: Economy::Normal, ..choice } }
}

/// All rows of the table, in its order.
pub const ROWS: &[Row] = &[
    normal("normal showpiece", "showpiece"),
    normal("normal craters", "craters"),
    normal("normal long shadows", "long-shadows"),
    normal("normal first light", "first-light"),
    normal("normal nominal drive", "nominal-drive"),
    normal("normal full drive", "full-drive"),
    preview("preview showpiece, ideal, f32", "showpiece", "ideal", Scalar::F32),
    preview("preview showpiece, ideal, f64", "showpiece", "ideal", Scalar::F64),
    preview("preview craters, ideal, f32", "craters", "ideal", Scalar::F32),
    preview("preview first light, ideal, f32", "first-light", "ideal", Scalar::F32),
    preview("preview nominal drive, ideal, f32", "nominal-drive", "ideal", Scalar::F32),
    preview("preview nominal drive, ideal, f64", "nominal-drive", "ideal", Scalar::F64),
    preview("preview full drive, ideal, f32", "full-drive", "ideal", Scalar::F32),
    preview("preview full drive, ideal, f64", "full-drive", "ideal", Scalar::F64),
    preview("preview showpiece, pra-wires, f32", "showpiece", "pra-wires", Scalar::F32),
    preview("preview nominal drive, pra-wires, f32", "nominal-drive", "pra-wires", Scalar::F32),
    preview("preview full drive, pra-wires, f32", "full-drive", "pra-wires", Scalar::F32),
    preview("preview nominal drive, pra-parts, f32", "nominal-drive", "pra-parts", Scalar::F32),
    preview("preview full drive, pra-parts, f32", "full-drive", "pra-parts", Scalar::F32),
    row("showpiece, ideal, f32", "showpiece", "ideal", Scalar::F32, STANDARD),
    row("showpiece, ideal, f64", "showpiece", "ideal", Scalar::F64, STANDARD),
    row("showpiece, modern-analog, f32", "showpiece", "modern-analog", Scalar::F32, STANDARD),
    row("showpiece, pra-wires, f32", "showpiece", "pra-wires", Scalar::F32, STANDARD),
    row("craters, ideal, f32", "craters", "ideal", Scalar::F32, STANDARD),
    row("long shadows, ideal, f32", "long-shadows", "ideal", Scalar::F32, STANDARD),
    row("first light, ideal, f32", "first-light", "ideal", Scalar::F32, STANDARD),
    row("first light, ideal, f64", "first-light", "ideal", Scalar::F64, STANDARD),
    row("lunar horizon, ideal, f32", "lunar-horizon", "ideal", Scalar::F32, STANDARD),
    row("nominal drive, ideal, f32", "nominal-drive", "ideal", Scalar::F32, STANDARD),
    row("nominal drive, ideal, f64", "nominal-drive", "ideal", Scalar::F64, STANDARD),
    row("nominal drive, pra-wires, f32", "nominal-drive", "pra-wires", Scalar::F32, STANDARD),
    row("full drive, ideal, f32", "full-drive", "ideal", Scalar::F32, STANDARD),
    row("full drive, ideal, f64", "full-drive", "ideal", Scalar::F64, STANDARD),
    row("full drive, pra-wires, f32", "full-drive", "pra-wires", Scalar::F32, STANDARD),
    row("nominal drive, pra-parts, f32", "nominal-drive", "pra-parts", Scalar::F32, STANDARD),
    row("full drive, pra-parts, f32", "full-drive", "pra-parts", Scalar::F32, STANDARD),
    row("nominal drive, pra-nominal, f32", "nominal-drive", "pra-nominal", Scalar::F32, STANDARD),
];
