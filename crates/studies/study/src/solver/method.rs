//! The chain by one method, step by step.

use super::chain::{Chain, Record, SAMPLES};
use super::flow::{implicit, runge_kutta};
#[cfg(any(test, feature = "solver-library"))]
use super::library;

/// How the chain is solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// The machine's parts: each the exact solution for an input that is a straight line over the step.
    Parts,
    /// The trapezoidal rule, of order 2.
    Trapezoidal,
    /// The backward Euler method, of order 1.
    BackwardEuler,
    /// Explicit Runge-Kutta of order 4.
    RungeKutta,
    /// Kvaerno's method of order 5 of a library, implicit and stiffly accurate, which chooses its steps by this tolerance
    /// and begins anew at each fold.
    #[cfg(any(test, feature = "solver-library"))]
    Library(f64),
}

/// Index of the summer's output and of the tracked value in the states.
pub(super) const SEEN: [usize; 2] = [5, 6];

impl Method {
    /// The run in `1 / step` values a sample; `None` if the method gave up.
    pub fn run(self, chain: &Chain, step: f64) -> Option<Record> {
        let steps = (SAMPLES as f64 / step).round() as usize;
        match self {
            Self::Parts => Some(chain.by_parts(step, steps)),
            Self::Trapezoidal => Some(stepped(chain, step, steps, |t, h, y| implicit(chain, t, h, y, 0.5))),
            Self::BackwardEuler => Some(stepped(chain, step, steps, |t, h, y| implicit(chain, t, h, y, 1.0))),
            Self::RungeKutta => Some(stepped(chain, step, steps, |t, h, y| runge_kutta(chain, t, h, y))),
            #[cfg(any(test, feature = "solver-library"))]
            Self::Library(tolerance) => library::run(chain, step, tolerance),
        }
    }
}

fn stepped(
    chain: &Chain,
    step: f64,
    steps: usize,
    advance: impl Fn(f64, f64, &[f64; 7]) -> [f64; 7],
) -> Record {
    let (mut y, h) = (chain.at_rest(), step * chain.sample);
    let mut record = Record::starting(SEEN.map(|index| y[index]), steps);
    for k in 0..steps {
        y = advance(k as f64 * h, h, &y);
        record.push(SEEN.map(|index| y[index]));
    }
    record
}
