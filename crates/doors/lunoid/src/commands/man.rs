//! `lunoid man`: the manual, a page a command.

use std::io;
use std::path::{Path, PathBuf};

use clap::Args;
use clap_mangen::Man;

use command_line::output::print;
use command_line::{Failure, Verdict};

const AFTER: &str = "Example:
  lunoid man --out runs/man
  man runs/man/lunoid-replay.1

The pages say what --help says. They are lunoid.1 and, for each command, one such as
lunoid-replay.1.";

/// How the head of every page begins.
const HEAD: &[u8] = b".TH lunoid";
/// Largest page that is read back (bytes).
const MOST_BYTES: u64 = 1 << 20;

/// Write the manual: a page for each command, or print its first page.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct ManCommand {
    /// Folder to write the pages into; without it the first page is printed.
    #[arg(short, long, value_name = "FOLDER")]
    out: Option<PathBuf>,
}

impl ManCommand {
    /// Writes all pages of the command line `whole`, or prints the first.
    pub fn run(&self, whole: &clap::Command) -> Result<Verdict, Failure> {
        let Some(folder) = &self.out else {
            print(&String::from_utf8_lossy(&page(whole, "lunoid")?))?;
            return Ok(Verdict::Yes);
        };
        files::make_folder(folder)?;
        expect_no_page_of_others(folder, whole, "lunoid")?;
        let mut written = 0;
        write_pages(folder, whole, "lunoid", &mut written)?;
        print(&format!("{}: {written} pages\n", folder.display()))?;
        Ok(Verdict::Yes)
    }
}

/// Nobody else has a file where a page is to be written.
fn expect_no_page_of_others(folder: &Path, of: &clap::Command, name: &str) -> Result<(), Failure> {
    let path = folder.join(format!("{name}.1"));
    let is_page = |path: &Path| {
        files::read_all(path, MOST_BYTES).is_ok_and(|text| text.windows(HEAD.len()).any(|at| at == HEAD))
    };
    if path.exists() && !is_page(&path) {
        let path = path.display();
        return Err(Failure::output(format!(
            "{path}: this file is no page of the manual; choose another --out"
        )));
    }
    let mut below = pages_below(of, name);
    below.try_for_each(|(below, name)| expect_no_page_of_others(folder, below, &name))
}

/// Commands below a command that have a page, each with its name.
fn pages_below<'c>(
    of: &'c clap::Command,
    name: &'c str,
) -> impl Iterator<Item = (&'c clap::Command, String)> {
    let below = of.get_subcommands().filter(|below| !below.is_hide_set() && below.get_name() != "help");
    below.map(move |below| (below, format!("{name}-{}", below.get_name())))
}

/// Writes the page of a command, and those of the commands below it.
fn write_pages(folder: &Path, of: &clap::Command, name: &str, written: &mut u32) -> Result<(), Failure> {
    let text = page(of, name)?;
    files::write_atomic(folder.join(format!("{name}.1")), |out| out.write_all(&text))?;
    *written += 1;
    let mut below = pages_below(of, name);
    below.try_for_each(|(below, name)| write_pages(folder, below, &name, written))
}

/// The page of a command, called `name` in its head.
fn page(of: &clap::Command, name: &str) -> Result<Vec<u8>, Failure> {
    // Names of commands live as long as the program: there are a few dozen of them.
    let shown = of.clone().name(&*name.to_owned().leak()).disable_help_subcommand(true);
    let mut text = Vec::new();
    let rendered: io::Result<()> = Man::new(shown).render(&mut text);
    rendered.map_err(|error| Failure::output(format!("{name}.1: {error}")))?;
    Ok(as_written(&String::from_utf8_lossy(&text)).into_bytes())
}

/// A page whose examples, and what is said below them, stand line by line as they are written.
fn as_written(page: &str) -> String {
    const EXTRA: &str = ".SH EXTRA\n";
    let Some((head, rest)) = page.split_once(EXTRA) else { return page.to_owned() };
    let (examples, tail) = rest.split_at(rest.find("\n.SH ").map_or(rest.len(), |at| at + 1));
    format!("{head}.SH EXAMPLES\n.nf\n{examples}.fi\n{tail}")
}
