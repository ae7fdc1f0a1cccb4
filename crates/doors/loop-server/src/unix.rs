//! Clients on a Unix socket, one after another.

use std::io::{self, BufReader, BufWriter};
use std::os::unix::net::UnixListener;
use std::path::Path;

use loop_protocol::{Home, Session, WireError};

use crate::{ServerError, serve};

/// Serves one client after another on the Unix socket `path`, each with a session of its own. `hear` is told when it listens, and of each client
/// that was let go.
///
/// # Errors
/// If nothing can listen at `path`.
pub fn on_unix_socket<H: Home>(
    path: &Path,
    session: impl Fn() -> Session<H>,
    hear: impl Fn(&str),
) -> Result<(), ServerError> {
    let listener = UnixListener::bind(path).map_err(|source| {
        let help = match source.kind() {
            io::ErrorKind::AddrInUse => "remove it if no other server uses it, or name another path",
            _ => "name another path",
        };
        ServerError::Listen { place: path.display().to_string(), source, help }
    })?;
    hear(&format!("listening on {}", path.display()));
    for client in listener.incoming() {
        let heard = client.map_err(WireError::Io).and_then(|client| {
            serve(&mut session(), &mut BufReader::new(&client), &mut BufWriter::new(&client))
        });
        if let Err(error) = heard {
            hear(&format!("warning: a client was let go: {error}"));
        }
    }
    Ok(())
}
