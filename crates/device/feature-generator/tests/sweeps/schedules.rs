//! Which craters find a sub-generator.

use crate::common::{bowl, parts, program, rimmed, run, scene, sweeps};
use feature_generator::{FeatureGenerator, FeatureLoad, FeatureProfile, FeatureProgram, Schedule};
use features::{Crater, Features};
use hardware_model::Organisation::{self, ByRegion, Scheduled};
use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

/// Craters drawn, number dropped and most in use of type 1, of a sweep to the north over regions of 100 m.
fn north(
    craters: &[Crater],
    organisation: Organisation,
    limit: impl Into<Option<u32>>,
) -> (Vec<u32>, u32, u32) {
    let features = Features::new(craters.to_vec());
    let program = program(&features, parts(organisation, limit.into()), ([0.0, 50.0], 0.0), [0.0, 1000.0]);
    let drawn = program.loads.iter().map(|load| load.crater).collect();
    (drawn, program.dropped, program.most_in_use[0])
}

/// A bowl that the sweep is in from one range to another.
fn chord(from: f64, to: f64) -> Crater {
    bowl([0.5 * (from + to), 50.0], 0.5 * (to - from))
}

#[test]
fn overlapping_craters_need_two_sub_generators() {
    let craters = [chord(20.0, 40.0), chord(10.0, 30.0)];
    for organisation in [Scheduled, ByRegion] {
        assert_eq!(north(&craters, organisation, 1), (vec![1], 1, 1));
        assert_eq!(north(&craters, organisation, 2), (vec![0, 1], 0, 2));
    }
}

#[test]
fn a_schedule_loads_the_next_crater_where_the_last_one_ends() {
    let craters = [chord(10.0, 20.0), chord(20.0, 30.0), chord(40.0, 50.0)];
    assert_eq!(north(&craters, Scheduled, 1), (vec![0, 1, 2], 0, 1));
    // Stored by region, all three are loaded at its edge.
    assert_eq!(north(&craters, ByRegion, 1), (vec![0], 2, 1));
    assert_eq!(north(&craters, ByRegion, 2), (vec![0, 1], 1, 2));
    assert_eq!(north(&craters, ByRegion, 3), (vec![0, 1, 2], 0, 3));
}

#[test]
fn regions_free_their_sub_generators_at_their_far_edge() {
    let craters = [chord(10.0, 20.0), chord(110.0, 120.0)];
    assert_eq!(north(&craters, ByRegion, 1), (vec![0, 1], 0, 1));
    // A crater on the edge belongs to both regions and holds its sub-generator to the end of the second.
    let craters = [chord(90.0, 110.0), chord(150.0, 160.0), chord(210.0, 220.0)];
    assert_eq!(north(&craters, ByRegion, 1), (vec![0, 2], 1, 1));
    assert_eq!(north(&craters, Scheduled, 1), (vec![0, 1, 2], 0, 1));
}

#[test]
fn slanting_sweeps_meet_the_edges_of_both_axes() {
    // From (0, 50) to the north-east: the sweep leaves region (0, 0) by its east edge after 50 sqrt 2 m.
    let at = |range: f64| bowl([range / 2.0_f64.sqrt(), 50.0 + range / 2.0_f64.sqrt()], 2.0);
    let dropped = |ranges: [f64; 2]| {
        let features = Features::new(ranges.map(at).to_vec());
        let sweep = ([0.0, 50.0], std::f64::consts::FRAC_PI_4);
        program(&features, parts(ByRegion, Some(1)), sweep, [0.0, 1000.0]).dropped
    };
    assert_eq!([[60.0, 66.0], [66.0, 80.0], [80.0, 130.0], [130.0, 150.0]].map(dropped), [1, 0, 1, 0]);
}

#[test]
fn each_type_has_its_own_sub_generators() {
    let craters = [chord(10.0, 90.0), rimmed([50.0, 50.0], 20.0, 30.0, 5.0, 1.0), chord(45.0, 55.0)];
    assert_eq!(north(&craters, Scheduled, 1), (vec![0, 1], 1, 1));
    assert_eq!(north(&craters, Scheduled, None), (vec![0, 1, 2], 0, 2));
    assert_eq!(north(&craters, Scheduled, 0), (vec![], 3, 0));
}

#[test]
fn what_is_dropped_is_not_drawn() {
    let features = Features::new(vec![chord(10.0, 40.0), chord(30.0, 60.0)]);
    let ranges: Vec<f64> = (0..100).map(f64::from).collect();
    let one = |limit| {
        let program = program(&features, parts(Scheduled, limit), ([0.0, 50.0], 0.0), [0.0, 99.0]);
        let programs: [FeatureProgram; 8] = std::array::from_fn(|_| program.clone());
        let mut profile = FeatureProfile::<f64>::default();
        FeatureGenerator { ranges: &ranges }.run(&features, &programs, &mut profile);
        profile
    };
    let alone = |number: usize| {
        let mut profile = FeatureProfile::<f64>::default();
        let features = Features::new(vec![features.crater(number as u32)]);
        run(&features, &[([0.0, 50.0], 0.0); 8], &ranges, &mut profile);
        profile
    };
    assert_eq!(one(Some(1)).height, alone(0).height);
    assert_eq!(one(Some(1)).kinks, alone(0).kinks);
    let both: Vec<f64> = (0..100).map(|k| alone(0).height[k][0] + alone(1).height[k][0]).collect();
    assert_eq!(one(None).height.iter().map(|sample| sample[0]).collect::<Vec<_>>(), both);
}

proptest! {
    /// No sub-generator makes two craters at once, and none is free where a crater is dropped.
    #[test]
    fn sub_generators_are_shared_fairly(features in scene(), sweeps in sweeps(), limit in 1..4u32) {
        for sweep in sweeps {
            let range = [0.0, 300.0];
            let few = program(&features, parts(Scheduled, Some(limit)), sweep, range);
            let all = program(&features, parts(Scheduled, None), sweep, range);
            prop_assert_eq!(few.loads.len() as u32 + few.dropped, all.loads.len() as u32);
            let kind = |load: &FeatureLoad| features.crater(load.crater).type_number();
            let ends = |load: &FeatureLoad| {
                let outer = features.crater(load.crater).outer();
                let half = (outer * outer - load.side * load.side).sqrt();
                [(load.middle - half).max(range[0]), (load.middle + half).min(range[1])]
            };
            for (number, one) in few.loads.iter().enumerate() {
                prop_assert!(one.sub_generator < limit);
                for other in &few.loads[number + 1..] {
                    let ([from, to], [begin, end]) = (ends(one), ends(other));
                    let same = one.sub_generator == other.sub_generator && kind(one) == kind(other);
                    prop_assert!(!same || to <= begin || end <= from);
                }
            }
            let is_drawn = |load: &&FeatureLoad| few.loads.iter().any(|drawn| drawn.crater == load.crater);
            for lost in all.loads.iter().filter(|load| !is_drawn(load)) {
                let entry = ends(lost)[0];
                let busy = |load: &&FeatureLoad| {
                    kind(load) == kind(lost) && ends(load)[0] <= entry && ends(load)[1] > entry
                };
                prop_assert_eq!(few.loads.iter().filter(busy).count() as u32, limit);
            }
        }
    }

    /// A used program forgets what was in it.
    #[test]
    fn programs_repeat(features in scene(), sweeps in sweeps(), limit in 0..4u32) {
        let schedule = Schedule {
            features: &features,
            parts: parts(ByRegion, Some(limit)),
            region_origin: [0.0; 2],
            region_size: 100.0,
            among: None, absent: &[],
        };
        let mut used = FeatureProgram::default();
        for (eye, angle) in sweeps {
            let (sin, cos) = quantities::sin_cos(angle);
            schedule.write(eye, [cos, sin], [0.0, 200.0], &mut used);
            prop_assert_eq!(&used, &program(&features, schedule.parts, (eye, angle), [0.0, 200.0]));
        }
    }
}
