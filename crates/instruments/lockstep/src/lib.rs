//! Machine and interpreter side by side (trust 3.3).
//!
//! ```text
//! stage ─┬▶ machine, probed ───▶ waveforms ─┐
//!        ├▶ control plane ─────▶ events ────┼─▶ compare ─▶ report: a row a signal, first difference
//!        └▶ interpreter, f64 ──▶ record ────┘
//! ```
//!
//! **What is compared.** Every signal that the interpreter has an opinion on, at every sample within the stored ground;
//! every event of the digital side with its tick. Events are equal or not. Signals agree within a part of full
//! scale ([`bounds`]). Where a value is nearer to a threshold than rounding can tell, the sample counts as doubtful.
//!
//! [`ComparedScene`] is a scene by hand, [`random`] one from a seed; [`shrink`] makes one that differs as small as it can.

pub mod answers;
pub mod bounds;
mod compare;
mod engines;
mod events;
pub mod random;
mod random_parts;
mod report;
pub mod scene;
pub mod shrink;
mod trials;

pub use engines::{Engines, LitSweep, Seen, drawn};
pub use random::Dice;
pub use report::{Difference, Report, Tally};
pub use scene::{ComparedScene, Drawn, level_of, plane};
pub use trials::{Fault, Trials, frame_of, trials};
