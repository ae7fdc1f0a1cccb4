//! A photograph's camera against the check values of its specification, closed forms and second evaluators.

mod angle;
mod camera;
mod check;
mod ellipsoid;
mod file;
mod frame;
mod orientation;
mod voids;

use photo_camera::{Affine, Axis, Camera, Ellipsoid, Geodetic, Orientation, parse_angle};

/// Random numbers that are the same in every run.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        let unit = quantities::unit_interval(self.0, &[]);
        self.0 = quantities::hash_words(self.0, &[]);
        unit
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}

/// A place by texts of its angles and its height (m).
fn place(latitude: &str, longitude: &str, height: f64) -> Geodetic {
    Geodetic {
        latitude: parse_angle(latitude, Axis::Latitude).expect("a latitude"),
        longitude: parse_angle(longitude, Axis::Longitude).expect("a longitude"),
        height,
    }
}

/// Georectangular point (m) on Clarke 1866.
fn ground(latitude: &str, longitude: &str, height: f64) -> glam::DVec3 {
    Ellipsoid::CLARKE_1866.point(place(latitude, longitude, height))
}

/// The camera of the thesis's photograph, with the second coefficient B2 as the specification reads it.
fn thesis_camera() -> Camera {
    let orientation = Orientation::from_angles([0.8341764, -0.4563699, 3.0761254]).expect("finite angles");
    let affine =
        Affine::new([20.11323959, 6.01620794, -34954.59484], [-6.022849824, 20.10938801, -22566.71593]);
    let centre = glam::DVec3::new(-2_693_765.9, -4_304_520.4, 3_859_018.3);
    Camera::new(0.153197, [2e-6, 0.0], centre, orientation, affine.expect("an affine")).expect("a camera")
}
