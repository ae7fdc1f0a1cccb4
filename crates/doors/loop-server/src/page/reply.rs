//! Replies of HTTP, one a connection.

use std::io::{self, Write};

use tungstenite::Bytes;
use tungstenite::http::StatusCode;

/// A reply with its body.
#[derive(Debug)]
pub struct Reply {
    status: u16,
    kind: &'static str,
    /// More lines of the head: name and value.
    lines: Vec<(&'static str, String)>,
    body: Bytes,
}

impl Reply {
    /// A file of a media type.
    pub fn file(kind: &'static str, body: Bytes) -> Self {
        Self { status: 200, kind, lines: Vec::new(), body }
    }

    /// A refusal, in words for people.
    pub fn refusal(status: u16, why: &str) -> Self {
        let body = format!("lunoid: {why}\n").into_bytes();
        Self { status, kind: "text/plain; charset=utf-8", lines: Vec::new(), body: body.into() }
    }

    /// Sends the browser to `place`, and gives it `cookie`.
    pub fn onward(place: &str, cookie: String) -> Self {
        let body = format!("{place}\n").into_bytes().into();
        let lines = vec![("Set-Cookie", cookie), ("Location", place.to_owned())];
        Self { status: 303, kind: "text/plain; charset=utf-8", lines, body }
    }

    /// Its number of HTTP.
    #[cfg(test)]
    pub fn status(&self) -> u16 {
        self.status
    }

    /// Writes it. Nothing of it is kept by a browser, and no other page may take it.
    ///
    /// # Errors
    /// If the other side does not take it.
    pub fn write(&self, to: &mut impl Write) -> io::Result<()> {
        let code = StatusCode::from_u16(self.status).map_err(io::Error::other)?;
        let lines: String = self.lines.iter().map(|(name, value)| format!("{name}: {value}\r\n")).collect();
        let head = format!(
            "HTTP/1.1 {code}\r\nContent-Type: {}\r\nContent-Length: {}\r\n{lines}Cache-Control: no-store\r\n\
             X-Content-Type-Options: nosniff\r\nCross-Origin-Resource-Policy: same-origin\r\n\
             Referrer-Policy: no-referrer\r\nConnection: close\r\n\r\n",
            self.kind,
            self.body.len(),
        );
        to.write_all(head.as_bytes())?;
        to.write_all(&self.body)?;
        to.flush()
    }
}
