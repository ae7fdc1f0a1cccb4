//! Parallel rays away from the sun, each swept once: the height of the shadow is carried along a ray from line to line.
//!
//! Lines run across the axis that is nearer to the sun's azimuth, and two rays lie between neighbouring posts of a line. A ray takes
//! the ground between the two posts beside it; the shadow over a post is interpolated between the two rays beside the post, once. So
//! edges are uncertain by the distance between rays, and nothing blurs on the way.

use glam::DVec3;

use crate::grid::Axis;
use crate::heights::Heights;

/// Rays between two posts of nominal spacing (chosen): one alone misses peaks by up to half a cell.
const RAYS_A_POST: f64 = 2.0;

/// Posts that lie below the shadow, row by row.
pub fn shadows(heights: &Heights, sun: DVec3) -> Vec<bool> {
    let grid = heights.grid();
    let axis = usize::from(sun.y.abs() > sun.x.abs());
    let axes = [&grid.north, &grid.east];
    let (lines, posts) = (axes[axis], axes[1 - axis]);
    let [along, across] = if axis == 0 { [sun.x, sun.y] } else { [sun.y, sun.x] };
    let columns = grid.size()[1];
    let index =
        |line: usize, post: usize| if axis == 0 { line * columns + post } else { post * columns + line };

    let mut rays = Rays::new(lines, posts, across / along);
    let mut shadowed = vec![false; heights.values().len()];
    let mut before: Option<f64> = None;
    for step in 0..lines.posts() {
        let line = if along > 0.0 { lines.posts() - 1 - step } else { step };
        let place = lines.place(line);
        let ground: Vec<f64> = (0..posts.posts()).map(|post| heights.values()[index(line, post)]).collect();
        // The rise of the ray on the way from the line before.
        let drop = before.map_or(0.0, |before| (before - place) / along * sun.z);
        rays.go_on(place, drop, &ground);
        for (post, height) in ground.iter().enumerate() {
            shadowed[index(line, post)] = rays.shadow(place, rays.posts[post]) > *height;
        }
        before = Some(place);
    }
    shadowed
}

/// Rays side by side. Ray `k` crosses the line at `place` at `first + k / density + slant * place`.
struct Rays {
    posts: Vec<f64>,
    slant: f64,
    first: f64,
    density: f64,
    /// Height of the shadow on the line that was reached last.
    shadows: Vec<f64>,
    /// The higher of shadow and ground there.
    tops: Vec<f64>,
}

impl Rays {
    fn new(lines: &Axis, posts: &Axis, slant: f64) -> Self {
        let places: Vec<f64> = (0..posts.posts()).map(|post| posts.place(post)).collect();
        let ends = [lines.place(0), lines.place(lines.posts() - 1)].map(|place| slant * place);
        let first = places[0] - ends[0].max(ends[1]);
        let last = places[places.len() - 1] - ends[0].min(ends[1]);
        let density = RAYS_A_POST / posts.resolution;
        let count = ((last - first) * density).ceil() as usize + 1;
        let none = vec![f64::NEG_INFINITY; count];
        Self { posts: places, slant, first, density, shadows: none.clone(), tops: none }
    }

    /// Takes all rays to the next line.
    fn go_on(&mut self, place: f64, drop: f64, ground: &[f64]) {
        for ray in 0..self.tops.len() {
            let at = self.first + ray as f64 / self.density + self.slant * place;
            let ground = between(&self.posts, ground, at);
            self.shadows[ray] = self.tops[ray] - drop;
            self.tops[ray] = self.shadows[ray].max(ground);
        }
    }

    /// Height of the shadow (m) between the rays beside a place of the line; beside a ray that nothing shades, that of the nearer.
    fn shadow(&self, place: f64, at: f64) -> f64 {
        let ray = ((at - self.slant * place - self.first) * self.density).max(0.0);
        let low = (ray as usize).min(self.shadows.len() - 2);
        let share = ray - low as f64;
        let [left, right] = [self.shadows[low], self.shadows[low + 1]];
        if left.is_finite() && right.is_finite() {
            left + share * (right - left)
        } else if share < 0.5 {
            left
        } else {
            right
        }
    }
}

/// Height between posts; nothing outside them.
fn between(posts: &[f64], heights: &[f64], at: f64) -> f64 {
    let last = posts.len() - 1;
    if at < posts[0] || at > posts[last] {
        return f64::NEG_INFINITY;
    }
    let low = posts.partition_point(|place| *place <= at).clamp(1, last) - 1;
    let share = (at - posts[low]) / (posts[low + 1] - posts[low]);
    heights[low] + share * (heights[low + 1] - heights[low])
}
