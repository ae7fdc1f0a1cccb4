//! The terrain database of a scenario.

use std::path::Path;

use landscape::{LUNOID_RADIUS, MapFrame, Posts, is_same_body};
use quantities::sin_cos;
use terrain_database::{Contents, Database, Map};

use crate::StageError;

/// Share of the ground's longer side by which the middle of a database may lie elsewhere than the bank's map has it. Chosen: the middle of a
/// bank's regions lies within one region of the middle of the posts.
const SAME_PLACE: f64 = 0.1;

/// Reads the posts of the database in `file`, over a bank with these borders (south, west, north, east; m) and this map.
///
/// # Errors
/// If the file is no sound database, is of another body or of another place, or has no ground in common with the bank.
pub(crate) fn posts(file: &Path, bank: [f64; 4], map: Option<&MapFrame>) -> Result<Posts, StageError> {
    let database = Database::open(file).map_err(Box::new)?;
    let Contents { frame, order, places, heights, ranges, light, albedo, .. } = database.into_contents();
    if !is_same_body(frame.radius, LUNOID_RADIUS) {
        return Err(StageError::OtherBody { file: file.into(), radius: frame.radius });
    }
    let stated = [frame.latitude, frame.longitude];
    let longer = [0, 1]
        .map(|axis| places[axis].last().zip(places[axis].first()).map_or(0.0, |(end, begin)| end - begin));
    let reach = SAME_PLACE * longer[0].max(longer[1]);
    // The middle of the area has the axes of the database, whose origin is the bank's corner.
    let mapped = map.and_then(|map| map.point([-frame.origin[1], -frame.origin[0]]));
    if let Some(found) = mapped.filter(|found| apart(*found, stated) * LUNOID_RADIUS > reach) {
        return Err(StageError::OtherPlace { file: file.into(), database: stated, bank: found });
    }
    let [east, north] =
        [0, 1].map(|axis| places[axis].iter().map(|place| place - frame.origin[axis]).collect::<Vec<f64>>());
    let ranges = ranges.into_iter().map(|range| [range.end, range.share]).collect();
    let [light, albedo] = [light, albedo].map(|map| map.map(|map| shares(&map)));
    let posts = Posts { order, places: [north, east], heights: heights.into(), ranges, light, albedo };
    let [south, west, north, east] = posts.extent();
    let is_apart = south >= bank[2] || north <= bank[0] || west >= bank[3] || east <= bank[1];
    match is_apart {
        true => Err(StageError::ApartDatabase { file: file.into(), posts: posts.extent(), bank }),
        false => Ok(posts),
    }
}

/// Angle (rad) between two places on a sphere, each a latitude and a longitude (rad).
fn apart(one: [f64; 2], other: [f64; 2]) -> f64 {
    let to = |[latitude, longitude]: [f64; 2]| {
        let ((up, level), (east, north)) = (sin_cos(latitude), sin_cos(longitude));
        [level * north, level * east, up]
    };
    let [a, b] = [one, other].map(to);
    let chord = (0..3).map(|axis| (a[axis] - b[axis]) * (a[axis] - b[axis])).sum::<f64>().sqrt();
    2.0 * libm::asin((0.5 * chord).min(1.0))
}

fn shares(map: &Map) -> Vec<f32> {
    (0..map.len()).map(|post| map.share(post) as f32).collect()
}

#[cfg(test)]
mod tests {
    use terrain_database::Frame;

    use super::*;

    /// 5 x 3 posts 100 m apart whose height is the place to the east; the landscape's origin lies 50 m east and 20 m north of theirs.
    fn read(radius: f64, bank: [f64; 4]) -> Result<Posts, StageError> {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("ground.lod");
        let frame = Frame { radius, latitude: 0.4, longitude: 0.1, origin: [50.0, 20.0] };
        let places = |count: u32| (0..count).map(|post| 100.0 * f64::from(post)).collect::<Vec<_>>();
        let heights = (0..15).map(|post| 100.0 * f64::from(post % 5)).collect();
        let light = Some(Map::U8((0..15).map(|post| 17 * post).collect()));
        let contents = Contents { light, ..Contents::new(frame, 1, [places(5), places(3)], heights) };
        Database::new(contents).unwrap().write(&file).unwrap();
        posts(&file, bank, None)
    }

    #[test]
    fn posts_stand_in_the_axes_of_the_landscape() {
        let posts = read(LUNOID_RADIUS, [0.0, 0.0, 100.0, 100.0]).unwrap();
        assert_eq!(posts.places[0], [-20.0, 80.0, 180.0]);
        assert_eq!(posts.extent(), [-20.0, -50.0, 180.0, 350.0]);
        assert_eq!(posts.heights[..6], [0.0, 100.0, 200.0, 300.0, 400.0, 0.0]);
        let light = posts.light.unwrap();
        assert!((light[3] - 0.2).abs() < 1e-7 && (light[14] - 14.0 / 15.0).abs() < 1e-7, "{light:?}");
        assert!(posts.albedo.is_none());
    }

    #[test]
    fn other_bodies_and_other_ground_are_refused() {
        let mars = read(3_389_500.0, [0.0, 0.0, 100.0, 100.0]).unwrap_err().to_string();
        assert!(mars.contains("3389500") && mars.contains("ground.lod"), "{mars}");
        let apart = read(LUNOID_RADIUS, [180.0, 0.0, 900.0, 100.0]).unwrap_err().to_string();
        assert!(apart.contains("from one export") && apart.contains("900.0"), "{apart}");
    }
}
