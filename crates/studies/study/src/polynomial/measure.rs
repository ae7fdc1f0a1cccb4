//! Error and time of the methods.

use std::hint::black_box;
use std::time::Instant;

use signal::Real;

use super::method::{Method, Ready};
use super::stretch::{Stretch, stretches};
use crate::figures::{ErrorFigure, Sum};
use crate::ladder::{Extent, LadderOutcome, RungOutcome};
use crate::work::{Effort, spread};
use crate::{StudyError, Subject};

/// Name of the ladder.
pub const POLYNOMIAL: &str = "polynomial";
/// Degrees at which the Chebyshev sum is cut.
const DEGREES: [usize; 7] = [4, 5, 6, 7, 8, 9, 10];
/// What it may leave out (m).
const TOLERANCES: [f64; 4] = [1e-1, 1e-2, 1e-3, 1e-4];

/// A rung: a method in one scalar, over all stretches.
trait Rung {
    fn turn(&mut self, stretches: &[Stretch], is_timed: bool);
    fn outcome(&self, stretches: &[Stretch], full_scale: f64) -> RungOutcome;
}

struct Run<S> {
    label: String,
    method: Method,
    ready: Vec<Ready<S>>,
    times: Vec<f64>,
    heights: Vec<f64>,
}

impl<S: Real> Run<S> {
    fn boxed(label: String, method: Method, stretches: &[Stretch]) -> Box<dyn Rung> {
        let ready = stretches.iter().map(|stretch| Ready::new(method, stretch)).collect();
        Box::new(Self { label, method, ready, times: Vec::new(), heights: Vec::new() })
    }
}

impl<S: Real> Rung for Run<S> {
    fn turn(&mut self, stretches: &[Stretch], is_timed: bool) {
        self.heights.clear();
        let start = Instant::now();
        for (ready, stretch) in self.ready.iter().zip(stretches) {
            ready.heights(self.method, black_box(stretch), &mut self.heights);
        }
        if is_timed {
            self.times.push(start.elapsed().as_secs_f64() / self.heights.len().max(1) as f64);
        }
    }

    fn outcome(&self, stretches: &[Stretch], full_scale: f64) -> RungOutcome {
        let truth = stretches.iter().flat_map(|stretch| &stretch.points).map(|point| point.height);
        let mut sum = Sum::default();
        self.heights.iter().zip(truth).for_each(|(height, truth)| sum.add(height - truth));
        let degrees: usize = self.ready.iter().zip(stretches).map(|(r, s)| r.degree() * s.points.len()).sum();
        let figure = |name, unit, value| ErrorFigure { name, unit, value };
        RungOutcome {
            changes: 1,
            label: self.label.clone(),
            step: None,
            time_s: Some(spread(&self.times)),
            work: self.heights.len() as u64,
            errors: vec![
                figure("evaluation rms", "m", sum.rms()),
                figure("evaluation max", "m", sum.max()),
                figure("evaluation max of full scale", "1", sum.max() / full_scale),
                figure("mean degree", "1", degrees as f64 / self.heights.len().max(1) as f64),
            ],
            refused: None,
        }
    }
}

/// Error and time of an evaluation of the height along the sweeps of the subject's first frame.
///
/// # Errors
/// If the frame cannot be drawn.
pub fn polynomial_ladder(
    subject: &Subject,
    effort: Effort,
    extent: Extent,
) -> Result<LadderOutcome, StudyError> {
    let (frame, pose) = subject.frames[0];
    let all = stretches(&subject.stage, frame, &pose)?;
    let mut rungs = runs(&all, extent);
    for turn in 0..=effort.repetitions {
        rungs.iter_mut().for_each(|rung| rung.turn(&all, turn > 0));
    }
    let heights = all.iter().flat_map(|stretch| &stretch.points).map(|point| point.height.abs());
    let full_scale = heights.fold(f64::MIN_POSITIVE, f64::max);
    let outcomes = rungs.iter().map(|rung| rung.outcome(&all, full_scale)).collect();
    let what = "evaluation of the height along a sweep";
    Ok(LadderOutcome::new((POLYNOMIAL, what), "evaluation", &[], outcomes))
}

fn runs(all: &[Stretch], extent: Extent) -> Vec<Box<dyn Rung>> {
    let double = |label: String, method| Run::<f64>::boxed(label + ", f64", method, all);
    let single = |label: String, method| Run::<f32>::boxed(label + ", f32", method, all);
    let degrees = if extent == Extent::Quick { &DEGREES[3..4] } else { &DEGREES[..] };
    let tolerances = if extent == Extent::Quick { &TOLERANCES[1..2] } else { &TOLERANCES[..] };
    let mut rungs = vec![
        double("36 products".into(), Method::Products),
        single("36 products".into(), Method::Products),
        double("factorised array".into(), Method::Array),
        double("powers along the sweep".into(), Method::Powers),
        single("powers along the sweep".into(), Method::Powers),
    ];
    rungs.extend(degrees.iter().map(|&k| double(format!("Chebyshev, degree {k}"), Method::Chebyshev(k))));
    rungs.push(single("Chebyshev, degree 10".into(), Method::Chebyshev(10)));
    let within = |&m: &f64| single(format!("Chebyshev within {m:e} m"), Method::ChebyshevWithin(m));
    rungs.extend(tolerances.iter().map(within));
    rungs
}
