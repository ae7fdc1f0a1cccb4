//! What a reader gives: heights on a grid, with the place of each sample.

use std::path::PathBuf;

use landscape::projection::Projection;

use crate::fill::fill_grid;
use crate::read::stretch::Window;

/// How grid coordinates are meant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Frame {
    /// Metres north and east; with the projection, if the file names one that is known here.
    Plane(Option<Projection>),
    /// Latitude and longitude (rad) on a sphere.
    Geographic {
        /// Radius of the sphere (m).
        radius: f64,
    },
}

impl Frame {
    /// Radius of the sphere that the coordinates lie on (m); `None` for a plane whose projection is not known.
    pub fn sphere(&self) -> Option<f64> {
        match self {
            Self::Plane(projection) => projection.map(|projection| projection.radius),
            Self::Geographic { radius } => Some(*radius),
        }
    }
}

/// Where the samples lie: north or latitude first, east or longitude second (m or rad, see [`Frame`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Affine {
    /// Centre of the sample at line 0, column 0.
    pub first: [f64; 2],
    /// From line to line and from column to column; the first is negative where line 0 is the northernmost.
    pub step: [f64; 2],
}

/// Number and place of the samples of a file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Grid {
    pub lines: usize,
    pub columns: usize,
    pub affine: Affine,
    pub frame: Frame,
}

impl Grid {
    /// Coordinates of a sample (m or rad, see [`Frame`]).
    pub fn place(&self, line: usize, column: usize) -> [f64; 2] {
        let Affine { first, step } = self.affine;
        [first[0] + line as f64 * step[0], first[1] + column as f64 * step[1]]
    }

    /// South, west, north, east edge: centres of the outermost samples (m or rad).
    pub fn extent(&self) -> [f64; 4] {
        let (a, b) = (self.place(0, 0), self.place(self.lines - 1, self.columns - 1));
        [a[0].min(b[0]), a[1].min(b[1]), a[0].max(b[0]), a[1].max(b[1])]
    }

    /// Columns that go once around the sphere: all of them, or all but a last one that stands for the first again. `None`
    /// if the columns go less or further around.
    pub fn turn(&self) -> Option<usize> {
        let is_turn = |columns: &usize| {
            let apart = (*columns as f64 * self.affine.step[1]).abs() - 2.0 * std::f64::consts::PI;
            apart.abs() < 1e-3 * self.affine.step[1].abs()
        };
        let geographic = matches!(self.frame, Frame::Geographic { .. });
        [self.columns, self.columns - 1].into_iter().find(|columns| geographic && is_turn(columns))
    }
}

/// An elevation file, or a window of one, in memory.
#[derive(Debug, Clone)]
pub struct Elevation {
    /// Lines, from the first stored.
    pub lines: usize,
    /// Number of samples a line.
    pub columns: usize,
    /// Line and column of the file where line 0 and column 0 stand: not 0 for a window of it.
    pub corner: [usize; 2],
    /// Lines of the whole file and samples of a line.
    pub file_size: [usize; 2],
    /// Place of the samples.
    pub affine: Affine,
    /// Meaning of the places.
    pub frame: Frame,
    /// What the heights are, for people.
    pub title: String,
    /// Paths of the files that were read.
    pub sources: Vec<PathBuf>,
    /// What the reader had to assume.
    pub notes: Vec<String>,
    /// Heights (m), line by line; NaN is a void. Private: a void must not be averaged by accident.
    heights: Vec<f64>,
}

impl Elevation {
    /// From heights line by line, NaN where void. `heights.len()` must be `lines * columns`; missing ones are void.
    pub fn new(lines: usize, columns: usize, mut heights: Vec<f64>, affine: Affine, frame: Frame) -> Self {
        heights.resize(lines * columns, f64::NAN);
        let (title, sources, notes) = (String::new(), Vec::new(), Vec::new());
        let file_size = [lines, columns];
        Self { lines, columns, corner: [0; 2], file_size, affine, frame, title, sources, notes, heights }
    }

    /// A window of a file on `grid`, with heights as [`Elevation::new`] takes them.
    pub(crate) fn of_window(
        grid: Grid,
        window: &Window,
        heights: Vec<f64>,
        title: String,
        sources: Vec<PathBuf>,
        notes: Vec<String>,
    ) -> Self {
        let corner = [window.lines.start, window.columns.start];
        let affine = Affine { first: grid.place(corner[0], corner[1]), ..grid.affine };
        let whole = Self::new(window.lines.len(), window.columns.len(), heights, affine, grid.frame);
        let file_size = [grid.lines, grid.columns];
        Self { corner, file_size, title, sources, notes, ..whole }
    }

    /// Number and place of the samples.
    pub(crate) fn grid(&self) -> Grid {
        Grid { lines: self.lines, columns: self.columns, affine: self.affine, frame: self.frame }
    }

    /// Height of a sample (m); `None` for a void and outside the grid.
    pub fn height(&self, line: usize, column: usize) -> Option<f64> {
        if line >= self.lines || column >= self.columns {
            return None;
        }
        let height = self.heights[line * self.columns + column];
        (!height.is_nan()).then_some(height)
    }

    /// Number of samples that are void.
    pub fn voids(&self) -> usize {
        self.heights.iter().filter(|height| height.is_nan()).count()
    }

    /// The same heights with every void filled nearly harmonically from the samples around it. The columns of a globe are not joined.
    pub fn filled(&self) -> Self {
        let mut filled = self.clone();
        fill_grid(&mut filled.heights, [self.lines, self.columns]);
        filled
    }

    /// Lowest and highest sample (m); `None` if all are void.
    pub fn range(&self) -> Option<[f64; 2]> {
        let held = self.heights.iter().filter(|height| !height.is_nan());
        held.fold(None, |range: Option<[f64; 2]>, &height| {
            let [low, high] = range.unwrap_or([height; 2]);
            Some([low.min(height), high.max(height)])
        })
    }

    /// Coordinates of a sample (m or rad, see [`Frame`]).
    pub fn place(&self, line: usize, column: usize) -> [f64; 2] {
        self.grid().place(line, column)
    }

    /// South, west, north, east edge: centres of the outermost samples (m or rad).
    pub fn extent(&self) -> [f64; 4] {
        self.grid().extent()
    }

    /// Lines whose last column stands for the first again but has another height.
    pub(crate) fn seams(&self) -> usize {
        let last = self.columns - 1;
        let differs = |line: &usize| self.height(*line, 0) != self.height(*line, last);
        if self.grid().turn() == Some(last) { (0..self.lines).filter(differs).count() } else { 0 }
    }

    /// Whether every height is a whole number: so files look that hold another unit than the metre.
    pub fn is_whole(&self) -> bool {
        let whole = |line, column| self.height(line, column).is_none_or(|height| height.floor() == height);
        (0..self.lines).all(|line| (0..self.columns).all(|column| whole(line, column)))
    }
}
