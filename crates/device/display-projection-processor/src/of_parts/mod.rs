//! The processor made of real parts; the data sheet is the crate's.

mod chain;
mod derivative;
mod falls;
mod field;
mod figures;
mod function;
mod lane;
mod peak_hold;

pub use chain::{Driven, PartsProcessor, Scratch};
pub use figures::DERIVATIVE;

#[cfg(test)]
mod tests;
