//! Region size of a bank against elevation data: what the survey loses, and what a fit takes.
//!
//! **Law.** Ground is sampled on a fine grid, as an elevation file has it, and the survey fits banks of several region sizes
//! to it. Each is held against the ground itself, half way between the samples, away from the edge by one region of the
//! largest size.
//! **Order.** Of pieces of degree 5 the best height is off by the sixth power of the region size over a smooth ground, its
//! slope by the fifth. The survey smooths: its penalty over `s` regions adds `s^4 d^4` times the ground's fourth derivatives,
//! so behind some size the order is 4. At the edge, where a bent ground meets a penalty that wants none, it is less.

mod ground;

use std::time::Instant;

use landscape::Level;
use survey::{Affine, Elevation, Frame, Stiffness, SurveyOptions, survey};

use crate::figures::{ErrorFigure, Figures, Sum};
use crate::ladder::{Expectation, Extent, LadderOutcome, RungOutcome};
use crate::work::spread;
use crate::{Effort, StudyError, Subject};
use ground::{Relief, Stored, Waves};

/// Names of the ladders.
pub const REGION_LADDERS: [&str; 2] = ["region", "region-smooth"];
/// Region sizes in units of the middle one.
const SIZES: [f64; 5] = [4.0, 2.0, 1.0, 0.5, 0.25];
/// Regions of the largest size along the side of the area, quick and whole, over the ground of the scenario.
const LARGEST: [usize; 2] = [6, 10];
/// Of the smooth ground.
const LARGEST_SMOOTH: usize = 4;
/// Samples along the side of a region of the middle size: four in the smallest region, or eight.
const SAMPLES: usize = 16;
const SAMPLES_SMOOTH: usize = 32;
/// Length of the waves of the smooth ground, in regions of the middle size.
const WAVE: f64 = 16.0;

/// The ladders of region size: over the ground of `subject`, and over a smooth ground of which theory speaks.
///
/// # Errors
/// If a bank cannot be fitted.
pub fn regions(subject: &Subject, extent: Extent, effort: Effort) -> Result<Vec<LadderOutcome>, StudyError> {
    let count = LARGEST[usize::from(extent == Extent::Whole)];
    let middle = subject.stage.landscape.level().region_size();
    let stored =
        Stored::about(&subject.stage.landscape, subject.frames[0].1.eye, SIZES[0] * middle * count as f64);
    let waves = Waves::of_length(WAVE * middle);
    let smooth = [
        Expectation {
            error: HEIGHT_RMS,
            order: 6.0,
            why: "pieces of degree 5 reproduce every polynomial of degree 5",
        },
        Expectation { error: SLOPE_RMS, order: 5.0, why: "the derivative of such a piece is of degree 4" },
    ];
    let mut ladders = Vec::new();
    let name = (REGION_LADDERS[0], "region size (m) of a bank fitted to the ground of the scenario");
    let shipped = SurveyOptions::new(middle);
    ladders.extend(stored.map(|ground| ladder(name, &ground, &shipped, [SAMPLES, count], &[], effort)));
    let name = (REGION_LADDERS[1], "region size (m) of a bank fitted to waves, without smoothing");
    ladders.push(ladder(
        name,
        &waves,
        &unsmoothed(middle),
        [SAMPLES_SMOOTH, LARGEST_SMOOTH],
        &smooth,
        effort,
    ));
    ladders.into_iter().collect()
}

const HEIGHT_RMS: &str = "bank height rms";
const SLOPE_RMS: &str = "bank slope rms";

/// The fit by its pieces alone: as good as no smoothing, no samples held out.
fn unsmoothed(region_size: f64) -> SurveyOptions {
    let usual = SurveyOptions::new(region_size);
    let stiffness = Stiffness { smoothing: 1e-3, ..usual.stiffness };
    SurveyOptions { stiffness, held_out: 0.0, tolerance: 1e-13, ..usual }
}

/// Banks by `options`, their region sizes about the one that stands there, fitted to an area of `count` regions of the
/// largest size with `samples` along the middle one.
fn ladder(
    name: (&'static str, &'static str),
    ground: &dyn Relief,
    options: &SurveyOptions,
    [samples, count]: [usize; 2],
    expected: &[Expectation],
    effort: Effort,
) -> Result<LadderOutcome, StudyError> {
    let middle = options.region_size;
    let area = Area {
        step: middle / samples as f64,
        side: SIZES[0] * middle * count as f64,
        margin: SIZES[0] * middle,
    };
    let elevation = area.sampled(ground);
    let options = SIZES.map(|share| SurveyOptions { region_size: share * middle, ..options.clone() });
    let rungs = options.map(|options| rung(ground, &area, &elevation, &options, effort));
    let rungs = rungs.into_iter().collect::<Result<_, StudyError>>()?;
    Ok(LadderOutcome::new(name, "fit", expected, rungs))
}

fn rung(
    ground: &dyn Relief,
    area: &Area,
    elevation: &Elevation,
    options: &SurveyOptions,
    effort: Effort,
) -> Result<RungOutcome, StudyError> {
    let mut times = Vec::new();
    let mut fitted = survey(elevation, options, &mut |_| {})?;
    for _ in 0..effort.repetitions {
        let start = Instant::now();
        fitted = survey(elevation, options, &mut |_| {})?;
        times.push(start.elapsed().as_secs_f64());
    }
    let report = &fitted.report.levels[0];
    let mut errors = area.errors(ground, fitted.bank.finest());
    errors.extend(report.held_out_rms.map(|value| ErrorFigure {
        name: "held-out height rms",
        unit: "m",
        value,
    }));
    Ok(RungOutcome {
        changes: 1,
        label: format!("{}", options.region_size),
        step: Some(options.region_size),
        time_s: Some(spread(&times)),
        work: report.coefficients as u64,
        errors,
        refused: None,
    })
}

/// A square of ground, its south-west corner at (0, 0).
struct Area {
    /// From sample to sample (m).
    step: f64,
    side: f64,
    /// Distance from the edge within which errors are not counted (m).
    margin: f64,
}

impl Area {
    /// Samples along a side, both ends included.
    fn samples(&self) -> usize {
        (self.side / self.step).round() as usize + 1
    }

    fn sampled(&self, ground: &dyn Relief) -> Elevation {
        let count = self.samples();
        let at = |index: usize| index as f64 * self.step;
        let heights = (0..count * count).map(|sample| ground.at([at(sample / count), at(sample % count)])[0]);
        let place = Affine { first: [0.0; 2], step: [self.step; 2] };
        Elevation::new(count, count, heights.collect(), place, Frame::Plane(None))
    }

    /// Half way between the samples.
    fn errors(&self, ground: &dyn Relief, level: &Level) -> Figures {
        let (mut height, mut slope, mut edge) = (Sum::default(), Sum::default(), Sum::default());
        let at = |index: usize| (index as f64 + 0.5) * self.step;
        let inside = |place: f64| self.margin <= place && place <= self.side - self.margin;
        let count = self.samples() - 1;
        for sample in 0..count * count {
            let place = [at(sample / count), at(sample % count)];
            let Some((region, within)) = level.locate(place[0], place[1]) else { continue };
            let ([found, north, east], truth) = (height_and_slopes(level, region, within), ground.at(place));
            if !place.into_iter().all(inside) {
                edge.add(found - truth[0]);
                continue;
            }
            height.add(found - truth[0]);
            slope.add(north - truth[1]);
            slope.add(east - truth[2]);
        }
        let figure = |name, unit, value| ErrorFigure { name, unit, value };
        vec![
            figure(HEIGHT_RMS, "m", height.rms()),
            figure("bank height max", "m", height.max()),
            figure(SLOPE_RMS, "1", slope.rms()),
            figure("bank height rms at the edge", "m", edge.rms()),
        ]
    }
}

/// Height (m) and slopes: derivatives of the words are for a region.
fn height_and_slopes(level: &Level, region: [usize; 2], within: [f64; 2]) -> [f64; 3] {
    let [height, north, east] = level.height_and_slopes(region, within);
    [height, north / level.region_size(), east / level.region_size()]
}

#[cfg(test)]
mod tests;
