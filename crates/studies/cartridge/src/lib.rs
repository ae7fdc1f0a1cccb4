//! Test cartridges: scenes whose answer is known in closed form (`tests/cartridges/README.md` describes the file).
//!
//! ```text
//! cartridge.toml ─▶ Cartridge ─┬─▶ cases: hardware models x headings x grounds ─▶ engine ─▶ what is seen ─┐
//!                              ├─▶ readings, each with its formula ──────────────────────────────────────┴▶ Outcome
//!                              └─▶ overlays: the same with a change ─▶ at least one answer must not come out ─▶ ▲
//! ```
//!
//! - [`carried`], [`of_folder`]: the cartridges of the program, and those of other people.
//! - [`Cartridge::run`] gives an [`Outcome`]; [`Summary::of`] says what a page needs to know of many;
//!   [`junit`] writes them for continuous integration.
//! - [`SCHEMA`]: the file as a JSON schema.
//!
//! **Law.** An answer is right if it is nowhere farther off than its tolerance; what is no number is infinitely far off.
//! A cartridge passes if all answers are right and every overlay makes one wrong.
//! **Second opinion.** The formulas of `formula` are written out here and share with the machine the words of the bank,
//! the figures of the hardware model, the azimuths of the fan, and the lot that static errors are drawn from.
//! **Our choices.** The answers of an overlaid scene stay those of the scene without. A cartridge names models and faults
//! that the program carries, and no files. The answers of a whole scenario stand in the file as numbers, each with its derivation.

mod engine;
mod file;
mod folder;
mod formula;
mod hardware;
mod junit;
mod outcome;
mod reading;
mod run;
mod scene;
#[cfg(test)]
mod tests;

pub use engine::Engine;
pub use file::{Cartridge, CartridgeError};
pub use folder::{CARRIED, SCHEMA, carried, of_file, of_folder};
pub use junit::junit;
pub use outcome::{Answer, Outcome, OverlayOutcome, Summary};
