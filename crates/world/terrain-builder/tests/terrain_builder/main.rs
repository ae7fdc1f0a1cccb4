//! The builder against the check values of its specification, closed forms, second evaluators and bad input.

mod boulders;
mod craters;
mod distributions;
mod frames;
mod growing;
mod rough;

/// Radius of the Moon (m).
const MOON: f64 = 1_737_400.0;

/// Numbers that agree within a tolerance.
fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} against {expected}");
}

/// A range of degrees in radians.
fn angles(range: [f64; 2]) -> [f64; 2] {
    range.map(quantities::radians)
}

/// The frame at the landing place of Apollo 15: 3.0 to 3.5 east, 26.0 to 26.5 north.
fn apollo() -> terrain_builder::Frame {
    terrain_builder::Frame::new(MOON, angles([3.0, 3.5]), angles([26.0, 26.5])).unwrap()
}
