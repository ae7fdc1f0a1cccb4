//! The terrain database of a scenario.

use std::path::Path;

use landscape::{LUNOID_RADIUS, Posts};
use terrain_database::{Contents, Database};

use crate::StageError;

/// By how much the radius of the body may be another, as a share. Chosen: that of the Moon is known to less.
const SAME_BODY: f64 = 1e-3;

/// Reads the posts of the database in `file`, over a bank with these borders (south, west, north, east; m).
///
/// # Errors
/// If the file is no sound database, is of another body, or has no ground in common with the bank.
pub(crate) fn posts(file: &Path, bank: [f64; 4]) -> Result<Posts, StageError> {
    let database = Database::open(file).map_err(Box::new)?;
    let Contents { frame, order, places, heights, ranges, .. } = database.contents();
    if (frame.radius - LUNOID_RADIUS).abs() > SAME_BODY * LUNOID_RADIUS {
        return Err(StageError::OtherBody { file: file.into(), radius: frame.radius });
    }
    let [east, north] =
        [0, 1].map(|axis| places[axis].iter().map(|place| place - frame.origin[axis]).collect::<Vec<f64>>());
    let ranges = ranges.iter().map(|range| [range.end, range.share]).collect();
    let posts = Posts { order: *order, places: [north, east], heights: heights.clone(), ranges };
    let [south, west, north, east] = posts.extent();
    let is_apart = south >= bank[2] || north <= bank[0] || west >= bank[3] || east <= bank[1];
    match is_apart {
        true => Err(StageError::ApartDatabase { file: file.into(), posts: posts.extent(), bank }),
        false => Ok(posts),
    }
}
