//! What is written, and where.

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use waveform::Format;

use crate::Failure;

/// A kind of file, as `--format` says it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum FormatWord {
    /// A table, a row a sample.
    Csv,
    /// Value changes as text, for every viewer.
    Vcd,
    /// Value changes for GTKWave and Surfer.
    Fst,
    /// Arrays of numpy.
    Npz,
    /// A document.
    Json,
    /// Vectors of ngspice, in volts.
    Raw,
    /// A session of sigrok, in volts.
    Sr,
    /// A page of the scope.
    Png,
    /// The same, as vectors.
    Svg,
}

/// What a command writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// A file of waveforms.
    Waveforms(Format),
    /// A page of the scope; the name of the file says which kind.
    Picture,
}

impl Target {
    /// By `--format`, else by the name of the file.
    pub fn of(format: Option<FormatWord>, out: &Path) -> Result<Self, Failure> {
        let ending = out.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let word = match format {
            Some(word) => word,
            None => FormatWord::from_str(ending, false).map_err(|_| unknown(out))?,
        };
        let name = word.name();
        match Format::ALL.into_iter().find(|format| format.name() == name) {
            Some(format) => Ok(Self::Waveforms(format)),
            None if ending == name => Ok(Self::Picture),
            None => Err(Failure::usage(format!(
                "--out {}: expected a name that ends in .{name} for --format {name}",
                out.display()
            ))),
        }
    }

    /// Word of the format, as in the record.
    pub fn name(self, out: &Path) -> String {
        match self {
            Self::Waveforms(format) => format.name().into(),
            Self::Picture => out.extension().unwrap_or_default().to_string_lossy().into_owned(),
        }
    }
}

impl FormatWord {
    fn name(self) -> String {
        self.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default()
    }
}

fn unknown(out: &Path) -> Failure {
    let words = FormatWord::value_variants().iter().map(|word| format!(".{}", word.name()));
    let words = words.collect::<Vec<_>>().join(", ");
    Failure::usage(format!("--out {}: expected a name that ends in {words}, or --format", out.display()))
}

/// The names of files, as they are told.
pub fn names(files: &[PathBuf]) -> Vec<String> {
    files.iter().map(|file| file.display().to_string()).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use waveform::Format;

    use super::{FormatWord, Target};

    #[test]
    fn names_and_words() {
        let of = |format, out| Target::of(format, Path::new(out));
        assert_eq!(of(None, "a.fst").ok(), Some(Target::Waveforms(Format::Fst)));
        assert_eq!(of(Some(FormatWord::Csv), "a.txt").ok(), Some(Target::Waveforms(Format::Csv)));
        assert_eq!(of(None, "a.svg").ok(), Some(Target::Picture));
        for (format, out) in [(None, "a.txt"), (None, "a"), (Some(FormatWord::Png), "a.svg")] {
            assert!(of(format, out).is_err(), "{out}");
        }
    }
}
