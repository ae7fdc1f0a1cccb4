//! Craters at the samples alone: no list of zones, no kinks.

use features::{Crater, Features};
use signal::{LANES, Real};

use crate::sub_generator::{SubGenerator, Zone};
use crate::{FeatureGenerator, FeatureLoad, FeatureProfile, FeatureProgram, Surface};

/// Ranges (m) at which a sweep goes over from zone to zone of a crater, no earlier than the word is there.
fn crossings(crater: &Crater, load: &FeatureLoad) -> [f64; 4] {
    let half = |radius: f64| (radius * radius - load.side * load.side).max(0.0).sqrt();
    let (outer, foot) = (half(crater.outer()), half(crater.foot()));
    [-outer, -foot, foot, outer].map(|way| (load.middle + way).max(load.from))
}

/// What a sweep meets of a zone: ranges (m), and where they are on the sweep clock.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    ranges: [f64; 2],
    places: [f64; 2],
}

impl FeatureGenerator<'_> {
    /// Adds the craters of a group to `surface`, in the order of the programs; `features` are those from which the programs
    /// were written, `place` of a range (m) is where it is on the sweep clock, sample k at k, from half a step before the first
    /// sample to half a step beyond the last.
    ///
    /// Heights are those of [`run`](Self::run), and slopes too but for samples less than half a step from a kink: they get of the
    /// slopes on both sides as much as either side has of the step about them. So a rim lies where it lies as far as samples
    /// can tell.
    pub fn lay<S: Real>(
        &self,
        features: &Features,
        programs: &[FeatureProgram; LANES],
        place: impl Fn(f64) -> f64,
        surface: &mut Surface<'_, S>,
    ) {
        self.lay_each(features, programs, place, surface, |_, _| {});
    }

    /// The same apart from the terrain: `profile` without kinks, present wherever it adds anything.
    pub fn lay_apart<S: Real>(
        &self,
        features: &Features,
        programs: &[FeatureProgram; LANES],
        place: impl Fn(f64) -> f64,
        profile: &mut FeatureProfile<S>,
    ) {
        let samples = self.ranges.len();
        profile.clear(samples);
        let FeatureProfile { height, along, across, present, .. } = profile;
        let mut surface = Surface { height, along, across };
        self.lay_each(features, programs, place, &mut surface, |lane, [begin, end]| {
            let touched = (begin + 0.5) as usize..((end + 0.5) as usize + 1).min(samples);
            present[touched].iter_mut().for_each(|present| present[lane] = S::ONE);
        });
    }

    /// Adds the craters, and tells for each in which lane and from where to where on the sweep clock it lies.
    fn lay_each<S: Real>(
        &self,
        features: &Features,
        programs: &[FeatureProgram; LANES],
        place: impl Fn(f64) -> f64,
        surface: &mut Surface<'_, S>,
        mut laid: impl FnMut(usize, [f64; 2]),
    ) {
        for (lane, program) in programs.iter().enumerate() {
            let last = self.end_of(program);
            for load in &program.loads {
                let crater = &features.crater(load.crater);
                let ranges = crossings(crater, load);
                let places = ranges.map(|range| place(range).min(last));
                if places[0] < places[3] {
                    let generator = SubGenerator::new(crater, load);
                    let mut lay = |zone, from: usize, to: usize| {
                        let stretch = Stretch {
                            ranges: [ranges[from], ranges[to]],
                            places: [places[from], places[to]],
                        };
                        self.lay_zone(&generator, zone, &stretch, lane, surface);
                    };
                    if ranges[1] < ranges[2] {
                        lay(Zone::Ring, 0, 1);
                        lay(Zone::Hollow, 1, 2);
                        lay(Zone::Ring, 2, 3);
                    } else {
                        lay(Zone::Ring, 0, 3);
                    }
                    laid(lane, [places[0], places[3]]);
                }
            }
        }
    }

    /// Place at which the profile of a sweep ends: half a step beyond its last sample.
    fn end_of(&self, program: &FeatureProgram) -> f64 {
        self.ranges.partition_point(|&range| range <= program.end_range) as f64 - 0.5
    }

    fn lay_zone<S: Real>(
        &self,
        generator: &SubGenerator,
        zone: Zone,
        &Stretch { ranges: [near, far], places: [begin, end] }: &Stretch,
        lane: usize,
        surface: &mut Surface<'_, S>,
    ) {
        if begin >= end {
            return;
        }
        let [first, last] = [begin, end].map(|place| (place + 0.5) as usize);
        let mut add_share = |sample: usize, share: f64| {
            // The step behind the last sample is no sample's.
            let Some(&range) = self.ranges.get(sample) else { return };
            let is_inside = (begin..end).contains(&(sample as f64));
            // Beyond its zone a law says nothing: it may be steep there, or have no value.
            let range = range.max(near).min(far);
            generator.add_share(zone, (range, sample), (share, is_inside), lane, surface);
        };
        if first == last {
            return add_share(first, end - begin);
        }
        add_share(first, first as f64 + 0.5 - begin);
        add_share(last, end + 0.5 - last as f64);
        generator.add(zone, self.ranges, first + 1..last, lane, surface);
    }
}

#[cfg(test)]
mod tests {
    use features::{Crater, Features, Shape};
    use hardware_model::{FeatureParts, Organisation};
    use proptest::prelude::{Strategy, prop_assert, prop_assert_eq, prop_oneof, proptest};
    use signal::{LANES, Lanes};

    use crate::{FeatureGenerator, FeatureLoad, FeatureProfile, FeatureProgram, Kink, Schedule, Surface};

    fn crater() -> impl Strategy<Value = Crater> {
        let shape = prop_oneof![
            (0.5..30.0f64).prop_map(|r1| (Shape::Bowl { r1 }, 0.0)),
            (0.5..30.0f64).prop_map(|r1| (Shape::RimmedBowl { r1, r2: 1.4 * r1 }, 0.3)),
            (0.5..30.0f64).prop_map(|r1| (Shape::FlatFloor { r1, r2: 2.0 * r1, r3: 2.6 * r1 }, 0.4)),
        ];
        let place = (-20.0..120.0f64, -40.0..40.0f64);
        (place, shape).prop_map(|((x, y), (shape, rim))| Crater::new([x, y], shape, 1.0, rim).unwrap())
    }

    #[test]
    fn a_kink_beside_a_sample_leaves_it_its_share() {
        let crater = Crater::new([10.3, 0.0], Shape::Bowl { r1: 5.0 }, 1.0, 0.0).unwrap();
        let (features, ranges) = (Features::new(vec![crater]), (1..30).map(f64::from).collect::<Vec<_>>());
        let load =
            FeatureLoad { crater: 0, sub_generator: 0, middle: 10.3, side: 0.0, from: f64::NEG_INFINITY };
        let mut program = FeatureProgram::default();
        (program.loads, program.end_range) = (vec![load], 29.0);
        let mut sums: [Vec<Lanes<f64>>; 3] = std::array::from_fn(|_| vec![Lanes::splat(0.0); 29]);
        let [height, along, across] = &mut sums;
        let programs = std::array::from_fn(|_| program.clone());
        let generator = FeatureGenerator { ranges: &ranges };
        generator.lay(&features, &programs, |range| range - 1.0, &mut Surface { height, along, across });
        // It begins at 5.3 m and ends at 15.3 m: a fifth of the step about 5 m, eight tenths of that about 15 m.
        let slope = |range: f64| 0.08 * (range - 10.3);
        let expected = [(4, 0.0), (5, 0.2 * slope(5.3)), (6, slope(6.0)), (15, 0.8 * slope(15.0)), (16, 0.0)];
        for (range, expected) in expected {
            assert!((sums[1][range - 1][0] - expected).abs() < 1e-12, "{range}: {}", sums[1][range - 1][0]);
        }
        assert_eq!((sums[0][4][0], sums[0][15][0]), (0.0, 0.0));
    }

    #[test]
    fn a_crater_within_a_step_has_a_slope_in_its_centre() {
        let shape = Shape::RimmedBowl { r1: 0.2, r2: 0.28 };
        let crater = Crater::new([10.0, 0.0], shape, 1.0, 0.1).unwrap();
        let (features, ranges) = (Features::new(vec![crater]), (1..30).map(f64::from).collect::<Vec<_>>());
        let load =
            FeatureLoad { crater: 0, sub_generator: 0, middle: 10.0, side: 0.0, from: f64::NEG_INFINITY };
        let mut program = FeatureProgram::default();
        (program.loads, program.end_range) = (vec![load], 29.0);
        let programs = std::array::from_fn(|_| program.clone());
        let mut profile = FeatureProfile::<f64>::default();
        FeatureGenerator { ranges: &ranges }.lay_apart(
            &features,
            &programs,
            |range| range - 1.0,
            &mut profile,
        );
        // Both halves are as steep the one way as the other.
        assert_eq!((profile.height[9][0], profile.across[9][0]), (-1.0, 0.0));
        assert!(profile.along[9][0].abs() < 1e-12, "{}", profile.along[9][0]);
        assert_eq!((profile.height[8][0], profile.along[10][0]), (0.0, 0.0));
        assert_eq!([8, 9, 10].map(|sample| profile.present[sample][0]), [0.0, 1.0, 0.0]);
    }

    proptest! {
        #[test]
        fn samples_beside_no_kink_are_those_of_the_way_with_kinks(
            craters in proptest::collection::vec(crater(), 1..12),
            end in 20.0..110.0f64,
            late in proptest::collection::vec(prop_oneof![3 => proptest::strategy::Just(f64::NEG_INFINITY), 1 => 0.0..80.0f64], 12),
        ) {
            let features = Features::new(craters);
            let ranges: Vec<f64> = (0..300).map(|k| 1.0 + 0.37 * f64::from(k)).collect();
            let schedule = Schedule {
                features: &features,
                parts: FeatureParts { sub_generators: None, organisation: Organisation::Scheduled },
                region_origin: [0.0; 2],
                region_size: 100.0,
                among: None,
            };
            let (mut programs, mut listed): ([FeatureProgram; LANES], [FeatureProgram; LANES]) = Default::default();
            for lane in 0..LANES {
                let (sin, cos) = quantities::sin_cos(0.02 * lane as f64 - 0.08);
                schedule.write([0.0; 2], [cos, sin], [ranges[0], end], &mut programs[lane]);
                schedule.list([0.0; 2], [cos, sin], [ranges[0], end], &mut listed[lane]);
                for (load, &from) in programs[lane].loads.iter_mut().zip(&late) {
                    load.from = from;
                }
                for (load, found) in programs[lane].loads.iter().zip(&mut listed[lane].loads) {
                    found.from = load.from;
                    prop_assert_eq!((load.crater, load.middle, load.side), (found.crater, found.middle, found.side));
                }
                prop_assert_eq!(programs[lane].loads.len(), listed[lane].loads.len());
            }
            let mut profile = FeatureProfile::<f64>::default();
            let generator = FeatureGenerator { ranges: &ranges };
            generator.run(&features, &programs, &mut profile);
            let zero = vec![Lanes::splat(0.0); ranges.len()];
            let (mut height, mut along, mut across) = (zero.clone(), zero.clone(), zero);
            let mut surface = Surface { height: &mut height, along: &mut along, across: &mut across };
            let place = |range: f64| if range <= 1.0 { -0.5 } else { ((range - 1.0) / 0.37).min(299.5) };
            generator.lay(&features, &listed, place, &mut surface);
            for sample in 0..ranges.len() {
                for lane in 0..LANES {
                    prop_assert!((height[sample][lane] - profile.height[sample][lane]).abs() < 1e-12);
                    let is_near = |kink: &Kink<f64>| (place(kink.range) - sample as f64).abs() <= 0.5 + 1e-9;
                    let is_late = |load: &FeatureLoad| (place(load.from) - sample as f64).abs() <= 0.5 + 1e-9;
                    // Beyond the last sample of the profile nobody looks for kinks.
                    let is_last = ranges.get(sample + 1).is_none_or(|&next| next > end);
                    if is_last || profile.kinks[lane].iter().any(is_near) || listed[lane].loads.iter().any(is_late) {
                        continue;
                    }
                    prop_assert!((along[sample][lane] - profile.along[sample][lane]).abs() < 1e-12);
                    prop_assert!((across[sample][lane] - profile.across[sample][lane]).abs() < 1e-12);
                }
            }
        }
    }
}
