//! Error against run time, as `lunoid study error` finds it.

use exact::Columns;
use hardware_model::{BUILT_IN, HardwareModel, ModelSource};
use study::ladder::{Extent, Ladder, LadderOutcome, ladders};
use study::{Effort, ExactPictures, Rehearsed, Subject, climb};

use crate::{Drive, DriveError};

/// Repetitions of each frame that are timed, as in the command.
const REPETITIONS: u32 = 5;

/// Ladders that were climbed.
#[derive(Debug, Clone)]
pub struct Study {
    /// One ladder each, in the order of the command.
    pub ladders: Vec<LadderOutcome>,
}

impl Study {
    /// The table of `error.csv`.
    pub fn csv(&self) -> String {
        study::csv(&self.ladders)
    }
}

impl Drive {
    /// Climbs the ladders of settings called `only`, all of them if it is empty, about the middle frame of the path. `goes_on` is asked before each
    /// ladder; the study ends early where it says no.
    ///
    /// # Errors
    /// If the hybrid machine does not draw, there is no such ladder, or a frame cannot be drawn.
    pub fn study(
        &self,
        only: &[String],
        goes_on: &mut (dyn FnMut() -> bool + Send),
    ) -> Result<Study, DriveError> {
        let file = self.file();
        if !self.opened.is_machine() {
            let title = format!("a study of {}: it holds a machine against the closed form", self.drawn_by());
            return Err(DriveError::asked(file, title, "a hardware model"));
        }
        let (scenario, model) = (self.opened.scenario.clone(), self.opened.model.clone());
        let subject = Subject::new(scenario, model, self.bench.machine.clone(), &[self.frames() / 2]);
        let subject = subject.map_err(|error| DriveError::of(file, &error))?;
        let chosen = self.chosen(ladders(&subject, &self.models()?, Extent::Whole), only)?;
        self.pool.install(|| self.climbed(&subject, &chosen, goes_on))
    }

    fn climbed(
        &self,
        subject: &Subject,
        chosen: &[Ladder],
        goes_on: &mut (dyn FnMut() -> bool + Send),
    ) -> Result<Study, DriveError> {
        let failed = |error: &dyn std::fmt::Display| DriveError::of(self.file(), &error.to_string());
        let pictures = ExactPictures::new("", &subject.scenario, &self.bench.stage, None);
        let mut exact = pictures.map_err(|error| failed(&error))?;
        let columns = Columns::new(self.bench.stage.clone());
        let mut study = Rehearsed { subject, exact: &mut exact, columns: &columns };
        let mut climbed = Vec::with_capacity(chosen.len());
        for ladder in chosen {
            if !goes_on() {
                break;
            }
            let effort = Effort { repetitions: REPETITIONS };
            climbed.push(climb(&mut study, ladder, effort, &mut |_| ()).map_err(|error| failed(&error))?);
        }
        Ok(Study { ladders: climbed })
    }

    /// The shipped models, whose parts are a ladder.
    fn models(&self) -> Result<Vec<HardwareModel>, DriveError> {
        let load = |name: &str| {
            let source = ModelSource::find(name, self.opened.folder())?;
            Ok(HardwareModel::load(&source, &[], &[])?.model)
        };
        BUILT_IN.iter().map(|(name, _)| load(name)).collect()
    }

    fn chosen(&self, mut all: Vec<Ladder>, only: &[String]) -> Result<Vec<Ladder>, DriveError> {
        let known: Vec<&str> = all.iter().map(|ladder| ladder.name).collect();
        if let Some(unknown) = only.iter().find(|name| !known.contains(&name.as_str())) {
            let title = format!("no ladder `{unknown}` for this scenario");
            return Err(DriveError::asked(self.file(), title, format!("one of {}", known.join(", "))));
        }
        all.retain(|ladder| only.is_empty() || only.iter().any(|name| name == ladder.name));
        Ok(all)
    }
}
