//! Too few parts, and more than anybody draws: stated behaviour.

use features::{Crater, Shape};
use hardware_model::{FeatureParts, Organisation, ShadowParts};
use lunoid_tests::Drawn;

use crate::landscape::pictures::{Agreement, agreement};
use crate::landscape::set::{Set, craters, flat, patch, rolling, sun, wave};

/// One sweep straight ahead.
fn alone(mut set: Set) -> Set {
    (set.stage.settings.raster.sweeps, set.stage.settings.raster.columns) = (1, 1);
    set
}

fn bowl(set: &Set, ahead: f64, r1: f64, depth: f64) -> Crater {
    let [x, y] = set.foot();
    Crater::new([x + ahead, y], Shape::Bowl { r1 }, depth, 0.0).unwrap()
}

/// Two bowls of one type that overlap and a third beyond both: the second finds the only sub-generator in use.
#[test]
fn one_sub_generator_draws_the_nearer_of_two_bowls() {
    for organisation in [Organisation::Scheduled, Organisation::ByRegion] {
        let set = alone(Set::over(flat()));
        let bowls = [bowl(&set, 40.0, 10.0, 2.0), bowl(&set, 52.0, 8.0, 1.0), bowl(&set, 140.0, 10.0, 3.0)];
        let mut set = set.with_craters(bowls.to_vec());
        let draw = |set: &Set| set.machine(&["fg.height", "sweep.range"]);
        let unlimited = draw(&set);
        assert_eq!((unlimited.counts["features"], unlimited.counts["dropped_features"]), (3, 0));
        set.stage.settings.feature_generator = FeatureParts { organisation, sub_generators: Some(1) };
        let limited = draw(&set);
        assert_eq!(
            (limited.counts["features"], limited.counts["dropped_features"]),
            (2, 1),
            "{organisation:?}"
        );
        for (found, range) in wave(&limited, 0, "fg.height").iter().zip(wave(&limited, 0, "sweep.range")) {
            let expected =
                bowls[0].profile((range - 40.0).abs())[0] + bowls[2].profile((range - 140.0).abs())[0];
            assert!((found - expected).abs() < 1e-9, "{organisation:?}, {range} m: {found}");
        }
    }
}

/// Sub-generators are counted type by type.
#[test]
fn another_type_has_a_sub_generator_of_its_own() {
    let set = alone(Set::over(flat()));
    let [x, y] = set.foot();
    let rimmed = Crater::new([x + 52.0, y], Shape::RimmedBowl { r1: 8.0, r2: 11.0 }, 1.0, 0.5).unwrap();
    let mut set = set.clone().with_craters(vec![bowl(&set, 40.0, 10.0, 2.0), rimmed]);
    set.stage.settings.feature_generator.sub_generators = Some(1);
    let counts = set.machine(&[]).counts;
    assert_eq!((counts["features"], counts["dropped_features"]), (2, 0));
}

/// Shadow from 20 m to 30 m and from 50 m to 60 m ahead; each edge runs across the sweep.
fn barred(line_generators: Option<u32>) -> (Set, Drawn) {
    let set = alone(Set::over(flat())).under(sun(45.0, 40.0)).with_shadows();
    let [x, y] = set.foot();
    let bar = |near: f64| patch([x + near, y - 5.0, x + near + 10.0, y + 5.0]);
    let mut set = set.with_patches(vec![bar(20.0), bar(50.0)]);
    set.stage.settings.shadow_controller = ShadowParts::Digital { line_generators };
    let drawn = set.machine(&["sc.gate", "mu.reflectivity", "sweep.range"]);
    (set, drawn)
}

/// An edge across a sweep along its x axis is met as long as x runs, so its line generator is never free again: with
/// `n` of them the gate changes `n` times, and where that is odd, the rest of the sweep is dark.
#[test]
fn few_line_generators_invert_the_gate() {
    for (line_generators, dropped, changes) in [
        (None, 0, &[20.0, 30.0, 50.0, 60.0][..]),
        (Some(4), 0, &[20.0, 30.0, 50.0, 60.0]),
        (Some(3), 1, &[20.0, 30.0, 50.0]),
        (Some(2), 2, &[20.0, 30.0]),
        (Some(1), 3, &[20.0]),
    ] {
        let (_, drawn) = barred(line_generators);
        let counts = (drawn.counts["dropped_segments"], drawn.counts["shadow_toggles"] as usize);
        assert_eq!(counts, (dropped, changes.len()), "{line_generators:?}");
        for (sample, range) in wave(&drawn, 0, "sweep.range").iter().enumerate() {
            let dark = changes.iter().filter(|change| *change <= range).count() % 2 == 1;
            assert_eq!(wave(&drawn, 0, "sc.gate")[sample] == 1.0, dark, "{line_generators:?}, {range} m");
            assert_eq!(wave(&drawn, 0, "mu.reflectivity")[sample] == 0.0, dark, "{range} m");
        }
    }
}

/// Shadows that overlap are one: only their outer edges change the gate, and ask for line generators.
#[test]
fn shadows_that_overlap_are_one() {
    let set = alone(Set::over(flat())).under(sun(45.0, 40.0)).with_shadows();
    let [x, y] = set.foot();
    let bars = [(20.0, 30.0), (25.0, 35.0), (22.0, 28.0)];
    let bars = bars.map(|(near, far)| patch([x + near, y - 5.0, x + far, y + 5.0]));
    let drawn = set.with_patches(bars.to_vec()).machine(&["sc.gate", "sweep.range"]);
    assert_eq!(drawn.counts["shadow_toggles"], 2);
    for (gate, range) in wave(&drawn, 0, "sc.gate").iter().zip(wave(&drawn, 0, "sweep.range")) {
        assert_eq!(*gate == 1.0, (20.0..35.0).contains(range), "{range} m");
    }
}

#[test]
fn two_thousand_shadow_segments_in_one_sweep_are_drawn() {
    let mut set = alone(Set::over(flat())).under(sun(45.0, 40.0)).with_shadows();
    set.stage.settings.raster.samples = 6000;
    let [x, y] = set.foot();
    let bar = |index: u32| x + 5.0 + 0.15 * f64::from(index);
    let patches = (0..1200).map(|index| patch([bar(index), y - 1.0, bar(index) + 0.08, y + 1.0]));
    let set = set.with_patches(patches.collect());
    let drawn = set.machine(&["sc.gate", "sweep.range"]);
    assert_eq!((drawn.counts["shadow_toggles"], drawn.counts["dropped_segments"]), (2400, 0));
    for (gate, range) in wave(&drawn, 0, "sc.gate").iter().zip(wave(&drawn, 0, "sweep.range")) {
        let place = (range - 5.0) / 0.15;
        let (index, within) = (place.floor(), 0.15 * (place - place.floor()));
        if [0.0, 0.08, 0.15].iter().any(|edge| (within - edge).abs() < 1e-9) {
            continue;
        }
        let dark = (0.0..1200.0).contains(&index) && within < 0.08;
        assert_eq!(*gate == 1.0, dark, "{range} m");
    }
    assert!(drawn.picture.iter().all(|value| (0.0..=1.0).contains(value)));
}

/// A hundred craters around one place, each inside the one before.
#[test]
fn a_hundred_nested_craters_are_drawn_as_they_are() {
    let set = Set::over(rolling(8, 2.0)).under(sun(100.0, 20.0));
    let [x, y] = set.foot();
    let nested = (0..100).map(|index| {
        let r1 = 40.0 * libm::pow(0.95, f64::from(index));
        let (centre, depth) = ([x + 70.0, y + 0.1 * r1], 0.004 * r1);
        Crater::new(centre, Shape::RimmedBowl { r1, r2: 1.2 * r1 }, depth, 0.001 * r1).unwrap()
    });
    let mut set = set.with_craters(nested.collect());
    set.pose.eye[2] += 12.0;
    set.pose.attitude.pitch = quantities::radians(-14.0);
    let drawn = set.machine(&["mu.height", "sweep.range"]);
    assert_eq!(drawn.counts["dropped_features"], 0);
    assert!(drawn.counts["features"] > 1500, "{:?}", drawn.counts);
    for sweep in [0, 31, 32, 63] {
        for (found, &range) in wave(&drawn, sweep, "mu.height").iter().zip(wave(&drawn, sweep, "sweep.range"))
        {
            let [x, y] = set.place(sweep, range);
            let expected = set.stage.landscape.height(x, y).unwrap();
            assert!((found - expected).abs() < 1e-8, "sweep {sweep}, {range} m: {found}, not {expected}");
        }
    }
    let raster = &mut set.stage.settings.raster;
    (raster.sweeps, raster.columns, raster.lines) = (144, 144, 84);
    let Agreement { off, masked } = agreement(&set);
    println!("nested: {off} off, {masked} masked");
    assert!(off <= 0.005, "{off}");
}

/// Whatever cannot be drawn is dropped and counted, and the rest is a picture.
#[test]
fn what_is_dropped_is_counted() {
    let set = Set::over(rolling(9, 3.0)).under(sun(60.0, 10.0)).with_shadows();
    let middle = [set.pose.eye[0] + 60.0, set.pose.eye[1]];
    let mut set = set.with_craters(craters(9, 60, middle, 60.0, 30.0));
    let whole = set.machine(&[]);
    set.stage.settings.feature_generator.sub_generators = Some(1);
    set.stage.settings.shadow_controller = ShadowParts::Digital { line_generators: Some(1) };
    let part = set.machine(&[]);
    assert_eq!((whole.counts["dropped_features"], whole.counts["dropped_segments"]), (0, 0));
    assert!(part.counts["dropped_features"] > 0 && part.counts["dropped_segments"] > 0, "{:?}", part.counts);
    assert_eq!(part.counts["features"] + part.counts["dropped_features"], whole.counts["features"]);
    assert!(part.picture.iter().all(|value| (0.0..=1.0).contains(value)));
    assert_ne!(part.picture, whole.picture);
}
