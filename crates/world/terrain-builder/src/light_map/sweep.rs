//! Parallel rays away from the sun, each swept once: the height of the shadow is carried along a ray from line to line.
//!
//! Lines run across the axis that is nearer to the sun's azimuth, and two rays lie between neighbouring posts of a line. A ray takes
//! the ground between the two posts beside it; the shadow over a post is interpolated between the two rays beside the post, once. So
//! edges are uncertain by the distance between rays, and nothing blurs on the way.
//!
//! Threads take strips of rays. A post belongs to the strip of the ray before it.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use crate::grid::Axis;
use crate::heights::Heights;

/// Rays between two posts of nominal spacing (chosen): one alone misses peaks by up to half a cell.
const RAYS_A_POST: f64 = 2.0;
/// Rays of a strip (chosen): some strips for each thread, and few rays that two strips sweep.
const STRIP: usize = 128;

/// Posts that lie below the shadow, row by row.
pub fn shadows(heights: &Heights, sun: DVec3) -> Vec<bool> {
    let field = Field::new(heights, sun);
    let shadowed: Vec<AtomicBool> = heights.values().iter().map(|_| AtomicBool::new(false)).collect();
    let strips = (field.rays - 1).div_ceil(STRIP);
    (0..strips).into_par_iter().for_each(|strip| {
        let rays = strip * STRIP..((strip + 1) * STRIP).min(field.rays - 1);
        field.sweep(rays, |index| shadowed[index].store(true, Ordering::Relaxed));
    });
    shadowed.into_iter().map(AtomicBool::into_inner).collect()
}

/// Ground with rays side by side. Ray `k` crosses the line at `place` at `first + k / density + slant * place`.
struct Field<'h> {
    heights: &'h Heights,
    /// Places of the lines and of the posts of a line (m).
    lines: Vec<f64>,
    posts: Vec<f64>,
    /// Steps in the heights from line to line and from post to post.
    strides: [usize; 2],
    /// Sun along the lines' axis and upwards, as shares of its unit vector.
    along: f64,
    up: f64,
    slant: f64,
    first: f64,
    density: f64,
    rays: usize,
}

impl<'h> Field<'h> {
    fn new(heights: &'h Heights, sun: DVec3) -> Self {
        let grid = heights.grid();
        let axis = usize::from(sun.y.abs() > sun.x.abs());
        let axes = [&grid.north, &grid.east];
        let places = |axis: &Axis| (0..axis.posts()).map(|post| axis.place(post)).collect::<Vec<_>>();
        let [lines, posts] = [axes[axis], axes[1 - axis]].map(places);
        let [along, across] = if axis == 0 { [sun.x, sun.y] } else { [sun.y, sun.x] };
        let columns = grid.size()[1];
        let strides = if axis == 0 { [columns, 1] } else { [1, columns] };
        let slant = across / along;
        let ends = [lines[0], lines[lines.len() - 1]].map(|place| slant * place);
        let first = posts[0] - ends[0].max(ends[1]);
        let last = posts[posts.len() - 1] - ends[0].min(ends[1]);
        let density = RAYS_A_POST / axes[1 - axis].resolution;
        let rays = ((last - first) * density).ceil() as usize + 1;
        Self { heights, lines, posts, strides, along, up: sun.z, slant, first, density, rays }
    }

    /// Sweeps some rays and the one behind them, and calls `mark` for each post of theirs in shadow.
    fn sweep(&self, rays: Range<usize>, mark: impl Fn(usize)) {
        let count = rays.len() + 1;
        let mut swept = Swept {
            first: rays.start,
            shadows: vec![f64::NEG_INFINITY; count],
            tops: vec![f64::NEG_INFINITY; count],
            cells: vec![0; count],
        };
        let mut before: Option<f64> = None;
        for step in 0..self.lines.len() {
            let line = if self.along > 0.0 { self.lines.len() - 1 - step } else { step };
            let place = self.lines[line];
            // The rise of the ray on the way from the line before.
            let drop = before.map_or(0.0, |before| (before - place) / self.along * self.up);
            swept.go_on(self, line, drop);
            for post in self.posts_behind(&rays, place) {
                let index = self.index(line, post);
                if swept.shadow(self.ray_at(place, post)) > self.heights.values()[index] {
                    mark(index);
                }
            }
            before = Some(place);
        }
    }

    fn index(&self, line: usize, post: usize) -> usize {
        line * self.strides[0] + post * self.strides[1]
    }

    /// Where a post lies among the rays on the line at `place`.
    fn ray_at(&self, place: f64, post: usize) -> f64 {
        ((self.posts[post] - self.slant * place - self.first) * self.density).max(0.0)
    }

    /// The last ray before a post, one less than the last ray of all at most.
    fn ray_before(&self, place: f64, post: usize) -> usize {
        (self.ray_at(place, post) as usize).min(self.rays - 2)
    }

    /// Posts of the line at `place` before which some rays are the last ones.
    fn posts_behind(&self, rays: &Range<usize>, place: f64) -> Range<usize> {
        let all: Range<usize> = 0..self.posts.len();
        let first_of = |ray: usize| {
            let [mut low, mut high] = [all.start, all.end];
            while low < high {
                let middle = (low + high) / 2;
                if self.ray_before(place, middle) < ray { low = middle + 1 } else { high = middle }
            }
            low
        };
        first_of(rays.start)..first_of(rays.end)
    }

    /// Height between posts of a line; nothing outside them. `cell` is where it lies, from a cell near by.
    fn between(&self, line: usize, at: f64, cell: &mut usize) -> f64 {
        let last = self.posts.len() - 1;
        if at < self.posts[0] || at > self.posts[last] {
            return f64::NEG_INFINITY;
        }
        while *cell + 1 < last && self.posts[*cell + 1] <= at {
            *cell += 1;
        }
        while *cell > 0 && self.posts[*cell] > at {
            *cell -= 1;
        }
        let low = *cell;
        let share = (at - self.posts[low]) / (self.posts[low + 1] - self.posts[low]);
        let [left, right] = [low, low + 1].map(|post| self.heights.values()[self.index(line, post)]);
        left + share * (right - left)
    }
}

/// Rays of a strip on the line that was reached last.
struct Swept {
    /// Number of its first ray.
    first: usize,
    /// Height of the shadow.
    shadows: Vec<f64>,
    /// The higher of shadow and ground.
    tops: Vec<f64>,
    /// Cell between posts in which each ray was seen last.
    cells: Vec<usize>,
}

impl Swept {
    /// Takes all rays to the next line.
    fn go_on(&mut self, field: &Field<'_>, line: usize, drop: f64) {
        let place = field.lines[line];
        for ray in 0..self.tops.len() {
            let at = field.first + (self.first + ray) as f64 / field.density + field.slant * place;
            let ground = field.between(line, at, &mut self.cells[ray]);
            self.shadows[ray] = self.tops[ray] - drop;
            self.tops[ray] = self.shadows[ray].max(ground);
        }
    }

    /// Height of the shadow (m) at a place among all rays, between the two beside it; beside a ray that nothing shades, that of the nearer.
    fn shadow(&self, at: f64) -> f64 {
        let low = (at as usize).min(self.first + self.shadows.len() - 2);
        let share = at - low as f64;
        let [left, right] = [low, low + 1].map(|ray| self.shadows[ray - self.first]);
        if left.is_finite() && right.is_finite() {
            left + share * (right - left)
        } else if share < 0.5 {
            left
        } else {
            right
        }
    }
}
