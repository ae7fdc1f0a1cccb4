//! Why it cannot be said what a file holds.

use std::path::PathBuf;

use diagnostics::ProblemList;
use files::FileError;
use front_door::OpenError;
use landscape::bank_file::BankFileError;
use photographs::PhotographFileError;
use replay::ReplayError;
use state::StateError;
use survey::SurveyError;
use terrain_database::DatabaseError;

/// Why it cannot be said what a file holds.
#[derive(Debug, thiserror::Error)]
pub enum InfoError {
    /// The file is of a kind that says nothing by itself.
    #[error("{0}")]
    Other(String),
    /// The file begins like none that is known.
    #[error(
        "{}: starts with {found}; expected a bank, a state of a machine, an elevation file (GeoTIFF, PDS3, PDS4, ISIS, ENVI, Arc ASCII, DTED, .hgt, .npy), a terrain database (.lod), a scenario, a hardware model or a landscape (.toml), a grey PNG, or the folder of a run",
        .file.display()
    )]
    UnknownStart {
        /// File that cannot be recognised.
        file: PathBuf,
        /// How it begins, in words.
        found: String,
    },
    /// A state of a machine is damaged, or cannot be read.
    #[error(transparent)]
    State(#[from] StateError),
    /// Faults of a file that people write.
    #[error(transparent)]
    Problems(#[from] ProblemList),
    /// A scenario cannot be read.
    #[error(transparent)]
    Open(#[from] OpenError),
    /// A file cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// A bank cannot be read.
    #[error(transparent)]
    Bank(#[from] BankFileError),
    /// A picture cannot be read.
    #[error(transparent)]
    Picture(#[from] PhotographFileError),
    /// A run cannot be read.
    #[error(transparent)]
    Run(#[from] ReplayError),
    /// A terrain database cannot be read.
    #[error(transparent)]
    Database(#[from] Box<DatabaseError>),
    /// An elevation file cannot be read.
    #[error(transparent)]
    Survey(Box<SurveyError>),
}

impl From<SurveyError> for InfoError {
    fn from(error: SurveyError) -> Self {
        Self::Survey(Box::new(error))
    }
}
