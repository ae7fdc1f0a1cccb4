//! `lunoid serve`: a closed loop for any program, by messages of `lunoid.loop/1`.

use std::io::{self, BufWriter};
use std::net::{IpAddr, Ipv4Addr};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use drive::DriveError;
use loop_protocol::{Home, Session, WireError};
use loop_server::{ServerError, TcpServer, Token, serve};

use crate::served::ServedArgs;
use command_line::output::tell;
use command_line::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid serve scenarios/first-light.toml
  lunoid serve scenarios/nominal-drive.toml --machine pra-nominal --socket runs/loop.sock \\
    --record runs/driven
  lunoid serve scenarios/first-light.toml --tcp 7070

A client writes a request, reads its reply, and only then sends the next one
(docs/loop-protocol.md). On standard input and output there is one client, and the command ends
with it. On a socket one client is served after another: each finds the scenario as it is opened
here, and nothing that another has driven. Bytes that are no message end a client with one
error. On TCP the first request is a `hello` with the token that the command says, or with that
of LUNOID_TOKEN. Ctrl-C ends the command.";

/// Answer requests of another program: pictures of poses, signals, explanations, one step after another.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct ServeCommand {
    #[command(flatten)]
    served: ServedArgs,
    /// Listen on this Unix socket instead of standard input and output.
    #[arg(long, value_name = "PATH", conflicts_with = "tcp")]
    socket: Option<PathBuf>,
    /// Listen on this TCP port of 127.0.0.1 instead; 0 is any that is free.
    #[arg(long, value_name = "PORT")]
    tcp: Option<u16>,
    /// Listen on this address of the computer instead of 127.0.0.1: whoever reaches it and has the token is served, and nothing is encrypted.
    #[arg(long, value_name = "ADDRESS", requires = "tcp")]
    listen: Option<IpAddr>,
    /// Token of clients on TCP; a random one, which is said, if left out.
    #[arg(long, value_name = "WORD", requires = "tcp", env = "LUNOID_TOKEN", hide_env_values = true)]
    token: Option<String>,
}

impl ServeCommand {
    /// Serves until the client, or the command, is ended.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let (home, _) = self.served.home()?;
        let server = self.tcp.map(|port| self.tcp_server(port)).transpose().map_err(failed)?;
        let drive = Arc::new(home.drive().map_err(DriveError::into_problems)?);
        let session = || Session::with(home.clone(), Arc::clone(&drive));
        match (&self.socket, server) {
            (Some(path), _) => on_socket(path, session)?,
            (None, Some(server)) => server.serve(session, hear),
            (None, None) => {
                let (from, to) = (io::stdin().lock(), io::stdout().lock());
                serve(&mut session(), &mut { from }, &mut BufWriter::new(to)).map_err(ended)?;
            }
        }
        Ok(Verdict::Yes)
    }

    /// The server on a TCP port; says where it listens, and its token if nobody has chosen it.
    fn tcp_server(&self, port: u16) -> Result<TcpServer, ServerError> {
        let token = self.token.as_deref().map_or_else(Token::random, Token::chosen)?;
        let server = TcpServer::bind(self.listen.unwrap_or(Ipv4Addr::LOCALHOST.into()), port, token)?;
        let said = match self.token {
            None => format!(" with the token {}", server.token().word()),
            Some(_) => String::new(),
        };
        hear(&format!("listening on {}{said}", server.address()));
        Ok(server)
    }
}

fn hear(said: &str) {
    tell(&format!("{}\n", text::visible(said)));
}

fn failed(error: ServerError) -> Failure {
    match error {
        ServerError::BadToken(_) => Failure::usage(format!("--token, or LUNOID_TOKEN: {error}")),
        _ => Failure::output(error),
    }
}

fn ended(error: WireError) -> Failure {
    match error {
        WireError::Io(error) => Failure::stdout(error),
        WireError::Problems(list) | WireError::Faulty { problems: list, .. } => Failure::Problems(list),
    }
}

#[cfg(unix)]
fn on_socket<H: Home>(path: &Path, session: impl Fn() -> Session<H>) -> Result<(), Failure> {
    loop_server::on_unix_socket(path, session, hear)
        .map_err(|error| Failure::output(format!("--socket {error}")))
}

/// Refuses a socket where the system has none.
#[cfg(not(unix))]
fn on_socket<H: Home>(path: &Path, _session: impl Fn() -> Session<H>) -> Result<(), Failure> {
    let path = path.display();
    Err(Failure::usage(format!(
        "--socket {path}: this system has no Unix sockets; use --tcp, or standard input and output"
    )))
}
