//! A photograph against an elevation grid: closed forms and bad input.

mod ground;
mod lines;
mod overlay;
mod page;
mod points;
mod relief;
mod sun;
mod voids;

use glam::DVec3;
use photo_camera::voids::{Fill, Wishes};
use photo_camera::{Affine as PixelAffine, Axes, Camera, Ellipsoid, Light, Orientation};
use photo_check::{Ground, fill_voids};
use photograph::{Map, MapUnit, Photograph, Placement};
use picture::{Depth, GreyPicture};
use survey::{Affine, Elevation, Frame};

/// A grid of `size` posts every 10 m, line 0 the northernmost, whose heights are `height(north, east)` (m); NaN is a void.
fn elevation(size: [usize; 2], height: impl Fn(f64, f64) -> f64) -> Elevation {
    let [lines, columns] = size;
    let north = |line: usize| 10.0 * (lines - 1 - line) as f64;
    let posts = (0..lines).flat_map(|line| (0..columns).map(move |column| [line, column]));
    let heights = posts.map(|[line, column]| height(north(line), 10.0 * column as f64)).collect();
    let affine = Affine { first: [north(0), 0.0], step: [-10.0, 10.0] };
    Elevation::new(lines, columns, heights, affine, Frame::Plane(None))
}

/// The same with line 0 the southernmost.
fn from_the_south(size: [usize; 2], height: impl Fn(f64, f64) -> f64) -> Elevation {
    let [lines, columns] = size;
    let posts = (0..lines).flat_map(|line| (0..columns).map(move |column| [line, column]));
    let heights = posts.map(|[line, column]| height(10.0 * line as f64, 10.0 * column as f64)).collect();
    let affine = Affine { first: [0.0; 2], step: [10.0, 10.0] };
    Elevation::new(lines, columns, heights, affine, Frame::Plane(None))
}

fn picture(size: [usize; 2], code: impl Fn(usize, usize) -> u16) -> GreyPicture {
    let [columns, lines] = size;
    let pixels = (0..lines).flat_map(|line| (0..columns).map(move |column| [column, line]));
    let codes = pixels.map(|[column, line]| code(column, line)).collect();
    GreyPicture::new(columns, lines, Depth::Sixteen, codes).expect("codes")
}

/// A photograph of 100 x 100 pixels of 2 m at height 0, from 1000 m above (north, east) = (100, 100) m, its top to the north.
fn from_above() -> Photograph {
    let (focal, pixel) = (0.15, 300.0);
    let affine =
        PixelAffine::new([pixel, 0.0, -50.0 * pixel], [0.0, -pixel, 50.0 * pixel]).expect("an affine");
    let axes = Orientation::from_axes([DVec3::X, DVec3::Y, DVec3::Z]).expect("axes");
    let centre = DVec3::new(100.0, 100.0, 1000.0);
    let camera = Camera::new(focal, [0.0; 2], centre, axes, affine).expect("a camera");
    let placement = Placement::Camera { camera, axes: Axes::Landscape };
    let picture = picture([100, 100], |column, line| (400 * column + line) as u16);
    Photograph::new(picture, placement, Light::default()).expect("a photograph")
}

/// A camera 10 km above the equator of the Moon at longitude 0, its top to the north.
fn over_the_moon() -> Photograph {
    let pixel = 20.0;
    let affine =
        PixelAffine::new([pixel, 0.0, -50.0 * pixel], [0.0, -pixel, 50.0 * pixel]).expect("an affine");
    let axes = Orientation::from_axes([DVec3::Y, DVec3::Z, DVec3::X]).expect("axes");
    let centre = DVec3::new(Ellipsoid::MOON.semi_major() + 10_000.0, 0.0, 0.0);
    let camera = Camera::new(0.2, [0.0; 2], centre, axes, affine).expect("a camera");
    let placement = Placement::Camera { camera, axes: Axes::Body(Ellipsoid::MOON) };
    Photograph::new(picture([100, 100], |_, _| 7), placement, Light::default()).expect("a photograph")
}

/// A map of `size` pixels (columns, lines) of 10 m whose first centre lies at the first post of [`elevation`].
fn map(picture: GreyPicture, unit: MapUnit) -> Photograph {
    let north = 10.0 * picture.lines() as f64 - 5.0;
    let map = Map::new([10.0, 0.0, -5.0], [0.0, -10.0, north], unit).expect("a map");
    Photograph::new(picture, Placement::Map(map), Light::default()).expect("a photograph")
}

/// The ground of a grid for a photograph, its voids filled harmonically.
fn ground(elevation: &Elevation, photo: &Photograph) -> Ground {
    filled(elevation, photo, Fill::Harmonic)
}

fn filled(elevation: &Elevation, photo: &Photograph, fill: Fill) -> Ground {
    let filling = fill_voids(elevation, Wishes { fill, ..Wishes::default() }).expect("a grid");
    Ground::new(elevation, filling, photo).expect("places that go with the photograph")
}
