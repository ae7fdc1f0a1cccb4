//! The video switches of the mixing unit with either gate (section 14).

use features::{Crater, Shape};
use hardware_model::Gate;
use lunoid_tests::Drawn;
use quantities::radians;
use scenario::FeatureLight;

use crate::landscape::set::{Set, flat, standing_box, sun, wave};

/// Elevation of the sun, which stands ahead (deg).
const ELEVATION: f64 = 10.0;

/// A bowl of 2 m depth and 10 m radius, 30 m ahead on level ground: its far wall looks away from nothing but the sun
/// behind it.
fn bowl(gate: Gate, threshold: f64) -> (Set, Drawn) {
    let mut set = Set::over(flat()).under(sun(0.0, ELEVATION));
    set.pose.eye[2] = 6.0;
    let parts = &mut set.stage.settings.mixing_unit;
    (parts.gate, parts.threshold) = (gate, threshold);
    let [x, y] = set.foot();
    let set = set.with_craters(vec![Crater::new([x + 30.0, y], Shape::Bowl { r1: 10.0 }, 2.0, 0.0).unwrap()]);
    let drawn = set.machine(&["fg.*", "tg.*", "mu.*", "sweep.range"]);
    (set, drawn)
}

/// Reflectivity with its sign at a slope along the way to the sun.
fn light(slope: f64) -> f64 {
    let elevation = radians(ELEVATION);
    (libm::sin(elevation) - slope * libm::cos(elevation)) / (1.0 + slope * slope).sqrt()
}

/// Signed light of the bowl where a sweep is inside it: slope north of a paraboloid, and its length.
fn inside(set: &Set, sweep: u32, range: f64) -> Option<f64> {
    let [north, east] = set.place(sweep, range);
    let [north, east] = [north - set.pose.eye[0] - 30.0, east - set.pose.eye[1]];
    let slopes = [north, east].map(|offset| 2.0 * 2.0 * offset / 100.0);
    let elevation = radians(ELEVATION);
    let up = libm::sin(elevation) - slopes[0] * libm::cos(elevation);
    let length = (1.0 + slopes[0] * slopes[0] + slopes[1] * slopes[1]).sqrt();
    (north * north + east * east < 100.0).then_some(up / length)
}

fn is_on_the_edge(set: &Set, sweep: u32, range: f64) -> bool {
    let [north, east] = set.place(sweep, range);
    let rho = libm::hypot(north - set.pose.eye[0] - 30.0, east - set.pose.eye[1]);
    (rho - 10.0).abs() < 1e-7
}

#[test]
fn a_presence_line_keeps_the_dark_wall_dark() {
    let (set, drawn) = bowl(Gate::Presence, 0.0);
    let mut dark = 0;
    for sweep in 0..set.stage.settings.raster.sweeps {
        let [ranges, found, keys] =
            ["sweep.range", "mu.reflectivity", "mu.vs1"].map(|signal| wave(&drawn, sweep, signal));
        for ((&range, &found), &key) in ranges.iter().zip(found).zip(keys) {
            if is_on_the_edge(&set, sweep, range) {
                continue;
            }
            let inside = inside(&set, sweep, range);
            let expected = inside.unwrap_or(light(0.0)).max(0.0);
            assert!(
                (found - expected).abs() < 1e-9,
                "sweep {sweep}, {range} m: {found}, expected {expected}"
            );
            assert_eq!(key == 1.0, inside.is_some());
            dark += usize::from(expected == 0.0);
        }
    }
    assert!(dark > 200, "{dark} dark samples");
}

/// The fault of section 14: where the wall is dark the gate falls, and level ground in the light shines through.
/// Straight ahead that is from `tan e r^2 / 2 a` beyond the centre to the rim.
#[test]
fn a_self_keyed_gate_lets_lit_terrain_shine_through_the_dark_wall() {
    for threshold in [0.0, 0.05] {
        let (set, drawn) = bowl(Gate::SelfKeyed, threshold);
        let mut through = Vec::new();
        for sweep in 0..set.stage.settings.raster.sweeps {
            let [ranges, found, keys] =
                ["sweep.range", "mu.reflectivity", "mu.vs1"].map(|signal| wave(&drawn, sweep, signal));
            for ((&range, &found), &key) in ranges.iter().zip(found).zip(keys) {
                if is_on_the_edge(&set, sweep, range) {
                    continue;
                }
                let inside = inside(&set, sweep, range);
                let keyed = inside.filter(|light| *light > threshold);
                let expected = keyed.unwrap_or(light(0.0));
                assert!((found - expected).abs() < 1e-9, "sweep {sweep}, {range} m: {found}");
                assert_eq!(key == 1.0, keyed.is_some());
                if sweep == 32 && inside.is_some() && keyed.is_none() {
                    through.push(range);
                }
            }
        }
        let from = 30.0 + libm::tan(radians(ELEVATION)) * 100.0 / 4.0;
        assert!(through.len() > 20, "{through:?}");
        assert!(through.iter().all(|range| *range < 40.1), "{through:?}");
        if threshold == 0.0 {
            assert!((through[0] - from).abs() < 0.3, "{} m, expected {from} m", through[0]);
        }
    }
}

/// Pictures: only the pixels of the dark wall tell the gates apart, and there the fault is bright.
#[test]
fn the_fault_is_where_the_picture_is_black() {
    let [right, wrong] = [Gate::Presence, Gate::SelfKeyed].map(|gate| bowl(gate, 0.0).1.picture);
    let mut faults = 0;
    for (index, (right, wrong)) in right.iter().zip(&wrong).enumerate() {
        assert!(wrong >= &(right - 1e-3), "pixel {index}: {right} {wrong}");
        faults += usize::from(*right == 0.0 && *wrong > 0.1);
    }
    assert!(faults > 10, "{faults} pixels");
}

/// Under the reported law a crater on a slope is lit as on level ground.
#[test]
fn the_reported_light_of_features_knows_no_terrain() {
    let (set, _) = bowl(Gate::Presence, 0.0);
    let tilt = lunoid_tests::plane(crate::landscape::set::REGION, -51.2, [0.2, 0.0]);
    let corners = [crate::landscape::set::REGIONS + 1; 2];
    let tilted = lunoid_tests::level_of(crate::landscape::set::REGION, [0.0; 2], corners, tilt);
    let mut on_slope = Set::over(tilted).under(sun(180.0, ELEVATION));
    let craters: Vec<_> = set.stage.landscape.features().craters().iter().collect();
    on_slope = on_slope.with_craters(craters);
    on_slope.stage.settings.laws.feature_light = FeatureLight::AsReported;
    on_slope.pose.eye[2] += 3.0;
    let mut level = set.clone().under(sun(180.0, ELEVATION));
    level.stage.settings.laws.feature_light = FeatureLight::AsReported;
    let lit = |set: &Set| set.machine(&["fg.reflectivity"]);
    let [a, b] = [lit(&on_slope), lit(&level)];
    for sweep in 0..64 {
        let pairs = wave(&a, sweep, "fg.reflectivity").iter().zip(wave(&b, sweep, "fg.reflectivity"));
        assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-9), "sweep {sweep}");
    }
    on_slope.stage.settings.laws.feature_light = FeatureLight::Combined;
    assert_ne!(lit(&on_slope).waveforms, a.waveforms);
}

/// A box 20 m ahead with the sun behind it: the face towards the eye is black.
fn boxed(gate: Gate) -> Drawn {
    let mut set = Set::over(flat()).under(sun(0.0, ELEVATION));
    set.stage.settings.mixing_unit.gate = gate;
    let foot = set.ahead(20.0, 0.0);
    set.with_bodies(vec![standing_box(1, foot, 2.0, 1.0)]).machine(&["pg.*"])
}

#[test]
fn a_dark_face_opens_vs3_by_its_presence_line_alone() {
    let black = |drawn: &Drawn, sweep: u32| {
        let (present, light) = (wave(drawn, sweep, "pg.present"), wave(drawn, sweep, "pg.reflectivity"));
        present.iter().zip(light).filter(|(present, light)| **present == 1.0 && **light == 0.0).count()
    };
    let [present, keyed] = [Gate::Presence, Gate::SelfKeyed].map(boxed);
    let middle = 32;
    assert!(black(&present, middle) > 0, "the face is there");
    assert_eq!(black(&keyed, middle), 0, "lit ground shines through it");
    assert_ne!(present.picture, keyed.picture);
}
