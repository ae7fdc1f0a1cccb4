//! Edge buffer: edges in buckets by their lowest row, rows from there upward, two active edges at a time.

use raster::Point;

use super::edges::Edge;
use super::{Buffer, PixelBox};

pub(super) fn mark(corners: [Point; 3], pixels: &PixelBox, lines: usize, buffer: &mut Buffer) {
    let edges = Edge::of(corners);
    // The listing clears a bucket for every line of the screen.
    let mut buckets = vec![[None::<usize>; 2]; lines];
    buffer.work.cleared += lines as u64;
    for (number, edge) in edges.iter().enumerate() {
        let rows = edge.rows();
        let last = rows.end.min(pixels.high[1]) - 1;
        if rows.is_empty() || last < rows.start || last < pixels.low[1] {
            continue;
        }
        let bucket = &mut buckets[last as usize];
        let free = usize::from(bucket[0].is_some());
        bucket[free] = Some(number);
    }
    let mut active: Vec<usize> = Vec::with_capacity(3);
    for row in pixels.rows().rev() {
        active.retain(|number| edges[*number].rows().contains(&row));
        active.extend(buckets[row as usize].iter().flatten());
        let columns = active.iter().map(|number| pixels.clamp(edges[*number].crossing(row)));
        let [from, to] = columns.fold([i64::MAX, i64::MIN], |[low, high], at| [low.min(at), high.max(at)]);
        (from..to).for_each(|column| buffer.set(column, row));
    }
}
