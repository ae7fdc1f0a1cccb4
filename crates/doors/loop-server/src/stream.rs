//! One client on a pair of streams.

use std::io::{Read, Write};

use loop_protocol::{Home, Message, Session, WireError, unreadable};

/// Answers each message of `from` before the next one is read, until there is none.
///
/// # Errors
/// If a stream fails, or the bytes are no message: then the client has had one error, if it is still there. After a message with faults in it the
/// client has an error too, and goes on.
pub fn serve<H: Home>(
    session: &mut Session<H>,
    from: &mut impl Read,
    to: &mut impl Write,
) -> Result<(), WireError> {
    loop {
        match Message::read(from) {
            Ok(None) => return Ok(()),
            Ok(Some(request)) => session.answer(&request).write(to).map_err(WireError::Io)?,
            Err(error @ WireError::Faulty { .. }) => unreadable(&error).write(to).map_err(WireError::Io)?,
            Err(error) => {
                // The client may be gone.
                let _ = unreadable(&error).write(to);
                return Err(error);
            }
        }
    }
}
