//! The checkerboard of a pattern: squares on the ground, and their vertices.

use std::ops::Range;

use crate::error::{FaceError, within};
use crate::face::{Face, Shading, Vertex};
use crate::mesh::{Loaded, Mesh};

/// Squares of one side length, by rows and columns; numbers may be negative.
///
/// Column `c` stands at `c side` north, row `r` at `r side` east: patterns run along a row.
#[derive(Debug, Clone, PartialEq)]
pub struct Board {
    side: f64,
    rows: Range<i64>,
    columns: Range<i64>,
    ring: Option<[f64; 2]>,
}

/// A vertex of a board: its numbers and its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GridVertex {
    /// Row of the vertex.
    pub row: i64,
    /// Column of the vertex.
    pub column: i64,
    /// Place in the group's axes: north, east (m).
    pub place: [f64; 2],
}

/// Farthest row or column: products of numbers and sides stay exact enough, counts fit.
const FARTHEST: i64 = 1 << 30;

impl Board {
    /// Squares of `side` m.
    ///
    /// # Errors
    /// If the side is not above 0, there is no square, or a number is beyond 2^30.
    pub fn new(side: f64, rows: Range<i64>, columns: Range<i64>) -> Result<Self, FaceError> {
        within("side of a square (m)", side, side > 0.0, "above 0")?;
        for numbers in [&rows, &columns] {
            let count = numbers.end.saturating_sub(numbers.start);
            within("number of rows or columns", count as f64, count > 0, "1 or more")?;
            let far = numbers.start.saturating_abs().max(numbers.end.saturating_abs());
            within("number of a row or column", far as f64, far <= FARTHEST, "from -2^30 to 2^30")?;
        }
        Ok(Self { side, rows, columns, ring: None })
    }

    /// The same board, of which only squares show whose middle lies from `inner` to `outer` (m) off the origin: a ring of dust.
    ///
    /// # Errors
    /// If a radius is below 0, or the outer one is not above the inner one.
    pub fn ring(self, inner: f64, outer: f64) -> Result<Self, FaceError> {
        within("inner radius of a ring (m)", inner, inner >= 0.0, "0 or more")?;
        within("outer radius of a ring (m)", outer, outer > inner, "above the inner radius")?;
        Ok(Self { ring: Some([inner, outer]), ..self })
    }

    /// Whether a square shows: all do, unless the board is a ring.
    fn shows(&self, row: i64, column: i64) -> bool {
        self.ring.is_none_or(|[inner, outer]| {
            let [x, y] = [column, row].map(|number| (number as f64 + 0.5) * self.side);
            (inner * inner..=outer * outer).contains(&(x * x + y * y))
        })
    }

    /// Side of a square (m).
    pub fn side(&self) -> f64 {
        self.side
    }

    fn counts(&self) -> [u64; 2] {
        [&self.rows, &self.columns].map(|numbers| numbers.end.abs_diff(numbers.start))
    }

    /// Vertices of the whole board, corners shared.
    pub fn vertices(&self) -> u64 {
        let [rows, columns] = self.counts();
        (rows + 1) * (columns + 1)
    }

    /// Triangles of the whole board, two of each square.
    pub fn triangles(&self) -> u64 {
        let [rows, columns] = self.counts();
        2 * rows * columns
    }

    /// Edges of the whole board, one diagonal of each square included.
    pub fn edges(&self) -> u64 {
        let [rows, columns] = self.counts();
        rows * (columns + 1) + columns * (rows + 1) + rows * columns
    }

    /// The vertex of a row and a column: the same bits in boards of any extent.
    pub fn vertex(&self, row: i64, column: i64) -> GridVertex {
        GridVertex { row, column, place: [column as f64 * self.side, row as f64 * self.side] }
    }

    /// All vertices, row by row.
    pub fn grid(&self) -> impl Iterator<Item = GridVertex> {
        let columns = self.columns.clone();
        let in_row = move |row| (columns.start..=columns.end).map(move |column| self.vertex(row, column));
        (self.rows.start..=self.rows.end).flat_map(in_row)
    }

    /// Whole squares as smooth faces of one `colour`, with vertices by `vertex`.
    ///
    /// A square begins at the corner from which its fan gives the diagonal that alternates with row + column.
    ///
    /// # Errors
    /// As [`Mesh::limited`], with at most `most` squares.
    pub fn squares(
        &self,
        list: &str,
        colour: [f64; 3],
        most: usize,
        vertex: impl Fn(GridVertex) -> Vertex,
    ) -> Result<Loaded, FaceError> {
        self.check_most(list, self.triangles() / 2, most)?;
        let faces = self.corners().map(|corners| Face::smooth(corners.to_vec(), colour)).collect();
        Mesh::limited(list, self.grid().map(vertex).collect(), faces, most)
    }

    /// The same cut in triangles, so that vertices may have heights.
    ///
    /// # Errors
    /// As [`Mesh::limited`], with at most `most` triangles.
    pub fn cut(
        &self,
        list: &str,
        (colour, shading): ([f64; 3], Shading),
        most: usize,
        vertex: impl Fn(GridVertex) -> Vertex,
    ) -> Result<Loaded, FaceError> {
        self.check_most(list, self.triangles(), most)?;
        let halves = self.corners().flat_map(|[a, b, c, d]| [vec![a, b, c], vec![a, c, d]]);
        let faces = halves.map(|corners| Face { shading, ..Face::smooth(corners, colour) }).collect();
        Mesh::limited(list, self.grid().map(vertex).collect(), faces, most)
    }

    /// Refuses too many faces before they are made.
    fn check_most(&self, list: &str, found: u64, most: usize) -> Result<(), FaceError> {
        let found = usize::try_from(found).unwrap_or(usize::MAX);
        if found > most { Err(FaceError::TooMany { list: list.into(), found, most }) } else { Ok(()) }
    }

    /// Corners of each square, counter-clockwise seen from above, from the corner at which its diagonal begins.
    fn corners(&self) -> impl Iterator<Item = [u32; 4]> {
        let width = self.counts()[1] as u32 + 1;
        let square = move |row: i64, column: i64| {
            let first =
                self.rows.start.abs_diff(row) as u32 * width + self.columns.start.abs_diff(column) as u32;
            let [a, b, c, d] = [first, first + width, first + width + 1, first + 1];
            if (row + column) % 2 == 0 { [a, b, c, d] } else { [b, c, d, a] }
        };
        let numbers = self.rows.clone().flat_map(|row| self.columns.clone().map(move |column| (row, column)));
        numbers.filter(|&(row, column)| self.shows(row, column)).map(move |(row, column)| square(row, column))
    }
}
