//! Why a scenario is no stage.

use std::path::{Path, PathBuf};

use features::population::PopulationError;
use features::{Crater, MOST_CRATERS};
use landscape::bank_file::BankFileError;
use landscape::relief::ReliefError;
use landscape::{BankError, TextureError};
use scenario::{PathProblems, SceneryProblems};

/// Why a scenario cannot be put on a stage.
#[derive(Debug, thiserror::Error)]
pub enum StageError {
    /// The bank cannot be read.
    #[error(transparent)]
    BankFile(#[from] BankFileError),
    /// The landscape cannot be generated.
    #[error(transparent)]
    Relief(#[from] ReliefError),
    /// The levels are no bank.
    #[error(transparent)]
    Bank(#[from] BankError),
    /// The vehicle cannot take the path.
    #[error(transparent)]
    Path(#[from] PathProblems),
    /// A crater of a list reaches over the edge of the ground.
    #[error("{}", outside(file, *row, crater, extent, *more))]
    CraterOutside {
        /// The list.
        file: PathBuf,
        /// Its row under the header, from 1, comments not counted.
        row: usize,
        /// The crater.
        crater: Box<Crater>,
        /// South, west, north, east edge of the area (m).
        extent: [f64; 4],
        /// How many others do.
        more: usize,
    },
    /// Craters cannot be strewn as asked.
    #[error("[[features.population]] {number}: {error}")]
    Population {
        /// Which, from 1.
        number: usize,
        /// Why not.
        error: PopulationError,
    },
    /// The area of a population is not inside the ground.
    #[error(
        "[[features.population]] {number}: craters outside the problem area, expected x {}..{} m, y {}..{} m; give an \
         area_m inside",
        extent[0], extent[2], extent[1], extent[3]
    )]
    PopulationOutside {
        /// Which, from 1.
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
        /// How many.
        count: usize,
    },
    /// No level to go over to.
    #[error("[levels]: the bank has one level only; expected two, the fine one first, or no [levels]")]
    OneLevel,
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
