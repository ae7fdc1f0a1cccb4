//! The elevations under a photograph, as a grid that anybody reads.

use std::fmt::Write;

use glam::DVec3;

use crate::Made;

/// Most posts of a grid; beyond it the posts stand farther apart (chosen).
const MOST_POSTS: f64 = 4e6;
/// Number that marks a post beside the ground.
const VOID: &str = "-99999";

/// Posts of a grid in the axes of the landscape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElevationGrid {
    /// Southernmost and westernmost post: north, east (m).
    pub first: [f64; 2],
    /// Number of posts to the north and to the east.
    pub posts: [usize; 2],
    /// Distance between posts (m).
    pub spacing: f64,
}

impl ElevationGrid {
    /// The grid over the ground that a photograph shows, its posts about `sample` (m) apart, one post farther on every side.
    pub fn over(made: &Made, sample: f64) -> Self {
        let [low, high] = extent(&made.ground);
        let size = high - low;
        let spacing = sample.max((size.x * size.y / MOST_POSTS).sqrt());
        let first = [low.y, low.x].map(|at| ((at / spacing).floor() - 1.0) * spacing);
        let last = [high.y, high.x].map(|at| ((at / spacing).ceil() + 1.0) * spacing);
        let posts = [0, 1].map(|axis| ((last[axis] - first[axis]) / spacing).round() as usize + 1);
        Self { first, posts, spacing }
    }

    /// Place of a post, counted to the north and to the east from the first: north, east (m).
    pub fn place(&self, [row, column]: [usize; 2]) -> [f64; 2] {
        [self.first[0] + row as f64 * self.spacing, self.first[1] + column as f64 * self.spacing]
    }

    /// An Arc ASCII grid of the ground's heights, to 0.1 mm; posts beside the ground are void.
    pub fn text(&self, made: &Made) -> String {
        let [rows, columns] = self.posts;
        let [north, east] = self.first;
        let mut text = format!(
            "ncols {columns}\nnrows {rows}\nxllcenter {east}\nyllcenter {north}\ncellsize {}\nNODATA_value {VOID}\n",
            self.spacing
        );
        for row in (0..rows).rev() {
            for column in 0..columns {
                let [x, y] = self.place([row, column]);
                let between = if column == 0 { "" } else { " " };
                let written = match made.landscape.height(x, y) {
                    Some(height) => write!(text, "{between}{height:.4}"),
                    None => write!(text, "{between}{VOID}"),
                };
                written.expect("a String takes everything");
            }
            text.push('\n');
        }
        text
    }
}

/// Lowest and highest east, north, up (m) of the ground points.
fn extent(ground: &[Option<DVec3>]) -> [DVec3; 2] {
    let none = [DVec3::INFINITY, DVec3::NEG_INFINITY];
    ground.iter().flatten().fold(none, |[low, high], point| [low.min(*point), high.max(*point)])
}
