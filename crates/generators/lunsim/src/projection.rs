//! Projection of the grid to the plotting positions, from far to near (block 14).

use rayon::prelude::*;

use crate::grid::{Cover, Grid};
use crate::observer::Observer;

/// Plotting positions of the SC 4020 on a side.
pub const POSITIONS: usize = 1024;

/// No point is seen at a position.
pub(crate) const SKY: u32 = u32::MAX;

/// The point of the grid that is seen at each plotting position.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Plot {
    /// Positions in a line and lines: square positions, the longer side [`POSITIONS`] of them.
    pub size: [usize; 2],
    /// Index of the point, column by column from the left, each from the top; or [`SKY`].
    pub seen: Vec<u32>,
    /// Points of the grid that were projected.
    pub projected: u64,
    /// Positions that were written, each as often as it was.
    pub written: u64,
}

/// Where a row of the grid crosses a column of positions.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    /// Line, or the one above the first or below the last for all that lie farther.
    line: i32,
    /// Index of the point.
    point: u32,
}

impl Plot {
    /// Positions for a field of view of these half tangents: width, height.
    fn size(half_field: [f64; 2]) -> [usize; 2] {
        let longer = half_field[0].max(half_field[1]);
        half_field.map(|half| ((POSITIONS as f64 * half / longer).round() as usize).max(1))
    }

    /// Makes a plot of nothing but sky.
    pub fn blank(observer: &Observer) -> Self {
        let size = Self::size(observer.half_field);
        Self { size, seen: vec![SKY; size[0] * size[1]], projected: 0, written: 0 }
    }

    /// Projects `grid`: every row by itself, then every column of positions from the farthest row to the nearest.
    pub fn new(grid: &Grid, observer: &Observer) -> Self {
        let mut plot = Self::blank(observer);
        let [columns, lines] = plot.size;
        let (rows, projected): (Vec<Vec<Crossing>>, Vec<u64>) =
            (0..grid.size).into_par_iter().map(|row| crossings(grid, observer, row, plot.size)).unzip();
        plot.projected = projected.iter().sum();
        let column =
            |(seen, column): (&mut [u32], usize)| overwrite(seen, rows.iter().rev().map(|row| row[column]));
        plot.written = plot.seen.par_chunks_mut(lines).zip(0..columns).map(column).sum();
        plot
    }
}

/// Line of positions, of `lines` over twice `half_height`, at `y` (down) of the view-plane: -1 for all that lies above the
/// first, `lines` for all below the last.
pub(crate) fn line(y: f64, half_height: f64, lines: usize) -> i32 {
    (0.5 * (y / half_height + 1.0) * lines as f64).floor().clamp(-1.0, lines as f64) as i32
}

/// Where a row crosses each column of positions: at the point whose projection lies nearest to the column's middle. And
/// how many of its points were projected.
fn crossings(
    grid: &Grid,
    observer: &Observer,
    row: usize,
    [columns, lines]: [usize; 2],
) -> (Vec<Crossing>, u64) {
    let project = |column: usize| {
        let index = row * grid.size + column;
        let place = grid.place(row, column);
        let [x, y] = observer.project(place, grid.heights[index] - observer.eye[2])?;
        (grid.covers[index] != Cover::Nothing).then_some((x, y, index as u32))
    };
    let points: Vec<_> = (0..grid.size).filter_map(project).collect();
    let [half_width, half_height] = observer.half_field;
    let mut nearest = 0;
    let crossing = |column: usize| {
        let middle = half_width * ((2 * column + 1) as f64 / columns as f64 - 1.0);
        let off = |at: usize| (points[at].0 - middle).abs();
        while nearest + 1 < points.len() && off(nearest + 1) <= off(nearest) {
            nearest += 1;
        }
        let (x, y, point) = *points.get(nearest)?;
        // Beside the ends of a row there is no ground: half a spacing, or half a position.
        let beside = [nearest.checked_sub(1), Some(nearest + 1)];
        let spacing = beside.into_iter().flatten().filter_map(|at| points.get(at)).map(|p| (p.0 - x).abs());
        let reach = 0.5 * spacing.fold(2.0 * half_width / columns as f64, f64::max);
        ((x - middle).abs() <= reach).then(|| Crossing { line: line(y, half_height, lines), point })
    };
    let found = (0..columns).map(crossing).map(|found| found.unwrap_or(Crossing { line: 0, point: SKY }));
    (found.collect(), points.len() as u64)
}

/// Writes the rows of one column of positions, the farthest first: nearer points overwrite farther ones, which is all
/// that occlusion takes. Positions between two rows show the farther of them. Tells how often a position was written.
fn overwrite(seen: &mut [u32], rows: impl Iterator<Item = Crossing>) -> u64 {
    let mut written = 0;
    let lines = seen.len() as i32;
    let mut before: Option<Crossing> = None;
    for row in rows.filter(|row| row.point != SKY) {
        if let Some(before) = before {
            for line in (before.line + 1).max(0)..row.line.min(lines) {
                seen[line as usize] = before.point;
                written += 1;
            }
        }
        if (0..lines).contains(&row.line) {
            seen[row.line as usize] = row.point;
            written += 1;
        }
        before = Some(row);
    }
    written
}

#[cfg(test)]
mod tests {
    use super::{Crossing, POSITIONS, Plot, SKY, overwrite};

    #[test]
    fn positions_are_square() {
        assert_eq!(Plot::size([0.3, 0.3]), [POSITIONS, POSITIONS]);
        assert_eq!(Plot::size([0.4, 0.2]), [1024, 512]);
        assert_eq!(Plot::size([0.1, 0.4]), [256, 1024]);
    }

    /// From far to near: a plain down to line 2, a valley that falls back behind a crest, and the near slope.
    #[test]
    fn near_rows_overwrite_far_ones_and_gaps_show_the_row_before() {
        let row = |line: i32, point: u32| Crossing { line, point };
        let mut seen = vec![SKY; 8];
        let rows = [row(1, 0), row(2, 1), row(5, 2), row(3, 3), row(6, 4), row(9, 5)];
        // Lines 1, 2, 3 to 5, 3, 4 to 6, 7.
        assert_eq!(overwrite(&mut seen, rows.into_iter()), 10);
        assert_eq!(seen, [SKY, 0, 1, 3, 3, 3, 4, 4]);
        // What lies above the picture or is missing leaves no mark of its own.
        let mut seen = vec![SKY; 4];
        overwrite(&mut seen, [row(-1, 7), row(0, SKY), row(2, 8)].into_iter());
        assert_eq!(seen, [7, 7, 8, SKY]);
    }
}
