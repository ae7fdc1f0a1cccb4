//! Where a place of a landscape lies in the lines and columns of an elevation file.

use std::f64::consts::TAU;

use survey::{Affine, Elevation, Frame as FileFrame, Opened, Window};

use crate::frame::Frame;
use crate::grid::Grid;

/// Samples around the range that are read with it: interpolation looks one further (chosen).
const AROUND: f64 = 2.0;

/// A file's lines and columns under a landscape's axes.
#[derive(Debug, Clone, Copy)]
pub struct Lay {
    frame: Frame,
    file: FileFrame,
    affine: Affine,
    /// Lines and columns of the file.
    pub size: [usize; 2],
    /// Line and column of the middle of the whole file, of which this may be a window.
    middle: [f64; 2],
    /// Column of the centre of the frame: others lie on the turn around the sphere that is nearest to it.
    centre: f64,
}

impl Lay {
    /// The lay of an elevation in memory.
    pub fn of(elevation: &Elevation, frame: Frame) -> Self {
        let whole = elevation.file_size.map(|count| 0.5 * (count as f64 - 1.0));
        let middle = [0, 1].map(|axis| whole[axis] - elevation.corner[axis] as f64);
        Self::new(frame, elevation.frame, elevation.affine, [elevation.lines, elevation.columns], middle)
    }

    fn new(frame: Frame, file: FileFrame, affine: Affine, size: [usize; 2], middle: [f64; 2]) -> Self {
        let mut lay = Self { frame, file, affine, size, middle, centre: 0.5 * (size[1] as f64 - 1.0) };
        lay.centre = lay.sample([0.0; 2]).map_or(lay.centre, |sample| sample[1]);
        lay
    }

    /// Line and column (from 0, with a fraction) of a place: north, east (m). None where the file's projection has no picture.
    pub fn sample(&self, place: [f64; 2]) -> Option<[f64; 2]> {
        let middle = [0, 1].map(|axis| self.affine.first[axis] + self.middle[axis] * self.affine.step[axis]);
        let coordinates = match self.file {
            FileFrame::Geographic { .. } => self.frame.inverse(place),
            FileFrame::Plane(Some(projection)) => {
                let [latitude, longitude] = self.frame.inverse(place);
                projection.forward_near(latitude, longitude, middle)?
            }
            FileFrame::Plane(None) => [place[0] + middle[0], place[1] + middle[1]],
        };
        let sample =
            [0, 1].map(|axis| (coordinates[axis] - self.affine.first[axis]) / self.affine.step[axis]);
        Some([sample[0], self.on_its_turn(sample[1])])
    }

    fn on_its_turn(&self, column: f64) -> f64 {
        if !matches!(self.file, FileFrame::Geographic { .. }) {
            return column;
        }
        let turn = (TAU / self.affine.step[1]).abs();
        column + turn * ((self.centre - column) / turn).round()
    }

    /// Samples that a step of a grid passes along lines and columns, in the middle of the frame.
    pub fn samples_a_step(&self, step: [f64; 2]) -> Option<[f64; 2]> {
        let from = self.sample([0.0; 2])?;
        let [north, east] = [self.sample([step[0], 0.0])?, self.sample([0.0, step[1]])?];
        Some([0, 1].map(|axis| (north[axis] - from[axis]).abs().max((east[axis] - from[axis]).abs())))
    }

    /// Lowest and highest line and column under the border of a grid.
    pub fn range(&self, grid: &Grid) -> Option<[[f64; 2]; 2]> {
        let [rows, columns] = grid.size();
        let rim = (0..rows).flat_map(|row| [[row, 0], [row, columns - 1]]);
        let rim = rim.chain((0..columns).flat_map(|column| [[0, column], [rows - 1, column]]));
        let mut range = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for [row, column] in rim {
            let sample = self.sample(grid.place(row, column))?;
            range[0] = [0, 1].map(|axis| range[0][axis].min(sample[axis]));
            range[1] = [0, 1].map(|axis| range[1][axis].max(sample[axis]));
        }
        Some(range)
    }

    /// The window of a file that a grid needs; it may pass the seam of a globe. None where the file does not reach over the grid.
    pub fn window(file: &Opened, frame: Frame, grid: &Grid) -> Option<Window> {
        let middle = file.size().map(|count| 0.5 * (count as f64 - 1.0));
        let lay = Self::new(frame, file.frame(), file.affine(), file.size(), middle);
        let [low, high] = lay.range(grid)?;
        let cell = lay.samples_a_step([grid.north.resolution, grid.east.resolution])?;
        let around = cell.map(|cell| AROUND + cell);
        let turn = (TAU / lay.affine.step[1]).abs();
        let is_globe = matches!(lay.file, FileFrame::Geographic { .. }) && lay.size[1] as f64 > turn - 1.5;
        let first = |axis: usize| (low[axis] - around[axis]).floor();
        let last = |axis: usize| (high[axis] + around[axis]).ceil();
        let lines = cut(first(0), last(0), lay.size[0])?;
        if !is_globe || (first(1) >= 0.0 && last(1) < lay.size[1] as f64) || last(1) - first(1) >= turn {
            return Some(Window { lines, columns: cut(first(1), last(1), lay.size[1])? });
        }
        // The reader counts columns behind the seam on from its last one.
        let start = first(1) - turn * (first(1) / turn).floor();
        Some(Window { lines, columns: start as usize..(start + last(1) - first(1)) as usize + 1 })
    }
}

/// Samples from a first to a last that a file has; none where it has none of them.
fn cut(first: f64, last: f64, count: usize) -> Option<std::ops::Range<usize>> {
    let range = first.max(0.0) as usize..(last + 1.0).clamp(0.0, count as f64) as usize;
    (range.start < range.end).then_some(range)
}
