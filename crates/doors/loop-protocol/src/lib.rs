//! The protocol `lunoid.loop/1`: an opened drive that answers messages.
//!
//! ```text
//! bytes ─▶ Message ─▶ Session ─▶ Message ─▶ bytes
//!           header      │ home      header: id, ok or error
//!           planes      ▼           planes: pictures, truth, waveforms, files
//!                     drive: Drive, Loop
//! ```
//!
//! # Law
//! - A [`Message`] is a prefix of 24 bytes, a header in JSON, and planes of raw little-endian numbers. Readers refuse what is longer than the
//!   limits `header-bytes` and `plane-bytes`. Memory grows with the bytes that come, not with the lengths that are claimed.
//! - A [`Session`] answers one request after the other. It has no clock and no thread, and does no input or output but what `drive` does. The same
//!   requests have the same answers, to the byte.
//! - A request that cannot be done changes nothing. Its answer has all faults at once. Two remain: files that came with an `open` stay with the
//!   host, and a `step` is driven although a plane of truth that it asks for fails.
//! - The host of a session is its [`Home`]: it decides which scenarios are opened and where records are kept.
//!
//! # See also
//! `docs/loop-protocol.md`: every request with an example. `browser`: the module that hosts a session in a page. `drive`: what is answered.

mod asked_pose;
mod digital;
mod keeping;
mod keys;
mod listing;
mod log;
mod message;
mod opened;
mod opening;
mod pictures;
mod plane;
mod poses;
mod requests;
mod searching;
mod session;
mod signals;
mod state;
mod wire;

pub use message::{MAGIC, Message, PREFIX};
pub use opening::{Home, Opening};
pub use plane::{Dtype, Element, Plane};
pub use requests::{REQUESTS, RequestRow};
pub use session::{Session, refusal, unreadable};
pub use wire::WireError;
