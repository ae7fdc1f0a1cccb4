//! From beside the area, where no sweep is drawn; numbers in every attitude.

use std::sync::Arc;

use crate::from_above::{labels, usual};
use crate::scenes::{landscape, laws, level, plane, planes, pose, ray, settings, standing_box, sun, value};
use exact::{Ceilings, Outlook, Ray, Sight};
use generator::{Label, PlaneKind};
use landscape::{Bank, LUNOID_RADIUS, Landscape, Level, Photometry, Silhouette};
use scenario::{Curvature, LevelSwitch, PixelRule, Pose, Projection, Scenery};

/// From beside the area ground is where the area is, and the rest is sky.
#[test]
fn from_beside_the_area() {
    let ground = landscape(plane(40.0, [4, 4], 3.0, [0.0; 2]), 1.0);
    let settings = usual(60, PixelRule::Centre);
    for (eye, pitch, heading) in [
        ([-50.0, 80.0, 23.0], -10.0, 0.0),
        ([300.0, 250.0, 60.0], -12.0, 225.0),
        ([80.0, -900.0, 500.0], -27.0, 90.0),
    ] {
        let pose = pose(eye, pitch, heading);
        let found = planes(&ground, Scenery::still(sun(70.0, 24.0)), &settings, &pose);
        let mut counts = [0; 2];
        for index in 0..21 * 60 {
            let ray = ray(&settings, &pose, index);
            let expected = (3.0 - eye[2]) / ray.rise;
            let place: [f64; 2] = std::array::from_fn(|axis| eye[axis] + expected * ray.direction[axis]);
            let met = expected > 0.0 && place.iter().all(|at| (0.0..=160.0).contains(at));
            let range = value(&found, PlaneKind::Range, index);
            assert_eq!(range.is_finite(), met, "{eye:?} {index}");
            assert!(
                !met || (range / expected - 1.0).abs() < 1e-6,
                "{eye:?} {index}: {range}, not {expected}"
            );
            counts[usize::from(met)] += 1;
        }
        assert!(counts.iter().all(|&count| count > 20), "{eye:?}: {counts:?}");
    }
}

/// An eye under the level of the ground, beside it, sees its side: black, and nothing behind it.
#[test]
fn the_side_of_the_ground() {
    let ground = landscape(plane(40.0, [4, 4], 3.0, [0.0; 2]), 1.0);
    let ceilings = Ceilings::new(&ground);
    let look = |eye: [f64; 3], rise: f64| {
        let outlook = Outlook::new(&ground, &ceilings, eye, Curvature::None, [0.0, 5000.0], None);
        outlook.look(&Ray { direction: [1.0, 0.0], rise })
    };
    assert_eq!(look([-50.0, 80.0, 1.0], 0.0), Sight::Cut(50.0));
    assert_eq!(look([-50.0, 80.0, 1.0], 0.039), Sight::Cut(50.0));
    assert_eq!(look([-50.0, 80.0, 1.0], 0.041), Sight::Sky);
    assert_eq!(look([-50.0, 80.0, -1e6], 1e4), Sight::Cut(50.0));
    assert_eq!(look([-50.0, 200.0, 1.0], 0.0), Sight::Sky, "the ray passes by");
    assert_eq!(look([200.0, 80.0, 1.0], 0.0), Sight::Sky, "the area lies behind");
    let scenery =
        || Scenery::still(sun(70.0, 24.0)).with_bodies(vec![standing_box(0, [80.0, 80.0, 3.0], 6.0, 9.0)]);
    let settings = usual(90, PixelRule::Centre);
    let found = planes(&ground, scenery(), &settings, &pose([-50.0, 80.0, 1.0], 2.0, 0.0));
    let (mut seen, labels) = (0, labels(&found));
    for (index, &label) in labels.iter().enumerate() {
        let ray = ray(&settings, &pose([-50.0, 80.0, 1.0], 2.0, 0.0), index);
        assert!(label == Label::Sky.code() || ray.rise > 2.0 / 60.0, "{index}: {label} through the ground");
        seen += usize::from(label == Label::Culture.code());
    }
    assert!(seen > 5, "the box stands higher than the side: {seen}");
}

/// Over coarse ground beside the fine level, with a switch: coarse before it begins, fine within, coarse behind.
#[test]
fn an_eye_beside_the_fine_level() {
    let fine = plane(10.0, [8, 8], 5.0, [0.0; 2]);
    let coarse = plane(100.0, [6, 6], 1.0, [0.0; 2]);
    let coarse = Level::new(100.0, [-300.0; 2], [7, 7], coarse.words().to_vec()).unwrap();
    let ground = Landscape::new(Bank::new("two", vec![fine, coarse], None).unwrap(), 1.0);
    let ceilings = Ceilings::new(&ground);
    let look = |switch: Option<LevelSwitch>, eye: [f64; 3], range: f64, height: f64| {
        let outlook = Outlook::new(&ground, &ceilings, eye, Curvature::None, [0.0, 5000.0], switch);
        match outlook.look(&Ray { direction: [1.0, 0.0], rise: (height - eye[2]) / range }) {
            Sight::Ground(spot) => Some((spot.range, spot.height)),
            _ => None,
        }
    };
    let switch = |range| Some(LevelSwitch { range, blend: 0.0 });
    let near = |found: Option<(f64, f64)>, range: f64, height: f64| {
        let (r, h) = found.unwrap();
        assert!((r - range).abs() < 1e-9 && (h - height).abs() < 1e-12, "{r} {h}, not {range} {height}");
    };
    let eye = [-100.0, 40.0, 50.0];
    near(look(switch(1e3), eye, 60.0, 1.0), 60.0, 1.0);
    near(look(switch(1e3), eye, 130.0, 5.0), 130.0, 5.0);
    near(look(switch(1e3), eye, 250.0, 1.0), 250.0, 1.0);
    near(look(switch(140.0), eye, 130.0, 5.0), 130.0, 5.0);
    near(look(switch(140.0), eye, 160.0, 1.0), 160.0, 1.0);
    near(look(switch(90.0), eye, 130.0, 1.0), 130.0, 1.0);
    assert_eq!(look(None, eye, 60.0, 1.0), None, "without a switch the finest level alone is seen");
    near(look(None, eye, 130.0, 5.0), 130.0, 5.0);
    near(look(switch(1e3), [-500.0, 40.0, 50.0], 230.0, 1.0), 230.0, 1.0);
    near(look(switch(1e3), [-100.0, 200.0, 50.0], 130.0, 1.0), 130.0, 1.0);
}

/// Where no sweep is drawn mountains beyond the area stand on the horizon, and below it there is nothing.
#[test]
fn silhouettes_stand_on_the_horizon() {
    let far = Silhouette::new(vec![[-3.0, 0.05], [3.0, 0.05]], 0.7).unwrap();
    let ground = Landscape::clone(&landscape(plane(40.0, [4, 4], 0.0, [0.0; 2]), 1.0));
    let ground = Arc::new(ground.with_silhouettes(vec![far]));
    for (curvature, height, pitch) in
        [(Curvature::None, 2.0, -2.0), (Curvature::Exact, 1e6, -50.0), (Curvature::Parabolic, 1e5, -19.0)]
    {
        let dip = match curvature {
            Curvature::None => 0.0,
            Curvature::Parabolic => (2.0 * height / LUNOID_RADIUS).sqrt(),
            Curvature::Exact => libm::tan(libm::acos(LUNOID_RADIUS / (LUNOID_RADIUS + height))),
        };
        let settings =
            settings(21, 300, laws(Projection::Exact, curvature, PixelRule::Centre), [12.0, 5000.0]);
        let pose = pose([-900.0, 80.0, height], pitch, 90.0);
        let found = labels(&planes(&ground, Scenery::still(sun(0.0, 30.0)), &settings, &pose));
        let mut counts = [0; 3];
        for (index, label) in found.into_iter().enumerate() {
            let over = ray(&settings, &pose, index).rise + dip;
            let kind = if over < 0.0 {
                0
            } else if over < 0.05 {
                1
            } else {
                2
            };
            let expected = if kind == 1 { Label::Silhouette } else { Label::Sky };
            assert!(
                label == expected.code() || over.abs() < 1e-9,
                "{curvature:?} {index}: {label} at {over}"
            );
            counts[kind] += 1;
        }
        assert!(counts.iter().all(|&count| count > 100), "{curvature:?}: {counts:?}");
    }
}

/// Light, texture and grids of pixels stay numbers in every attitude, over any ground.
#[test]
fn every_attitude_stays_finite() {
    let rough = landscape(
        level(20.0, [16, 16], |m, n| {
            std::array::from_fn(|k| (((m * 31.0 + n * 17.0 + k as f64 * 7.0) * 2654.43).fract() - 0.5) * 40.0)
        }),
        1.0,
    );
    let rough = Arc::new(Landscape::clone(&rough).with_photometry(Photometry::LunarLambert));
    let foot = rough.height(160.0, 160.0).unwrap();
    for eye in [
        [160.0, 160.0, foot.next_up()],
        [160.0, 160.0, foot + 1e-6],
        [160.0, 160.0, 9e8],
        [-9e8, 160.0, 5.0],
        [0.0, 0.0, 1e6],
    ] {
        for curvature in [Curvature::None, Curvature::Parabolic, Curvature::Exact] {
            for (pitch, heading, yoke) in
                [(-90.0, 0.0, 0.0), (90.0, 45.0, 1.0), (-135.0, 271.0, 3.0), (0.0, 0.0, 0.0)]
            {
                let settings =
                    settings(5, 5, laws(Projection::Exact, curvature, PixelRule::LineMean), [12.0, 1e6]);
                let pose = Pose { yoke, ..pose(eye, pitch, heading) };
                let found = planes(&rough, Scenery::still(sun(50.0, 1.0)), &settings, &pose);
                for kind in PlaneKind::ALL {
                    let values = found.get(kind).unwrap();
                    assert!(values.iter().all(|value| !value.is_nan()), "{eye:?} {pitch} {kind:?}");
                }
            }
        }
    }
}
