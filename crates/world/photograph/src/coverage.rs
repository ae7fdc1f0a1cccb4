//! How much of a ground a photograph shows.

use glam::DVec3;

use crate::{PhotoError, Photograph};

/// Where ground points fall.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Coverage {
    /// Number of points inside the picture.
    pub inside: usize,
    /// Number of points beside the picture.
    pub outside: usize,
    /// Number of points behind the camera.
    pub behind: usize,
}

impl Coverage {
    /// Number of all points.
    pub fn points(&self) -> usize {
        self.inside + self.outside + self.behind
    }
}

/// Ranges of pixels I and J.
struct Reach([[f64; 2]; 2]);

impl Reach {
    fn take(&mut self, pixel: [f64; 2]) {
        for (reach, at) in self.0.iter_mut().zip(pixel) {
            *reach = [reach[0].min(at), reach[1].max(at)];
        }
    }

    fn words(&self) -> String {
        let [[i, to_i], [j, to_j]] = self.0;
        if i > to_i {
            return "no pixel".into();
        }
        format!("I {i:.0} to {to_i:.0}, J {j:.0} to {to_j:.0}")
    }
}

impl Photograph {
    /// Counts where ground points fall. Heights between points and hidden ground have no part in it.
    ///
    /// # Errors
    ///
    /// If no point lies inside the picture.
    pub fn coverage(&self, points: impl IntoIterator<Item = DVec3>) -> Result<Coverage, PhotoError> {
        let mut found = Coverage::default();
        let mut reach = Reach([[f64::INFINITY, f64::NEG_INFINITY]; 2]);
        for point in points {
            match self.pixel(point) {
                None => found.behind += 1,
                Some(pixel) => {
                    reach.take(pixel);
                    let count = if self.holds(pixel) { &mut found.inside } else { &mut found.outside };
                    *count += 1;
                }
            }
        }
        if found.inside > 0 {
            return Ok(found);
        }
        Err(PhotoError::NothingInCommon {
            columns: self.picture().columns(),
            lines: self.picture().lines(),
            points: found.points(),
            behind: found.behind,
            place: reach.words(),
        })
    }
}
