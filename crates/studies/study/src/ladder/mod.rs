//! Ladders: what is varied, rung by rung, and what came of it.

mod plan;

use serde::Serialize;

use crate::change::Change;
use crate::figures::Figures;
use crate::order::{Order, fit};

pub use plan::{Extent, ladders};

/// One factor, or two, over a base setting.
#[derive(Debug, Clone)]
pub struct Ladder {
    /// Name on the command line and in the tables.
    pub name: &'static str,
    /// What is varied, in words.
    pub what: &'static str,
    /// Orders of convergence that theory predicts.
    pub expected: Vec<Expectation>,
    /// Settings, coarse to fine where they have an order.
    pub rungs: Vec<Rung>,
}

/// One setting of a ladder.
#[derive(Debug, Clone)]
pub struct Rung {
    /// Its name in the ladder.
    pub label: String,
    /// What convergence is measured along, such as `1 / samples`; `None` where the rungs have no order.
    pub step: Option<f64>,
    /// What it does to the base.
    pub changes: Vec<Change>,
}

/// What theory says of an error along a ladder.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Expectation {
    /// Name of the error.
    pub error: &'static str,
    /// Order in the step.
    pub order: f64,
    /// Reason why theory says so.
    pub why: &'static str,
}

/// What came of a rung.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RungOutcome {
    /// Name of the rung in the ladder.
    pub label: String,
    /// What convergence is measured along.
    pub step: Option<f64>,
    /// Settings that are not those of the base.
    pub changes: usize,
    /// Median, smallest and largest time (s), in the ladder's unit of work.
    pub time_s: Option<[f64; 3]>,
    /// Samples, or evaluations, in a unit of work: a count that no busy machine changes.
    pub work: u64,
    /// Errors at this rung, each with its unit.
    pub errors: Figures,
    /// Why there are none.
    pub refused: Option<String>,
}

impl RungOutcome {
    /// The value of an error.
    pub fn error(&self, name: &str) -> Option<f64> {
        self.errors.iter().find(|error| error.name == name).map(|error| error.value)
    }
}

/// The order of an error along a ladder, beside what theory says.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OrderOutcome {
    /// Order that theory predicts, and why.
    #[serde(flatten)]
    pub expected: Expectation,
    /// What was measured; `None` without a straight part.
    pub measured: Option<Order>,
}

impl OrderOutcome {
    /// Whether theory and measurement agree within `within`.
    pub fn agrees(&self, within: f64) -> bool {
        self.measured.is_some_and(|order| (order.slope - self.expected.order).abs() <= within)
    }
}

/// What the whole error is told against.
pub const EXACT: &str = "exact";

/// What came of a ladder.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LadderOutcome {
    /// Name of the ladder.
    pub name: &'static str,
    /// What was varied, in words.
    pub what: &'static str,
    /// What a time is of: `frame`, `sample`.
    pub unit_of_work: &'static str,
    /// What errors are against: [`EXACT`], or what leaves a part of the error out.
    pub against: &'static str,
    /// Outcomes of the rungs, in their order.
    pub rungs: Vec<RungOutcome>,
    /// Orders of convergence, measured and expected.
    pub orders: Vec<OrderOutcome>,
}

impl LadderOutcome {
    /// The outcome of `rungs`, with the orders that theory speaks of.
    pub fn new(
        (name, what): (&'static str, &'static str),
        unit_of_work: &'static str,
        expected: &[Expectation],
        rungs: Vec<RungOutcome>,
    ) -> Self {
        let order = |expected: &Expectation| {
            let point = |rung: &RungOutcome| Some([rung.step?, rung.error(expected.error)?]);
            let points: Vec<[f64; 2]> = rungs.iter().filter_map(point).collect();
            OrderOutcome { expected: *expected, measured: fit(&points) }
        };
        let orders = expected.iter().map(order).collect();
        Self { name, what, unit_of_work, against: EXACT, rungs, orders }
    }

    /// The same with errors against something else than `exact`: they are a part of the whole error.
    pub fn against(self, against: &'static str) -> Self {
        Self { against, ..self }
    }

    /// Errors that any rung has, in the order of the first that has them.
    pub fn error_names(&self) -> Vec<(&'static str, &'static str)> {
        let mut names = Vec::new();
        for error in self.rungs.iter().flat_map(|rung| &rung.errors) {
            if !names.contains(&(error.name, error.unit)) {
                names.push((error.name, error.unit));
            }
        }
        names
    }
}
