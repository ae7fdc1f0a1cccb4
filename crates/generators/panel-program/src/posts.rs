//! Posts of the ground, with and without heights.

use glam::DVec3;
use photo_camera::voids::{Border, Fill, Wishes, fill};

use crate::{ProgramError, Restrictions};

/// Posts row by row from the south, each row from the west.
#[derive(Debug, Clone, PartialEq)]
pub struct Posts {
    /// Number of rows and of columns, each 2 or more.
    pub size: [usize; 2],
    /// Places: north, east, up (m); up is NaN where the height is void.
    pub places: Vec<DVec3>,
}

impl Posts {
    /// The posts with their voids filled, and which of them were void: by the mean of all known posts, or harmonically.
    ///
    /// # Errors
    /// If they are no grid, a height is out of range, or the voids cannot be filled.
    pub(crate) fn filled(&self, restrictions: Restrictions) -> Result<(Vec<DVec3>, Vec<bool>), ProgramError> {
        let heights: Vec<f64> = self.places.iter().map(|place| place.z).collect();
        let way = if restrictions.mean_void { Fill::WrittenMean } else { Fill::Harmonic };
        // The listing fills any hole; harmonically a large one would be invented ground.
        let wishes = Wishes { fill: way, border: Border::Filled, allow_large_holes: restrictions.mean_void };
        let filled = fill(self.size, &heights, wishes)?;
        let places = self.places.iter().zip(filled.heights);
        Ok((places.map(|(place, height)| DVec3::new(place.x, place.y, height)).collect(), filled.was_void))
    }

    /// Numbers of the corners of all panels: two a cell, cut from the south-eastern to the north-western post.
    pub(crate) fn panels(&self) -> impl Iterator<Item = [usize; 3]> {
        let [rows, columns] = self.size;
        let cells =
            (0..rows - 1).flat_map(move |row| (0..columns - 1).map(move |column| row * columns + column));
        cells.flat_map(move |sw| [[sw, sw + 1, sw + columns], [sw + 1, sw + columns + 1, sw + columns]])
    }
}
