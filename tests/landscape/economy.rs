//! What a scene does not need is left out: the same bits, or a stated bound, and the record names it.

use generator::{Omission, Weight};
use glam::DVec3;
use hardware_model::{Economy, Forced, HardwareModel, LevelSwitch, Yoke};
use landscape::{Bank, CraterGrain, Landscape, Silhouette, Source};
use lunoid_tests::{Dice, Drawn};
use machine::Prepare;
use polyhedron_generator::{LeftOut, Sight};
use quantities::radians;
use scenario::Scalar;

use crate::landscape::set::{Set, bits, craters, rolling, standing_box, sun};

fn with(set: &Set, economy: Economy, scalar: Scalar) -> Drawn {
    let mut set = set.clone();
    (set.stage.settings.economy, set.stage.settings.scalar) = (economy, scalar);
    set.machine(&["*"])
}

fn assert_same_bits(a: &Drawn, b: &Drawn, what: &str) {
    assert!(bits(&a.picture) == bits(&b.picture), "{what}: pictures differ");
    assert_eq!(a.counts, b.counts, "{what}");
    assert_eq!(a.waveforms.len(), b.waveforms.len(), "{what}");
    for (a, b) in a.waveforms.iter().zip(&b.waveforms) {
        // The slope of features that are not there is 0, and -0 where the block runs and finds none.
        assert!(a.values == b.values, "{what}: {} of sweep {} differs", a.signal.name, a.sweep);
    }
}

fn bare(seed: u64) -> Set {
    let mut set = Set::over(rolling(seed, 4.0));
    set.pose.attitude.heading = radians(130.0 + 97.0 * seed as f64);
    set
}

/// Returns a set with some of everything: craters, texture, hills, shadow and rocks.
fn full(seed: u64) -> Set {
    let set = Set::over(rolling(seed, 3.0)).under(sun(70.0, 9.0));
    let middle = [set.pose.eye[0] + 60.0, set.pose.eye[1]];
    let set = set.with_craters(craters(seed, 24, middle, 60.0, 14.0)).with_texture(Source::Random);
    let hills = Silhouette::new(vec![[-0.5, 0.02], [0.0, 0.09], [0.5, 0.01]], 0.4).unwrap();
    let set = set.dressed(|ground| ground.with_silhouettes(vec![hills])).with_shadows();
    let set = set.dressed(|ground| ground.with_crater_grain(CraterGrain::new([2.0, 0.5, 3.0])));
    strewn(set, seed, 200, [0.03, 0.4])
}

/// Boxes as small as pebbles and as large as boulders.
fn strewn(set: Set, seed: u64, count: u32, [smallest, largest]: [f64; 2]) -> Set {
    let mut dice = Dice::new(seed);
    let bodies = (0..count).map(|object| {
        let place = set.ahead(dice.between(8.0, 180.0), dice.between(-40.0, 40.0));
        let half = smallest * libm::pow(largest / smallest, dice.between(0.0, 1.0));
        standing_box(object, place, half, 2.0 * half)
    });
    let bodies = bodies.collect();
    set.with_bodies(bodies)
}

#[test]
fn forcing_blocks_without_work_changes_no_bit() {
    for (seed, scalar) in [(1, Scalar::F32), (2, Scalar::F64), (3, Scalar::F32)] {
        let everything = with(&bare(seed), Economy::Everything, scalar);
        for economy in [Economy::Bounded, Economy::Lossless] {
            let what = format!("seed {seed}, {scalar:?}, {economy:?}");
            assert_same_bits(&with(&bare(seed), economy, scalar), &everything, &what);
        }
    }
}

#[test]
fn lossless_omissions_change_no_bit_of_a_full_scene() {
    for seed in [4, 5] {
        for scalar in [Scalar::F32, Scalar::F64] {
            let [lossless, everything] =
                [Economy::Lossless, Economy::Everything].map(|economy| with(&full(seed), economy, scalar));
            let counts = &lossless.counts;
            assert!(
                counts["features"] > 0 && counts["shadow_toggles"] > 0 && counts["bodies"] > 0,
                "{counts:?}"
            );
            assert_same_bits(&lossless, &everything, &format!("seed {seed}, {scalar:?}"));
        }
    }
}

#[test]
fn each_thing_that_runs_without_work_changes_no_bit() {
    for (scene, set) in [("bare", bare(1)), ("full", full(4))] {
        let lossless = with(&set, Economy::Lossless, Scalar::F32);
        for forced in Forced::ALL {
            let forcing = with(&set, Economy::LosslessBut(forced), Scalar::F32);
            assert_same_bits(&lossless, &forcing, &format!("{scene}, {}", forced.name()));
        }
    }
}

/// What is left out of a frame, worked out beside the machine.
fn left_out(set: &Set) -> LeftOut {
    let raster = set.stage.settings.raster;
    let sight = Sight::new(f64::from(raster.lines), 2.0 * libm::atan(raster.field.tan_half_height));
    let mut left_out = LeftOut::default();
    for body in set.stage.scenery.bodies(0.0) {
        sight.resolves(DVec3::from_array(set.pose.eye), body, &mut left_out);
    }
    // From cells as wide as a line is high to pixels.
    let square = f64::from(raster.lines) * raster.field.tan_half_width / raster.field.tan_half_height;
    left_out.cells *= (f64::from(raster.columns) / square).max(1.0);
    let [x, y] = [raster.field.tan_half_width, raster.field.tan_half_height];
    left_out.cells *= libm::pow(1.0 + x * x + y * y, 1.5);
    if set.stage.settings.shadows.is_some() {
        left_out.cells *= 1.0 + 1.0 / libm::sin(set.stage.scenery.sun(0.0).elevation);
    }
    left_out
}

fn sum_of_differences(a: &Drawn, b: &Drawn) -> f64 {
    a.picture.iter().zip(&b.picture).map(|(a, b)| f64::from((a - b).abs())).sum()
}

/// A set of pebbles, and whether the bound of what is left out of it holds.
fn check_bound(what: &str, set: &Set) {
    let [bounded, lossless] =
        [Economy::Bounded, Economy::Lossless].map(|economy| with(set, economy, Scalar::F64));
    let (bound, found) = (left_out(set), sum_of_differences(&bounded, &lossless));
    println!("{what}: {found} of {bound:?}");
    let told = (bounded.counts["bodies_left_out"], bounded.counts["pixels_left_out"]);
    assert_eq!(told, (bound.bodies, bound.cells.ceil() as u64), "{what}: what the record says");
    assert_eq!((lossless.counts["bodies_left_out"], lossless.counts["pixels_left_out"]), (0, 0), "{what}");
    assert!(bound.bodies > 50 && bound.bodies < 400, "{what}: {bound:?}");
    assert!(found > 0.0, "{what}: nothing to bound");
    assert!(found <= bound.cells, "{what}: {found} of {bound:?}");
}

fn pebbles(seed: u64) -> Set {
    strewn(Set::over(rolling(seed, 2.0)), seed, 400, [0.02, 0.3])
}

#[test]
fn bounded_omissions_stay_within_their_bound() {
    check_bound("high sun, no shadows", &pebbles(6).under(sun(80.0, 40.0)));
    for (seed, azimuth, elevation) in [(7, 80.0, 40.0), (8, 80.0, 15.0), (9, 80.0, 4.0), (10, 0.0, 2.0)] {
        let set = pebbles(seed).with_shadows().under(sun(azimuth, elevation));
        check_bound(&format!("sun {elevation} deg high"), &set);
    }
}

/// From above nothing hides a pebble or its shadow.
#[test]
fn the_bound_holds_from_above() {
    for (seed, elevation, columns) in [(11, 4.0, 64), (12, 20.0, 64), (13, 20.0, 256)] {
        let mut set = pebbles(seed).with_shadows().under(sun(180.0, elevation));
        set.pose.eye[2] += 40.0;
        set.pose.attitude.pitch = radians(-40.0);
        (set.stage.settings.raster.sweeps, set.stage.settings.raster.columns) = (columns, columns);
        check_bound(&format!("from above, sun {elevation} deg high, {columns} columns"), &set);
    }
}

/// On black ground, the sun behind the eye, each pebble counts as much as it can; columns are a sixth as wide as lines
/// are high.
#[test]
#[ignore = "long: .ci/long runs it"]
fn the_bound_holds_on_narrow_pixels() {
    let mut set = pebbles(14).under(sun(180.0, 15.0));
    set.pose.eye[2] += 40.0;
    set.pose.attitude.pitch = radians(-30.0);
    (set.stage.settings.raster.sweeps, set.stage.settings.raster.columns) = (400, 400);
    check_bound("narrow pixels", &set.dressed(|ground| Landscape::new(ground.bank().clone(), 0.0)));
}

/// Blocks that a session of the machine leaves out, each with what and why.
fn omissions(set: &Set) -> Vec<Omission> {
    set.stage.clone().prepare().omissions()
}

const ABSENT: [(&str, &str, &str); 7] = [
    ("feature-generator", "sub-generators and VS1", "no features"),
    ("shadow-controller", "line generators and VS2", "no shadows"),
    ("texture-generator", "texture and its adder", "no texture"),
    ("polyhedron-generator", "polyhedra and VS3", "nothing stands"),
    ("terrain-generator", "second level and its switch", "one level"),
    ("terrain-generator", "profiles of far mountains", "has none"),
    ("display", "turning yoke", "no roll"),
];

/// Which of [`ABSENT`] a set leaves out.
fn absent(set: &Set) -> Vec<usize> {
    let found = omissions(set);
    let is_left_out = |&index: &usize| {
        let (block, what, why) = ABSENT[index];
        let omission = found.iter().find(|omission| omission.block == block && omission.what == what);
        if let Some(omission) = omission {
            assert!(omission.why.contains(why), "{omission:?}");
            assert_eq!(omission.weight, Weight::Lossless);
        }
        omission.is_some()
    };
    (0..ABSENT.len()).filter(is_left_out).collect()
}

fn two_levels(set: Set) -> Set {
    let fine = set.stage.landscape.level().clone();
    let coarse = lunoid_tests::level_of(8.0 * 32.0, [-256.0; 2], [5; 2], |_, _| [0.0; 9]);
    let bank = Bank::new("two", vec![fine, coarse], None).unwrap();
    set.dressed(|ground| Landscape::new(bank, ground.albedo()))
}

#[test]
fn the_record_names_each_block_that_is_left_out_and_why() {
    let bare = || bare(1);
    let crater = |set: Set| {
        let place = set.foot();
        set.with_craters(craters(1, 1, place, 1.0, 4.0))
    };
    let body = |set: Set| {
        let place = set.ahead(10.0, 0.0);
        set.with_bodies(vec![standing_box(0, place, 1.0, 1.0)])
    };
    let hill = |set: Set| {
        let outline = Silhouette::new(vec![[0.0, 0.1], [1.0, 0.1]], 0.5).unwrap();
        set.dressed(|ground| ground.with_silhouettes(vec![outline]))
    };
    let yoke = |mut set: Set| {
        set.stage.settings.yoke =
            Some(Yoke { step: 0.0, rate: 1.0, travel: 1.0, ..HardwareModel::ideal().yoke });
        set
    };
    let levels = |set: Set| {
        let mut set = two_levels(set);
        set.stage.settings.levels = Some(LevelSwitch { range: 100.0, blend: 0.0 });
        set
    };
    let forced = |mut set: Set| {
        set.stage.settings.economy = Economy::Everything;
        set
    };
    for (scene, set, left_out) in [
        ("bare", bare(), &[0, 1, 2, 3, 4, 5, 6][..]),
        ("a crater", crater(bare()), &[1, 2, 3, 4, 5, 6]),
        ("shadow", bare().with_shadows(), &[0, 2, 3, 4, 5, 6]),
        ("texture", bare().with_texture(Source::Pattern), &[0, 1, 3, 4, 5, 6]),
        ("a body", body(bare()), &[0, 1, 2, 4, 5, 6]),
        ("two levels", levels(bare()), &[0, 1, 2, 3, 5, 6]),
        ("a hill", hill(bare()), &[0, 1, 2, 3, 4, 6]),
        ("a yoke", yoke(bare()), &[0, 1, 2, 3, 4, 5]),
        ("everything forced", forced(bare()), &[1, 2, 4, 5, 6]),
        (
            "all of it",
            yoke(hill(body(crater(levels(bare()))).with_texture(Source::Pattern)).with_shadows()),
            &[],
        ),
    ] {
        assert_eq!(absent(&set), left_out, "{scene}");
    }
}

#[test]
fn what_is_not_lossless_says_so() {
    let weight = |set: &Set, what: &str| {
        let all = omissions(set);
        all.into_iter().find(|omission| omission.what.contains(what)).map(|omission| omission.weight)
    };
    let unused = two_levels(bare(1));
    assert_eq!(weight(&unused, "coarser terrain levels"), Some(Weight::NotModelled));
    let mut bodies = strewn(bare(1), 1, 3, [0.1, 0.2]);
    assert!(matches!(weight(&bodies, "smaller than a resolution cell"), Some(Weight::Bounded(_))));
    for economy in [Economy::Lossless, Economy::Everything] {
        bodies.stage.settings.economy = economy;
        assert_eq!(weight(&bodies, "smaller than a resolution cell"), None);
    }
}
