//! What is written, and where.

use std::path::{Path, PathBuf};

use clap::builder::PossibleValue;
use waveform::{Format, companions};

use command_line::Failure;
use command_line::output::{Place, ending};

/// Pictures of a sweep, by the ending of their names.
const PICTURES: [(&str, &str); 2] = [("png", "A page of the scope"), ("svg", "The same, as vectors")];

/// What a command writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// A file of waveforms.
    Waveforms(Format),
    /// A page of the scope; the name of the file says which kind.
    Picture,
}

/// The words of `--format`.
pub fn words() -> Vec<PossibleValue> {
    let formats = Format::ALL.map(|format| PossibleValue::new(format.name()).help(format.meaning()));
    let pictures = PICTURES.map(|(name, meaning)| PossibleValue::new(name).help(meaning));
    formats.into_iter().chain(pictures).collect()
}

impl Target {
    /// By a word of `--format`, else by the name of the file.
    pub fn of(word: Option<&str>, out: &Path) -> Result<Self, Failure> {
        let by_name = ending(out);
        let name = word.unwrap_or(&by_name);
        match Self::called(name).ok_or_else(|| unknown(out, ", or --format"))? {
            Self::Picture if by_name != name => Err(Failure::usage(format!(
                "--out {}: expected a name that ends in .{name} for --format {name}",
                out.display()
            ))),
            target => Ok(target),
        }
    }

    /// By the name of the file alone.
    pub fn of_name(out: &Path) -> Result<Self, Failure> {
        Self::called(&ending(out)).ok_or_else(|| unknown(out, ""))
    }

    fn called(name: &str) -> Option<Self> {
        let format = Format::ALL.into_iter().find(|format| format.name() == name);
        let is_picture = PICTURES.iter().any(|(picture, _)| *picture == name);
        format.map(Self::Waveforms).or(is_picture.then_some(Self::Picture))
    }

    /// All files that are written where the `option` names `out`.
    pub fn places(self, option: &'static str, out: &Path) -> Vec<Place> {
        let beside = match self {
            Self::Waveforms(format) => companions(format, out),
            Self::Picture => Vec::new(),
        };
        let beside = beside.into_iter().map(|file| Place::file("a file written beside the waveforms,", file));
        [Place::file(option, out)].into_iter().chain(beside).collect()
    }

    /// Word of the format, as in the record.
    pub fn name(self, out: &Path) -> String {
        match self {
            Self::Waveforms(format) => format.name().into(),
            Self::Picture => out.extension().unwrap_or_default().to_string_lossy().into_owned(),
        }
    }
}

fn unknown(out: &Path, more: &str) -> Failure {
    let words = words();
    let endings = words.iter().map(|word| format!(".{}", word.get_name())).collect::<Vec<_>>().join(", ");
    Failure::usage(format!("--out {}: expected a name that ends in {endings}{more}", out.display()))
}

/// The names of files, as they are told.
pub fn names(files: &[PathBuf]) -> Vec<String> {
    files.iter().map(|file| file.display().to_string()).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use waveform::Format;

    use super::Target;

    #[test]
    fn names_and_words() {
        let of = |format, out| Target::of(format, Path::new(out));
        assert_eq!(of(None, "a.fst").ok(), Some(Target::Waveforms(Format::Fst)));
        assert_eq!(of(Some("csv"), "a.txt").ok(), Some(Target::Waveforms(Format::Csv)));
        assert_eq!(of(None, "a.svg").ok(), Some(Target::Picture));
        for (format, out) in [(None, "a.txt"), (None, "a"), (Some("png"), "a.svg")] {
            assert!(of(format, out).is_err(), "{out}");
        }
    }
}
