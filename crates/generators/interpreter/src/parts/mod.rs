//! Real parts, integrated by the interpreter itself. Of the terrain generator, the circuit of one array:
//!
//! ```text
//! accumulator ─▶ D/A ─▶ smoother ─▶ 12 function generators an axis ─▶ ± polarity ─▶ 108 multipliers
//!                                                                                        │
//!      height, slopes ◀─ trimmed datum ◀─ three trees of amplifiers ◀─ 108 multiplying D/As
//! ```
//!
//! **What it shares with the machine**: the figures of the hardware model, the numbers that a seed draws for parts and for noise,
//! and the points of broken lines, which are fitted to a function. **What it does not share**: any code that makes a signal. Its
//! figures are worked out here from the sections of `docs/hardware-1969.md`, each lag is a power series of its differential
//! equation ([`series`]) instead of an exponential, words divide steps one by one, and amplifiers that slew or clip are walked in
//! small steps ([`amplifier`]).
//!
//! **The machine's own law.** Each part sees its input as a straight line between samples; a converter's word changes as a step
//! begins, polarity at a sample, and the word of a multiplying D/A at its own instant within a step.
//!
//! **Terrain generator**: [`drawn`] (what a seed gives), [`figures`] (of every part), [`series`], [`ramp`], [`functions`], [`words`]
//! (what D/As take, and when), [`amplifier`], [`tree`], [`chain`] (all of them, step by step), [`array`](mod@array) (what a sweep drives
//! them by), [`light_stage`] and [`reflectivity`] (light of its slopes, and its delay).
//!
//! **Behind it**, all from the figures of a [`kit`]: [`sub_generator`] and [`crater_chains`] (feature generator), [`texture`],
//! [`comparator`], [`gates`] (with the fades that they command), [`video_switch`], [`broken`] (a signal that jumps between samples),
//! [`video_amplifier`] and [`mixer`] (mixing unit), [`falls`], [`sample_hold`], [`latch`], [`peak_detector`] and [`beam`] (projection
//! processor).

pub mod amplifier;
pub mod array;
pub mod beam;
pub mod broken;
pub mod chain;
pub mod comparator;
pub mod crater_chains;
pub mod drawn;
pub mod falls;
pub mod figures;
pub mod functions;
pub mod gates;
pub mod kit;
pub mod latch;
pub mod light_stage;
pub mod mixer;
pub mod peak_detector;
pub mod ramp;
pub mod reflectivity;
pub mod sample_hold;
pub mod series;
pub mod sub_generator;
pub mod texture;
pub mod tree;
pub mod video_amplifier;
pub mod video_switch;
pub mod words;

pub use array::{Array, Sweep};
pub use drawn::Drawn;
pub use figures::Figures;
pub use light_stage::LightStage;
pub use reflectivity::ReflectivityStage;
