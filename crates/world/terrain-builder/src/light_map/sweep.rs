//! The height of the shadow, carried from line to line away from the sun.
//!
//! Lines run across the axis that is nearer to the sun's azimuth. At each post the ray towards the sun meets the line before between
//! two posts; the higher of ground and shadow there, less the rise of the ray on the way, is the shadow's height at the post.

use glam::DVec3;

use crate::heights::Heights;

/// Posts that lie below the shadow, row by row.
pub fn shadows(heights: &Heights, sun: DVec3) -> Vec<bool> {
    let grid = heights.grid();
    let size = grid.size();
    let axis = usize::from(sun.y.abs() > sun.x.abs());
    let [lines, posts] = [size[axis], size[1 - axis]];
    let axes = [&grid.north, &grid.east];
    let places: Vec<f64> = (0..posts).map(|post| axes[1 - axis].place(post)).collect();
    let [along, across] = if axis == 0 { [sun.x, sun.y] } else { [sun.y, sun.x] };
    let index =
        |line: usize, post: usize| if axis == 0 { line * size[1] + post } else { post * size[1] + line };

    let mut shadowed = vec![false; size[0] * size[1]];
    let mut before: Option<Line> = None;
    for step in 0..lines {
        let line = if along > 0.0 { lines - 1 - step } else { step };
        let mut tops: Vec<f64> = (0..posts).map(|post| heights.values()[index(line, post)]).collect();
        let place = axes[axis].place(line);
        if let Some(before) = &before {
            // Parts of the sun's vector that the way to the line before takes.
            let parts = (before.place - place) / along;
            for post in 0..posts {
                let shadow = before.top(&places, places[post] + parts * across) - parts * sun.z;
                shadowed[index(line, post)] = shadow > tops[post];
                tops[post] = tops[post].max(shadow);
            }
        }
        before = Some(Line { place, tops });
    }
    shadowed
}

/// The higher of ground and shadow along a line.
struct Line {
    place: f64,
    tops: Vec<f64>,
}

impl Line {
    /// Height (m) at a place of the line; nothing shades from outside the grid.
    fn top(&self, places: &[f64], at: f64) -> f64 {
        let last = places.len() - 1;
        if at < places[0] || at > places[last] {
            return f64::NEG_INFINITY;
        }
        let low = places.partition_point(|place| *place <= at).clamp(1, last) - 1;
        let share = (at - places[low]) / (places[low + 1] - places[low]);
        self.tops[low] + share * (self.tops[low + 1] - self.tops[low])
    }
}
