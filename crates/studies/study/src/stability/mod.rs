//! Stability: cases that break solvers and scenes that break generators, each by every method.
//!
//! ```text
//! parts: time constants, chains, poles, slew, comparators, holds, drift ──▶ parts │ trapezoidal, Euler, Runge-Kutta ─┐
//! scene ─▶ one extreme, a pair, a mixture ─▶ ideal f64, ideal f32, parts, machine ─▶ every wire, every pixel, exact ┼▶ cells
//! scenario text, words, craters that are none ─▶ readers ────────────────────────────────────────────────────────────┘
//! ```
//!
//! **Law** (trust sections 3.8 and 4). A [`Cell`] holds if what comes out is finite and bounded and no further off than
//! theory allows, or is refused with a message where it must be. A cell of a method of the machine that does not hold
//! says why; methods for comparison may break, and are there to show where.
//! **Our choices.** Scenes are 48 x 32. Signals are held against the ground below the sweep: those of ideal parts to
//! roundings, those of real parts behind an ideal digital side to what their figures allow. A whole real machine, whose words
//! come late, must be finite and bounded, and refuse what it cannot draw. A panic is caught and is a fault.

mod cell;
mod exponential;
mod extremes;
mod frames;
mod linear;
mod matrix;
mod refusals;
mod scene;
mod second_order;
mod survey_fit;
mod switching;
pub mod table;

pub use cell::{Action, Cell, Found, Theory};
pub use matrix::{Choice, matrix, rows};
pub use refusals::BASE;
pub use scene::StabilityScene;
pub use survey_fit::{FitOutcome, survey_fits};

#[cfg(test)]
mod tests;
