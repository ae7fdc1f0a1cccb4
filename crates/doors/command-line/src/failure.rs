//! What goes wrong, in one message, and the exit code that belongs to it.

mod photo;

use std::fmt::Display;
use std::io;

use briefing::BriefingError;
use compare::CompareError;
use dataset::DatasetError;
use deadlines::DeadlineError;
use diagnostics::ProblemList;
use event_list::EventListError;
use file_info::InfoError;
use files::{Action, FileError, FolderError, NpyFileError};
use front_door::{OpenError, StageError};
use generator::FrameError;
use landscape::bank_file::BankFileError;
use merge::MergeError;
use photographs::PhotographFileError;
use picture::PictureFileError;
use plots::PlotError;
use replay::ReplayError;
use report::ReportError;
use robot_log::LogError;
use run_compare::RunCompareError;
use run_page::{PageError, RequestError};
use scope::ScopeError;
use state::StateError;
use survey::SurveyError;
use terrain_builder::LandscapeFileError;
use terrain_export::ExportError;
use text::visible;
use timing::RecordError;
use trigger_search::SearchError;
use vehicle_shadow::AugmentError;
use waveform::WaveformError;

/// Why a command did not do what it was told.
#[derive(Debug)]
pub enum Failure {
    /// Faults of files that people write, each with its place.
    Problems(ProblemList),
    /// The command line asks for what cannot be.
    Usage(String),
    /// A file cannot be read, or is not what it should be.
    Input(String),
    /// A result cannot be written.
    Output(String),
    /// Bad input that the command has told of already.
    Told,
    /// Whoever read our results has gone.
    ClosedPipe,
}

impl Failure {
    /// Makes a failure of wrong usage (exit code 2).
    pub fn usage(message: impl Display) -> Self {
        Self::Usage(message.to_string())
    }

    /// Makes a failure of bad input (exit code 3).
    pub fn input(message: impl Display) -> Self {
        Self::Input(message.to_string())
    }

    /// Failure of an output.
    pub fn output(message: impl Display) -> Self {
        Self::Output(message.to_string())
    }

    /// A failure to write results.
    pub fn stdout(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::ClosedPipe,
            _ => Self::Output(format!("standard output: cannot write: {error}")),
        }
    }

    /// What to print, if anything.
    pub fn message(&self, colour: bool) -> Option<String> {
        match self {
            // What comes from files is visible in it; the rest may be colour.
            Self::Problems(list) => Some(list.render(colour).trim_end().to_owned()),
            Self::Usage(message) | Self::Input(message) | Self::Output(message) => {
                // Several faults are several lines.
                Some(
                    visible(message)
                        .lines()
                        .map(|line| format!("error: {line}"))
                        .collect::<Vec<_>>()
                        .join("\n"),
                )
            }
            Self::Told | Self::ClosedPipe => None,
        }
    }

    /// Exit code of the process.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Usage(_) => 2,
            Self::Problems(_) | Self::Input(_) | Self::Told => 3,
            Self::Output(_) => 4,
            Self::ClosedPipe => 0,
        }
    }
}

impl From<ProblemList> for Failure {
    fn from(list: ProblemList) -> Self {
        Self::Problems(list)
    }
}

impl From<FileError> for Failure {
    fn from(error: FileError) -> Self {
        let is_input = match &error {
            FileError::Missing { .. } | FileError::TooLarge { .. } => true,
            FileError::IsFolder { action, .. }
            | FileError::NoFile { action, .. }
            | FileError::OtherNames { action, .. }
            | FileError::MissingFolder { action, .. }
            | FileError::Denied { action, .. }
            | FileError::NoSpace { action, .. }
            | FileError::Io { action, .. } => *action == Action::Read,
        };
        if is_input { Self::input(error) } else { Self::output(error) }
    }
}

impl From<FolderError> for Failure {
    fn from(error: FolderError) -> Self {
        match error {
            FolderError::File(error) => error.into(),
            other => Self::output(other),
        }
    }
}

impl From<PictureFileError> for Failure {
    fn from(error: PictureFileError) -> Self {
        match error {
            PictureFileError::File(error) => error.into(),
            PictureFileError::Picture { .. } => Self::input(error),
        }
    }
}

impl From<PhotographFileError> for Failure {
    fn from(error: PhotographFileError) -> Self {
        match error {
            PhotographFileError::File(error) => error.into(),
            PhotographFileError::Picture { .. } => Self::input(error),
        }
    }
}

impl From<BankFileError> for Failure {
    fn from(error: BankFileError) -> Self {
        match error {
            BankFileError::File(error) => error.into(),
            BankFileError::Format { .. } => Self::input(error),
        }
    }
}

impl From<StageError> for Failure {
    fn from(error: StageError) -> Self {
        match error {
            StageError::BankFile(error) => error.into(),
            other => Self::input(other),
        }
    }
}

impl From<OpenError> for Failure {
    fn from(error: OpenError) -> Self {
        match error {
            OpenError::Problems(list) => list.into(),
            OpenError::Wish(message) => Self::Usage(message),
            OpenError::Input(message) => Self::Input(message),
            OpenError::Output(message) => Self::Output(message),
            OpenError::File(error) => error.into(),
            OpenError::Bank(error) => error.into(),
            OpenError::Prepare(error) => Self::input(error),
        }
    }
}

impl From<NpyFileError> for Failure {
    fn from(error: NpyFileError) -> Self {
        match error {
            NpyFileError::File(error) => error.into(),
            other => Self::input(other),
        }
    }
}

impl From<RecordError> for Failure {
    fn from(error: RecordError) -> Self {
        match error {
            RecordError::File(error) => error.into(),
            other => Self::input(other),
        }
    }
}

impl From<ReplayError> for Failure {
    fn from(error: ReplayError) -> Self {
        match error {
            ReplayError::File(error) => error.into(),
            ReplayError::PictureFile(error) => error.into(),
            ReplayError::Claim(error) => error.into(),
            ReplayError::Beyond { .. }
            | ReplayError::Speed { .. }
            | ReplayError::Poses(_)
            | ReplayError::Prepare(_)
            | ReplayError::Frame(_)
            | ReplayError::Display(_)
            | ReplayError::Record { .. }
            | ReplayError::NoRecord { .. }
            | ReplayError::Unfinished { .. }
            | ReplayError::TruthRecord { .. }
            | ReplayError::TruthNotANumber { .. }
            | ReplayError::Changed { .. }
            | ReplayError::Costs { .. }
            | ReplayError::Picture { .. } => Self::input(error),
            ReplayError::NoFrames(_) | ReplayError::TooManyChecks { .. } => Self::usage(error),
            _ => Self::output(error),
        }
    }
}

impl From<LogError> for Failure {
    fn from(error: LogError) -> Self {
        match error {
            LogError::File(error) => error.into(),
            LogError::Run(error) => error.into(),
            LogError::NotInThisBuild(_) | LogError::Lacks { .. } => Self::usage(error),
            LogError::NotOurs { .. } | LogError::Pack { .. } => Self::output(error),
            _ => Self::input(error),
        }
    }
}

impl From<MergeError> for Failure {
    fn from(error: MergeError) -> Self {
        match error {
            MergeError::Run(error) => error.into(),
            MergeError::Twice { .. } | MergeError::IntoItself { .. } | MergeError::Outside { .. } => {
                Self::usage(error)
            }
            other => Self::input(other),
        }
    }
}

impl From<SurveyError> for Failure {
    fn from(error: SurveyError) -> Self {
        match error {
            SurveyError::Npy(error) => error.into(),
            // The file is what it is; the option asks for what it does not hold.
            SurveyError::Option { .. }
            | SurveyError::NoSuchBand { .. }
            | SurveyError::AreaOutside { .. }
            | SurveyError::AreaKind { .. }
            | SurveyError::TooManyRegions { .. } => Self::usage(error),
            other => Self::input(other),
        }
    }
}

impl From<LandscapeFileError> for Failure {
    fn from(error: LandscapeFileError) -> Self {
        match error {
            LandscapeFileError::File(error) => error.into(),
            LandscapeFileError::Problems(list) => list.into(),
            LandscapeFileError::Exists { .. } => Self::usage(error),
            _ => Self::input(error),
        }
    }
}

impl From<ExportError> for Failure {
    fn from(error: ExportError) -> Self {
        match error {
            ExportError::Survey(error) => error.into(),
            ExportError::Bank(error) => error.into(),
            ExportError::Array(error) => error.into(),
            ExportError::File(error) => error.into(),
            ExportError::Folder(error) => error.into(),
            ExportError::Database(_) | ExportError::Boulder { .. } | ExportError::Albedo(_) => {
                Self::input(error)
            }
            ExportError::Strange { .. } | ExportError::NoFolder { .. } | ExportError::System { .. } => {
                Self::output(error)
            }
        }
    }
}

impl From<DeadlineError> for Failure {
    fn from(error: DeadlineError) -> Self {
        match error {
            DeadlineError::Open(error) => error.into(),
            DeadlineError::Write(_) => Self::output(error),
            DeadlineError::NoTime(_)
            | DeadlineError::TooManyMisses { .. }
            | DeadlineError::BeyondSweep { .. }
            | DeadlineError::Asked(_) => Self::usage(error),
            _ => Self::input(error),
        }
    }
}

impl From<EventListError> for Failure {
    fn from(error: EventListError) -> Self {
        Self::usage(error)
    }
}

impl From<FrameError> for Failure {
    fn from(error: FrameError) -> Self {
        Self::input(error)
    }
}

impl From<study::report::ReportError> for Failure {
    fn from(error: study::report::ReportError) -> Self {
        match error {
            study::report::ReportError::File(error) => error.into(),
            other => Self::output(other),
        }
    }
}

impl From<ReportError> for Failure {
    fn from(error: ReportError) -> Self {
        match error {
            ReportError::File(error) => error.into(),
            ReportError::Folder(error) => error.into(),
            ReportError::Run(error) => error.into(),
            ReportError::PictureFile(error) => error.into(),
            ReportError::Content { .. } | ReportError::Strip { .. } | ReportError::Compare { .. } => {
                Self::input(error)
            }
        }
    }
}

impl From<RunCompareError> for Failure {
    fn from(error: RunCompareError) -> Self {
        match error {
            RunCompareError::Run(error) => error.into(),
            RunCompareError::Picture(error) => error.into(),
            RunCompareError::Photograph(error) => error.into(),
            RunCompareError::Open(error) => error.into(),
            RunCompareError::NoFrames => Self::usage(error),
            _ => Self::input(error),
        }
    }
}

impl From<InfoError> for Failure {
    fn from(error: InfoError) -> Self {
        match error {
            InfoError::Problems(list) => list.into(),
            InfoError::Open(error) => error.into(),
            InfoError::File(error) => error.into(),
            InfoError::Bank(error) => error.into(),
            InfoError::State(error) => error.into(),
            InfoError::Picture(error) => error.into(),
            InfoError::Run(error) => error.into(),
            InfoError::Survey(error) => (*error).into(),
            InfoError::Database(_) | InfoError::Other(_) | InfoError::UnknownStart { .. } => {
                Self::input(error)
            }
        }
    }
}

impl From<RequestError> for Failure {
    fn from(error: RequestError) -> Self {
        Self::usage(error)
    }
}

impl From<PageError> for Failure {
    fn from(error: PageError) -> Self {
        match error {
            PageError::Run(error) => error.into(),
            PageError::Report(error) => error.into(),
            PageError::Scope(error) => error.into(),
            PageError::File(error) => error.into(),
            PageError::Request(error) => error.into(),
            PageError::Path(_) | PageError::Prepare(_) | PageError::Frame(_) => Self::input(error),
        }
    }
}

impl From<SearchError> for Failure {
    fn from(error: SearchError) -> Self {
        match error {
            SearchError::Condition(_) => Self::usage(error),
            SearchError::Poses(error) => error.into(),
            SearchError::Frame(error) => error.into(),
        }
    }
}

impl From<ScopeError> for Failure {
    fn from(error: ScopeError) -> Self {
        match error {
            ScopeError::Waveform(error) => error.into(),
            ScopeError::Write(_) => Self::output(error),
            ScopeError::Frame(_) | ScopeError::Picture(_) => Self::input(error),
            _ => Self::usage(error),
        }
    }
}

impl From<WaveformError> for Failure {
    fn from(error: WaveformError) -> Self {
        match error {
            WaveformError::File(error) => error.into(),
            other => Self::input(other),
        }
    }
}

impl From<StateError> for Failure {
    fn from(error: StateError) -> Self {
        match error {
            StateError::File(error) => error.into(),
            StateError::Place(_) | StateError::Registers(_) => Self::usage(error),
            StateError::Fault { .. } | StateError::Frame(_) | StateError::Path(_) => Self::input(error),
        }
    }
}

impl From<CompareError> for Failure {
    fn from(error: CompareError) -> Self {
        Self::input(error)
    }
}

impl From<PlotError> for Failure {
    fn from(error: PlotError) -> Self {
        match error {
            PlotError::File(error) => error.into(),
            other => Self::input(other),
        }
    }
}

impl From<AugmentError> for Failure {
    fn from(error: AugmentError) -> Self {
        match error {
            AugmentError::File(error) => error.into(),
            AugmentError::Poses(faults) => faults.into(),
            AugmentError::Claim(error) => error.into(),
            AugmentError::Foreign { .. } | AugmentError::WouldReplace { .. } | AugmentError::Other { .. } => {
                Self::output(error)
            }
            AugmentError::Picture(error) => error.into(),
            AugmentError::Photograph(error) => error.into(),
            AugmentError::Folder { doing: "list this folder", .. } => Self::input(error),
            AugmentError::Folder { .. } => Self::output(error),
            AugmentError::SameFolder { .. }
            | AugmentError::Sun { .. }
            | AugmentError::TracksWithoutGround => Self::usage(error),
            other => Self::input(other),
        }
    }
}

impl From<BriefingError> for Failure {
    fn from(error: BriefingError) -> Self {
        Self::input(error)
    }
}

impl From<DatasetError> for Failure {
    fn from(error: DatasetError) -> Self {
        match error {
            DatasetError::Plan(list) => list.into(),
            DatasetError::Open(error) => error.into(),
            DatasetError::File(error) => error.into(),
            DatasetError::Folder(error) => error.into(),
            DatasetError::Journal(error) => error.into(),
            DatasetError::NoSamples { .. } | DatasetError::Folders { .. } => Self::usage(error),
            DatasetError::Foreign { .. } | DatasetError::Other { .. } | DatasetError::Sheet(_) => {
                Self::output(error)
            }
            _ => Self::input(error),
        }
    }
}
