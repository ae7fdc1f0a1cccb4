//! The whole scene elsewhere: ground, craters, bodies, tracks and eye moved by an even number of regions.

use features::Crater;
use glam::DVec3;
use landscape::{Bank, Landscape, Level, Source};
use lunoid_tests::{Drawn, level_of};
use scenario::{Scalar, Standing, TrackPatch};

use crate::landscape::set::{REGION, Set, bits, craters, patch, rolling, standing_box, sun};

/// Lengths that double precision adds without rounding.
fn dyadic(length: f64) -> f64 {
    (length * 64.0).round() / 64.0
}

fn rounded(crater: &Crater) -> Crater {
    Crater::new(crater.centre().map(dyadic), crater.shape(), crater.depth(), crater.rim()).unwrap()
}

/// Returns a set with everything but shadow.
fn lit(seed: u64, scalar: Scalar) -> Set {
    let mut set = Set::over(rolling(seed, 3.0)).under(sun(75.0, 12.0));
    set.stage.settings.scalar = scalar;
    set.pose.eye = [dyadic(250.3), dyadic(260.7), dyadic(set.pose.eye[2] + 2.0)];
    let middle = [set.pose.eye[0] + 50.0, set.pose.eye[1]];
    let craters = craters(seed, 30, middle, 50.0, 16.0).iter().map(rounded).collect();
    let set = set.with_craters(craters);
    let bodies = (0..12).map(|object| {
        let [x, y, height] = set.ahead(10.0 + 5.0 * f64::from(object), 3.0 * f64::from(object) - 15.0);
        standing_box(object, [x, y, height].map(dyadic), 0.5, 1.25)
    });
    let bodies = bodies.collect();
    set.with_bodies(bodies)
}

fn moved_body(standing: &Standing, by: DVec3) -> Standing {
    let mut moved = standing.clone();
    moved.body.foot += by;
    moved.body.centre += by;
    moved
}

/// The same ground `regions` further: its grid begins further.
fn begun_further(set: &Set, regions: [f64; 2]) -> Level {
    let old = set.stage.landscape.level();
    let [north, east] = old.corners();
    let origin = [0, 1].map(|axis: usize| old.origin()[axis] + regions[axis] * REGION);
    level_of(REGION, origin, [north, east], |m, n| old.words()[m * east + n])
}

/// The same ground `regions` further: its grid has more regions in the south and west.
fn padded(set: &Set, regions: [f64; 2]) -> Level {
    let old = set.stage.landscape.level();
    let ([north, east], by) = (old.corners(), regions.map(|count| count as usize));
    level_of(REGION, old.origin(), [north + by[0], east + by[1]], |m, n| {
        old.words()[m.saturating_sub(by[0]) * east + n.saturating_sub(by[1])]
    })
}

/// The same set on `level`, `regions` further.
fn moved(set: &Set, regions: [f64; 2], level: Level) -> Set {
    let by = regions.map(|count| count * REGION);
    let place = |[x, y]: [f64; 2]| [x + by[0], y + by[1]];
    let craters = set.stage.landscape.features().craters().iter().map(|crater| {
        Crater::new(place(crater.centre()), crater.shape(), crater.depth(), crater.rim()).unwrap()
    });
    let bodies = set.stage.scenery.standing().iter();
    let bodies = bodies.map(|body| moved_body(body, DVec3::new(by[0], by[1], 0.0))).collect();
    let patches = set.stage.scenery.patches(f64::INFINITY).iter();
    let patches = patches.map(|patch| TrackPatch { corners: patch.corners.map(place), ..*patch }).collect();
    let bank = Bank::new("moved", vec![level], None).unwrap();
    let there = set.clone().dressed(|ground| Landscape::new(bank, ground.albedo()));
    let mut there = there.with_craters(craters.collect()).with_bodies(bodies).with_patches(patches);
    if set.stage.landscape.texture().is_some() {
        there = there.with_texture(Source::Pattern);
    }
    let [x, y, height] = set.pose.eye;
    there.pose.eye = [x + by[0], y + by[1], height];
    there
}

fn assert_same_bits(a: &Drawn, b: &Drawn, what: &str) {
    assert!(bits(&a.picture) == bits(&b.picture), "{what}: pictures differ");
    assert_eq!(a.counts, b.counts, "{what}");
    // The number of a corner is its place in the grid that is stored.
    let waves = a.waveforms.iter().zip(&b.waveforms);
    for (a, b) in waves.filter(|(a, _)| a.signal.unit != signal::Unit::Corner) {
        let same = a.values.iter().zip(&b.values).all(|(a, b)| a.to_bits() == b.to_bits());
        assert!(same, "{what}: {} of sweep {} differs", a.signal.name, a.sweep);
    }
}

#[test]
fn a_lit_scene_elsewhere_has_the_same_bits() {
    for (seed, scalar) in [(1, Scalar::F32), (2, Scalar::F64)] {
        let here = lit(seed, scalar);
        let drawn = here.machine(&["*"]);
        assert!(drawn.counts["features"] > 0 && drawn.counts["bodies"] > 0);
        for regions in [[2.0, -4.0], [-16.0, 0.0], [64.0, 128.0]] {
            let there = moved(&here, regions, begun_further(&here, regions)).machine(&["*"]);
            assert_same_bits(&drawn, &there, &format!("seed {seed}, {scalar:?}, {regions:?}"));
        }
        let there = moved(&here, [2.0, 6.0], padded(&here, [2.0, 6.0])).machine(&["*"]);
        assert_same_bits(&drawn, &there, &format!("seed {seed}, {scalar:?}, in the grid"));
    }
}

/// A stored texture is mirrored from region to region, and so is the same again two regions on, to the rounding of
/// the place.
#[test]
fn a_stored_texture_is_the_same_two_regions_on() {
    let here = lit(1, Scalar::F64).with_texture(Source::Pattern);
    let off = |regions: [f64; 2]| {
        let there = moved(&here, regions, padded(&here, regions));
        let [a, b] = [&here, &there].map(|set| set.machine(&["txg.texture"]));
        let pairs = a.waveforms.iter().zip(&b.waveforms).flat_map(|(a, b)| a.values.iter().zip(&b.values));
        pairs.fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()))
    };
    assert!(off([2.0, 6.0]) < 1e-12, "{}", off([2.0, 6.0]));
    assert!(off([1.0, 0.0]) > 0.01, "one region on it is another");
}

/// Profiles of shadow lie on a lattice of the Moon, not of the scene: edges move by less than two of them.
#[test]
fn a_shadowed_scene_elsewhere_differs_along_edges_of_shadow_only() {
    for seed in [3, 4] {
        let here = lit(seed, Scalar::F64).under(sun(75.0, 6.0)).with_shadows();
        let [x, y] = here.foot();
        let here = here.with_patches(vec![patch([x + 5.0, y - 4.0, x + 6.0, y + 4.0])]);
        let there = moved(&here, [6.0, -8.0], begun_further(&here, [6.0, -8.0]));
        let [a, b] = [&here, &there].map(|set| set.machine(&["sc.gate"]));
        let share = |differ: usize, all: usize| differ as f64 / all as f64;
        let pixels = a.picture.iter().zip(&b.picture).filter(|(a, b)| (*a - *b).abs() > 2.0 / 255.0).count();
        let samples =
            |drawn: &Drawn| drawn.waveforms.iter().flat_map(|wave| wave.values.clone()).collect::<Vec<_>>();
        let (a_gate, b_gate) = (samples(&a), samples(&b));
        let gates = a_gate.iter().zip(&b_gate).filter(|(a, b)| a != b).count();
        println!("seed {seed}: {pixels} pixels, {gates} samples differ");
        assert!(a_gate.iter().filter(|gate| **gate == 1.0).count() > 2000);
        assert!(share(gates, a_gate.len()) < 0.005, "{gates} samples");
        assert!(share(pixels, a.picture.len()) < 0.02, "{pixels} pixels");
    }
}
