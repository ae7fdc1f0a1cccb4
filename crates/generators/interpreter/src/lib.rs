//! The second engine: a slow and obvious interpreter of one sweep, as the report draws it (sections 6 to 10, 13 to 15, 24).
//!
//! ```text
//! clock ──▶ registers ◀── stops of ramps ──▶ event list
//!               │              │
//!             hold ──▶ 36 products, sums ─┬─▶ light ─▶ VS1 ─▶ VS2 ─▶ + ─▶ clip ─┬─▶ video
//! craters ─▶ closed forms ────────────────┴─▶ height ─▶ elevation ─▶ occlusion ─┴─▶ deflection
//! ```
//!
//! **What it shares with the machine**: words of the bank, list of craters, pattern of the texture, sun and pose; the
//! numbers of a hardware model; the names of signals. **What it does not share**: any code that makes a signal. It
//! knows no polynomials in ground range, no lanes and no programs: at every accumulator step it reads the two ramps,
//! forms 36 products and adds them, asks every crater, and feeds the occlusion circuit sample by sample, all in f64.
//!
//! Files, by part of the drawing: [`scene`] and [`given`](mod@given) (what is given), [`fan`] (azimuths, ranges), [`clock`] (ticks), [`ramp`],
//! [`registers`] and [`server`] (hold, preload registers, pointers, words on their way), [`terrain`] (function
//! generators, products, sums), [`parts`] (the same of real parts), [`wires`] (their names), [`walk`] (one terrain generator along a sweep), [`levels`] (two of them), [`light`],
//! [`craters`], [`loads`] (their words), [`shadows`] (words of boundaries), [`mixing`], `composite` and `switching` (generators and mixing unit, of ideal and of real parts), [`output_amplifiers`], [`projector`], `projecting` (it along a sweep), [`sweep`] (one sweep in order), [`coverage`] (what it does not model). For a whole
//! frame: [`frame`](mod@frame), [`processor`] (set-ups), [`drums`] (with queues and storage buffer), [`demand`] (what a frame asks of them).
//!
//! **Our choices.** Ground range of the samples is taken as it is given, so that both engines look at the same places;
//! [`range_programme`] is an opinion of its own on it. The gate of remote shadow is given too: boundaries are made
//! before the mission.

pub mod clock;
mod composite;
pub mod coverage;
pub mod craters;
pub mod demand;
pub mod drums;
pub mod event;
pub mod fan;
pub mod frame;
pub mod given;
mod grain;
pub mod levels;
pub mod light;
pub mod loads;
pub mod mixing;
pub mod output_amplifiers;
pub mod parts;
pub mod processor;
mod projecting;
pub mod projector;
pub mod ramp;
pub mod registers;
pub mod scene;
pub mod server;
pub mod shadows;
mod sub_generators;
pub mod sweep;
mod switching;
pub mod terrain;
pub mod walk;
pub mod wires;

pub use coverage::{Unknown, why_not, why_straight};
pub use drums::{Arrivals, DrumFigures, GivenKind};
pub use event::{AskedFor, Event, FromDrum, Happening, Outcome, Part, Register};
pub use fan::range_programme;
pub use frame::{Frame, FrameGiven, frame};
pub use given::{Given, straight};
pub use scene::SceneData;
pub use shadows::ShadowLine;
pub use sweep::{Record, array, interpret};
