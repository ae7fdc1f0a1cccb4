//! What the tests share.
//!
//! - [`ComparedScene`], [`random`], [`level_of`], [`Dice`]: scenes by hand and from a seed, of the crate `lockstep`.
//! - [`lockstep`](mod@lockstep): such a scene on machine and interpreter.
//! - [`trust`]: the evidence of docs/trust.md, and the page made of it.
//! - [`shipped`]: the scenarios of the folder `scenarios/`, and their agreement with `exact`.
//! - [`link`]: figures of a study of sea states, remade and measured.
//! - [`breaks`]: deliberate breaks of the code, for `awake`.

pub mod breaks;
pub mod link;
pub mod lockstep;
pub mod shipped;
pub mod trust;

pub use ::lockstep::{ComparedScene, Dice, Drawn, level_of, plane, random, scene};
pub use lockstep::Lockstep;
pub use shipped::{Shipped, Shown};
