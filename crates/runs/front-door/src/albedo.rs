//! From a picture to a map of the ground's albedo.

use landscape::{AlbedoMap, AlbedoMapError, Texels};
use picture::{AnyPicture, Curve};
use scenario::{AlbedoMapWish, MapCurve};

use crate::StageError;

/// The map that `wish` asks for, over `extent` (south, west, north, east edge; m) unless it has an area of its own: a code
/// is light under the curve, and light goes in proportion from the albedo of black to that of white.
///
/// # Errors
/// If the picture cannot be read.
pub(crate) fn albedo_map(wish: &AlbedoMapWish, extent: [f64; 4]) -> Result<AlbedoMap, StageError> {
    let picture = photographs::read(&wish.file)?;
    let size = [picture.columns(), picture.lines()];
    let made = AlbedoMap::new(wish.area.unwrap_or(extent), size, texels(&picture, wish));
    made.map_err(|error| no_map(wish, error))
}

fn no_map(wish: &AlbedoMapWish, error: AlbedoMapError) -> StageError {
    StageError::AlbedoMap { file: wish.file.clone(), error }
}

fn texels(picture: &AnyPicture, wish: &AlbedoMapWish) -> Texels {
    let curve = match wish.curve {
        MapCurve::Srgb => photographs::CURVE,
        MapCurve::Linear => Curve::Power(1.0),
    };
    let white = picture.depth().white();
    let [dark, bright] = wish.ends;
    let albedo = |code: u16| {
        let light = curve.light(f64::from(code) / f64::from(white));
        (dark + light * (bright - dark)).clamp(0.0, 1.0) as f32
    };
    let albedos: Vec<f32> = (0..=white).map(albedo).collect();
    let of = |code: u16| albedos[usize::from(code)];
    match picture {
        AnyPicture::Grey(grey) => Texels::Grey(grey.codes().iter().map(|&code| of(code)).collect()),
        AnyPicture::Colour(colour) => {
            Texels::Colour(colour.pixels().iter().map(|codes| codes.map(of)).collect())
        }
    }
}
