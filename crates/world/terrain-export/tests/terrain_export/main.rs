//! Exports: every file against the ground that it came from, and folders that stay whole.

mod albedo;
mod files_of_export;
mod folders;
mod levels;
mod places;

use std::path::Path;

use terrain_builder::{Base, Description, Ground, Textures};
use terrain_export::{Exported, Wishes};

/// A landscape of 3 x 3 tiles of 8 cells, the last ones cut short, with a sun.
const LANDSCAPE: &str = r#"
format = 1
title = "Ground \"one\""

[area]
longitude_deg = [3.0, 3.04]
latitude_deg = [26.0, 26.036]
resolution_m = 50.0
tile_exponent = 3

[light]
sub_solar_deg = [1.5, 80.0]
ambient = [0.05, 0.05, 0.05]
diffuse = [0.9, 0.9, 0.9]

[[feature]]
id = "round"
kind = "crater"
longitude_deg = 3.02
latitude_deg = 26.018
radius_m = 250.0
wall_percent = 4.0
depth_percent = 20.0

[[feature]]
id = "slanted"
kind = "crater"
longitude_deg = 3.01
latitude_deg = 26.01
radius_m = 150.0
wall_percent = 5.0
depth_percent = 15.0
impact_elevation_deg = 8.0

[[feature]]
id = "stone"
kind = "boulder"
longitude_deg = 3.025
latitude_deg = 26.02
radius_m = 6.0
shape = "rock"
seed = 4

[[feature]]
id = "box"
kind = "boulder"
longitude_deg = 3.015
latitude_deg = 26.02
radius_m = 8.0
shape = "cube"
"#;

fn ground(text: &str) -> Ground {
    let description = Description::parse("ground.toml", text, Path::new("")).unwrap();
    Ground::new(description, Base::Level(0.0)).unwrap()
}

/// The textures of ground without any.
fn bare() -> Textures {
    Textures::open(ground(LANDSCAPE).description()).unwrap()
}

fn exported(wishes: Wishes) -> (Ground, Exported) {
    let ground = ground(LANDSCAPE);
    let exported = Exported::new(&ground, &bare(), LANDSCAPE, wishes, &mut |_| {}).unwrap();
    (ground, exported)
}

/// Every bit of the heights, regions of four posts.
const USUAL: Wishes = Wishes { step: None, region_size: None };
