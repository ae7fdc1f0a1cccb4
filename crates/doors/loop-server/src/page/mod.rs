//! A page on loopback: files, and a session a WebSocket.
//!
//! ```text
//! connection ─▶ head ─▶ admission ─▶ reply: files of the page
//!                                └──▶ socket ─▶ Session
//! ```

mod admission;
mod files;
mod head;
mod reply;
mod socket;

use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use loop_protocol::{Home, Session};

use self::admission::{Admission, Verdict};
use self::reply::Reply;
use crate::patient::Patient;
use crate::{PATIENCE, ServerError, Token};

pub use self::files::{PageFiles, Shelf};

/// Where the page opens its socket.
const SOCKET: &str = "/loop";

/// Most connections at a time; a browser has six, and each open page one more (chosen).
const CONNECTIONS: usize = 64;

/// Most sessions at a time: open pages (chosen).
const SESSIONS: usize = 8;

/// A server of one page on 127.0.0.1, for the one browser that brings the token.
#[derive(Debug)]
pub struct PageServer<S> {
    listener: TcpListener,
    port: u16,
    admission: Admission,
    files: S,
    connections: AtomicUsize,
    sessions: AtomicUsize,
    patience: Duration,
}

impl<S: Shelf + Sync> PageServer<S> {
    /// A server of `files` at a port; 0 means any that is free. `first` is the page that is opened first, with a slash in front.
    ///
    /// # Errors
    /// If nothing can listen there, or the system has no random bytes for a token.
    pub fn bind(port: u16, first: &'static str, files: S) -> Result<Self, ServerError> {
        let failed = |source| ServerError::Listen {
            place: format!("{}:{port}", Ipv4Addr::LOCALHOST),
            source,
            help: "name another port, or 0 for any that is free",
        };
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(failed)?;
        let port = listener.local_addr().map_err(failed)?.port();
        let admission = Admission::new(port, first, Token::random()?, Token::random()?);
        let (connections, sessions) = (AtomicUsize::new(0), AtomicUsize::new(0));
        Ok(Self { listener, port, admission, files, connections, sessions, patience: PATIENCE })
    }

    /// The same with another longest wait for a first request and for a browser that takes nothing, [`PATIENCE`] unless it is said.
    pub fn with_patience(self, patience: Duration) -> Self {
        Self { patience, ..self }
    }

    /// The address that opens the page, once.
    pub fn address(&self) -> String {
        format!("http://{}:{}/?token={}", Ipv4Addr::LOCALHOST, self.port, self.admission.token().word())
    }

    /// Serves connections side by side, each page with a session of its own. `hear` is told of each that failed.
    pub fn serve<H: Home>(&self, session: impl Fn() -> Session<H> + Sync, hear: impl Fn(&str) + Sync) {
        let (session, hear) = (&session, &hear);
        thread::scope(|scope| {
            for stream in self.listener.incoming() {
                let Ok(stream) = stream else { continue };
                let Some(place) = Place::take(&self.connections, CONNECTIONS) else { continue };
                scope.spawn(move || {
                    let _place = place;
                    if let Err(error) = self.answer(stream, session) {
                        hear(&format!("warning: a connection of the page ended: {error}"));
                    }
                });
            }
        });
    }

    /// Answers the one request of a connection; a socket has as many messages as its page sends.
    fn answer<H: Home>(&self, mut stream: TcpStream, session: impl Fn() -> Session<H>) -> Result<(), String> {
        let said = |error: std::io::Error| error.to_string();
        stream.set_nodelay(true).map_err(said)?;
        // A client that takes nothing is let go.
        stream.set_write_timeout(Some(self.patience)).map_err(said)?;
        let request = match head::read(&mut Patient::new(&stream, self.patience)) {
            Ok(Some(request)) => request,
            // The browser has opened a connection ahead of need.
            Ok(None) => return Ok(()),
            Err(reply) => return reply.write(&mut stream).map_err(said),
        };
        let reply = match self.admission.of(&request.head) {
            Verdict::Socket => match Place::take(&self.sessions, SESSIONS) {
                Some(_place) => return socket::serve(stream, request, session()),
                None => full(),
            },
            Verdict::IsThereRoom if self.sessions.load(Ordering::Relaxed) >= SESSIONS => full(),
            Verdict::IsThereRoom => Reply::refusal(426, "there is room for a page; open a WebSocket here"),
            Verdict::File => files::reply(&self.files, request.head.uri().path()),
            Verdict::Reply(reply) => reply,
        };
        reply.write(&mut stream).map_err(said)
    }
}

/// The reply to a page more than there may be.
fn full() -> Reply {
    let why = format!("{SESSIONS} pages are open, as many as can be; close one and load this page again");
    Reply::refusal(503, &why)
}

/// One of so many places, until it is dropped.
struct Place<'a>(&'a AtomicUsize);

impl<'a> Place<'a> {
    fn take(taken: &'a AtomicUsize, most: usize) -> Option<Self> {
        let more = |count| (count < most).then_some(count + 1);
        taken.fetch_update(Ordering::Relaxed, Ordering::Relaxed, more).ok().map(|_| Self(taken))
    }
}

impl Drop for Place<'_> {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::Relaxed);
    }
}
