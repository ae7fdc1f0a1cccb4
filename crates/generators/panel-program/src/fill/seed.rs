//! Seed fill: a first pixel inside, then its neighbours.
//!
//! Centres in a thin triangle do not all touch. A row that no neighbour has reached is searched for a seed of its own.

use raster::Point;

use super::edges::Edge;
use super::span::ends;
use super::{Buffer, PixelBox};

pub(super) fn mark(corners: [Point; 3], pixels: &PixelBox, buffer: &mut Buffer) {
    let edges = Edge::of(corners);
    let mut stack = Vec::new();
    for row in pixels.rows() {
        let is_reached = pixels.columns().any(|column| {
            buffer.work.scanned += 1;
            buffer.is_set(column, row)
        });
        if is_reached {
            continue;
        }
        let seed = pixels.columns().find(|column| is_inside(&edges, [*column, row], buffer));
        stack.extend(seed.map(|column| [column, row]));
        while let Some([column, row]) = stack.pop() {
            if buffer.is_set(column, row) {
                continue;
            }
            buffer.set(column, row);
            let around = [[column - 1, row], [column + 1, row], [column, row - 1], [column, row + 1]];
            for beside in around {
                let [column, row] = beside;
                let is_in_box = pixels.columns().contains(&column) && pixels.rows().contains(&row);
                if is_in_box && !buffer.is_set(column, row) && is_inside(&edges, beside, buffer) {
                    stack.push(beside);
                }
            }
        }
    }
}

/// Whether a pixel's centre lies in the triangle.
fn is_inside(edges: &[Edge; 3], [column, row]: [i64; 2], buffer: &mut Buffer) -> bool {
    buffer.work.tested += 1;
    let [from, to] = ends(edges, row);
    (from..to).contains(&column)
}
