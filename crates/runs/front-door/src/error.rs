//! Why a scenario cannot be opened, or put on a stage.

use std::path::{Path, PathBuf};

use diagnostics::{Problem, ProblemList, Problems};
use faces::FaceError;
use features::population::PopulationError;
use features::{Crater, MOST_CRATERS};
use files::FileError;
use generator::PrepareError;
use landscape::bank_file::BankFileError;
use landscape::relief::ReliefError;
use landscape::{AlbedoMapError, BankError, LUNOID_RADIUS, TextureError};
use photograph::PhotoError;
use photographs::PhotographFileError;
use quantities::degrees;
use scenario::{PathProblems, SceneryProblems};
use terrain_database::DatabaseError;
use wind_waves::WaveError;

/// Why files and wishes do not come to a generator on a stage.
#[derive(Debug, thiserror::Error)]
pub enum OpenError {
    /// Faults of files that people write, each with its place.
    #[error(transparent)]
    Problems(#[from] ProblemList),
    /// Wishes that cannot be.
    #[error("{0}")]
    Wish(String),
    /// A file that is not what it should be.
    #[error("{0}")]
    Input(String),
    /// A folder that cannot be made.
    #[error("{0}")]
    Output(String),
    /// A file that cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// A bank that cannot be read.
    #[error(transparent)]
    Bank(#[from] BankFileError),
    /// A stage that the generator cannot draw.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
}

/// Why a scenario cannot be put on a stage.
#[derive(Debug, thiserror::Error)]
pub enum StageError {
    /// The bank cannot be read.
    #[error(transparent)]
    BankFile(#[from] BankFileError),
    /// The landscape cannot be generated.
    #[error(transparent)]
    Relief(#[from] ReliefError),
    /// There are no such waves.
    #[error("[sea] waves: {0}")]
    Waves(#[from] WaveError),
    /// The levels are no bank.
    #[error(transparent)]
    Bank(#[from] BankError),
    /// The vehicle cannot take the path.
    #[error(transparent)]
    Path(#[from] PathProblems),
    /// A crater of a list reaches over the edge of the ground.
    #[error("{}", outside(file, *row, crater, extent, *more))]
    CraterOutside {
        /// File of the crater list.
        file: PathBuf,
        /// Its row under the header, from 1, comments not counted.
        row: usize,
        /// Crater that reaches over the edge.
        crater: Box<Crater>,
        /// South, west, north, east edge of the area (m).
        extent: [f64; 4],
        /// How many others do.
        more: usize,
    },
    /// Craters cannot be strewn as asked.
    #[error("[[features.population]] {number}: {error}")]
    Population {
        /// Number of the population in the scenario, from 1.
        number: usize,
        /// Why the craters cannot be strewn.
        error: PopulationError,
    },
    /// The area of a population is not inside the ground.
    #[error(
        "[[features.population]] {number}: craters outside the problem area, expected x {}..{} m, y {}..{} m; give an \
         area_m inside",
        extent[0], extent[2], extent[1], extent[3]
    )]
    PopulationOutside {
        /// Number of the population in the scenario, from 1.
        number: usize,
        /// South, west, north, east edge of the area (m).
        extent: [f64; 4],
    },
    /// More craters than an index can tell apart.
    #[error(
        "[features]: {count} craters in the list and all populations, expected at most {MOST_CRATERS}; make a population thinner \
         or its area smaller"
    )]
    Craters {
        /// Number of craters in the list and all populations.
        count: usize,
    },
    /// No level to go over to.
    #[error("[levels]: the bank has one level only; expected two, the fine one first, or no [levels]")]
    OneLevel,
    /// The picture of the albedo cannot be read.
    #[error("[landscape] albedo_map: {0}")]
    AlbedoPicture(#[from] PhotographFileError),
    /// The picture of the albedo is no map.
    #[error("[landscape] albedo_map: {}: {error}", file.display())]
    AlbedoMap {
        /// File of the picture.
        file: PathBuf,
        /// Why the picture is no map of the albedo.
        error: AlbedoMapError,
    },
    /// A photograph cannot be read.
    #[error("[[photograph]] {}: {error}", file.display())]
    Photograph {
        /// File of the picture.
        file: PathBuf,
        /// Why it is no photograph of ground.
        error: Box<PhotoError>,
    },
    /// An effect file has faults.
    #[error("{0}")]
    Effect(ProblemList),
    /// A figure of `[sea]`, `[[ship]]` or `[[plume]]` makes no list of faces.
    #[error("[sea], [[ship]], [[plume]]: {0}")]
    Faces(#[from] FaceError),
    /// The terrain database cannot be read.
    #[error("[landscape] database: {0}")]
    Database(#[from] Box<DatabaseError>),
    /// The terrain database is of another body.
    #[error(
        "[landscape] database: {}: a body of radius {radius} m, expected the Moon ({LUNOID_RADIUS} m); export a landscape on it",
        file.display()
    )]
    OtherBody {
        /// File of the database.
        file: PathBuf,
        /// Radius of its body (m).
        radius: f64,
    },
    /// The terrain database is of another place.
    #[error(
        "[landscape] database: {}: ground about latitude {:.4}, longitude {:.4} degrees, where the bank has {:.4}, {:.4}; expected the same \
         ground, from one export",
        file.display(), degrees(database[0]), degrees(database[1]), degrees(bank[0]), degrees(bank[1])
    )]
    OtherPlace {
        /// File of the database.
        file: PathBuf,
        /// Latitude and longitude (rad) of its middle.
        database: [f64; 2],
        /// Those of the same place by the map of the bank.
        bank: [f64; 2],
    },
    /// The terrain database and the bank are of different ground.
    #[error(
        "[landscape] database: {}: its posts lie between x = {:.1} and {:.1} m, y = {:.1} and {:.1} m, and the bank between x = {:.1} and {:.1} m, \
         y = {:.1} and {:.1} m; expected the same ground, from one export",
        file.display(), posts[0], posts[2], posts[1], posts[3], bank[0], bank[2], bank[1], bank[3]
    )]
    ApartDatabase {
        /// File of the database.
        file: PathBuf,
        /// South, west, north, east border of its posts (m).
        posts: [f64; 4],
        /// The same of the bank's finest level.
        bank: [f64; 4],
    },
    /// The texture does not go with the ground.
    #[error("[texture]: {0}")]
    Texture(#[from] TextureError),
    /// Something of the scenery has no place on the ground.
    #[error(transparent)]
    Scenery(#[from] SceneryProblems),
}

fn outside(file: &Path, row: usize, crater: &Crater, extent: &[f64; 4], more: usize) -> String {
    let ([x, y], radius, [south, west, north, east]) = (crater.centre(), crater.outer(), extent);
    let others = if more > 0 { format!("; so are {more} others") } else { String::new() };
    format!(
        "{}: row {row}: a crater of {radius} m around x = {x} m, y = {y} m is not wholly inside the problem area, \
         expected x {south}..{north} m, y {west}..{east} m; move it or take it out{others}",
        file.display()
    )
}

/// Everything that `error` says of the scenario in `file`.
pub fn stage_problems(file: &str, error: &StageError) -> ProblemList {
    if let StageError::Path(error) = error {
        return path_problems(error);
    }
    if let StageError::Effect(problems) = error {
        return problems.clone();
    }
    let problems = Problems::new();
    error.to_string().lines().for_each(|line| problems.push(Problem::of_file(file, line)));
    problems.into_result().err().unwrap_or_else(|| Problem::of_file(file, "no stage").into())
}

/// Why a path cannot be driven, one problem a stretch of frames.
pub fn path_problems(error: &PathProblems) -> ProblemList {
    let problems = Problems::new();
    error.iter().for_each(|problem| problems.push(Problem::of_file(error.path(), problem.to_string())));
    problems.into_result().err().unwrap_or_else(|| Problem::of_file(error.path(), "no path").into())
}
