//! JSON Schema of the files that people write, for their editors.
//!
//! ```text
//! files that use every key ─▶ their reader, recorded ─▶ keys: type, bounds, unit, words ─┐
//!                                       pages of docs ─▶ meaning of each key ────────────┴▶ schema
//! ```
//!
//! - [`SCENARIO`], [`MODEL`], [`LANDSCAPE`]: the committed schemas, which a test of this crate makes anew and compares. The schema of cartridges is that of
//!   their crate.
//! - [`Keys`]: what some readings asked for, merged key by key; [`Keys::schema`] writes it.
//!
//! **What a schema says.** Every key with its type, bounds, words and meaning. A key is required if every table of its kind that was read
//! must have it. A table has no other keys.
//! **What it cannot say.** Rules that span several keys. A file that a schema accepts may still be refused by `lunoid check`; what it refuses
//! `check` refuses too.

mod keys;
mod meanings;
mod schema;
#[cfg(test)]
mod tests;

pub use keys::Keys;
pub use meanings::Meanings;
pub use schema::Told;

/// Schema of scenario files.
pub const SCENARIO: &str = include_str!("../../../../docs/schema/scenario.schema.json");

/// Schema of hardware models, and of what differs from one.
pub const MODEL: &str = include_str!("../../../../docs/schema/hardware-model.schema.json");

/// Schema of landscape files.
pub const LANDSCAPE: &str = include_str!("../../../../docs/schema/landscape.schema.json");
