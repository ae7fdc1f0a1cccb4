//! Light points against check values, and what a sceptic would try, with the sampling points of the rasteriser.

mod beam;
mod calligraphic;
mod distance;
mod flight;
mod twinkle;

/// Focal length (pixels) of 1000 pixels over 50 degrees.
fn focal() -> f64 {
    500.0 / libm::tan(25f64.to_radians())
}

/// Holds a value to a published one with 12 decimals.
#[track_caller]
fn assert_published(value: f64, published: f64) {
    assert!((value - published).abs() < 6e-13, "{value:.15}, published {published}");
}
