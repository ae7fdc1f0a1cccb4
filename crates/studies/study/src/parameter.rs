//! A run parameter of a generator: error of its picture, rung by rung, against `exact`, its own faces by area, or itself without a limit.

use std::sync::Arc;
use std::time::Instant;

use generator::{Against, ErrorLadder, Generator, PlaneKind, Planes, Stage};
use quantities::luminance;
use scenario::Pose;
use signal::Probe;

use crate::figures::{ErrorFigure, Figures, PictureErrors};
use crate::ladder::{EXACT, Expectation, Extent, LadderOutcome, RungOutcome};
use crate::reference::{ExactPicture, ExactPictures, picture};
use crate::work::{Effort, spread};
use crate::{StudyError, Subject};

const MEAN: &str = "picture mean";

/// Makes the generator with some keys set over the scenario's own run parameters; an error says which key is wrong.
pub type Configure<'a> = dyn Fn(&[(&str, &str)]) -> Result<Arc<dyn Generator>, String> + 'a;

/// Error and time of a generator's pictures, over the values of its run parameter.
///
/// # Errors
/// If `exact` cannot be drawn or kept. A rung that the generator cannot draw is told in its outcome.
pub fn parameter_ladder(
    (ladder, configure): (&ErrorLadder, &Configure<'_>),
    subject: &Subject,
    exact: &mut ExactPictures,
    effort: Effort,
    extent: Extent,
) -> Result<LadderOutcome, StudyError> {
    let values = ladder.rungs;
    let count = if extent == Extent::Quick { values.len().saturating_sub(1) } else { values.len() };
    let expected: Vec<Expectation> =
        ladder.order.iter().map(|&(order, why)| Expectation { error: MEAN, order, why }).collect();
    let truths = truths((ladder, configure), subject, exact)?;
    let rungs = values[..count].iter().map(|&value| {
        let generator = configured(ladder, configure, value.0);
        rung(subject, &truths, effort, (value, generator))
    });
    let rungs = rungs.collect::<Result<_, _>>()?;
    let outcome = LadderOutcome::new((ladder.name, ladder.what), "frame", &expected, rungs);
    Ok(outcome.against(match ladder.against {
        Against::Judge => EXACT,
        Against::OwnFaces => "its own faces by area",
        Against::Itself(_) => "itself without the limit",
    }))
}

/// What the pictures of each frame are held against.
fn truths(
    (ladder, configure): (&ErrorLadder, &Configure<'_>),
    subject: &Subject,
    exact: &mut ExactPictures,
) -> Result<Vec<Arc<ExactPicture>>, StudyError> {
    let stage = subject.stage.stage();
    let size = [stage.view.columns as usize, stage.view.lines as usize];
    let configured = |further: &[(&str, &str)]| {
        let sets: Vec<_> = ladder.fixed.iter().chain(further).copied().collect();
        configure(&sets).map_err(StudyError::Ladder)
    };
    let of_frame = |(frame, pose): &(u64, Pose)| match ladder.against {
        Against::Judge => exact.picture(&stage, (*frame, pose), size),
        Against::Itself(keys) => Ok(Arc::new(picture(&*configured(keys)?, &stage, (*frame, pose), size)?)),
        Against::OwnFaces => {
            let generator = configured(&[])?;
            let Some(faces) = generator.prepare(stage.clone())?.faces(*frame, pose)? else {
                return Err(StudyError::Ladder(format!("{} draws no faces", generator.name())));
            };
            let light = face_areas::draw(&faces, size);
            let intensity = light.into_iter().map(|colour| luminance(colour) as f32).collect();
            let drawn = picture(&*generator, &stage, (*frame, pose), size)?;
            Ok(Arc::new(ExactPicture { intensity, range: drawn.range }))
        }
    };
    subject.frames.iter().map(of_frame).collect()
}

/// The generator of a rung, and how many settings it changes.
type Configured = Result<(Arc<dyn Generator>, usize), String>;

fn configured(ladder: &ErrorLadder, configure: &Configure<'_>, value: &str) -> Configured {
    let sets: Vec<_> = ladder.fixed.iter().copied().chain([(ladder.key, value)]).collect();
    let (usual, generator) = (configure(&[])?, configure(&sets)?);
    let changes = 1 + usize::from(generator.record() != usual.record());
    Ok((generator, changes))
}

fn rung(
    subject: &Subject,
    truths: &[Arc<ExactPicture>],
    effort: Effort,
    ((value, fine), generator): ((&str, f64), Configured),
) -> Result<RungOutcome, StudyError> {
    let stage = subject.stage.stage();
    let changes = generator.as_ref().map_or(1, |(_, changes)| *changes);
    let outcome = RungOutcome {
        // Words stand in quotes, as TOML has them.
        label: value.trim_matches('"').to_owned(),
        step: Some(1.0 / fine),
        changes,
        time_s: None,
        work: 0,
        errors: Vec::new(),
        refused: None,
    };
    let drawn = generator.and_then(|(generator, _)| {
        drawn(subject, &stage, &*generator, effort).map_err(|error| error.to_string())
    });
    match drawn {
        Err(refused) => Ok(RungOutcome { refused: Some(refused), ..outcome }),
        Ok(Drawn { pictures, times, samples }) => Ok(RungOutcome {
            errors: errors(truths, &stage, &pictures)?,
            time_s: Some(spread(&times)),
            work: samples,
            ..outcome
        }),
    }
}

/// What a rung has drawn.
struct Drawn {
    pictures: Vec<Vec<f32>>,
    /// Seconds a frame, repetition by repetition.
    times: Vec<f64>,
    samples: u64,
}

/// All frames: once to warm up, then as often as is timed.
fn drawn(
    subject: &Subject,
    stage: &Stage,
    generator: &dyn Generator,
    effort: Effort,
) -> Result<Drawn, StudyError> {
    let session = generator.prepare(stage.clone())?;
    let [columns, lines] = [stage.view.columns, stage.view.lines].map(|count| count as usize);
    let mut planes = Planes::new(columns, lines, &[PlaneKind::Intensity]);
    let mut all = Drawn { pictures: Vec::new(), times: Vec::new(), samples: 0 };
    for repetition in 0..=effort.repetitions {
        let mut seconds = 0.0;
        for (frame, pose) in &subject.frames {
            let start = Instant::now();
            let counts = session.frame(*frame, pose, &mut planes, &mut Probe::off())?;
            seconds += start.elapsed().as_secs_f64();
            if repetition == 0 {
                all.samples += counts.get("samples").unwrap_or(0);
                all.pictures.push(planes.get(PlaneKind::Intensity).unwrap_or_default().to_vec());
            }
        }
        if repetition > 0 {
            all.times.push(seconds / subject.frames.len() as f64);
        }
    }
    Ok(all)
}

/// The mean of what the light is off by, and the figures of every picture.
fn errors(truths: &[Arc<ExactPicture>], stage: &Stage, pictures: &[Vec<f32>]) -> Result<Figures, StudyError> {
    let size = [stage.view.columns as usize, stage.view.lines as usize];
    let (mut sum, mut count, mut shown) = (0.0, 0.0, PictureErrors::default());
    for (truth, picture) in truths.iter().zip(pictures) {
        let off = picture.iter().zip(&truth.intensity).map(|(a, b)| f64::from((a - b).abs()));
        sum += off.sum::<f64>();
        count += picture.len() as f64;
        shown.add(&stage.view.display, picture, truth, None, size)?;
    }
    let mean = ErrorFigure { name: MEAN, unit: "1", value: sum / f64::max(count, 1.0) };
    Ok([vec![mean], shown.figures()].concat())
}
