//! The line of the horizon.

use serde::Deserialize;

use super::Deviation;
use crate::formula::horizon::Horizon;
use crate::formula::light::lambert;
use crate::scene::machine::{Drawn, MachineCase};

/// The horizon of a plane in every column.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct HorizonLineReading {
    /// Formula of the line where the horizon is.
    pub formula: Horizon,
}

impl HorizonLineReading {
    /// Ground of one brightness fills a column from the horizon down, so their sum tells where it begins.
    pub(super) fn deviation(&self, meant: &MachineCase, seen: &Drawn) -> Result<Deviation, String> {
        let raster = meant.settings.raster;
        let (columns, lines) = (raster.columns as usize, f64::from(raster.lines));
        let [_, north, east] = meant.surface([meant.scene.eye_m[0], meant.scene.eye_m[1]]);
        let brightness = lambert(&meant.scene, [north, east]);
        let found = |column: usize| {
            let of_column = seen.picture.iter().skip(column).step_by(columns);
            lines - of_column.map(|&value| f64::from(value)).sum::<f64>() / brightness
        };
        let expected = |column: usize| {
            let x = raster.field.tan_half_width * ((2 * column + 1) as f64 / columns as f64 - 1.0);
            0.5 * lines * (1.0 + self.formula.at(meant, x) / raster.field.tan_half_height)
        };
        let [found, expected] =
            [(0..columns).map(found).collect::<Vec<_>>(), (0..columns).map(expected).collect::<Vec<_>>()];
        Ok(Deviation::between("horizon line", &found, &expected, 1.0))
    }
}
