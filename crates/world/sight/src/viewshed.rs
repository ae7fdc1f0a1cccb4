//! Over an area: each post of the mesh as a target.

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
        within("height of the targets (m)", height, height >= 0.0, "a finite number of 0 or more")?;
        let (start, _) = observer.heights(|place| self.height(place))?;
        let from = self.in_posts(observer.place);
        curvature.check_reach(self.farthest(from))?;
        Ok(self.of_posts(|row, column, ground| {
            if ground.is_nan() {
                return Sight::Unknown;
            }
            let Some(ray) = Ray::new(from, [row as f64, column as f64]) else { return Sight::Visible };
            let distance = ray.length() * self.spacing();
            self.sight(&ray, Line::new(start, ground + height, curvature, distance))
        }))
    }

    /// Least height (m) above each post at which a target is seen, row by row; 0 where the ground is seen, NaN where it is unknown.
    ///
    /// # Errors
    /// An observer that [`Posts::line_of_sight`] refuses.
    pub fn least_heights(&self, observer: &Point, curvature: Curvature) -> Result<Vec<f64>, SightError> {
        let (start, _) = observer.heights(|place| self.height(place))?;
        let from = self.in_posts(observer.place);
        curvature.check_reach(self.farthest(from))?;
        Ok(self.of_posts(|row, column, ground| {
            if ground.is_nan() {
                return f64::NAN;
            }
            let Some(ray) = Ray::new(from, [row as f64, column as f64]) else { return 0.0 };
            let line = Line::new(start, ground, curvature, ray.length() * self.spacing());
            self.least(&ray, line).unwrap_or(f64::NAN)
        }))
    }

    /// Distance (m) from a place in posts to the farthest corner of the mesh.
    fn farthest(&self, from: [f64; 2]) -> f64 {
        let [rows, columns] = [0, 1].map(|axis| from[axis].max((self.size()[axis] - 1) as f64 - from[axis]));
        self.spacing() * (rows * rows + columns * columns).sqrt()
    }

    /// A function of row, column and height (m) of every post, by all threads of the caller's pool.
    fn of_posts<T: Send>(&self, of_post: impl Fn(usize, usize, f64) -> T + Sync) -> Vec<T> {
        let [rows, columns] = self.size();
        let of_post = |at: usize| of_post(at / columns, at % columns, self.post(at / columns, at % columns));
        (0..rows * columns).into_par_iter().with_min_len(columns).map(of_post).collect()
    }
}
