//! `lunoid serve`: a closed loop for any program, by messages of `lunoid.loop/1`.

mod clients;
mod home;

use std::io;
use std::path::PathBuf;
use std::sync::Arc;

use clap::Args;
use drive::Drive;
use loop_protocol::Session;

use self::home::Served;
use crate::loading::{StageArgs, Threads};
use crate::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid serve scenarios/first-light.toml
  lunoid serve scenarios/nominal-drive.toml --machine pra-nominal --socket runs/loop.sock --record runs/driven

A client writes a request, reads its reply, and only then sends the next one (docs/loop-protocol.md). On standard input and output there
is one client, and the command ends with it. On a socket one client is served after another: each finds the scenario as it is opened here,
and nothing that another has driven. Bytes that are no request end a client with one error. Ctrl-C ends the command.";

/// Answer requests of another program: pictures of poses, signals, explanations, one step after another.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct ServeCommand {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// Listen on this Unix socket instead of standard input and output.
    #[arg(long, value_name = "PATH")]
    socket: Option<PathBuf>,
    /// Folder into which the request `record` writes what was driven; the client gets the files if left out.
    #[arg(long, value_name = "FOLDER")]
    record: Option<PathBuf>,
}

impl ServeCommand {
    /// Serves until the client, or the command, is ended.
    pub fn run(&self) -> Result<Verdict, Failure> {
        // What is wrong is told before any ground is made.
        self.stage.load()?;
        let home = Served {
            scenario: self.stage.scenario.clone(),
            wishes: self.stage.wishes(),
            threads: self.threads.count()?,
            record: self.record.clone(),
        };
        let drive = Drive::open(&home.scenario, &home.wishes, home.threads).map_err(Failure::input)?;
        let drive = Arc::new(drive);
        let session = || Session::with(home.clone(), Arc::clone(&drive));
        match &self.socket {
            Some(path) => clients::on_socket(path, session)?,
            None => clients::one(session(), &mut io::stdin().lock(), &mut io::stdout().lock())?,
        }
        Ok(Verdict::Yes)
    }
}
