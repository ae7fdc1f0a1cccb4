//! Remote shadow in closed form, and against marching towards the sun.

use std::sync::Arc;

use crate::scenes::{
    bumps, crater_field, landscape, laws, level, place, plane, planes, pose, settings, standing_box, sun,
    value,
};
use features::{Crater, Features, Shape};
use generator::{Label, PlaneKind, Shade};
use hardware_model::Settings;
use landscape::{Landscape, Sun};
use proptest::prelude::*;
use scenario::{Curvature, PixelRule, Pose, Projection, Scenery, ShadowFineness, TrackPatch};

fn shadowed(columns: u32, lines: u32, ranges: [f64; 2]) -> Settings {
    let laws = laws(Projection::Exact, Curvature::None, PixelRule::Centre);
    Settings { shadows: Some(ShadowFineness::default()), ..settings(columns, lines, laws, ranges) }
}

/// Whether each pixel of ground is dark, with its place.
fn dark(
    ground: &Arc<Landscape>,
    scenery: Scenery,
    settings: &Settings,
    pose: &Pose,
) -> Vec<(bool, [f64; 2])> {
    let found = planes(ground, scenery, settings, pose);
    let pixels = 0..found.get(PlaneKind::Label).unwrap().len();
    let ground = |index: &usize| value(&found, PlaneKind::Range, *index).is_finite();
    let pixel = |index: usize| {
        let dark = value(&found, PlaneKind::Intensity, index) == 0.0;
        (dark, place(settings, pose, index, value(&found, PlaneKind::Range, index)))
    };
    pixels.filter(ground).map(pixel).collect()
}

/// Check value of 23.4: behind the sunward rim the bowl is dark up to 56.2557 m beyond its centre.
#[test]
fn the_shadow_in_a_bowl() {
    let crater = Crater::new([200.0, 200.0], Shape::Bowl { r1: 100.0 }, 20.0, 0.0).unwrap();
    let ground = Landscape::clone(&landscape(plane(80.0, [6, 6], 0.0, [0.0; 2]), 1.0));
    let ground = Arc::new(ground.with_features(Features::new(vec![crater])));
    let settings = shadowed(1, 4000, [0.1, 300.0]);
    let pixels =
        dark(&ground, Scenery::still(sun(180.0, 5.0)), &settings, &pose([130.0, 200.0, 30.0], -20.0, 0.0));
    let inside = pixels.iter().map(|(dark, [x, _])| (*dark, x - 200.0)).filter(|(_, q)| q.abs() < 99.0);
    let (mut last_dark, mut first_lit) = (f64::NEG_INFINITY, f64::INFINITY);
    for (dark, q) in inside {
        assert_eq!(dark, q < 56.25566823703998, "{q}");
        if dark { last_dark = last_dark.max(q) } else { first_lit = first_lit.min(q) }
    }
    assert!(first_lit - last_dark < 0.1, "{last_dark} {first_lit}");
}

/// A mountain 60 km off, over many regions of level ground: its crest's angle decides.
#[test]
fn a_far_mountain() {
    let peak = |m: f64, n: f64| if (m, n) == (62.0, 2.0) { 1000.0 } else { 0.0 };
    let ground =
        landscape(level(1000.0, [70, 4], |m, n| [peak(m, n), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]), 1.0);
    let pose = pose([2000.0, 2000.0, 2.0], 0.0, 0.0);
    let settings = shadowed(1, 7, [1.0, 200.0]);
    let found = planes(&ground, Scenery::still(sun(0.0, 5.0)), &settings, &pose);
    let nearest = value(&found, PlaneKind::Range, 6);
    // The flank g00(w) * 1000 m at 62 km - w * 1 km, seen from the spot: its largest tangent.
    let tangent = |x: f64| ground.height(x, 2000.0).unwrap() / (x - 2000.0 - nearest);
    let (mut low, mut high) = (61_000.0, 62_000.0);
    for _ in 0..90 {
        let (a, b) = (high - 0.6180339887498949 * (high - low), low + 0.6180339887498949 * (high - low));
        if tangent(a) < tangent(b) { low = a } else { high = b }
    }
    for (factor, expected) in [(1.0 - 1e-7, true), (1.0 + 1e-7, false)] {
        let light = Sun { azimuth: 0.0, elevation: libm::atan(tangent(low) * factor) };
        let found = planes(&ground, Scenery::still(light), &settings, &pose);
        assert_eq!(value(&found, PlaneKind::Shadow, 6) == 2.0, expected, "{factor}");
    }
}

#[test]
fn a_cube_on_level_ground() {
    let ground = landscape(plane(40.0, [3, 3], 0.0, [0.0; 2]), 1.0);
    let settings = shadowed(60, 80, [1.0, 60.0]);
    // 2 m high: under a sun 30 degrees high in the south its shadow goes 2 / tan 30 = 3.4641 m to the north.
    let bodies = || vec![standing_box(0, [60.0, 60.0, 0.0], 1.0, 2.0)];
    let scenery = || Scenery::still(sun(180.0, 30.0)).with_bodies(bodies());
    let pose = pose([62.0, 45.0, 6.0], -10.0, 90.0);
    let found = planes(&ground, scenery(), &settings, &pose);
    let (mut counts, length) = ([0; 2], 2.0 * 3.0_f64.sqrt());
    for index in 0..60 * 80 {
        if value(&found, PlaneKind::Label, index) != f64::from(Label::Terrain.code()) {
            continue;
        }
        let [x, y] = place(&settings, &pose, index, value(&found, PlaneKind::Range, index));
        let depth = (x - 61.0).min(61.0 + length - x).min(1.0 - (y - 60.0).abs());
        let shade = value(&found, PlaneKind::Shadow, index);
        let expected = if depth > 0.0 { Shade::Remote } else { Shade::Lit };
        assert!(depth.abs() < 1e-5 || shade == f64::from(expected.code()), "{x} {y}: {shade}");
        counts[usize::from(depth > 0.0)] += 1;
    }
    assert!(counts[1] > 20 && counts[0] > 1000, "{counts:?}");
    let lit = planes(&ground, scenery(), &Settings { shadows: None, ..settings }, &pose);
    assert!(lit.get(PlaneKind::Shadow).unwrap().iter().all(|&shade| shade != 2.0));
}

#[test]
fn tracks_are_dark() {
    let ground = landscape(plane(40.0, [3, 3], 0.0, [0.0; 2]), 1.0);
    let corners = [[70.0, 58.0], [71.0, 62.0], [66.0, 63.0], [64.0, 59.0]];
    let patches = [0.0, 5.0].map(|laid| TrackPatch { laid, corners: corners.map(|[x, y]| [x + laid, y]) });
    let settings = shadowed(60, 80, [1.0, 60.0]);
    let pose = pose([55.0, 60.0, 3.0], -10.0, 0.0);
    let scenery = Scenery::still(sun(180.0, 30.0)).with_patches(patches.to_vec());
    let found = planes(&ground, scenery, &settings, &pose);
    let tracks = (0..60 * 80).filter(|&index| value(&found, PlaneKind::Label, index) == 5.0);
    let places: Vec<_> =
        tracks.map(|index| place(&settings, &pose, index, value(&found, PlaneKind::Range, index))).collect();
    assert!(places.len() > 50, "{}", places.len());
    for [x, y] in places {
        // Only the first is laid at time 0; within its box, and right of its southern edge.
        assert!((64.0..71.0).contains(&x) && (58.0..63.0).contains(&y), "{x} {y}");
        assert!((x - 70.0) <= (y - 58.0) * 0.25 + 1e-5, "{x} {y}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn dark_is_what_marching_to_the_sun_finds_dark(
        (seed, count) in (any::<u64>(), 0..200u64),
        (size, relief) in (0.5..20.0f64, 0.0..1.0f64),
        (azimuth, elevation) in (0.0..360.0f64, 0.5..50.0f64),
        heading in 0.0..360.0f64,
    ) {
        let ground = Landscape::clone(&landscape(bumps(seed, relief), 1.0));
        let ground = Arc::new(ground.with_features(crater_field(seed, count, size)));
        let light = sun(azimuth, elevation);
        let pose = pose([24.0, 24.0, ground.height(24.0, 24.0).unwrap() + 2.0], -12.0, heading);
        let settings = shadowed(8, 8, [0.5, 45.0]);
        let found = planes(&ground, Scenery::still(light), &settings, &pose);
        let ([north, east, up], level) = (light.direction(), libm::cos(light.elevation));
        for index in 0..64 {
            let range = value(&found, PlaneKind::Range, index);
            let [x, y] = place(&settings, &pose, index, range);
            let Some(here) = ground.at(x, y).filter(|_| range.is_finite()) else { continue };
            let (mut highest, mut way) = (f64::NEG_INFINITY, 0.0_f64);
            while way < 40.0 {
                // Finer next to the place, where a wall may end within millimetres.
                way += (0.01 * way).clamp(0.0005, 0.005);
                let Some(height) = ground.height(x + way * north / level, y + way * east / level) else { break };
                highest = highest.max(height - here.height - way * up / level);
            }
            let dark = value(&found, PlaneKind::Intensity, index) == 0.0;
            let remote = value(&found, PlaneKind::Shadow, index) == f64::from(Shade::Remote.code());
            prop_assert!(dark || highest < 1e-3, "lit, but {highest} m in the sunbeam");
            prop_assert!(!remote || highest > -1e-2, "dark, but the sunbeam is {} m clear", -highest);
        }
    }
}
