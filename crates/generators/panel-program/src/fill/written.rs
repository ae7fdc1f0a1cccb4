//! The fill of the listing (FRAMEFIL): whole-number corners, and both ends of a span.

use super::FillWork;
use crate::real::Real;

/// What filling panels takes, counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct WrittenFill {
    /// Buckets and words of the active edge list that were cleared: those of every panel that is filled.
    pub buckets: u64,
    /// Cells of the boxes of panels: each is cleared once and looked at once.
    pub boxed: u64,
    /// Cells that were marked; a depth is found for each.
    pub marked: u64,
}

impl WrittenFill {
    /// The same in the words of all ways to fill, with `cells` of the screen's buffers that were cleared before.
    pub(crate) fn as_fill_work(self, cells: u64) -> FillWork {
        let Self { buckets, boxed, marked } = self;
        FillWork { cleared: cells + buckets + boxed, marked, scanned: boxed, tested: 0, found: marked }
    }
}

/// Words of the active edge list: four of each of three lines.
const EDGE_WORDS: u64 = 12;

/// An entry of the active edge list.
#[derive(Debug, Clone, Copy)]
struct Line {
    /// Column at the line's highest row.
    intercept: f64,
    /// Change of the column from a row to the one before it.
    delta_i: f64,
    /// Rows that are left.
    delta_j: f64,
}

/// Calls `each` for the pixels (column, row; whole numbers) of a panel with whole-number corners. Rows go from the highest to the lowest. `lines` is how
/// many buckets the listing clears. A panel of a single row has no line, and no pixel.
pub(crate) fn fill(
    corners: [[i64; 2]; 3],
    lines: usize,
    real: Real,
    work: &mut WrittenFill,
    mut each: impl FnMut(i64, i64),
) {
    let ends = |axis: usize| {
        let along = corners.map(|corner| corner[axis]);
        [along[0].min(along[1]).min(along[2]), along[0].max(along[1]).max(along[2])]
    };
    let ([left, right], [top, bottom]) = (ends(0), ends(1));
    let cells = ((right - left + 1) * (bottom - top + 1)) as u64;
    work.buckets += lines as u64 + EDGE_WORDS;
    work.boxed += cells;
    let lines = lines_of(corners, real);
    let mut waiting: Vec<([i64; 2], Line)> = lines.into_iter().flatten().collect();
    // The listing takes the two lines that begin in the highest row, in their order.
    let mut take = |row: i64| {
        let at = waiting.iter().position(|(rows, _)| rows[1] == row)?;
        Some(waiting.remove(at).1)
    };
    let (Some(mut first), Some(mut second)) = (take(bottom), take(bottom)) else { return };
    let mut at = [first.intercept, second.intercept];
    for row in (top..=bottom).rev() {
        if row < bottom {
            match take(row) {
                None => at = [at[0] + first.delta_i, at[1] + second.delta_i],
                Some(next) if first.delta_j <= 0.0 => {
                    at = [next.intercept, at[1] + second.delta_i];
                    first = next;
                }
                Some(next) => {
                    at = [at[0] + first.delta_i, next.intercept];
                    second = next;
                }
            }
            at = at.map(|column| real.of(column));
        }
        let [from, to] = [at[0].min(at[1]), at[0].max(at[1])].map(|column| column.round() as i64);
        for column in from..=to {
            work.marked += 1;
            each(column, row);
        }
        first.delta_j -= 1.0;
        second.delta_j -= 1.0;
    }
}

/// The lines of a panel with their lowest and highest rows, in the order of the listing; horizontal ones are left out.
fn lines_of(corners: [[i64; 2]; 3], real: Real) -> [Option<([i64; 2], Line)>; 3] {
    [0, 1, 2].map(|k| {
        let (one, other) = (corners[k], corners[(k + 1) % 3]);
        let (high, low) = if one[1] >= other[1] { (one, other) } else { (other, one) };
        let delta_j = high[1] - low[1];
        (delta_j != 0).then(|| {
            let delta_i = real.of(-((high[0] - low[0]) as f64) / delta_j as f64);
            let line = Line { intercept: high[0] as f64, delta_i, delta_j: delta_j as f64 };
            ([low[1], high[1]], line)
        })
    })
}
