//! Fence fill: pixels between each edge and one fence are inverted; what lies in the triangle is inverted once, all else twice or never.

use raster::Point;

use super::edges::Edge;
use super::{Buffer, PixelBox};

pub(super) fn mark(corners: [Point; 3], pixels: &PixelBox, buffer: &mut Buffer) {
    // The fence stands in the middle of the box, where the edges are near it on both sides.
    let fence = (pixels.low[0] + pixels.high[0]) / 2;
    for edge in Edge::of(corners) {
        let rows = edge.rows();
        for row in rows.start.max(pixels.low[1])..rows.end.min(pixels.high[1]) {
            let at = pixels.clamp(edge.crossing(row));
            buffer.invert(row, at.min(fence)..at.max(fence));
        }
    }
}
