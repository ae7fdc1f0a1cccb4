//! From late words to the pixels that they changed.

use event_list::{LatePlace, PlaceOf};
use explain::{LateEffect, boundary_at, late_effect};
use machine::{FrameSweeps, LateOf, LateWords, prepare_twice};
use serde_json::Value;

use crate::{DriveError, Viewpoint};

/// What late words changed.
#[derive(Debug, Clone, PartialEq)]
pub struct LateWordsEffect {
    /// What the command prints.
    pub text: String,
    /// The document of `lunoid explain --late --json`: schema `lunoid.explain.late/1`.
    pub document: Value,
}

impl Viewpoint<'_> {
    /// What the late words at `place` changed in the picture. `place` names them as `lunoid explain --late` does: by sweep and crossing
    /// (`260:60`), by crater or shadow boundary (`260:crater.7`), or by the line of the listing that tells them. Of a crossing without a
    /// level it is the fine one.
    ///
    /// # Errors
    /// If the hybrid machine does not draw, no word was late there, or a frame cannot be drawn.
    pub fn late_effect(&self, place: &str) -> Result<LateWordsEffect, DriveError> {
        let Self { drive, bench, frame, pose } = self;
        let file = drive.file();
        if !drive.opened.is_machine() {
            let title = format!("{} has no late words", drive.drawn_by());
            return Err(DriveError::asked(file, title, "a hardware model"));
        }
        let place: LatePlace = place.parse().map_err(|error: String| DriveError::of(file, &error))?;
        let twice = prepare_twice(bench.machine.clone());
        let told: Result<LateEffect, DriveError> = drive.pool.install(|| {
            let control = bench.control();
            let sweeps = match place.of.needs_gates() {
                true => control.sweeps_with_gates(*frame, pose),
                false => control.sweeps(*frame, pose),
            };
            let sweeps = sweeps.map_err(|error| DriveError::of(file, &error))?;
            let late = LateWords { frame: *frame, sweep: place.sweep, of: self.late_of(place, &sweeps)? };
            let effect = late_effect(&*twice, (&bench.machine, &sweeps), pose, late);
            effect.map_err(|error| DriveError::of(file, &error))
        });
        let told = told?;
        Ok(LateWordsEffect { text: told.text(), document: told.json() })
    }

    /// What waited for the words at `place`.
    fn late_of(&self, place: LatePlace, sweeps: &FrameSweeps<'_>) -> Result<LateOf, DriveError> {
        match place.of {
            PlaceOf::Said(of) => Ok(of),
            PlaceOf::Crossing(crossing) => Ok(LateOf::Crossing { level: 0, crossing }),
            PlaceOf::LineGenerator(number, range) => {
                let of = boundary_at(sweeps, place.sweep, number, range);
                let title = format!(
                    "no word of line-generator.{number} was late at {range} m in sweep {}",
                    place.sweep
                );
                of.ok_or_else(|| DriveError::asked(self.drive.file(), title, "a late event of this frame"))
            }
        }
    }
}
