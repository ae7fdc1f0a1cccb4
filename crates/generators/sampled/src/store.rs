//! The light point store: which points of a frame find a place.

use raster::Screen;
use scene_sampler::{Lights, Point, Scene};

/// The scene of a frame, within the limits of the light point store.
pub(crate) struct Gathered {
    pub scene: Scene,
    /// Points that found no place in the store, the brightest first.
    pub lost_points: Vec<Point>,
}

/// Takes the faintest light points out of `lights` until at most `most` are left, and returns them, the brightest first. Of
/// equally faint ones those with larger numbers are taken.
pub fn limit(lights: &mut Lights, most: Option<u32>, screen: &Screen) -> Vec<Point> {
    let Some(most) = most.filter(|most| lights.points.len() > *most as usize) else { return Vec::new() };
    let mut points = std::mem::take(&mut lights.points);
    let light = |point: &Point| point.disc.intensity * point.disc.area();
    points.sort_unstable_by(|one, other| light(other).total_cmp(&light(one)).then(one.id.cmp(&other.id)));
    let lost = points.split_off(most as usize);
    *lights = Lights::new(points, screen);
    lost
}
