//! Photographs over ground against closed forms.

mod albedo;
mod footprints;
mod places;
mod refused;
mod triangles;

use std::sync::Arc;

use glam::DVec3;
use landscape::relief::{Massif, Relief};
use landscape::{Bank, CornerWords, Landscape, Level};
use photo_camera::{Affine, Axes, Camera, Light, Orientation};
use photo_drape::{Choice, Drape, DrapeError, Ground};
use photograph::{Photograph, Placement};
use picture::{Depth, GreyPicture};

/// A plane of 400 m x 400 m that passes through the origin, with slopes to the north and to the east.
fn plane([north, east]: [f64; 2]) -> Landscape {
    let corner = |i: usize, j: usize| -> CornerWords {
        let mut words = [0.0; 9];
        words[0] = 100.0 * (north * i as f64 + east * j as f64);
        // Derivatives in units of a region.
        (words[1], words[3]) = (100.0 * east, 100.0 * north);
        words
    };
    let words = (0..5).flat_map(|i| (0..5).map(move |j| corner(i, j))).collect();
    let level = Level::new(100.0, [0.0; 2], [5, 5], words).unwrap();
    Landscape::new(Bank::new("plane", vec![level], None).unwrap(), 0.5)
}

/// A ridge: a steep hill of 80 m in the middle of 400 m x 400 m of flat ground.
fn hill() -> Landscape {
    let massif = Massif { at: [200.0, 200.0], height: 80.0, radius: 60.0, detail: 30.0, ruggedness: 0.0 };
    let relief = Relief { massifs: vec![massif], ..Relief::flat(1, [400.0; 2], 10.0) };
    Landscape::new(Bank::new("hill", vec![relief.build().unwrap()], None).unwrap(), 0.5)
}

/// A picture of 16 bits whose codes are shares of white.
fn picture([columns, lines]: [usize; 2], share: impl Fn(usize, usize) -> f64) -> GreyPicture {
    let codes = (0..lines)
        .flat_map(|line| (0..columns).map(move |column| [column, line]))
        .map(|[column, line]| (share(column, line) * 65_535.0).round() as u16)
        .collect();
    GreyPicture::new(columns, lines, Depth::Sixteen, codes).unwrap()
}

/// A camera at a place (north, east, up; m) that looks along a direction; pixels are a thousandth of a radian in the middle.
fn camera(place: DVec3, ahead: DVec3, [columns, lines]: [usize; 2]) -> Placement {
    let swapped = |v: DVec3| DVec3::new(v.y, v.x, v.z);
    // Image z points from the scene to the camera, x to the right, y up.
    let back = -swapped(ahead).normalize();
    let right = if back.z > 0.99 { DVec3::X } else { DVec3::Z.cross(back).normalize() };
    let orientation = Orientation::from_axes([right, back.cross(right), back]).unwrap();
    let [a, b] = [columns, lines].map(|count| count as f64 / 2.0);
    let affine = Affine::new([100.0, 0.0, -100.0 * a], [0.0, -100.0, 100.0 * b]).unwrap();
    let camera = Camera::new(0.1, [0.0; 2], swapped(place), orientation, affine).unwrap();
    Placement::Camera { camera, axes: Axes::Landscape }
}

/// A vertical photograph from `height` (m) over the middle of the ground, 400 x 400 pixels.
fn from_above(height: f64, share: impl Fn(usize, usize) -> f64, sun: Option<[f64; 2]>) -> Photograph {
    let placement = camera(DVec3::new(200.0, 200.0, height), -DVec3::Z, [400; 2]);
    let light = Light::new(sun, None).unwrap();
    Photograph::new(picture([400; 2], share), placement, light).unwrap()
}

/// Photographs over a landscape with posts `spacing` (m) apart.
fn drape(
    landscape: Landscape,
    photographs: Vec<Photograph>,
    spacing: f64,
    choice: Choice,
) -> Result<Drape, DrapeError> {
    let photographs: Arc<[Photograph]> = photographs.into();
    let landscape = landscape.with_photographs(photographs);
    let ground = Ground::new(&landscape, landscape.level().extent(), spacing)?;
    Drape::new(&landscape, ground, choice)
}
