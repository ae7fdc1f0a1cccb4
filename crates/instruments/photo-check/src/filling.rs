//! Heights of an elevation file with their voids filled, and the mask of what was void.

use photo_camera::voids::{Filled, Wishes, fill};
use survey::Elevation;

use crate::GroundError;

/// Fills the voids of `elevation` as `wishes` say. A file without voids keeps its heights, whatever they are.
///
/// # Errors
/// If the grid is smaller than 2 x 2, or its voids cannot be filled.
pub fn fill_voids(elevation: &Elevation, wishes: Wishes) -> Result<Filled, GroundError> {
    let [lines, columns] = [elevation.lines, elevation.columns];
    if lines < 2 || columns < 2 {
        return Err(GroundError::Small { lines, columns });
    }
    let posts = (0..lines).flat_map(|line| (0..columns).map(move |column| [line, column]));
    let height = |[line, column]: [usize; 2]| elevation.height(line, column).unwrap_or(f64::NAN);
    let heights: Vec<f64> = posts.map(height).collect();
    if !heights.iter().any(|height| height.is_nan()) {
        let was_void = vec![false; heights.len()];
        return Ok(Filled { heights, was_void, holes: 0, largest_hole: 0, still_void: 0 });
    }
    Ok(fill([lines, columns], &heights, wishes)?)
}
