//! Analog solver: the machine's exact discretisation against methods that step.
//!
//! **Law.** A chain of the machine ([`Chain`]) by four methods, each in steps of 1/16 to 16 samples, and with the feature
//! `solver-library` by the stiff integrator of a library, which chooses its own. Error is against the
//! exact discretisation in steps of 1/1024 and 1/2048 of a sample, extrapolated to no step ([`Truth`]). A part solved
//! exactly for a straight input is wrong only where its input is curved: behind the multiplier, by the square of the step.

mod chain;
mod flow;
#[cfg(any(test, feature = "solver-library"))]
mod library;
mod measure;
mod method;

pub use chain::{Chain, Record};
pub use flow::{Flow, implicit, runge_kutta};
pub use measure::{NOT_BUILT, SOLVER, Truth, solver_ladders};
pub use method::Method;
