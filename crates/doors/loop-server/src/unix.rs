//! Clients on a Unix socket, one after another.

use std::fs;
use std::io::{self, BufReader, BufWriter};
use std::os::unix::fs::FileTypeExt;
use std::os::unix::net::{UnixListener, UnixStream};
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
    let listener = listener(path).map_err(|source| {
        let place = path.display().to_string();
        ServerError::Listen { place, source, help: "name another path" }
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

/// Listens at `path`. The file of a server that has ended, at which nobody listens any more, is replaced.
fn listener(path: &Path) -> io::Result<UnixListener> {
    let first = UnixListener::bind(path);
    let is_taken = first.as_ref().is_err_and(|error| error.kind() == io::ErrorKind::AddrInUse);
    let is_socket = fs::symlink_metadata(path).is_ok_and(|file| file.file_type().is_socket());
    let is_left =
        || UnixStream::connect(path).is_err_and(|error| error.kind() == io::ErrorKind::ConnectionRefused);
    if is_taken && is_socket && is_left() {
        fs::remove_file(path)?;
        return UnixListener::bind(path);
    }
    first
}
