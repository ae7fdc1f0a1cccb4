//! Labels of keyword = value statements, as PDS3 and ISIS have them.

mod parse;
mod statements;

pub use self::parse::{Statement, Value};
pub use self::statements::{
    Dialect, Label, angles, is_nothing, kilometres, length_of_sample, pieces, place, plain, samples_of_angle,
};
