//! Databases that come back, damaged files, hostile sizes, errors of levels.

mod damage;
mod hostile;
mod levels;
mod round_trip;
mod sizes;

use quantities::unit_interval;
use terrain_database::{Boulder, Contents, Frame, Map, Range, Shape};

/// Frame on the Moon.
const FRAME: Frame =
    Frame { radius: 1_737_400.0, latitude: 0.456, longitude: 0.0634, origin: [-150.0, -250.0] };

/// Places of so many tiles of `2^order` cells; the last tile has `left` of them, stretched to fill it.
fn places(order: u32, tiles: usize, left: usize) -> Vec<f64> {
    let side = 1 << order;
    let whole = (tiles - 1) * side;
    let closer = left as f64 / side as f64;
    let place = |post: usize| 100.0 * (post.min(whole) as f64 + post.saturating_sub(whole) as f64 * closer);
    (0..=tiles * side).map(place).collect()
}

/// Ground of random heights up to `size` (m) with all that a database may have. The last column of tiles is cut short.
fn ground(seed: u64, order: u32, [columns, rows]: [usize; 2], step: Option<f64>) -> Contents {
    let places = [places(order, columns, 1), places(order, rows, 1 << order)];
    let posts: Vec<u64> = (0..(places[0].len() * places[1].len()) as u64).collect();
    let of = |word: u64, post: &u64| unit_interval(seed, &[word, *post]);
    let heights = posts.iter().map(|post| 3000.0 * of(1, post) - 1000.0).collect();
    let light = Map::U8(posts.iter().map(|post| (256.0 * of(2, post)) as u8).collect());
    let albedo = Map::U16(posts.iter().map(|post| (65536.0 * of(3, post)) as u16).collect());
    Contents {
        step,
        ranges: vec![Range { end: 1000.0, share: 0.5 }, Range { end: 2000.0, share: 0.0 }],
        light: Some(light),
        albedo: Some(albedo),
        boulders: boulders(seed),
        sidecar: "format = 1\n# Größe\n".into(),
        ..Contents::new(FRAME, order, places, heights)
    }
}

fn boulders(seed: u64) -> Vec<Boulder> {
    let boulder = |(number, shape): (u64, Shape)| Boulder {
        centre: [0, 1, 2].map(|axis| 100.0 * unit_interval(seed, &[4, number, axis])),
        radius: 1.5,
        shape,
        seed,
        number,
        yaw: 0.25,
        burial: 0.1 * number as f64,
    };
    (0..).zip([Shape::Sphere, Shape::Cube, Shape::Rock(14)]).map(boulder).collect()
}
