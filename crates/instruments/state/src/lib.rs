//! The whole hybrid machine at the start of a sweep: written, read, stepped, and gone on from.
//!
//! ```text
//! mission, place ─▶ Bench::save ─▶ State ─▶ bytes of a file (docs/state-format.md)
//! bytes ─▶ State ─▶ Bench::restore ─┬▶ Bench::go_on ─▶ picture of the frame, and of later ones
//!                                   ├▶ Bench::moved ─▶ State at another place
//!                                   └▶ Bench::look  ─▶ what is there, as text or document
//! ```
//!
//! **Law.** What a machine remembers is taken from the file: rows of the sweep memory, earlier stores, earlier pictures. All else
//! follows from mission and place. The digital side is worked out again and held to the file, line by line.
//! **Place.** A [`Place`] is a sweep's start and the way gone in the sweep, in ticks or in samples: the state of a place inside a sweep
//! is that of the start. A [`Clock`] steps from place to place.
//! **Our choices.** A step goes to the next place of its kind. A sweep's start is a place of every kind: its first tick, its first sample,
//! and an event. So N steps of a kind and N steps back lead to the same place, from a sweep's start and from any place of that kind.

mod bench;
mod container;
mod decode;
mod digital;
mod error;
mod events;
mod identity;
mod look;
mod place;

pub use bench::{Bench, Mission};
pub use container::{Block, BlockKind, Head, State};
pub use error::{BlockName, Fault, Other, StateError};
pub use identity::{Hashes, Identity};
pub use look::Look;
pub use place::{Clock, Gone, Place, PlaceError, Unit};
