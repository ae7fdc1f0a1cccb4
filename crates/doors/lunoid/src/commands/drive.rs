//! `lunoid drive`: the instrument in a browser, and the machine in this program.

use clap::Args;
use loop_protocol::Session;
use loop_server::{PageFiles, PageServer};

use crate::browser::open_in_browser;
use crate::served::ServedArgs;
use command_line::output::{print, tell};
use command_line::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid drive scenarios/first-light.toml
  lunoid drive scenarios/nominal-drive.toml --machine pra-nominal --record runs/driven --no-open

The page has a tube, a scope, a fault board, time and the controls of the vehicle
(docs/browser.md). This program draws, with all its threads. Only this computer reaches it: the
address has a token, which the first browser spends. Ctrl-C ends the command.";

/// Files of a site that need its module and its scenarios.
const OF_A_SITE: [&str; 2] = ["index.html", "first.js"];

/// Drive the machine in a browser: the instrument as a page, served to this computer alone.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct DriveCommand {
    #[command(flatten)]
    served: ServedArgs,
    /// Port on 127.0.0.1; 0 is any that is free.
    #[arg(long, value_name = "PORT", default_value_t = 0)]
    port: u16,
    /// Say the address, and do not open it.
    #[arg(long)]
    no_open: bool,
}

impl DriveCommand {
    /// Serves the page until the command is ended.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let (home, opened) = self.served.home()?;
        let scenario = home.scenario();
        let list = site::list(&[site::row(&scenario, &scenario, &opened, &[])]);
        let mut files = page();
        files.put(site::LIST, list.to_string().into_bytes());
        let server = PageServer::bind(self.port, "/instrument.html", files).map_err(Failure::output)?;
        let address = server.address();
        print(&format!("{address}\n"))?;
        if !self.no_open {
            open_in_browser(&address);
        }
        server.serve(|| Session::new(home.clone()), |said| tell(&format!("{}\n", text::visible(said))));
        Ok(Verdict::Yes)
    }
}

/// The files of the page, for a machine in this program.
fn page() -> PageFiles {
    let mut files = PageFiles::default();
    let own = site::page().filter(|(name, _)| !OF_A_SITE.contains(name));
    own.chain(site::OF_A_PROGRAM).for_each(|(name, bytes)| files.put(name, bytes));
    files
}
