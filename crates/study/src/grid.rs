//! LUNSIM's grid: error of its picture against `exact`, as the points of the grid come closer (section 20).

use std::time::Instant;

use generator::{Generator, PlaneKind, Planes, Session, Stage};
use lunsim::Lunsim;
use signal::Probe;

use crate::figures::{ErrorFigure, Figures, PictureErrors};
use crate::ladder::{Expectation, Extent, LadderOutcome, RungOutcome};
use crate::reference::ExactPictures;
use crate::work::{Effort, spread};
use crate::{StudyError, Subject};

/// Name of the ladder.
pub const GRID: &str = "grid";

/// Points of the grid along the line of sight, and as many across; the last is the report's largest.
const POINTS: [u32; 5] = [64, 128, 256, 512, 1024];
/// So many that the steps of the recorder's codes do not hide those of the grid.
const CODES: u32 = 256;

const MEAN: &str = "picture mean";

/// Error and time of LUNSIM's picture, over the size of its grid.
///
/// # Errors
/// If `exact` cannot be drawn or kept. A rung that LUNSIM cannot draw is told in its outcome.
pub fn grid_ladder(
    subject: &Subject,
    exact: &mut ExactPictures,
    effort: Effort,
    extent: Extent,
) -> Result<LadderOutcome, StudyError> {
    let count = if extent == Extent::Quick { 4 } else { POINTS.len() };
    let rungs = POINTS[..count].iter().map(|&points| rung(subject, exact, effort, points));
    let expected =
        [Expectation { error: MEAN, order: 1.0, why: "a position shows a point up to one step away" }];
    let what = (GRID, "points a side of LUNSIM's grid, 256 codes");
    Ok(LadderOutcome::new(what, "frame", &expected, rungs.collect::<Result<_, _>>()?))
}

fn rung(
    subject: &Subject,
    exact: &mut ExactPictures,
    effort: Effort,
    points: u32,
) -> Result<RungOutcome, StudyError> {
    let mut stage = subject.stage.clone();
    stage.settings.lunsim.grid = points;
    stage.settings.lunsim.intensity_codes = CODES;
    let outcome = RungOutcome {
        label: points.to_string(),
        step: Some(1.0 / f64::from(points)),
        changes: 1 + usize::from(stage.settings.lunsim != subject.stage.settings.lunsim),
        time_s: None,
        work: 0,
        errors: Vec::new(),
        refused: None,
    };
    match drawn(subject, &stage, effort) {
        Err(refused) => Ok(RungOutcome { refused: Some(refused.to_string()), ..outcome }),
        Ok(Drawn { pictures, times, samples }) => Ok(RungOutcome {
            errors: errors(subject, exact, &stage, &pictures)?,
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
fn drawn(subject: &Subject, stage: &Stage, effort: Effort) -> Result<Drawn, StudyError> {
    let session: Box<dyn Session> = Lunsim.prepare(stage.clone())?;
    let raster = stage.settings.raster;
    let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &[PlaneKind::Intensity]);
    let mut all = Drawn { pictures: Vec::new(), times: Vec::new(), samples: 0 };
    for repetition in 0..=effort.repetitions {
        let mut seconds = 0.0;
        for (frame, pose) in &subject.frames {
            let start = Instant::now();
            let counts = session.frame(*frame, pose, &mut planes, &mut Probe::off())?;
            seconds += start.elapsed().as_secs_f64();
            if repetition == 0 {
                all.samples += counts.samples;
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
fn errors(
    subject: &Subject,
    exact: &mut ExactPictures,
    stage: &Stage,
    pictures: &[Vec<f32>],
) -> Result<Figures, StudyError> {
    let size = [stage.settings.raster.columns as usize, stage.settings.raster.lines as usize];
    let (mut sum, mut count, mut shown) = (0.0, 0.0, PictureErrors::default());
    for ((frame, pose), picture) in subject.frames.iter().zip(pictures) {
        let truth = exact.picture(stage, (*frame, pose), size)?;
        let off = picture.iter().zip(&truth.intensity).map(|(a, b)| f64::from((a - b).abs()));
        sum += off.sum::<f64>();
        count += picture.len() as f64;
        shown.add(stage, picture, &truth, None, size)?;
    }
    let mean = ErrorFigure { name: MEAN, unit: "1", value: sum / f64::max(count, 1.0) };
    Ok([vec![mean], shown.figures()].concat())
}
