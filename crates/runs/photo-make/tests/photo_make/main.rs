//! Photographs of made ground: closed loop, closed forms, faults of the wishes.

mod closed_loop;
mod files;
mod grey;
mod import;
mod stand;
mod wishes;

use std::sync::Arc;

use features::{Crater, Features, Shape};
use generator::Stage;
use landscape::{Bank, Landscape, Level, Sun};
use photo_make::{Reach, Wishes};
use picture::{Depth, Transfer};
use quantities::{Rate, radians, unit_interval};
use scenario::{Display, FieldOfView, Laws, Scenery, ShadowFineness, View};

/// A level of 20 x 20 regions of 20 m whose corner (m, n) has the words `corner(m, n)`.
fn level(corner: impl Fn(u64, u64) -> [f64; 9]) -> Level {
    let words = (0..21_u64 * 21).map(|index| corner(index / 21, index % 21)).collect();
    Level::new(20.0, [0.0; 2], [21; 2], words).expect("a level")
}

/// The ground `height + north x + east y` (m), 400 m x 400 m.
fn plane(height: f64, [north, east]: [f64; 2]) -> Level {
    level(|m, n| {
        let value = height + 20.0 * (north * m as f64 + east * n as f64);
        [value, 20.0 * east, 0.0, 20.0 * north, 0.0, 0.0, 0.0, 0.0, 0.0]
    })
}

/// Random ground, words up to `relief` (m).
fn bumps(relief: f64) -> Level {
    level(|m, n| std::array::from_fn(|word| relief * (2.0 * unit_interval(5, &[m, n, word as u64]) - 1.0)))
}

/// A stage of one level under a sun at 120 degrees, 35 degrees high, with remote shadow.
fn stage(level: Level, features: Features) -> Stage {
    let bank = Bank::new("test", vec![level], None).expect("a bank");
    let sun = Sun { azimuth: radians(120.0), elevation: radians(35.0) };
    let update = Rate::new(30, 1).expect("a rate");
    Stage {
        landscape: Arc::new(Landscape::new(bank, 1.0).with_features(features)),
        scenery: Arc::new(Scenery::still(sun)),
        view: View {
            columns: 1,
            lines: 1,
            field: FieldOfView { tan_half_width: 0.5, tan_half_height: 0.3 },
            update,
            refresh: update,
            display: Display { white: 1.0, gamma: 1.0 },
            laws: Laws::default(),
            ranges: [1.0, 1e5],
            yoke: None,
            levels: None,
            shadows: Some(ShadowFineness::default()),
        },
    }
}

/// Craters of all shapes on the ground of [`stage`].
fn craters() -> Features {
    let crater = |index: u64| {
        let part = |k: u64| unit_interval(9, &[index, k]);
        let r1 = 3.0 + 12.0 * part(2);
        let centre = [400.0 * part(0), 400.0 * part(1)];
        match index % 2 {
            0 => Crater::new(centre, Shape::Bowl { r1 }, 0.4 * r1, 0.0),
            _ => Crater::new(centre, Shape::RimmedBowl { r1, r2: 1.5 * r1 }, 0.4 * r1, 0.08 * r1),
        }
    };
    Features::new((0..60).map(|index| crater(index).expect("a crater")).collect())
}

/// A vertical photograph of the middle of the ground: 48 x 36 pixels of 2 m from 300 m, its top to the north.
fn wishes() -> Wishes {
    Wishes {
        centre: [200.0, 200.0],
        size: [48, 36],
        ground_sample: 2.0,
        reach: Reach::Height(300.0),
        focal_length: 0.15,
        heading: 0.0,
        pitch: -0.5 * std::f64::consts::PI,
        roll: 0.0,
        time: 0.0,
        depth: Depth::Sixteen,
        transfer: Transfer::new(1.0, 1.0).expect("a curve"),
        noise: 0.0,
        seed: 1,
    }
}

/// The attitudes of [`wishes`] that a test goes through: straight down, turned, oblique, rolled.
fn attitudes() -> Vec<Wishes> {
    [(0.0, -90.0, 0.0), (75.0, -90.0, 0.0), (0.0, -60.0, 0.0), (200.0, -35.0, 0.0), (310.0, -50.0, 20.0)]
        .map(|(heading, pitch, roll)| Wishes {
            heading: radians(heading),
            pitch: radians(pitch),
            roll: radians(roll),
            ..wishes()
        })
        .to_vec()
}
