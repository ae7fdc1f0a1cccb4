//! Over an area: posts of the mesh as targets.

use std::ops::Range;

use rayon::prelude::*;

use crate::error::within;
use crate::line::Line;
use crate::ray::Ray;
use crate::{Curvature, Point, Posts, Sight, SightError};

impl Posts {
    /// Whether a target of a `height` (m) above each post is seen; row by row.
    ///
    /// # Errors
    /// An observer that [`Posts::line_of_sight`] refuses, or a height below 0.
    pub fn viewshed(
        &self,
        observer: &Point,
        height: f64,
        curvature: Curvature,
    ) -> Result<Vec<Sight>, SightError> {
        self.viewshed_within(observer, self.whole(), height, curvature, &|| ())
    }

    /// The same for the posts of some rows and columns. `done` is called after each row.
    ///
    /// # Errors
    /// Those of [`Posts::viewshed`], and rows or columns that the mesh does not have.
    pub fn viewshed_within(
        &self,
        observer: &Point,
        window: [Range<usize>; 2],
        height: f64,
        curvature: Curvature,
        done: &(impl Fn() + Sync),
    ) -> Result<Vec<Sight>, SightError> {
        within("height of the targets (m)", height, height >= 0.0, "a finite number of 0 or more")?;
        let (start, from) = self.start(observer, &window, curvature)?;
        let of_post = |row: usize, column: usize, ground: f64| {
            if ground.is_nan() {
                return Sight::Unknown;
            }
            let Some(ray) = Ray::new(from, [row as f64, column as f64]) else { return Sight::Visible };
            let distance = ray.length() * self.spacing();
            self.sight(&ray, Line::new(start, ground + height, curvature, distance))
        };
        Ok(self.of_posts(window, of_post, done))
    }

    /// Least height (m) above each post at which a target is seen, row by row; 0 where the ground is seen, NaN where it is unknown.
    ///
    /// # Errors
    /// An observer that [`Posts::line_of_sight`] refuses.
    pub fn least_heights(&self, observer: &Point, curvature: Curvature) -> Result<Vec<f64>, SightError> {
        self.least_heights_within(observer, self.whole(), curvature, &|| ())
    }

    /// The same for the posts of some rows and columns. `done` is called after each row.
    ///
    /// # Errors
    /// Those of [`Posts::least_heights`], and rows or columns that the mesh does not have.
    pub fn least_heights_within(
        &self,
        observer: &Point,
        window: [Range<usize>; 2],
        curvature: Curvature,
        done: &(impl Fn() + Sync),
    ) -> Result<Vec<f64>, SightError> {
        let (start, from) = self.start(observer, &window, curvature)?;
        let of_post = |row: usize, column: usize, ground: f64| {
            if ground.is_nan() {
                return f64::NAN;
            }
            let Some(ray) = Ray::new(from, [row as f64, column as f64]) else { return 0.0 };
            let line = Line::new(start, ground, curvature, ray.length() * self.spacing());
            self.least(&ray, line).unwrap_or(f64::NAN)
        };
        Ok(self.of_posts(window, of_post, done))
    }

    fn whole(&self) -> [Range<usize>; 2] {
        self.size().map(|count| 0..count)
    }

    /// Height (m) above the datum and place (posts) of an observer that looks over a window.
    fn start(
        &self,
        observer: &Point,
        window: &[Range<usize>; 2],
        curvature: Curvature,
    ) -> Result<(f64, [f64; 2]), SightError> {
        for (range, count) in window.iter().zip(self.size()) {
            let allowed = range.start < range.end && range.end <= count;
            within("end of the rows or columns", range.end as f64, allowed, "some of those of the mesh")?;
        }
        let (start, _) = observer.heights(|place| self.height(place))?;
        let from = self.in_posts(observer.place);
        let [rows, columns] = [0, 1].map(|axis| {
            let [first, last] = [window[axis].start as f64, (window[axis].end - 1) as f64];
            (from[axis] - first).abs().max((from[axis] - last).abs())
        });
        curvature.check_reach(self.spacing() * (rows * rows + columns * columns).sqrt())?;
        Ok((start, from))
    }

    /// A function of row, column and height (m) of every post of a window, by all threads of the caller's pool.
    fn of_posts<T: Send>(
        &self,
        [rows, columns]: [Range<usize>; 2],
        of_post: impl Fn(usize, usize, f64) -> T + Sync,
        done: &(impl Fn() + Sync),
    ) -> Vec<T> {
        let width = columns.len();
        let of_post = |at: usize| {
            let [row, column] = [rows.start + at / width, columns.start + at % width];
            let found = of_post(row, column, self.post(row, column));
            if column + 1 == columns.end {
                done();
            }
            found
        };
        (0..rows.len() * width).into_par_iter().with_min_len(width).map(of_post).collect()
    }
}
