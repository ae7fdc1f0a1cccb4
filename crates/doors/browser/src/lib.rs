//! The machine as a WebAssembly module: bytes of a request in, bytes of a reply out.
//!
//! ```text
//! page ─▶ worker ─▶ reserve, answer ─▶ Host ─▶ Session ─▶ drive
//!                ◀─ reply, reply_length  │
//!                                        └─ Page: given files, no disk
//! ```
//!
//! # Law
//! - The module imports nothing: it has no clock, no random numbers, no network and no disk. The same requests have the same replies, to the
//!   byte, and the pictures have the bits of the native program.
//! - Scenarios and the files that they name come as planes of a request `open`. They are held in memory below `given:`.
//! - A fault of a file or a request is an answer. A panic ends the module: its message stays readable, and nothing else does.
//!
//! # See also
//! `docs/browser.md`: the page and its script `lunoid.js`. `loop-protocol`: the requests. `files::give`: files in memory.

mod exports;
mod host;
mod page;

pub use host::Host;
pub use page::Page;
