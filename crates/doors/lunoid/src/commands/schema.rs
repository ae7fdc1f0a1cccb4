//! `lunoid schema`: the JSON Schema of a kind of file.

use clap::{Args, ValueEnum};

use command_line::output::print;
use command_line::{Failure, Verdict};

const AFTER: &str = "Example:
  lunoid schema scenario > scenario.schema.json

An editor with a TOML language server checks a file as you write it, and shows what a key means,
if the first line of the file is
  #:schema scenario.schema.json

A schema knows every key, its type, its bounds and its words. Rules that span several keys are
those of `lunoid check`.";

/// Print the JSON Schema of a kind of file, for editors.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Schema {
    /// Kind of file that is described.
    kind: Kind,
}

/// Kinds of files that people write.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum Kind {
    /// What happens and how it is seen.
    Scenario,
    /// What a machine is made of, or how it differs from another.
    Model,
    /// A scene whose answer is known.
    Cartridge,
    /// Features over a base, from which ground is built.
    Landscape,
}

impl Schema {
    /// Prints the schema of the kind.
    pub fn run(&self) -> Result<Verdict, Failure> {
        print(match self.kind {
            Kind::Scenario => file_schema::SCENARIO,
            Kind::Model => file_schema::MODEL,
            Kind::Cartridge => cartridge::SCHEMA,
            Kind::Landscape => file_schema::LANDSCAPE,
        })?;
        Ok(Verdict::Yes)
    }
}
