//! `lunoid completions`: what a shell completes a command line with.

use clap::Args;
use clap_complete::{Shell, generate};

use command_line::output::print;
use command_line::{Failure, Verdict};

const AFTER: &str = "Example:
  lunoid completions bash > ~/.local/share/bash-completion/completions/lunoid

zsh: a file _lunoid in a folder of $fpath. fish: ~/.config/fish/completions/lunoid.fish. elvish,
powershell: a file that the profile of the shell reads.";

/// Print the completions of the command line for a shell.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Completions {
    /// The shell that reads them.
    shell: Shell,
}

impl Completions {
    /// Prints the completions of the command line `whole`.
    pub fn run(&self, mut whole: clap::Command) -> Result<Verdict, Failure> {
        let mut text = Vec::new();
        generate(self.shell, &mut whole, "lunoid", &mut text);
        print(&String::from_utf8_lossy(&text))?;
        Ok(Verdict::Yes)
    }
}
