//! Clients: one on standard input and output, or one after another on a socket.

use std::io::{self, Read, Write};
use std::path::Path;

use loop_protocol::{Home, Message, Session, WireError, unreadable};

use crate::Failure;

/// Serves one client until it has nothing more to say. Rubbish ends it, with one error to it and one of the command.
pub fn one<H: Home>(
    mut session: Session<H>,
    from: &mut impl Read,
    to: &mut impl Write,
) -> Result<(), Failure> {
    match serve(&mut session, from, to) {
        Ok(()) => Ok(()),
        Err(WireError::Io(error)) => Err(Failure::stdout(error)),
        Err(WireError::Problems(list)) => Err(Failure::Problems(list)),
    }
}

/// Answers each message before the next one is read.
fn serve<H: Home>(
    session: &mut Session<H>,
    from: &mut impl Read,
    to: &mut impl Write,
) -> Result<(), WireError> {
    let send = |to: &mut dyn Write, reply: &Message| -> io::Result<()> {
        to.write_all(&reply.encode())?;
        to.flush()
    };
    loop {
        match Message::read(from) {
            Ok(None) => return Ok(()),
            Ok(Some(request)) => send(to, &session.answer(&request)).map_err(WireError::Io)?,
            Err(error) => {
                // The client may be gone.
                let _ = send(to, &unreadable(&error));
                return Err(error);
            }
        }
    }
}

/// Serves one client after another on the Unix socket `path`.
#[cfg(unix)]
pub fn on_socket<H: Home>(path: &Path, session: impl Fn() -> Session<H>) -> Result<(), Failure> {
    use std::os::unix::net::UnixListener;

    let listener = UnixListener::bind(path).map_err(|error| {
        let help = match error.kind() {
            io::ErrorKind::AddrInUse => {
                "; remove it if no other `lunoid serve` uses it, or name another path"
            }
            _ => "",
        };
        Failure::output(format!("--socket {}: cannot listen there: {error}{help}", path.display()))
    })?;
    crate::output::tell(&format!("listening on {}\n", path.display()));
    for client in listener.incoming() {
        let heard = client
            .map_err(WireError::Io)
            .and_then(|client| serve(&mut session(), &mut io::BufReader::new(&client), &mut &client));
        if let Err(error) = heard {
            crate::output::warn(&format!("a client was let go: {error}"));
        }
    }
    Ok(())
}

/// Refuses a socket where the system has none.
#[cfg(not(unix))]
pub fn on_socket<H: Home>(path: &Path, _session: impl Fn() -> Session<H>) -> Result<(), Failure> {
    let path = path.display();
    Err(Failure::usage(format!(
        "--socket {path}: this system has no Unix sockets; use standard input and output"
    )))
}
