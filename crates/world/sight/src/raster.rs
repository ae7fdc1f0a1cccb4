//! Places of targets on a regular grid.

use rayon::prelude::*;

use crate::SightError;
use crate::error::within;

/// A grid of targets: rows from north to south, columns from west to east.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Raster {
    /// How many rows and columns there are.
    pub size: [usize; 2],
    /// Place of the north-western target: north, east (m).
    pub corner: [f64; 2],
    /// Distance from target to target (m).
    pub spacing: f64,
}

impl Raster {
    /// Place of a target: north, east (m).
    pub fn place(&self, row: usize, column: usize) -> [f64; 2] {
        [self.corner[0] - row as f64 * self.spacing, self.corner[1] + column as f64 * self.spacing]
    }

    /// Refuses a grid that has no places.
    pub(crate) fn check(&self) -> Result<(), SightError> {
        let [rows, columns] = self.size;
        within("rows of targets", rows as f64, rows > 0, "1 or more")?;
        within("columns of targets", columns as f64, columns > 0, "1 or more")?;
        within("spacing of the targets (m)", self.spacing, self.spacing > 0.0, "a finite number above 0")?;
        self.corner
            .into_iter()
            .try_for_each(|place| within("place of the targets (m)", place, true, "a finite number"))
    }

    /// A function of every place, row by row, by all threads of the caller's pool. `done` is called after each row.
    pub(crate) fn each<T: Send>(
        &self,
        of_place: impl Fn([f64; 2]) -> T + Sync,
        done: &(impl Fn() + Sync),
    ) -> Vec<T> {
        let [rows, columns] = self.size;
        let row = |row: usize| {
            let found: Vec<T> = (0..columns).map(|column| of_place(self.place(row, column))).collect();
            done();
            found
        };
        let found: Vec<Vec<T>> = (0..rows).into_par_iter().with_max_len(1).map(row).collect();
        found.into_iter().flatten().collect()
    }

    /// Distance (m) from a place to the farthest target.
    pub(crate) fn farthest(&self, from: [f64; 2]) -> f64 {
        let far = self.place(self.size[0] - 1, self.size[1] - 1);
        let [north, east] =
            [0, 1].map(|axis| (self.corner[axis] - from[axis]).abs().max((far[axis] - from[axis]).abs()));
        libm::hypot(north, east)
    }
}
