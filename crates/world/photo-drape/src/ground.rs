//! Posts of a landscape, as far apart to the north as to the east.

use glam::DVec3;
use landscape::Landscape;
use rayon::prelude::*;

use crate::DrapeError;

/// Most posts. Chosen: a photograph of 5000 x 5000 with a post a pixel is 25 million.
const MOST_POSTS: u128 = 64_000_000;

/// Heights and slopes on a grid of posts, row by row from the south, each row from the west.
#[derive(Debug, Clone, PartialEq)]
pub struct Ground {
    /// Place of the south-western post: north, east (m).
    corner: [f64; 2],
    spacing: f64,
    /// Number of rows and of columns.
    size: [usize; 2],
    heights: Vec<f64>,
    /// Slopes to the north and to the east (m/m).
    slopes: Vec<[f32; 2]>,
}

impl Ground {
    /// The posts of `landscape` over `area`: south, west, north, east border (m). They are `spacing` (m) apart from its south-western corner.
    ///
    /// # Errors
    /// If there are fewer than 2 x 2 posts or too many, or the landscape has no ground at one of them.
    pub fn new(
        landscape: &Landscape,
        [south, west, north, east]: [f64; 4],
        spacing: f64,
    ) -> Result<Self, DrapeError> {
        // A side that is a whole number of cells but for rounding keeps its last post.
        let posts = |length: f64| (length / spacing + 1e-9).floor() as u128 + 1;
        let [rows, columns] = [posts(north - south), posts(east - west)];
        if rows < 2 || columns < 2 || rows.saturating_mul(columns) > MOST_POSTS {
            return Err(DrapeError::Posts { posts: rows.saturating_mul(columns), spacing, most: MOST_POSTS });
        }
        let (rows, columns) = (rows as usize, columns as usize);
        let place = |post: usize| {
            [south + (post / columns) as f64 * spacing, west + (post % columns) as f64 * spacing]
        };
        let at = |post: usize| {
            // Rounding may put the last post a hair beyond the border.
            let [x, y] = place(post);
            let [x, y] = [x.min(north), y.min(east)];
            let found = landscape.at_spacing(x, y, spacing).ok_or(DrapeError::Hole { north: x, east: y })?;
            Ok((found.height, found.slopes.map(|slope| slope as f32)))
        };
        let found: Result<Vec<(f64, [f32; 2])>, DrapeError> =
            (0..rows * columns).into_par_iter().map(at).collect();
        let (heights, slopes) = found?.into_iter().unzip();
        Ok(Self { corner: [south, west], spacing, size: [rows, columns], heights, slopes })
    }

    /// Rows and columns of posts.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Distance between posts (m).
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Place of the south-western post: north, east (m).
    pub fn corner(&self) -> [f64; 2] {
        self.corner
    }

    /// Heights (m), row by row from the south.
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// Slopes to the north and to the east (m/m), in the same order.
    pub fn slopes(&self) -> &[[f32; 2]] {
        &self.slopes
    }

    /// A post: north, east, up (m).
    pub fn post(&self, [row, column]: [usize; 2]) -> DVec3 {
        let [south, west] = self.corner;
        let height = self.heights[row * self.size[1] + column];
        DVec3::new(south + row as f64 * self.spacing, west + column as f64 * self.spacing, height)
    }

    /// South-western post of the cell around a place (north, east; m), and the shares of its northern and eastern posts, 0 to 1.
    /// Beyond the border it is the cell of the border.
    #[inline]
    pub fn cell(&self, place: [f64; 2]) -> ([usize; 2], [f64; 2]) {
        let along = |axis: usize| {
            let at = (place[axis] - self.corner[axis]) / self.spacing;
            let at = at.clamp(0.0, (self.size[axis] - 1) as f64);
            let first = (at as usize).min(self.size[axis] - 2);
            (first, at - first as f64)
        };
        let ((row, up), (column, right)) = (along(0), along(1));
        ([row, column], [up, right])
    }

    /// Unit normal of the ground at a place (north, east; m), by the slopes of the posts around it.
    #[inline]
    pub fn normal(&self, place: [f64; 2]) -> DVec3 {
        let [north, east] = self.between(place, |post| {
            let [north, east] = self.slopes[post];
            [f64::from(north), f64::from(east)]
        });
        DVec3::new(-north, -east, 1.0).normalize()
    }

    /// What posts around a place have, mixed bilinearly.
    #[inline]
    pub fn between<const N: usize>(&self, place: [f64; 2], of: impl Fn(usize) -> [f64; N]) -> [f64; N] {
        let (first, share) = self.cell(place);
        let mut sum = [0.0; N];
        for [up, right] in [[0, 0], [0, 1], [1, 0], [1, 1]] {
            let part = |axis: usize, step: usize| if step == 1 { share[axis] } else { 1.0 - share[axis] };
            let weight = part(0, up) * part(1, right);
            // A post without weight need not have a value.
            if weight > 0.0 {
                let values = of((first[0] + up) * self.size[1] + first[1] + right);
                for k in 0..N {
                    sum[k] += weight * values[k];
                }
            }
        }
        sum
    }
}
