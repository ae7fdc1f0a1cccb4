//! From a picture to a map of the ground's albedo.

use landscape::{AlbedoMap, AlbedoMapError, Texels};
use picture::Curve;
use scenario::{AlbedoMapWish, MapCurve};

use crate::StageError;

/// The map that `wish` asks for, over `extent` (south, west, north, east edge; m) unless it has an area of its own: a code
/// is light under the curve, and light goes in proportion from the albedo of black to that of white.
///
/// # Errors
/// If the picture cannot be read.
pub(crate) fn albedo_map(wish: &AlbedoMapWish, extent: [f64; 4]) -> Result<AlbedoMap, StageError> {
    let curve = match wish.curve {
        MapCurve::Srgb => photographs::CURVE,
        MapCurve::Linear => Curve::Power(1.0),
    };
    let picture = photographs::read_map(&wish.file, curve)?;
    let size = [picture.columns(), picture.lines()];
    let texels = Texels::of_picture(&picture, curve, wish.ends);
    let made = AlbedoMap::new(wish.area.unwrap_or(extent), size, texels);
    made.map_err(|error| no_map(wish, error))
}

fn no_map(wish: &AlbedoMapWish, error: AlbedoMapError) -> StageError {
    StageError::AlbedoMap { file: wish.file.clone(), error }
}
