//! Light on every post of a landscape.

use ephemeris::sun_direction;
use terrain_builder::{Ground, Heights, LightMap, Method};

/// The light of the landscape's sun on its posts, by rays along the triangles; none where the landscape has no `[light]`.
pub fn light_map(ground: &Ground, heights: &Heights) -> Option<LightMap> {
    let light = ground.description().light?;
    let sun = sun_direction(ground.description().frame.centre(), light.sub_solar);
    Some(LightMap::new(heights, sun, Method::Rays))
}
