//! Stability: cases that break solvers and scenes that break generators, each by every method.
//!
//! ```text
//! parts: time constants, chains, poles, slew, comparators, holds, drift ──▶ parts │ trapezoidal, Euler, Runge-Kutta ─┐
//! scene ─▶ one extreme, a pair, a mixture ─▶ ideal f64, ideal f32, parts ──▶ every wire, every pixel, exact ─────────┼▶ cells
//! scenario text, words, craters that are none ─▶ readers ────────────────────────────────────────────────────────────┘
//! ```
//!
//! **Law** (trust sections 3.8 and 4). A [`Cell`] holds if what comes out is finite and bounded and no further off than
//! theory allows, or is refused with a message where it must be. A cell of a method of the machine that does not hold
//! says why; methods for comparison may break, and are there to show where.
//! **Our choices.** Scenes are 48 x 32. The signals of the ideal machine are held against the ground below the sweep, the picture
//! of a machine with parts against `exact`. A panic is caught and is a fault.

mod cell;
mod extremes;
mod frames;
mod linear;
mod matrix;
mod refusals;
mod scene;
mod survey_fit;
mod switching;
pub mod table;

pub use cell::{Action, Cell, Found, Theory};
pub use matrix::{Choice, matrix, rows};
pub use refusals::BASE;
pub use scene::Scene;
pub use survey_fit::{FitOutcome, survey_fits};

#[cfg(test)]
mod tests;
