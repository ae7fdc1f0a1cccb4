//! Triggers: where in a mission a signal does what is waited for.
//!
//! ```text
//! text ─▶ Condition ─▶ Trigger ◀─ wires of the machine
//!          (names)        │
//! sweeps, in order ───────┴─▶ Search ─▶ hits: sample, instant, values
//! ```
//!
//! **Law.** A condition is clauses joined by `and`. A *state* holds at samples (`tg.height > 1700`); a *moment* happens at
//! an instant (`rising tg.height 1700`). The clauses are met together where every state holds at a sample and every
//! moment happens in the step that ends there. States alone are found where they begin to hold, once a stretch.
//! Instants lie between samples: a level is crossed on the straight line between two samples, a digital wire changes at
//! its own instant, a gate that is sampled changes at its sample. The sample of an instant is the first at or after it.
//! **Parameters.** The condition; the samples in which the trigger is armed. What holds already where it is armed is
//! found there.
//! **State and timing.** Every sweep begins afresh: where a mission is divided between two searches changes nothing that
//! is found in a sweep.
//! **Elaboration.** Names are looked up once, against the signal table and then against the wires that the machine has.
//! What is searched costs a pass over the signals that are named.
//! **Our choices.** Hysteresis arms an edge: after a rise through L it waits for the signal to be below L - H. A pulse
//! shorter than W is told at its end and must have begun in the sweep; one longer than W when W has passed. Saturation
//! is the voltage at which amplifiers clip, or full scale where they do not; without a name it is looked for on every
//! voltage but those of the sweep generator, which are at full scale where they end. Of several moments at one sample the
//! last says when.
//! **Not modelled.** What a digital wire does between two samples is no state: ask for its edge.

mod condition;
mod error;
mod lexer;
mod moments;
mod parser;
mod search;
mod states;
mod sweep;
mod trigger;

pub use condition::Condition;
pub use error::{ConditionError, Fault};
pub use search::{Search, Which};
pub use sweep::value_at;
pub use trigger::{Hit, Machine, Reading, Trigger};
