//! A regular grid of posts, cut into triangles.

use crate::SightError;
use crate::error::within;
use crate::pyramid::Pyramid;

/// Share of the spacing within which a place counts as on a row or column of posts, so that the place of a post is that post.
/// Chosen: far above rounding, far below a figure of use.
const SNAP: f64 = 1e-9;

/// Heights at the posts of a regular grid. Each cell is cut from its north-western to its south-eastern post into two triangles.
///
/// Rows run from north to south, columns from west to east. A height of NaN is a void: the triangles at this post have no ground.
#[derive(Debug, Clone)]
pub struct Posts {
    /// How many rows and columns there are.
    size: [usize; 2],
    /// Place of the north-western post: north, east (m).
    corner: [f64; 2],
    /// Distance from post to post (m).
    spacing: f64,
    heights: Vec<f64>,
    pyramid: Pyramid,
}

impl Posts {
    /// Posts from the heights (m) row by row, the place of the north-western post (north, east, m) and the spacing (m).
    ///
    /// # Errors
    /// A shape that does not fit, an infinite height, a corner or a spacing out of range.
    pub fn new(
        size: [usize; 2],
        corner: [f64; 2],
        spacing: f64,
        heights: Vec<f64>,
    ) -> Result<Self, SightError> {
        let [rows, columns] = size;
        if rows < 2 || columns < 2 || rows.checked_mul(columns) != Some(heights.len()) {
            return Err(SightError::Shape { rows, columns, heights: heights.len() });
        }
        if let Some(at) = heights.iter().position(|height| height.is_infinite()) {
            return Err(SightError::Infinite { row: at / columns, column: at % columns, found: heights[at] });
        }
        within("spacing of the posts (m)", spacing, spacing > 0.0, "a finite number above 0")?;
        for place in corner {
            within("place of the north-western post (m)", place, true, "a finite number")?;
        }
        let pyramid = Pyramid::new(size, &heights);
        Ok(Self { size, corner, spacing, heights, pyramid })
    }

    /// The mesh of every 2^`level`-th post.
    ///
    /// # Errors
    /// A stride that leaves out the last row or column.
    pub fn level(&self, level: u32) -> Result<Self, SightError> {
        let [rows, columns] = self.size;
        let stride = 1usize.checked_shl(level).unwrap_or(usize::MAX);
        if !(rows - 1).is_multiple_of(stride) || !(columns - 1).is_multiple_of(stride) {
            return Err(SightError::Level { level, stride, rows, columns });
        }
        let size = self.size.map(|count| (count - 1) / stride + 1);
        let row_of =
            |row: usize| (0..size[1]).map(move |column| self.heights[(row * columns + column) * stride]);
        let heights = (0..size[0]).flat_map(row_of).collect();
        Self::new(size, self.corner, self.spacing * stride as f64, heights)
    }

    /// Rows and columns of posts.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Distance from post to post (m).
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Place of the north-western post: north, east (m).
    pub fn corner(&self) -> [f64; 2] {
        self.corner
    }

    /// Height (m) of a post; NaN is a void.
    pub fn post(&self, row: usize, column: usize) -> f64 {
        self.heights[row * self.size[1] + column]
    }

    /// Place of a post: north, east (m).
    pub fn place(&self, row: usize, column: usize) -> [f64; 2] {
        self.place_of([row as f64, column as f64])
    }

    /// Height (m) of the triangle at a place (north, east, m); `None` off the mesh and where a corner of the triangle is a void.
    pub fn height(&self, place: [f64; 2]) -> Option<f64> {
        let at = self.in_posts(place);
        let inside = (0..2).all(|axis| at[axis] >= 0.0 && at[axis] <= (self.size[axis] - 1) as f64);
        let height = inside.then(|| {
            let cell = [0, 1].map(|axis| (at[axis] as usize).min(self.size[axis] - 2));
            self.in_cell(0, cell, [at[0] - cell[0] as f64, at[1] - cell[1] as f64])
        })?;
        (!height.is_nan()).then_some(height)
    }

    /// Row and column, as real numbers, of a place (m). A place within [`SNAP`] of a row or column of posts counts as on it.
    pub(crate) fn in_posts(&self, place: [f64; 2]) -> [f64; 2] {
        let at = [(self.corner[0] - place[0]) / self.spacing, (place[1] - self.corner[1]) / self.spacing];
        at.map(|at| if (at - at.round()).abs() < SNAP { at.round() } else { at })
    }

    /// Place (m) of a row and a column.
    pub(crate) fn place_of(&self, at: [f64; 2]) -> [f64; 2] {
        [self.corner[0] - at[0] * self.spacing, self.corner[1] + at[1] * self.spacing]
    }

    /// Highest post (m) of a block, infinite where it has a void; `main` is the axis that `block` begins with.
    pub(crate) fn highest(&self, main: usize, level: usize, block: [usize; 2]) -> f64 {
        self.pyramid.highest(level, if main == 0 { block } else { [block[1], block[0]] })
    }

    /// Number of levels of blocks above the cells.
    pub(crate) fn block_levels(&self) -> usize {
        self.pyramid.levels()
    }

    /// Height (m) in a cell at shares (0..=1) along both axes, the first of which is `main`; NaN where a post that counts is a void.
    pub(crate) fn in_cell(&self, main: usize, [i, j]: [usize; 2], [u, v]: [f64; 2]) -> f64 {
        let steps = if main == 0 { [self.size[1], 1] } else { [1, self.size[1]] };
        let first = i * steps[0] + j * steps[1];
        let last = first + steps[0] + steps[1];
        let middle = first + if u >= v { steps[0] } else { steps[1] };
        let (most, least) = if u >= v { (u, v) } else { (v, u) };
        let share = |post: usize, weight: f64| if weight == 0.0 { 0.0 } else { weight * self.heights[post] };
        share(first, 1.0 - most) + share(middle, most - least) + share(last, least)
    }
}
