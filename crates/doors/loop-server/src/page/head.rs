//! The head of a request, bounded before it is taken up.

use std::io::Read;

use tungstenite::http::{Method, Request, Uri, Version};

use super::reply::Reply;

/// Most bytes of a head (chosen).
const MOST: usize = 16 << 10;

/// Most lines of a head (chosen).
const LINES: usize = 64;

/// A request for a file or a socket.
pub struct Asked {
    /// Method, address and lines.
    pub head: Request<()>,
    /// Bytes that have come behind the head.
    pub rest: Vec<u8>,
}

/// Reads a head; `None` where the other side says nothing.
///
/// # Errors
/// The reply to whoever sends something else.
pub fn read(from: &mut impl Read) -> Result<Option<Asked>, Reply> {
    let mut bytes = Vec::new();
    let mut piece = [0; 2048];
    loop {
        let count =
            from.read(&mut piece).map_err(|_| Reply::refusal(408, "the request did not come in time"))?;
        if count == 0 && bytes.is_empty() {
            return Ok(None);
        }
        bytes.extend_from_slice(&piece[..count]);
        if let Some((head, length)) = parsed(&bytes)? {
            return Ok(Some(Asked { head, rest: bytes.split_off(length) }));
        }
        if count == 0 {
            return Err(Reply::refusal(400, "the request ends within its head"));
        }
        if bytes.len() > MOST {
            return Err(Reply::refusal(431, "the head of the request is too long"));
        }
    }
}

/// The head that `bytes` begin with, and its length; `None` as long as more must come.
fn parsed(bytes: &[u8]) -> Result<Option<(Request<()>, usize)>, Reply> {
    let bad = || Reply::refusal(400, "the bytes are no request of HTTP");
    let mut lines = [httparse::EMPTY_HEADER; LINES];
    let mut request = httparse::Request::new(&mut lines);
    let length = match request.parse(bytes).map_err(|_| bad())? {
        httparse::Status::Partial => return Ok(None),
        httparse::Status::Complete(length) => length,
    };
    let method: Method = request.method.unwrap_or("").parse().map_err(|_| bad())?;
    let uri: Uri = request.path.unwrap_or("").parse().map_err(|_| bad())?;
    let version = if request.version == Some(1) { Version::HTTP_11 } else { Version::HTTP_10 };
    let head = Request::builder().method(method).uri(uri).version(version);
    let head = request.headers.iter().fold(head, |head, line| head.header(line.name, line.value));
    Ok(Some((head.body(()).map_err(|_| bad())?, length)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn status(bytes: &[u8]) -> Option<u16> {
        read(&mut &bytes[..]).err().map(|reply| reply.status())
    }

    #[test]
    fn a_head_is_whole_and_bounded() {
        let whole = b"GET /loop?x=1 HTTP/1.1\r\nHost: here\r\nUpgrade: websocket\r\n\r\nrest";
        let asked = read(&mut &whole[..]).ok().flatten().unwrap();
        assert_eq!((asked.head.uri().path(), asked.head.uri().query()), ("/loop", Some("x=1")));
        assert_eq!(
            (&asked.head.headers()["host"], &asked.rest[..]),
            (&"here".parse().unwrap(), &b"rest"[..])
        );
        assert!(read(&mut &b""[..]).ok().flatten().is_none() && status(b"").is_none());
        for length in 1..whole.len() - 4 {
            assert_eq!(status(&whole[..length]), Some(400), "cut after {length}");
        }
        assert_eq!(status(b"lunoid.1\x10\0\0\0\0\0\0\0"), Some(400));
        assert_eq!(status(b"GET / HTTP/1.1\r\nHost : x\r\n\r\n"), Some(400));
        let long = format!("GET / HTTP/1.1\r\nA: {}\r\n\r\n", "x".repeat(3 * MOST));
        assert_eq!(status(long.as_bytes()), Some(431));
        let many = format!("GET / HTTP/1.1\r\n{}\r\n", "A: b\r\n".repeat(LINES + 1));
        assert_eq!(status(many.as_bytes()), Some(400));
    }
}
