//! What the features lie on: a level, or an elevation file.

use std::f64::consts::TAU;

use survey::{Elevation, Frame as FileFrame};

use crate::frame::Frame;
use crate::grid::Grid;
use crate::refused::{Refused, expect};

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
    frame: Frame,
    /// Samples in a cell of the landscape along lines and along columns: above 1 a mean of samples is taken.
    cell: [f64; 2],
}

impl Base {
    /// Height (m) at a place: north, east (m).
    pub fn height(&self, place: [f64; 2]) -> f64 {
        match self {
            Self::Level(height) => *height,
            Self::Elevation(base) => base.height(place),
        }
    }
}

impl ElevationBase {
    /// Lays a file under the grid of a frame. Samples of a file without a known projection are metres; the middle of the file then
    /// lies in the middle of the frame.
    ///
    /// # Errors
    /// If the file does not reach over all posts.
    pub fn new(elevation: Elevation, frame: Frame, grid: &Grid) -> Result<Self, Refused> {
        let filled = elevation.filled();
        let mut base = Self { elevation, filled, frame, cell: [0.0; 2] };
        let [low, high] = grid.extent();
        let corners = [low, [low[0], high[1]], high, [high[0], low[1]]];
        let samples = corners.map(|corner| base.sample(corner));
        let last = [base.elevation.lines - 1, base.elevation.columns - 1].map(|last| last as f64);
        let is_in = |sample: [f64; 2]| {
            (0..2).all(|axis| sample[axis] >= -0.5 - 1e-6 && sample[axis] <= last[axis] + 0.5 + 1e-6)
        };
        let found = format!("{} x {} samples", base.elevation.lines, base.elevation.columns);
        let is_covered = samples.into_iter().all(|sample| sample.is_some_and(is_in));
        expect(is_covered, "file", found, "a file that reaches over the whole range")?;
        let middle = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])];
        let step = [grid.north.resolution, grid.east.resolution];
        base.cell = base.samples_a_step(middle, step).unwrap_or([1.0; 2]);
        Ok(base)
    }

    /// The file as it was read.
    pub fn elevation(&self) -> &Elevation {
        &self.elevation
    }

    /// Samples that a step of the grid (m) passes along lines and columns.
    fn samples_a_step(&self, place: [f64; 2], step: [f64; 2]) -> Option<[f64; 2]> {
        let from = self.sample(place)?;
        let moved = [[place[0] + step[0], place[1]], [place[0], place[1] + step[1]]];
        let ways = moved.map(|place| self.sample(place));
        let [north, east] = [ways[0]?, ways[1]?];
        Some([0, 1].map(|axis| (north[axis] - from[axis]).abs().max((east[axis] - from[axis]).abs())))
    }

    /// How many times finer the grid is than the file, where that is more than eight times.
    pub fn much_finer(&self) -> Option<f64> {
        let finer = 1.0 / self.cell[0].max(self.cell[1]);
        (finer > MUCH_FINER).then_some(finer)
    }

    /// Line and column (from 0, with a fraction) of a place: north, east (m). None where the file's projection has no picture.
    pub fn sample(&self, place: [f64; 2]) -> Option<[f64; 2]> {
        let coordinates = match self.elevation.frame {
            FileFrame::Geographic { .. } => self.frame.inverse(place),
            FileFrame::Plane(Some(projection)) => {
                let [latitude, longitude] = self.frame.inverse(place);
                let [south, west, north, east] = self.elevation.extent();
                let middle = [0.5 * (south + north), 0.5 * (west + east)];
                projection.forward_near(latitude, longitude, middle)?
            }
            FileFrame::Plane(None) => {
                let [south, west, north, east] = self.elevation.extent();
                [place[0] + 0.5 * (south + north), place[1] + 0.5 * (west + east)]
            }
        };
        let affine = &self.elevation.affine;
        let sample = [0, 1].map(|axis| (coordinates[axis] - affine.first[axis]) / affine.step[axis]);
        Some([sample[0], self.on_its_turn(sample[1])])
    }

    /// A column of a geographic file on the turn around the sphere that is nearest to the middle of the file.
    fn on_its_turn(&self, column: f64) -> f64 {
        if !matches!(self.elevation.frame, FileFrame::Geographic { .. }) {
            return column;
        }
        let turn = (TAU / self.elevation.affine.step[1]).abs();
        let middle = 0.5 * (self.elevation.columns - 1) as f64;
        column + turn * ((middle - column) / turn).round()
    }

    /// Height (m) at a place: bilinear between samples, voids left out. Where the grid is coarser than the file along an axis, the mean
    /// of these heights over the cell around the place.
    fn height(&self, place: [f64; 2]) -> f64 {
        let sample = self.sample(place).unwrap_or([0.0; 2]);
        let last = [self.elevation.lines, self.elevation.columns].map(|count| count - 1);
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
