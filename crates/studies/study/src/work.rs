//! Climbs a ladder: prepares its rungs, times them in turn, measures their errors.

use std::time::Instant;

use control_plane::{ControlPlane, MachineStage};
use exact::Columns;
use generator::{PlaneKind, Planes, Session};
use machine::Prepare;
use signal::Probe;

use crate::figures::{Bench, PictureErrors, SignalErrors};
use crate::ladder::{Ladder, LadderOutcome, Rung, RungOutcome};
use crate::reference::ExactPictures;
use crate::{StudyError, Subject};

/// How much a study does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Effort {
    /// Repetitions of each frame that are timed, at least 1; fewer where a turn over all rungs takes long.
    pub repetitions: u32,
}

/// What the timed turns of one ladder may take (s), beyond the first of them.
const PATIENCE: f64 = 30.0;

impl Effort {
    /// Repetitions that fit, where one turn takes `turn` seconds.
    fn fitting(self, turn: f64) -> u32 {
        self.repetitions.min((PATIENCE / turn) as u32).max(1)
    }
}

/// A rung made ready, with what its frames took.
struct Standing {
    label: String,
    step: Option<f64>,
    changes: usize,
    ready: Result<Ready, StudyError>,
}

struct Ready {
    stage: MachineStage,
    session: Box<dyn Session>,
    /// Seconds a frame, repetition by repetition.
    times: Vec<f64>,
    /// Linear intensity of every frame.
    pictures: Vec<Vec<f32>>,
    samples: u64,
}

/// A study that has been made ready: who knows what is true.
pub struct Rehearsed<'a> {
    /// The base setting that is studied, with its frames.
    pub subject: &'a Subject,
    /// Pictures of `exact`, each drawn once.
    pub exact: &'a mut ExactPictures,
    /// Ground below the sweeps of the base.
    pub columns: &'a Columns,
}

/// Climbs `ladder`: the threads of the current pool draw. `hear` is told of each rung that is done.
///
/// # Errors
/// If `exact` cannot be drawn or kept. A rung that cannot be drawn is told in its outcome.
pub fn climb(
    study: &mut Rehearsed<'_>,
    ladder: &Ladder,
    effort: Effort,
    hear: &mut dyn FnMut(&str),
) -> Result<LadderOutcome, StudyError> {
    let mut rungs: Vec<Standing> = ladder.rungs.iter().map(|rung| stand(study.subject, rung)).collect();
    let mut turn = |is_timed: bool| {
        let begin = Instant::now();
        rungs.iter_mut().for_each(|rung| rung.run(study.subject, is_timed));
        begin.elapsed().as_secs_f64()
    };
    // The first turn is not counted: it warms up, and leaves the pictures.
    turn(false);
    let first = turn(true);
    (1..effort.fitting(first)).for_each(|_| {
        turn(true);
    });
    let mut outcomes = Vec::with_capacity(rungs.len());
    for rung in rungs {
        hear(&rung.label);
        outcomes.push(rung.measured(study)?);
    }
    Ok(LadderOutcome::new((ladder.name, ladder.what), "frame", &ladder.expected, outcomes))
}

fn stand(subject: &Subject, rung: &Rung) -> Standing {
    let ready = || {
        let stage = subject.changed(&rung.changes)?;
        let session = stage.clone().prepare();
        Ok(Ready { stage, session, times: Vec::new(), pictures: Vec::new(), samples: 0 })
    };
    Standing {
        label: rung.label.clone(),
        step: rung.step,
        changes: subject.differing(&rung.changes),
        ready: ready(),
    }
}

impl Standing {
    /// One turn over all frames of the study.
    fn run(&mut self, subject: &Subject, is_timed: bool) {
        let done = match &mut self.ready {
            Ok(ready) => ready.run(subject, is_timed),
            Err(_) => return,
        };
        if let Err(error) = done {
            self.ready = Err(error);
        }
    }

    fn measured(self, study: &mut Rehearsed<'_>) -> Result<RungOutcome, StudyError> {
        let outcome = RungOutcome {
            label: self.label,
            step: self.step,
            changes: self.changes,
            time_s: None,
            work: 0,
            errors: Vec::new(),
            refused: None,
        };
        match self.ready {
            Err(refused) => Ok(RungOutcome { refused: Some(refused.to_string()), ..outcome }),
            Ok(ready) => Ok(RungOutcome {
                errors: ready.errors(study)?,
                time_s: Some(spread(&ready.times)),
                work: ready.samples,
                ..outcome
            }),
        }
    }
}

impl Ready {
    fn run(&mut self, subject: &Subject, is_timed: bool) -> Result<(), StudyError> {
        let raster = self.stage.settings.raster;
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &[PlaneKind::Intensity]);
        let mut seconds = 0.0;
        for (frame, pose) in &subject.frames {
            let start = Instant::now();
            let counts = self.session.frame(*frame, pose, &mut planes, &mut Probe::off())?;
            seconds += start.elapsed().as_secs_f64();
            if !is_timed {
                self.samples += counts.get("samples").unwrap_or(0);
                self.pictures.push(planes.get(PlaneKind::Intensity).unwrap_or_default().to_vec());
            }
        }
        if is_timed {
            self.times.push(seconds / subject.frames.len() as f64);
        }
        Ok(())
    }

    fn errors(&self, study: &mut Rehearsed<'_>) -> Result<crate::Figures, StudyError> {
        let control = ControlPlane::new(self.stage.clone());
        let base = &study.subject.stage;
        // The ground does not change from rung to rung, but levels and sight may.
        let own =
            (self.stage.settings.levels != base.settings.levels).then(|| Columns::new(self.stage.stage()));
        let bench = Bench {
            stage: &self.stage,
            session: self.session.as_ref(),
            control: &control,
            exact: own.as_ref().unwrap_or(study.columns),
        };
        let (mut signals, mut pictures) = (SignalErrors::default(), PictureErrors::default());
        let size = [base.settings.raster.columns as usize, base.settings.raster.lines as usize];
        for ((frame, pose), drawn) in study.subject.frames.iter().zip(&self.pictures) {
            signals.add_frame(&bench, *frame, pose)?;
            let own = study.exact.picture(&self.stage.stage(), (*frame, pose), size)?;
            let law = study.exact.picture(&base.stage(), (*frame, pose), size)?;
            let law = (law != own).then_some(law);
            let shown = shown(drawn, self.stage.settings.raster.columns as usize, size);
            pictures.add(&self.stage.settings.display, &shown, &own, law.as_deref(), size)?;
        }
        Ok([signals.figures(), pictures.figures()].concat())
    }
}

/// A picture of `from` columns on the columns of the base: each shows the sweep at its centre.
fn shown(plane: &[f32], from: usize, [columns, lines]: [usize; 2]) -> Vec<f32> {
    let nearest = |column: usize| ((2 * column + 1) * from / (2 * columns)).min(from - 1);
    let line = |line: usize| (0..columns).map(move |column| plane[line * from + nearest(column)]);
    (0..lines).flat_map(line).collect()
}

/// Median, smallest and largest.
pub(crate) fn spread(times: &[f64]) -> [f64; 3] {
    let mut sorted = times.to_vec();
    sorted.sort_by(f64::total_cmp);
    match sorted.as_slice() {
        [] => [0.0; 3],
        [only] => [*only; 3],
        [first, .., last] => [sorted[sorted.len() / 2], *first, *last],
    }
}

#[cfg(test)]
mod tests {
    use super::{shown, spread};

    #[test]
    fn columns_show_the_nearest_sweep() {
        let two = [1.0, 2.0, 3.0, 4.0];
        assert_eq!(shown(&two, 2, [4, 2]), [1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0]);
        let four = [1.0, 2.0, 3.0, 4.0];
        assert_eq!(shown(&four, 4, [2, 1]), [2.0, 4.0]);
        assert_eq!(shown(&four, 4, [4, 1]), four);
    }

    #[test]
    fn a_median_lies_between() {
        assert_eq!(spread(&[3.0, 1.0, 2.0]), [2.0, 1.0, 3.0]);
        assert_eq!(spread(&[5.0]), [5.0; 3]);
    }
}
