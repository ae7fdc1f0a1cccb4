//! The sun programme of a list.

use diagnostics::Reader;
use quantities::{Rate, radians};

use super::list::report_at;
use crate::sun::{SunProgramme, Turn, TurningSun};
use crate::warning::Warning;

/// The sun of a list: a table `sun`, or the scenario's sun where there is none.
pub(super) fn programme(table: &Reader, frames: Rate, warnings: &mut Vec<Warning>) -> Option<SunProgramme> {
    let Some(sun) = table.optional_table("sun") else {
        return (!table.has("sun")).then_some(SunProgramme::Scenario);
    };
    let elevation = sun.f64("elevation_deg").between(-90.0, 90.0).required();
    let azimuth = sun.f64("azimuth_deg").between(-360.0, 360.0).default(0.0);
    let phase = sun.f64("phase_deg").between(-360.0, 360.0).default(0.0);
    let turns = sun.i64("turns").default(0);
    let seconds = sun.i64("seconds").at_least(1).default(1);
    let (elevation, azimuth) = (radians(elevation?), radians(azimuth? + phase?));
    let turn = Turn::new([turns?, seconds?], frames);
    let made = turn.and_then(|turn| TurningSun::new(elevation, azimuth, turn));
    let made = made.map_err(|error| report_at(&sun, &error)).ok()?;
    warnings.extend(made.warnings());
    Some(SunProgramme::Turning(made))
}
