//! Which files can be written.

use std::path::Path;
use std::str::FromStr;

use crate::WaveformError;

/// A kind of waveform file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Format {
    /// A table, a row a sample.
    Csv,
    /// Value changes as text (IEEE 1364).
    Vcd,
    /// Value changes as GTKWave keeps them.
    Fst,
    /// Arrays of numpy, zipped into one file.
    Npz,
    /// A JSON document, with its sweeps as members.
    Json,
    /// Vectors of ngspice, in volts.
    Raw,
    /// A session of sigrok, in volts.
    Sr,
}

impl Format {
    /// All formats that can be written.
    pub const ALL: [Self; 7] = [Self::Csv, Self::Vcd, Self::Fst, Self::Npz, Self::Json, Self::Raw, Self::Sr];

    /// Word on the command line, and ending of file names.
    pub fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Vcd => "vcd",
            Self::Fst => "fst",
            Self::Npz => "npz",
            Self::Json => "json",
            Self::Raw => "raw",
            Self::Sr => "sr",
        }
    }

    /// What it is, in a few words.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Csv => "A table, a row a sample",
            Self::Vcd => "Value changes as text, for every viewer",
            Self::Fst => "Value changes for GTKWave and Surfer",
            Self::Npz => "Arrays of numpy",
            Self::Json => "A document",
            Self::Raw => "Vectors of ngspice, in volts",
            Self::Sr => "A session of sigrok, in volts",
        }
    }

    /// The format that the ending of `path` says.
    pub fn of_path(path: &Path) -> Option<Self> {
        path.extension().and_then(|ending| ending.to_str())?.parse().ok()
    }

    /// Whether units and full scales are kept in a file beside it, because it cannot hold them.
    pub(crate) fn needs_record(self) -> bool {
        !matches!(self, Self::Csv | Self::Json)
    }

    /// Whether GTKWave opens it.
    pub(crate) fn is_of_gtkwave(self) -> bool {
        matches!(self, Self::Vcd | Self::Fst)
    }

    /// All names, for messages.
    pub(crate) fn words() -> String {
        Self::ALL.map(Self::name).join(", ")
    }
}

impl FromStr for Format {
    type Err = WaveformError;

    fn from_str(text: &str) -> Result<Self, WaveformError> {
        let known = Self::ALL.into_iter().find(|format| format.name() == text);
        known.ok_or_else(|| WaveformError::Format { found: text.to_owned() })
    }
}
