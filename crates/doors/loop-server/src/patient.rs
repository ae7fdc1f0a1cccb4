//! A stream that is read for so long and no longer.

use std::io::{self, ErrorKind, Read};
use std::net::TcpStream;
use std::time::{Duration, Instant};

/// A client whose bytes must come in time, however they are cut into pieces.
#[derive(Debug)]
pub struct Patient<'a> {
    stream: &'a TcpStream,
    patience: Duration,
    /// When the time is over; never if left out.
    end: Option<Instant>,
}

impl<'a> Patient<'a> {
    /// `stream`, which has `patience` from now on.
    pub fn new(stream: &'a TcpStream, patience: Duration) -> Self {
        Self { stream, patience, end: Some(Instant::now() + patience) }
    }

    /// Waits without an end from here on.
    pub fn has_time(&mut self) {
        self.end = None;
    }

    fn too_late(&self) -> io::Error {
        io::Error::new(ErrorKind::TimedOut, format!("the request did not come within {:?}", self.patience))
    }
}

impl Read for Patient<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let left = self.end.map(|end| end.saturating_duration_since(Instant::now()));
        if left.is_some_and(|left| left.is_zero()) {
            return Err(self.too_late());
        }
        self.stream.set_read_timeout(left)?;
        self.stream.read(buffer).map_err(|error| match error.kind() {
            // Each system has its own word for it.
            ErrorKind::WouldBlock | ErrorKind::TimedOut => self.too_late(),
            _ => error,
        })
    }
}

#[cfg(test)]
mod tests {
    use std::io::Write;
    use std::net::TcpListener;
    use std::thread;

    use super::*;

    #[test]
    fn bytes_that_come_one_by_one_do_not_lengthen_the_time() {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let mut client = TcpStream::connect(listener.local_addr().unwrap()).unwrap();
        let (stream, _) = listener.accept().unwrap();
        thread::spawn(move || {
            while client.write_all(b"x").is_ok() {
                thread::sleep(Duration::from_millis(5));
            }
        });
        let mut patient = Patient::new(&stream, Duration::from_millis(60));
        let error = patient.by_ref().take(200).read_to_end(&mut Vec::new()).unwrap_err();
        assert_eq!(error.to_string(), "the request did not come within 60ms");
        patient.has_time();
        assert_eq!(patient.read(&mut [0]).unwrap(), 1, "without an end what comes is read");
    }
}
