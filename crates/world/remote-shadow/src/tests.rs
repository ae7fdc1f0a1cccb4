//! Landscapes that the tests of this crate share.

use features::{Crater, Features, Shape};
use landscape::relief::{Relief, Undulation};
use landscape::{Bank, Landscape, Level};
use quantities::unit_interval;

/// Rolling ground of 600 m by 600 m with `count` craters of all types.
pub(crate) fn cratered(seed: u64, count: u64) -> Landscape {
    let mut relief = Relief::flat(seed, [600.0, 600.0], 40.0);
    relief.undulation =
        Some(Undulation { rms_height: 6.0, hurst: 0.9, shortest: 120.0, longest: 600.0, waves: 200 });
    let bank = Bank::new("rolling", vec![relief.build().unwrap()], None).unwrap();
    Landscape::new(bank, 1.0).with_features(craters(seed, count, 600.0))
}

/// Ground of 400 m by 400 m that bends much within one square.
pub(crate) fn rough() -> Landscape {
    let mut relief = Relief::flat(2, [400.0, 400.0], 10.0);
    relief.undulation =
        Some(Undulation { rms_height: 2.0, hurst: 0.2, shortest: 30.0, longest: 60.0, waves: 200 });
    Landscape::new(Bank::new("rough", vec![relief.build().unwrap()], None).unwrap(), 1.0)
}

/// Craters of 5 m to 40 m on a square of `side` (m).
pub(crate) fn craters(seed: u64, count: u64, side: f64) -> Features {
    let crater = |n: u64| {
        let random = |word: u64| unit_interval(seed, &[n, word]);
        let r = 5.0 + 35.0 * random(0) * random(1) * random(2);
        let (depth, rim) = (r * (0.1 + 0.2 * random(3)), r * 0.06 * random(4));
        let (shape, rim) = match n % 3 {
            0 => (Shape::Bowl { r1: r }, 0.0),
            1 => (Shape::RimmedBowl { r1: r, r2: 1.5 * r }, rim),
            _ => (Shape::FlatFloor { r1: 0.5 * r, r2: r, r3: 1.4 * r }, rim),
        };
        Crater::new([side * random(5), side * random(6)], shape, depth, rim).unwrap()
    };
    Features::new((0..count).map(crater).collect())
}

/// A fine level of 2 km within a coarse one of 16 km, the same smooth ground, with craters on both.
pub(crate) fn two_levels() -> Landscape {
    let level = |size: f64, origin: f64, count: usize| {
        let words = (0..count * count).map(|n| {
            let place = [n / count, n % count].map(|k| (origin + size * k as f64) / 1500.0);
            let waves = place.map(|at| {
                let (sin, cos) = (libm::sin(at), libm::cos(at));
                [sin, cos * size / 1500.0, -sin * size * size / (1500.0 * 1500.0)]
            });
            std::array::from_fn(|index| 90.0 * waves[0][index / 3] * waves[1][index % 3])
        });
        Level::new(size, [origin; 2], [count; 2], words.collect()).unwrap()
    };
    let bank = Bank::new("two", vec![level(100.0, 0.0, 21), level(800.0, -6400.0, 21)], None).unwrap();
    Landscape::new(bank, 1.0).with_features(craters(8, 60, 2500.0))
}
