//! Data banks: drums that turn, their queues, and the storage buffer in front of them (section 17; hardware
//! sections 2.3 and 4.7).
//!
//! ```text
//! demand of a frame ─▶ records not held ─▶ queue of each drum ─▶ drum ─▶ channel ─▶ I/O processor ─▶ storage buffer ─▶ loader
//! (pieces, urgent first)                   (FIFO | shortest latency)               (edits)           │ capacity   missing until
//!                                                                                                    ▼ dropped    the arrival tick
//! ```
//!
//! **Law.** A drum of revolution `T` that stands at angle `(t + start) mod T` at tick `t` delivers the record that
//! begins at place `p` at `t + ((p - angle) mod T) + transfer`, and nothing else until then. `transfer` is
//! `words x ticks a word` of the slower of drum and channel, rounded up. A channel carries one record at a time: one that
//! passes meanwhile waits for the next turn of its drum. A record of terrain holds an aligned square of `n x n` corners of nine words each; the data of
//! another kind are chains of records, one for each square of ground ([`Contents`]). A record is in the buffer when the I/O processor of its kind has edited it,
//! one after another;
//! record `r` lies on drum `r mod count`, drum `d` is on channel `d mod channels`, its records end to end along the tracks, heads switched at once.
//! **Parameters.** [`hardware_model::Drum`], [`hardware_model::Channels`] and the words of the buffer. The seed draws start angle and speed of each
//! drum, 0.5 % (one standard deviation); a slow drum is slow in revolution and in transfer. [`DrumUnit`] shows what
//! was drawn.
//! **State and timing.** Whole master ticks. A [`DataBank`] holds a store for each kind of data on its drums. It is called once a frame, in order of frames, and keeps
//! buffers, queues and the record under the heads; a clone is a checkpoint. A demand is acted on at its start. A record
//! that arrives with the last tick of the frame still belongs to the frame.
//! **Elaboration.** With all words at hand there is no data bank.
//! **Our choices.**
//! - The first frame finds the buffer full of what it demands: it was loaded before the mission, in the time that
//!   [`DataBank::first_load`] tells.
//! - Behind a channel that is slower than the drum a record is laid out interleaved, so long that it comes at the channel's
//!   rate. Of two records that pass in one tick that of the drum with the lower number is read. A drum that had to let its
//!   record pass keeps to it.
//! - Every frame the list of requests is written anew in the order of the demand. FIFO serves that list from its top;
//!   shortest latency takes what comes under the heads first, and of two at one place the more urgent.
//! - What the frame no longer wants is cancelled, also under the heads: a drum has no arm to move.
//! - Room is made when a record is ordered: the record goes that no frame has demanded for longest, and of several
//!   the least urgent in its last demand. What a frame demands beyond the buffer's capacity is not ordered.
//! - A record at the edge of the level is as long as any other.
//! - Kinds on the same drums take turns by rank: the most urgent record of each, then the second of each. Each kind lies on tracks of its own,
//!   from the origin on.
//! - What is being edited goes on over the end of a frame, and is not read again.
//!
//! **Not modelled.** Errors of reading, gaps between records, the time to switch heads, writing (a changed record is
//! there with the next fetch). The drum's speed does not wander during a mission.

mod bank;
mod buffer;
mod channel;
mod corners;
mod drum;
mod editor;
mod key;
mod layout;
mod span;
mod state;
mod store;
mod supply;
mod wanted;

pub use bank::DataBank;
pub use corners::{corners_of, nearest_first};
pub use drum::DrumUnit;
pub use layout::Contents;
pub use state::{BankState, DrumState, Heads, HeldRecord, OrderedRecord, StoreState};
pub use store::StoreDesign;
pub use supply::{Demand, DrumSpell, EditSpell, FrameSupply, Missing, Piece};
