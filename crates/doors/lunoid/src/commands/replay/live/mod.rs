//! `lunoid replay --live`: the run in a browser of this computer, while it is drawn and afterwards.
//!
//! ```text
//! carriers of the run ─▶ progress ─▶ LiveRun ◀─ PageServer ◀─ browser
//!                                      │ live.json, newest picture
//!                        folder ───────┘ the page of the run, when it is finished
//!                        Drive ◀──── LiveHome: sweeps that were not recorded
//! ```
//!
//! # Law
//! - The run does not wait for a page: it leaves two numbers behind for each frame, and never looks at who reads them. Its folder has the same bytes.
//! - Until the run is finished a page gets files alone. A sweep is computed afterwards, by a drive of its own.

mod home;
mod run;

use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::thread;
use std::time::Duration;

use clap::Args;
use front_door::Opened;
use loop_protocol::Session;
use loop_server::{PageFiles, PageServer};
use replay::{Job, RunFolder};
use report::{LIVE_FILES, LIVE_FIRST, waiting_page};
use text::visible;

use self::home::LiveHome;
pub use self::run::LiveRun;
use super::{DepthWord, Replay};
use crate::browser::open_in_browser;
use crate::served::Served;
use command_line::Failure;
use command_line::interrupt;
use command_line::loading::StageArgs;
use command_line::output::tell;

/// Where the page begins.
const FIRST: &str = "/live.html";

/// Scripts of the instrument that the page of a run needs to reach the program.
const SCRIPTS: [&str; 7] =
    ["home.js", "journal.js", "lunoid.js", "message.js", "module.js", "socket-home.js", "worker-home.js"];

/// Time between two looks for Ctrl-C.
const EVERY: Duration = Duration::from_millis(50);

/// The run in a browser.
#[derive(Debug, Args)]
pub struct LiveArgs {
    /// Show the run in a browser of this computer: the newest picture while it is drawn, then the page of the run. A click computes a sweep that was not
    /// recorded, and shows it if the frame has the hash of the run. The command then stays until Ctrl-C.
    #[arg(long, conflicts_with = "no_page")]
    live: bool,
    /// Port of --live on 127.0.0.1; any that is free if left out.
    #[arg(long, value_name = "PORT", requires = "live")]
    port: Option<u16>,
    /// Say the address of --live, and do not open it.
    #[arg(long, requires = "live")]
    no_open: bool,
}

impl LiveArgs {
    /// Whether the run is shown.
    pub fn is_asked(&self) -> bool {
        self.live
    }
}

impl Replay {
    /// Begins to serve the run of `job` in `folder`, if that is asked for.
    pub(super) fn begin_live(
        &self,
        stage: &StageArgs,
        opened: &Opened,
        job: &Job,
        folder: &RunFolder,
    ) -> Result<Option<Arc<LiveRun>>, Failure> {
        if !self.live.live {
            return Ok(None);
        }
        let run = Arc::new(LiveRun::new(folder.path(), job, fixed(opened, job)));
        let server = PageServer::bind(self.live.port.unwrap_or(0), FIRST, Arc::clone(&run));
        let server = server.map_err(Failure::output)?;
        let address = server.address();
        tell(&format!("live: {address}\n"));
        if !self.live.no_open {
            open_in_browser(&address);
        }
        let home = LiveHome::new(Served::of(stage, opened, self.threads.count()?), Arc::clone(&run));
        // It ends with the command.
        thread::spawn(move || {
            server.serve(|| Session::new(home.clone()), |said| tell(&format!("{}\n", visible(said))));
        });
        Ok(Some(run))
    }

    /// Pictures of 16 bits have other hashes than the program computes for a page.
    pub(super) fn expect_live_possible(&self) -> Result<(), Failure> {
        match self.live.live && self.depth == DepthWord::Sixteen {
            true => Err(Failure::usage(
                "--live: a page checks frames of 8 bits, and --depth 16 asks for 16; leave one of the two out",
            )),
            false => Ok(()),
        }
    }
}

/// The files of the page that do not change.
fn fixed(opened: &Opened, job: &Job) -> PageFiles {
    let mut files = PageFiles::default();
    let own = site::page().filter(|(name, _)| SCRIPTS.contains(name));
    own.chain(LIVE_FILES).for_each(|(name, bytes)| files.put(name, bytes));
    let field = &job.stage.view.field;
    let aspect = field.tan_half_width / field.tan_half_height;
    let page = waiting_page(&opened.scenario.title, &opened.scenario.shows, aspect);
    files.put(LIVE_FIRST, page.into_bytes());
    files
}

/// Shows the finished run until Ctrl-C.
pub fn stay(run: &LiveRun) -> Result<(), Failure> {
    run.finish()?;
    tell("live: the run is finished; its page stays until Ctrl-C\n");
    let is_told = interrupt::listen();
    while !is_told.load(Ordering::Relaxed) {
        thread::sleep(EVERY);
    }
    Ok(())
}
