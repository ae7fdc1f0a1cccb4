//! Error and time of the methods.

use std::time::Instant;

use super::chain::{Chain, Record, SAMPLES};
use super::method::Method;
use crate::figures::{ErrorFigure, Figures, Sum};
use crate::ladder::{Expectation, Extent, LadderOutcome, RungOutcome};
use crate::work::{Effort, spread};

/// What the ladders of solvers are called together.
pub const SOLVER: &str = "solver";
/// Steps of the reference in a sample; and half as long ones, for the extrapolation.
const REFERENCE: usize = 1024;
/// Steps of the methods (samples).
const STEPS: [f64; 9] = [16.0, 8.0, 4.0, 2.0, 1.0, 0.5, 0.25, 0.125, 0.0625];
/// Steps beside them for the explicit method, which has its order only where it is far from its limit.
const FINER: [f64; 2] = [0.03125, 0.015625];
/// Steps of a quick study: the coarse end, where all methods still differ, is left out.
const QUICK: usize = 4;
/// Tolerances of the library.
#[cfg(any(test, feature = "solver-library"))]
const TOLERANCES: [f64; 7] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8];
/// Weights of the waveform norm (trust section 4).
const NORM: [f64; 2] = [1e-3, 1e-4];

/// What a program without the feature `solver-library` leaves out, and how to have it.
pub const NOT_BUILT: Option<&str> = if cfg!(any(test, feature = "solver-library")) {
    None
} else {
    Some(
        "not built: the ladder solver-library, a library's implicit method of order 5; \
         `cargo run --release --features solver-library -- study error SCENARIO --only solver` has it",
    )
};

const BEHIND_PRODUCT: &str = "a product of ramps is curved, and a straight line stands for it over a step";
const TRAPEZOIDAL: &str = "trapezoidal rule";
const BACKWARD: &str = "rate at the end of the step alone";
const RUNGE_KUTTA: &str = "four stages, smooth between folds";
const STRAIGHT: &str = "the comparator and the hold see straight lines between steps, whoever made them";

/// The converged solution of a chain.
#[derive(Debug, Clone, PartialEq)]
pub struct Truth {
    /// Output of the summer at every sample.
    summed: Vec<f64>,
    /// Values held, and when (samples).
    held: Vec<[f64; 2]>,
    /// By how much the reference of steps twice as long differs: largest of all values.
    pub doubt: f64,
}

impl Truth {
    /// Returns the true values of `chain`, extrapolated from runs of fine steps.
    pub fn new(chain: &Chain) -> Self {
        let runs = [REFERENCE / 2, REFERENCE, 2 * REFERENCE].map(|steps| {
            let step = 1.0 / steps as f64;
            let record = chain.by_parts(step, SAMPLES * steps);
            (record.summed.iter().copied().step_by(steps).collect::<Vec<f64>>(), chain.held(&record, step))
        });
        let [coarse, middle, fine] = &runs;
        let (rough, summed) = (extrapolated(&coarse.0, &middle.0), extrapolated(&middle.0, &fine.0));
        let flat = |run: &[[f64; 2]]| run.as_flattened().to_vec();
        let held_rough = extrapolated(&flat(&coarse.1), &flat(&middle.1));
        let held = extrapolated(&flat(&middle.1), &flat(&fine.1));
        // Instants are samples, not full scales: only values are compared.
        let values = held_rough.iter().zip(&held).step_by(2);
        let off = rough.iter().zip(&summed).chain(values).map(|(a, b)| (a - b).abs());
        let doubt = off.fold(0.0, f64::max);
        let held = held.as_chunks().0.to_vec();
        Self { summed, held, doubt }
    }

    /// Errors of a record in steps of `step` samples, or why there are none.
    pub fn errors(&self, chain: &Chain, record: &Record, step: f64) -> Result<Figures, String> {
        if !record.is_bounded() {
            return Err("unbounded".to_owned());
        }
        let (stride, every) = ((1.0 / step).round().max(1.0) as usize, step.max(1.0) as usize);
        let (mut sum, mut norm) = (Sum::default(), Sum::default());
        for (found, truth) in record.summed.iter().step_by(stride).zip(self.summed.iter().step_by(every)) {
            sum.add(found - truth);
            norm.add((found - truth) / (NORM[0] * truth.abs() + NORM[1]));
        }
        let mut figures = vec![
            ErrorFigure { name: "chain rms", unit: "FS", value: sum.rms() },
            ErrorFigure { name: "chain max", unit: "FS", value: sum.max() },
            ErrorFigure { name: "waveform norm", unit: "1", value: norm.rms() },
        ];
        let held = chain.held(record, step);
        if held.len() == self.held.len() {
            let off = |column: usize| {
                let pairs = held.iter().zip(&self.held);
                pairs.fold(0.0_f64, |most, (a, b)| most.max((a[column] - b[column]).abs()))
            };
            figures.push(ErrorFigure { name: "held max", unit: "FS", value: off(0) });
            figures.push(ErrorFigure { name: "hold instant max", unit: "samples", value: off(1) });
        }
        Ok(figures)
    }
}

/// The extrapolation to no step of an error that falls with its square.
fn extrapolated(coarse: &[f64], fine: &[f64]) -> Vec<f64> {
    coarse.iter().zip(fine).map(|(coarse, fine)| fine + (fine - coarse) / 3.0).collect()
}

/// A rung on its way.
struct Run {
    method: Method,
    step: f64,
    label: String,
    along: f64,
    times: Vec<f64>,
    record: Option<Record>,
}

impl Run {
    fn new(method: Method, step: f64) -> Self {
        let (label, along) = match method {
            #[cfg(any(test, feature = "solver-library"))]
            Method::Library(tolerance) => (format!("{tolerance:e}"), tolerance),
            _ if step < 1.0 => (format!("1/{}", 1.0 / step), step),
            _ => (format!("{step}"), step),
        };
        Self { method, step, label, along, times: Vec::new(), record: None }
    }

    fn turn(&mut self, chain: &Chain, is_timed: bool) {
        let start = Instant::now();
        let record = self.method.run(chain, self.step);
        if is_timed {
            self.times.push(start.elapsed().as_secs_f64() / SAMPLES as f64);
        }
        self.record = record;
    }

    fn outcome(self, chain: &Chain, truth: &Truth) -> RungOutcome {
        let gave_up = || "the solver gave up".to_owned();
        let found = self
            .record
            .as_ref()
            .ok_or_else(gave_up)
            .and_then(|record| truth.errors(chain, record, self.step));
        let (errors, refused) = found.map_or_else(|why| (Vec::new(), Some(why)), |errors| (errors, None));
        RungOutcome {
            changes: 1,
            label: self.label,
            step: Some(self.along),
            time_s: Some(spread(&self.times)),
            work: (SAMPLES as f64 / self.step) as u64,
            errors,
            refused,
        }
    }
}

/// One method, rung by rung, and the orders that theory expects of it.
struct Climb {
    name: &'static str,
    what: &'static str,
    orders: Vec<Expectation>,
    runs: Vec<Run>,
}

/// One ladder a method: error and time a sample of the chain against the step, and of the library, where it is built,
/// against its tolerance.
pub fn solver_ladders(chain: &Chain, effort: Effort, extent: Extent) -> Vec<LadderOutcome> {
    let truth = Truth::new(chain);
    let mut climbs = own(extent);
    #[cfg(any(test, feature = "solver-library"))]
    climbs.push(library());
    // The first turn is not timed, and within a turn all methods are as busy as the machine.
    for turn in 0..=effort.repetitions {
        climbs.iter_mut().flat_map(|climb| &mut climb.runs).for_each(|run| run.turn(chain, turn > 0));
    }
    let outcome = |climb: Climb| {
        let rungs = climb.runs.into_iter().map(|run| run.outcome(chain, &truth)).collect();
        LadderOutcome::new((climb.name, climb.what), "sample", &climb.orders, rungs)
    };
    climbs.into_iter().map(outcome).collect()
}

/// The methods that every program has.
fn own(extent: Extent) -> Vec<Climb> {
    let first = if extent == Extent::Quick { QUICK } else { 0 };
    let stepped = |method: Method| STEPS[first..].iter().map(move |&step| Run::new(method, step));
    let explicit = stepped(Method::RungeKutta).chain(FINER.map(|step| Run::new(Method::RungeKutta, step)));
    vec![
        Climb {
            name: "solver-parts",
            what: "step of the machine's parts (samples)",
            orders: vec![order("chain rms", 2.0, BEHIND_PRODUCT), order("hold instant max", 2.0, STRAIGHT)],
            runs: stepped(Method::Parts).collect(),
        },
        Climb {
            name: "solver-trapezoidal",
            what: "step of the trapezoidal rule (samples)",
            orders: vec![order("chain rms", 2.0, TRAPEZOIDAL)],
            runs: stepped(Method::Trapezoidal).collect(),
        },
        Climb {
            name: "solver-backward-euler",
            what: "step of backward Euler (samples)",
            orders: vec![order("chain rms", 1.0, BACKWARD)],
            runs: stepped(Method::BackwardEuler).collect(),
        },
        Climb {
            name: "solver-runge-kutta",
            what: "step of explicit Runge-Kutta (samples)",
            orders: vec![order("chain rms", 4.0, RUNGE_KUTTA), order("hold instant max", 2.0, STRAIGHT)],
            runs: explicit.collect(),
        },
    ]
}

#[cfg(any(test, feature = "solver-library"))]
fn library() -> Climb {
    Climb {
        name: "solver-library",
        what: "tolerance of a library's implicit method of order 5, a value a sample",
        orders: Vec::new(),
        runs: TOLERANCES.map(|tolerance| Run::new(Method::Library(tolerance), 1.0)).into(),
    }
}

fn order(error: &'static str, order: f64, why: &'static str) -> Expectation {
    Expectation { error, order, why }
}

#[cfg(test)]
mod tests {
    use hardware_model::{HardwareModel, ModelSource};

    use super::{Truth, solver_ladders};
    use crate::ladder::Extent;
    use crate::solver::Chain;
    use crate::work::Effort;

    fn nominal() -> Chain {
        let source = ModelSource::BuiltIn("pra-nominal".into());
        Chain::of(&HardwareModel::load(&source, &[], &[]).unwrap().model)
    }

    #[test]
    fn the_reference_has_converged() {
        let truth = Truth::new(&nominal());
        assert!(truth.doubt < 1e-9, "{:e}", truth.doubt);
        assert!(truth.held.len() > 4);
    }

    #[test]
    fn orders_are_those_of_theory() {
        let ladders = solver_ladders(&nominal(), Effort { repetitions: 1 }, Extent::Whole);
        assert_eq!((ladders.len(), ladders[4].name), (5, "solver-library"));
        for ladder in ladders {
            for order in &ladder.orders {
                assert!(order.agrees(0.2), "{}: {order:?}", ladder.name);
            }
        }
    }
}
