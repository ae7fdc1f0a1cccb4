//! A photograph against closed forms, a second look-up and bad input.

mod coverage;
mod files;
mod geometry;
mod look_up;

use glam::DVec3;
use photo_camera::{Affine, Axes, Camera, Ellipsoid, Light, Orientation};
use photograph::{Photograph, Placement};
use picture::{Depth, GreyPicture};

/// A picture whose code at (column, line) is `code(column, line)`.
fn picture(columns: usize, lines: usize, depth: Depth, code: impl Fn(usize, usize) -> u16) -> GreyPicture {
    let codes = (0..lines).flat_map(|line| (0..columns).map(move |column| (column, line)));
    let codes = codes.map(|(column, line)| code(column, line)).collect();
    GreyPicture::new(columns, lines, depth, codes).expect("codes within the depth")
}

/// A camera that looks straight down from `centre` (m), its picture's top to the north: `sample` metres a pixel at height 0.
fn straight_down(size: [usize; 2], centre: DVec3, sample: f64) -> Camera {
    let focal = 0.15;
    let pixel = 1e6 * focal * sample / centre.z;
    let [across, down] = size.map(|count| 0.5 * pixel * count as f64);
    let affine = Affine::new([pixel, 0.0, -across], [0.0, -pixel, down]).expect("an affine");
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    Camera::new(focal, [0.0; 2], centre, Orientation::from_axes(axes).expect("axes"), affine)
        .expect("a camera")
}

/// A photograph of a landscape from straight above the origin: 40 x 30 pixels of 2 m at height 0, from 1000 m.
fn from_above(picture: GreyPicture, light: Light) -> Photograph {
    let size = [picture.columns(), picture.lines()];
    let camera = straight_down(size, DVec3::new(0.0, 0.0, 1000.0), 2.0);
    Photograph::new(picture, Placement::Camera { camera, axes: Axes::Landscape }, light)
        .expect("a photograph")
}

/// A camera 10 km above the equator of the Moon that looks down at it, the top of its picture to the north.
fn over_the_moon() -> Placement {
    let axes = [DVec3::Y, DVec3::Z, DVec3::X];
    let pixel = 20.0;
    let affine = Affine::new([pixel, 0.0, -250.0 * pixel], [0.0, -pixel, 250.0 * pixel]).expect("an affine");
    let centre = DVec3::new(Ellipsoid::MOON.semi_major() + 10_000.0, 0.0, 0.0);
    let orientation = Orientation::from_axes(axes).expect("axes");
    let camera = Camera::new(0.2, [0.0; 2], centre, orientation, affine).expect("a camera");
    Placement::Camera { camera, axes: Axes::Body(Ellipsoid::MOON) }
}
