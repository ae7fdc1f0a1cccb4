//! The record of a photograph.

use picture::Depth;
use quantities::degrees;
use serde_json::{Value, json};

use crate::{ElevationGrid, Made, Wishes};

/// What was made, by figures with their units; `scenario` is the file as the user named it.
pub fn record(scenario: &str, wishes: &Wishes, made: &Made, grid: &ElevationGrid) -> Value {
    let shown = made.ground.iter().flatten().count();
    let camera = &made.stand.camera;
    json!({
        "schema": "lunoid.photo-made/1",
        "scenario": scenario,
        "time_s": wishes.time,
        "columns": wishes.size[0],
        "lines": wishes.size[1],
        "bits": if wishes.depth == Depth::Eight { 8 } else { 16 },
        "ground_sample_m": wishes.ground_sample,
        "distance_m": made.stand.distance,
        "eye_north_east_up_m": made.stand.pose.eye,
        "heading_deg": degrees(wishes.heading),
        "pitch_deg": degrees(wishes.pitch),
        "roll_deg": degrees(wishes.roll),
        "focal_length_m": camera.focal_length(),
        "pixel_um": camera.affine().rows()[0][0],
        "sun_azimuth_deg": degrees(made.sun.azimuth),
        "sun_elevation_deg": degrees(made.sun.elevation),
        "grey_white": wishes.transfer.white(),
        "grey_gamma": wishes.transfer.gamma(),
        "noise": wishes.noise,
        "seed": wishes.seed,
        "ground_pixels": shown,
        "other_pixels": made.ground.len() - shown,
        "residual_px": made.residual,
        "elevation_spacing_m": grid.spacing,
        "elevation_posts": grid.posts,
    })
}
