//! `site build`: the page with the machine in it, as a folder for any static host.

mod books;
mod building;
mod error;
mod module;
mod scenarios;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// Builds the page with the machine in it.
#[derive(Debug, Parser)]
#[command(name = "site", version)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Builds the folder, with its module, from the repository.
    #[command(after_help = "Example: cargo run -p site -- build --out runs/site")]
    Build {
        /// Folder to write; one of an earlier build is replaced.
        #[arg(long, default_value = "site")]
        out: PathBuf,
        /// Module that is taken as it is, instead of one that is built.
        #[arg(long)]
        module: Option<PathBuf>,
    },
}

fn main() -> ExitCode {
    let Command::Build { out, module } = Cli::parse().command;
    match building::build(&out, module.as_deref()) {
        Ok(told) => {
            println!("{told}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("site: {error}");
            ExitCode::FAILURE
        }
    }
}
