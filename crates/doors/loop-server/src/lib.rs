//! Servers of the protocol `lunoid.loop/1`: they carry messages between a client and a [`Session`](loop_protocol::Session).
//!
//! ```text
//! standard input and output ─▶ serve ──────────┐
//! Unix socket ─▶ on_unix_socket ───────────────┼─▶ Session
//! TCP ─▶ TcpServer ─▶ token ─▶ serve ──────────┤
//! browser ─▶ PageServer ─▶ cookie, files, WebSocket ─┘
//! ```
//!
//! # Law
//! - Each reply goes out before the next request of that client is read.
//! - A client whose bytes are no message gets one error and is let go; the next one is served. After a message with faults in it, or on a WebSocket
//!   where each message has its own end, the client goes on after the error.
//! - A Unix socket is guarded by the rights of its file. TCP asks each client for a [`Token`] in its first request. A page is served to
//!   whoever brings the token once, and then to that browser alone.
//! - Nothing is taken up for a client that has not been admitted but a bounded first request, within [`PATIENCE`]. A browser that takes nothing of its
//!   reply for as long is let go.
//!
//! # See also
//! `docs/loop-protocol.md`: the messages and how a client is admitted. `loop-protocol`: who answers.

mod error;
mod page;
mod patient;
mod stream;
mod tcp;
mod token;
#[cfg(unix)]
mod unix;

use std::time::Duration;

pub use error::ServerError;
pub use page::{PageFiles, PageServer, Shelf};
pub use stream::serve;
pub use tcp::TcpServer;
pub use token::{SHORTEST_TOKEN, Token};
pub use tungstenite::Bytes;
#[cfg(unix)]
pub use unix::on_unix_socket;

/// Longest wait for the first request of a client that has not been admitted, and for a browser that takes nothing (chosen).
pub const PATIENCE: Duration = Duration::from_secs(10);
