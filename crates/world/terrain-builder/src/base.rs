//! What the features lie on: a level, or an elevation file.

use std::path::PathBuf;

use landscape::is_same_body;
use survey::{Elevation, ReadOptions, SurveyError};

use crate::description::{BaseWish, Description};
use crate::frame::Frame;
use crate::grid::Grid;
use crate::lay::Lay;
use crate::refused::Refused;

/// Posts a sample above which a grid finer than its file is warned of, along one direction (chosen).
const MUCH_FINER: f64 = 8.0;

/// Ground below all features.
#[derive(Debug, Clone)]
pub enum Base {
    /// The same height everywhere (m).
    Level(f64),
    /// Heights of a file.
    Elevation(Box<ElevationBase>),
}

/// An elevation file in the axes of a landscape.
#[derive(Debug, Clone)]
pub struct ElevationBase {
    elevation: Elevation,
    /// The same without voids.
    filled: Elevation,
    lay: Lay,
    /// Samples in a cell of the landscape along lines and along columns: above 1 a mean of samples is taken.
    cell: [f64; 2],
}

/// Why a landscape has no base.
#[derive(Debug, thiserror::Error)]
pub enum BaseError {
    /// The elevation file cannot be read.
    #[error(transparent)]
    Survey(#[from] SurveyError),
    /// The file does not reach over the landscape.
    #[error("{path}: {refused}", path = .path.display())]
    Refused {
        /// Path of the elevation file.
        path: PathBuf,
        /// What was found and expected.
        refused: Refused,
    },
}

impl Base {
    /// The base that a description wishes. Of a file only the part under the grid is read.
    ///
    /// # Errors
    /// If the file cannot be read, or does not reach over all posts.
    pub fn open(of: &Description) -> Result<Self, BaseError> {
        let (path, band) = match &of.base {
            BaseWish::Level(height) => return Ok(Self::Level(*height)),
            BaseWish::File { path, band } => (path, band),
        };
        let refused = |refused| BaseError::Refused { path: path.clone(), refused };
        let file = survey::open(path, &ReadOptions { band: *band, ..ReadOptions::default() })?;
        let window =
            Lay::window(&file, of.frame, &of.grid).ok_or_else(|| refused(not_covered(file.size())))?;
        let base = ElevationBase::new(file.window(&window)?, of.frame, &of.grid).map_err(refused)?;
        Ok(Self::Elevation(Box::new(base)))
    }

    /// Height (m) at a place: north, east (m).
    pub fn height(&self, place: [f64; 2]) -> f64 {
        match self {
            Self::Level(height) => *height,
            Self::Elevation(base) => base.height(place),
        }
    }
}

fn not_covered([lines, columns]: [usize; 2]) -> Refused {
    Refused::new("file", format!("{lines} x {columns} samples"), "a file that reaches over the whole range")
}

impl ElevationBase {
    /// Lays a file under the grid of a frame. Samples of a file without a known projection are metres; the middle of the file then
    /// lies in the middle of the frame.
    ///
    /// # Errors
    /// If the file does not reach over all posts, or is of another body.
    pub fn new(elevation: Elevation, frame: Frame, grid: &Grid) -> Result<Self, Refused> {
        let lay = Lay::of(&elevation, frame);
        let last = lay.size.map(|count| count as f64 - 1.0);
        let is_in = |[low, high]: [[f64; 2]; 2]| {
            (0..2).all(|axis| low[axis] >= -0.5 - 1e-6 && high[axis] <= last[axis] + 0.5 + 1e-6)
        };
        if !lay.range(grid).is_some_and(is_in) {
            return Err(not_covered(lay.size));
        }
        if let Some(radius) = elevation.frame.sphere().filter(|radius| !is_same_body(*radius, frame.radius()))
        {
            let expected = "a file of the body of the landscape, `area.radius_m`";
            return Err(Refused::new("file", format!("of a body of {radius} m"), expected));
        }
        let cell = lay.samples_a_step([grid.north.resolution, grid.east.resolution]).unwrap_or([1.0; 2]);
        Ok(Self { filled: elevation.filled(), elevation, lay, cell })
    }

    /// The part of the file that was read.
    pub fn elevation(&self) -> &Elevation {
        &self.elevation
    }

    /// Whether the file names no projection, so that its middle was laid under the middle of the landscape.
    pub fn is_unplaced(&self) -> bool {
        self.elevation.frame == survey::Frame::Plane(None)
    }

    /// Share of the samples under the landscape that are void, 0 to 1.
    pub fn voids(&self) -> f64 {
        let [lines, columns] = [self.elevation.lines, self.elevation.columns];
        let is_void = |sample: &usize| self.elevation.height(sample / columns, sample % columns).is_none();
        (0..lines * columns).filter(is_void).count() as f64 / (lines * columns) as f64
    }

    /// How many times finer the grid is than the file, where that is more than eight times.
    pub fn much_finer(&self) -> Option<f64> {
        let finer = 1.0 / self.cell[0].max(self.cell[1]);
        (finer > MUCH_FINER).then_some(finer)
    }

    /// Line and column (from 0, with a fraction) of a place: north, east (m). None where the file's projection has no picture.
    pub fn sample(&self, place: [f64; 2]) -> Option<[f64; 2]> {
        self.lay.sample(place)
    }

    /// Height (m) at a place: bilinear between samples, voids left out. Where the grid is coarser than the file along an axis, the mean
    /// of these heights over the cell around the place.
    fn height(&self, place: [f64; 2]) -> f64 {
        let sample = self.sample(place).unwrap_or([0.0; 2]);
        let last = self.lay.size.map(|count| count - 1);
        let [lines, columns] = [0, 1].map(|axis| Span::new(sample[axis], self.cell[axis], last[axis]));
        let lines = (lines.first..=lines.last).map(|line| (line, lines.weight(line)));
        let columns = (columns.first..=columns.last).map(move |column| (column, columns.weight(column)));
        self.weighted(lines.flat_map(|(line, share)| {
            columns.clone().map(move |(column, weight)| ([line, column], share * weight))
        }))
    }

    /// Mean of samples by weight, without voids; where all are void, of the filled samples.
    fn weighted(&self, samples: impl Iterator<Item = ([usize; 2], f64)> + Clone) -> f64 {
        let mean = |of: &Elevation| {
            let sums =
                samples.clone().fold([0.0; 2], |[heights, weights], ([line, column], weight)| {
                    match of.height(line, column) {
                        Some(height) => [heights + weight * height, weights + weight],
                        None => [heights, weights],
                    }
                });
            (sums[1] > 0.0).then(|| sums[0] / sums[1])
        };
        mean(&self.elevation).or_else(|| mean(&self.filled)).unwrap_or(0.0)
    }
}

/// Samples along one axis that have a say at a place.
#[derive(Clone, Copy)]
struct Span {
    first: usize,
    last: usize,
    middle: f64,
    /// Half of the cell (samples); 0 where heights are not averaged along the axis.
    half: f64,
}

impl Span {
    fn new(at: f64, cell: f64, last: usize) -> Self {
        let half = if cell > 1.0 { 0.5 * cell } else { 0.0 };
        let middle = if half > 0.0 { at } else { at.clamp(0.0, last as f64) };
        let post = |at: f64| (at.max(0.0) as usize).min(last);
        Self { first: post((middle - half).floor()), last: post((middle + half).ceil()), middle, half }
    }

    /// Weight of a sample: its hat at the place, or the mean of the hat over the cell.
    fn weight(&self, sample: usize) -> f64 {
        let from = self.middle - sample as f64;
        if self.half > 0.0 {
            below_hat(from + self.half) - below_hat(from - self.half)
        } else {
            (1.0 - from.abs()).max(0.0)
        }
    }
}

/// Area below the hat of a sample, from its left to `at`: 0 to 1.
fn below_hat(at: f64) -> f64 {
    match at {
        _ if at <= -1.0 => 0.0,
        _ if at <= 0.0 => 0.5 * (at + 1.0) * (at + 1.0),
        _ if at < 1.0 => 1.0 - 0.5 * (1.0 - at) * (1.0 - at),
        _ => 1.0,
    }
}
