//! The brightness of a plane.

use serde::Deserialize;

use super::Deviation;
use crate::formula::light::lambert;
use crate::scene::machine::{Drawn, MachineCase};

/// Lambert's value of the plane on these lines of all columns.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct BrightnessReading {
    /// First line that is read, from 0 at the top.
    pub first_line: usize,
    /// Last line that is read; it is included.
    pub last_line: usize,
}

impl BrightnessReading {
    pub(super) fn deviation(&self, meant: &MachineCase, seen: &Drawn) -> Result<Deviation, String> {
        let columns = meant.settings.raster.columns as usize;
        let Self { first_line, last_line } = *self;
        if first_line > last_line || last_line >= meant.settings.raster.lines as usize {
            return Err(format!("lines {first_line} to {last_line} are not in the picture"));
        }
        let ground = &seen.picture[first_line * columns..(last_line + 1) * columns];
        let [_, north, east] = meant.surface([meant.scene.eye_m[0], meant.scene.eye_m[1]]);
        let found: Vec<f64> = ground.iter().map(|&value| f64::from(value)).collect();
        let expected = vec![lambert(&meant.scene, [north, east]); found.len()];
        Ok(Deviation::between("brightness", &found, &expected, 1.0))
    }
}
