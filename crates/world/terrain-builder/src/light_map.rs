//! Which posts the sun lights, and how much.
//!
//! Two methods: one ray from each post along the triangles of the ground, exact for the mesh, and a sweep from the sun's side that
//! carries the height of the shadow from line to line. The sweep takes one step a post; it blurs the edges of shadows by its linear
//! interpolation. Both take one direction for the whole landscape and flat axes.

mod rays;
mod sweep;

use glam::DVec3;
use rayon::prelude::*;

use crate::grid::Grid;
use crate::heights::Heights;
use crate::sunlight::Light;

/// How shadows are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// One ray a post along the triangles of the mesh.
    Rays,
    /// The height of the shadow from line to line, from the sun's side.
    Sweep,
}

/// Light on each post of a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct LightMap {
    grid: Grid,
    /// True where the ground hides the sun; row by row from the south.
    shadowed: Vec<bool>,
    /// Cosine between normal and sun where a post is lit, at least 0; 0 in shadow.
    shares: Vec<f64>,
}

/// How many posts two light maps see otherwise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Apart {
    /// Posts that only one of them has in shadow.
    pub posts: usize,
    /// Those of them that lie farther from every edge of the first map's shadows than was allowed.
    pub beyond_edges: usize,
}

impl LightMap {
    /// Light from a direction (unit vector to the sun: north, east, up). Under a sun at or below the horizon every post is in shadow.
    pub fn new(heights: &Heights, sun: DVec3, method: Method) -> Self {
        let [rows, columns] = heights.grid().size();
        let shadowed = match method {
            _ if sun.z <= 0.0 => vec![true; rows * columns],
            _ if sun.x == 0.0 && sun.y == 0.0 => vec![false; rows * columns],
            Method::Rays => rays::shadows(heights, sun),
            Method::Sweep => sweep::shadows(heights, sun),
        };
        let share = |(index, dark): (usize, &bool)| {
            if *dark { 0.0 } else { heights.normal(index / columns, index % columns).dot(sun).max(0.0) }
        };
        let shares = shadowed.par_iter().enumerate().map(share).collect();
        Self { grid: *heights.grid(), shadowed, shares }
    }

    /// Whether each post is in a cast shadow, row by row from the south: the mask of a shadow controller.
    pub fn shadowed(&self) -> &[bool] {
        &self.shadowed
    }

    /// Share of full light on each post, 0 to 1, row by row from the south.
    pub fn shares(&self) -> &[f64] {
        &self.shares
    }

    /// Red, green and blue of each post, row by row from the south.
    pub fn colours<'m>(&'m self, light: &'m Light) -> impl Iterator<Item = [f64; 3]> + 'm {
        self.shares.iter().map(|share| light.colour(*share))
    }

    /// Posts in which another map of the same grid differs; those within `cells` of an edge of this map's shadows are at an edge.
    pub fn apart(&self, other: &Self, cells: usize) -> Apart {
        let columns = self.grid.size()[1];
        let differs = |index: &usize| self.shadowed[*index] != other.shadowed[*index];
        let all: Vec<usize> = (0..self.shadowed.len()).filter(differs).collect();
        let beyond =
            all.iter().filter(|index| !self.is_near_edge([*index / columns, *index % columns], cells));
        Apart { posts: all.len(), beyond_edges: beyond.count() }
    }

    fn is_near_edge(&self, post: [usize; 2], cells: usize) -> bool {
        let size = self.grid.size();
        let around =
            [0, 1].map(|axis| post[axis].saturating_sub(cells)..=(post[axis] + cells).min(size[axis] - 1));
        let [rows, columns] = around;
        let here = self.shadowed[post[0] * size[1] + post[1]];
        rows.into_iter()
            .any(|row| columns.clone().any(|column| self.shadowed[row * size[1] + column] != here))
    }
}
