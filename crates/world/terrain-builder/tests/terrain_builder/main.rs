//! The builder against the check values of its specification, closed forms, second evaluators and bad input.

mod bases;
mod boulders;
mod craters;
mod distributions;
mod editing;
mod effects;
mod exports;
mod files;
mod frames;
mod grounds;
mod growing;
mod light;
mod rough;
mod textures;

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

/// Head of a landscape file: 0.1 by 0.1 degrees at 26 north, posts 50 m apart.
const HEAD: &str = r#"format = 1
title = "Test ground"

[area]
longitude_deg = [3.0, 3.1]
latitude_deg = [26.0, 26.1]
resolution_m = 50.0
tile_exponent = 4
"#;

/// One feature of every kind.
const FEATURES: [&str; 6] = [
    r#"
# The large one.
[[feature]]
id = "north-crater"
kind = "crater"
longitude_deg = 3.04
latitude_deg = 26.06
radius_m = 500.0
wall_percent = 4.0
depth_percent = 20.0
impact_elevation_deg = 8.0
impact_direction_deg = 40.0
[feature.roughness]
seeds = [4, 9]
scale_m = 2.0
"#,
    r#"
[[feature]]
id = "hill"
kind = "growth"
longitude_deg = [3.02, 3.08]
latitude_deg = [26.01, 26.05]
iterations = 3
points = [{ at_deg = [3.05, 26.03], height_m = 120.0 }, { at_deg = [3.03, 26.02], height_m = -30.0, weight = 2.0 }]
curves = [{ picks = [{ at_deg = [3.06, 26.02], height_m = 40.0 }, { at_deg = [3.06, 26.04], height_m = 80.0 }] }]
"#,
    r#"
[[feature]]
id = "small-craters"
kind = "craters"
longitude_deg = [3.0, 3.1]
latitude_deg = [26.0, 26.1]
radius_m = [20.0, 300.0]
density_per_km2 = 6.0
seed = 5
"#,
    r#"
[[feature]]
id = "plain"
kind = "area"
longitude_deg = [3.0, 3.05]
latitude_deg = [26.0, 26.05]
[feature.roughness]
seeds = [7]
scale_m = 1.0
smoothing_m = 120.0
"#,
    r#"
[[feature]]
id = "a-rock"
kind = "boulder"
longitude_deg = 3.05
latitude_deg = 26.03
radius_m = 8.0
shape = "cube"
burial = 0.0
"#,
    r#"
[[feature]]
id = "rocks"
kind = "boulders"
longitude_deg = [3.0, 3.1]
latitude_deg = [26.0, 26.1]
radius_m = [1.0, 9.0]
density_per_km2 = 20.0
shape = "rock"
sizes = "power-law"
min_separation_m = 30.0
seed = 3
"#,
];

/// A landscape from its text.
fn described(text: &str) -> terrain_builder::Description {
    let read = terrain_builder::Description::parse("ground.toml", text, std::path::Path::new(""));
    read.unwrap_or_else(|problems| panic!("{problems}"))
}

/// A landscape that is built from its text, on a level.
fn built(text: &str) -> terrain_builder::Ground {
    let base = terrain_builder::Base::Level(-100.0);
    terrain_builder::Ground::new(described(text), base).unwrap()
}

/// A file of some of the features, in an order.
fn file_of(order: &[usize]) -> String {
    order.iter().fold(HEAD.to_owned(), |text, &index| text + FEATURES[index])
}
