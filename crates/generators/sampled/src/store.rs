//! The light point store: which points of a frame find a place.

use raster::Screen;

use crate::lights::{Lights, Point};

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
