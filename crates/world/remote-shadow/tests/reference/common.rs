//! Grounds, and shadow of a point from boundaries and from a ray.

use std::sync::Arc;

use features::{Crater, Features, Shape};
use landscape::relief::{Massif, Relief, Undulation};
use landscape::{Bank, Landscape, Sun};
use quantities::{sin_cos, unit_interval};
use remote_shadow::{Segment, Tile};

/// Steepest slope of the grounds below, which a ray must not outrun.
const STEEPEST: f64 = 2.0;
/// Smallest step of a ray (m).
const SMALLEST_STEP: f64 = 0.05;

pub fn flat(side: f64) -> Relief {
    Relief::flat(1, [side, side], 40.0)
}

pub fn landscape(relief: &Relief, craters: Vec<Crater>) -> Landscape {
    let bank = Bank::new("test", vec![relief.build().unwrap()], None).unwrap();
    Landscape::new(bank, 1.0).with_features(Features::new(craters))
}

/// Rolling ground of 640 m by 640 m with craters of 8 m to 40 m.
pub fn cratered(seed: u64) -> Landscape {
    let mut relief = Relief { seed, ..flat(640.0) };
    relief.undulation =
        Some(Undulation { rms_height: 5.0, hurst: 0.9, shortest: 120.0, longest: 600.0, waves: 200 });
    let crater = |n: u64| {
        let random = |word: u64| unit_interval(seed, &[n, word]);
        let r = 8.0 + 32.0 * random(0) * random(1);
        let (depth, rim) = (r * (0.2 + 0.4 * random(3)), r * 0.06 * random(4));
        let (shape, rim) = match n % 3 {
            0 => (Shape::Bowl { r1: r }, 0.0),
            1 => (Shape::RimmedBowl { r1: r, r2: 1.5 * r }, rim),
            _ => (Shape::FlatFloor { r1: 0.5 * r, r2: r, r3: 1.4 * r }, rim),
        };
        Crater::new([640.0 * random(5), 640.0 * random(6)], shape, depth, rim).unwrap()
    };
    landscape(&relief, (0..60).map(crater).collect())
}

/// A plane with a smooth mountain of `height` at `at`.
pub fn mountain(at: [f64; 2], height: f64) -> Landscape {
    let massif = Massif { at, height, radius: 1200.0, detail: 300.0, ruggedness: 0.0 };
    let relief = Relief { massifs: vec![massif], ..Relief::flat(1, [24_000.0, 4000.0], 100.0) };
    landscape(&relief, Vec::new())
}

/// How often boundaries enclose a place clockwise.
pub fn winding(tiles: &[Arc<Tile>], place: [f64; 2]) -> i32 {
    tiles.iter().flat_map(|tile| tile.outlines.segments()).map(|segment| crossing(&segment, place)).sum()
}

/// Crossing of a ray to the north: eastward boundaries enclose, westward ones release.
pub fn crossing(Segment { from, to }: &Segment, [x, y]: [f64; 2]) -> i32 {
    if (from[1] <= y) == (to[1] <= y) {
        return 0;
    }
    let north = from[0] + (y - from[1]) / (to[1] - from[1]) * (to[0] - from[0]);
    if north <= x {
        0
    } else if to[1] > from[1] {
        1
    } else {
        -1
    }
}

/// Whether the line from a place to the sun meets the ground: marched, with steps that cannot leap over it.
pub fn ray_is_blocked(landscape: &Landscape, sun: &Sun, [x, y]: [f64; 2], highest: f64) -> bool {
    let (sin_a, cos_a) = sin_cos(sun.azimuth);
    let (sin_e, cos_e) = sin_cos(sun.elevation);
    let tan = sin_e / cos_e;
    let start = landscape.height(x, y).unwrap();
    let mut way = 1e-4;
    while start + way * tan <= highest {
        let Some(ground) = landscape.height(x + way * cos_a, y + way * sin_a) else { return false };
        let clearance = start + way * tan - ground;
        if clearance < -1e-9 {
            return true;
        }
        way += (clearance / (STEEPEST + tan)).max(SMALLEST_STEP.min(0.1 * way));
    }
    false
}
