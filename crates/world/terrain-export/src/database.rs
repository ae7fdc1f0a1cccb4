//! The terrain database of a landscape.

use terrain_builder::{Axis, Ground, Heights, LightMap, PlacedBoulder, Shape as BuiltShape};
use terrain_database::{Boulder, Contents, Database, Frame, Map, Shape, Unfit};

/// The database of a landscape with these heights, light, and luminance of the albedo on every post (16 bits). `sidecar` is the text of the
/// landscape file, `step` that of the heights (m).
///
/// # Errors
/// If the tiles have a single cell, or a value is out of range.
pub fn database(
    ground: &Ground,
    heights: &Heights,
    (light, albedo): (Option<&LightMap>, Option<Vec<u16>>),
    step: Option<f64>,
    sidecar: &str,
) -> Result<Database, Unfit> {
    let (grid, frame) = (ground.description().grid, ground.description().frame);
    let [[south, west], _] = grid.extent();
    let [latitude, longitude] = frame.centre();
    let frame = Frame { radius: frame.radius(), latitude, longitude, origin: [west, south] };
    let places =
        [grid.east, grid.north].map(|axis: Axis| (0..axis.posts()).map(|post| axis.place(post)).collect());
    let light = light.map(|map| Map::U16(map.shares().iter().map(|share| code(*share)).collect()));
    Database::new(Contents {
        step,
        light,
        albedo: albedo.map(Map::U16),
        boulders: ground.boulders().iter().map(boulder).collect(),
        sidecar: sidecar.into(),
        ..Contents::new(frame, grid.north.exponent, places, heights.values().to_vec())
    })
}

/// Number of 16 bits that stands for a share of full light.
fn code(share: f64) -> u16 {
    (share * f64::from(u16::MAX)).round() as u16
}

fn boulder(placed: &PlacedBoulder) -> Boulder {
    let boulder = &placed.boulder;
    let ([north, east], [seed, number]) = (boulder.at(), boulder.seeds());
    Boulder {
        centre: [east, north, placed.middle],
        radius: boulder.radius(),
        shape: match boulder.shape() {
            BuiltShape::Sphere => Shape::Sphere,
            BuiltShape::Cube => Shape::Cube,
            BuiltShape::Rock(faces) => Shape::Rock(faces),
        },
        seed,
        number,
        yaw: boulder.yaw(),
        burial: boulder.burial(),
    }
}
