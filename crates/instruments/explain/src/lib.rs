//! From a pixel of a frame to the wires that made it, and from late words to the pixels that they changed.
//!
//! ```text
//! pixel ─▶ read beam ─▶ sweep, cell ─▶ last stroke across the cell ─▶ sample ─▶ every signal there
//!                          │                                            └▶ region, colours, craters, gates
//!                          └▶ program of the sweep ─▶ registers then, late words in force
//! exact ─▶ the same pixel by closed form ─▶ error
//! ```
//!
//! **Law.** The stroke from sample k-1 to k crosses the middle of a cell if the beam's line passes it and the beam is not
//! blanked at k; of several the last one stays in the store. What the sample tells is the machine's own: every number is
//! a signal of the signal table or follows from the program that the sweep ran.
//! **Our choices.** A pixel is read between two sweeps: both are named with their weights, and with the late words of each: those due
//! before the last sample that leaves anything in the cell, or before the sweep's end where it does not fill the cell. The sample
//! and its wires are those of the nearest. What bodies cover is told as
//! theirs; the ground behind is told as well. A register is stale if its corner is not the one that the region asks
//! for, whatever brought it there.
//! **Forward** ([`late_effect`]). The words that one fold found missing are brought into their registers right before that fold, and
//! nothing else is changed: the pixels that differ are the work of these words. A sweep's program is its own, so only that sweep is
//! drawn twice. The words of a crater are in its sub-generator, and those of a shadow boundary in its line generator, as the sweep meets
//! them. A boundary is of all sweeps that are drawn with the same set-up. Later frames differ only where the storage tube or the picture tube still shows this one.
//! **Other generators** ([`facts`]) say of a pixel what they will, or else what their planes hold there.
//! **Not told.** What the read beam, the storage tube's residue, noise and the law of the picture tube add to what the sweep left: that is the difference
//! between `left` and the pixel's `intensity`.

mod because;
mod column;
mod effect;
mod effect_text;
mod facts;
mod ground;
mod late;
mod not_late;
mod seek;
mod text;

pub use effect::{FrameEffect, LateEffect, LateError, Missed, late_effect};
pub use facts::facts;
pub use ground::corner_place;
pub use late::{Late, LateLoad, boundary_at};
pub use seek::{Between, Explanation, Inquiry, InquiryError, Place, ReadSweep, Writer};
