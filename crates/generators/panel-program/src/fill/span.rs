//! From edge to edge in each row.

use raster::Point;

use super::edges::Edge;
use super::{FillWork, PixelBox};

/// Columns of a row that lie between its edges: the first, and the one behind the last. Both are equal where there are none.
pub(crate) fn ends(edges: &[Edge; 3], row: i64) -> [i64; 2] {
    let crossed = edges.iter().filter(|edge| edge.rows().contains(&row));
    crossed.fold([i64::MAX, i64::MIN], |[low, high], edge| {
        let at = edge.crossing(row);
        [low.min(at), high.max(at)]
    })
}

pub(super) fn fill(
    corners: [Point; 3],
    pixels: &PixelBox,
    work: &mut FillWork,
    mut each: impl FnMut(usize, usize),
) {
    let edges = Edge::of(corners);
    for row in pixels.rows() {
        let [from, to] = ends(&edges, row).map(|column| pixels.clamp(column));
        for column in from..to {
            work.found += 1;
            each(column as usize, row as usize);
        }
    }
}
