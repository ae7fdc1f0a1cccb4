//! Craters at the samples alone: no list of zones, no kinks.

use fearless_simd::{Level, Simd, dispatch};
use features::Features;
use signal::{Lanes, Real};

use crate::side_by_side::{Lie, TerrainBelow};
use crate::{FeatureGenerator, FeatureProfile, Passings, Surface};

impl FeatureGenerator<'_> {
    /// Adds the craters of a group to `surface`, in their order; `features` are those among which they were found, `place` of a
    /// range (m) is where it is on the sweep clock, sample k at k, from half a step before the first
    /// sample to half a step beyond the last.
    ///
    /// Heights are those of [`run`](Self::run), and slopes too but for samples less than half a step from a kink: they get of the
    /// slopes on both sides as much as either side has of the step about them. So a rim lies where it lies as far as samples
    /// can tell.
    pub fn lay<S: Real>(
        &self,
        features: &Features,
        passings: &Passings,
        place: impl Fn(f64) -> f64,
        surface: Surface<'_, S>,
    ) {
        self.lay_all(Level::new(), features, passings, place, surface, None);
    }

    /// The same apart from the terrain: `profile` without kinks, present wherever it adds anything.
    pub fn lay_apart<S: Real>(
        &self,
        features: &Features,
        passings: &Passings,
        place: impl Fn(f64) -> f64,
        profile: &mut FeatureProfile<S>,
    ) {
        profile.clear(self.ranges.len());
        let FeatureProfile { height, along, across, present, .. } = profile;
        let surface = Surface { height, along, across };
        self.lay_all(Level::new(), features, passings, place, surface, Some(present));
    }

    fn lay_all<'s, S: Real>(
        &self,
        vectors: Level,
        features: &Features,
        passings: &Passings,
        place: impl Fn(f64) -> f64,
        surface: Surface<'s, S>,
        present: Option<&'s mut [Lanes<S>]>,
    ) {
        let samples = passings.ends.map(|end| self.ranges.partition_point(|&range| range <= end));
        let mut ground = TerrainBelow { ranges: self.ranges, place, samples, surface, present };
        dispatch!(vectors, simd => lay_passings(simd, features, passings, &mut ground));
    }
}

#[inline(always)]
fn lay_passings<L: Simd, S: Real>(
    simd: L,
    features: &Features,
    passings: &Passings,
    ground: &mut TerrainBelow<'_, '_, S, impl Fn(f64) -> f64>,
) {
    let mut lies = [Lie::default(); FOUND];
    for some in passings.craters.chunks(FOUND) {
        for (lie, passing) in lies.iter_mut().zip(some) {
            *lie = ground.find(simd, &features.crater(passing.crater), passing);
        }
        for (lie, passing) in lies.iter().zip(some) {
            ground.lay(simd, &features.crater(passing.crater), passing, lie);
        }
    }
}

/// Craters that are found before any of them is laid: nobody can guess how many samples a zone has, so that is to be known by
/// then.
const FOUND: usize = 8;

#[cfg(test)]
pub(crate) mod tests {
    use fearless_simd::Level;
    use features::{Crater, Features, Shape};
    use hardware_model::{FeatureParts, Organisation};
    use proptest::prelude::{Strategy, prop_assert, prop_assert_eq, prop_oneof, proptest};
    use signal::{LANES, Lanes};

    use crate::passing::Passing;
    use crate::{FeatureGenerator, FeatureProfile, FeatureProgram, Kink, Passings, Schedule, Surface};

    fn crater() -> impl Strategy<Value = Crater> {
        let shape = prop_oneof![
            (0.5..30.0f64).prop_map(|r1| (Shape::Bowl { r1 }, 0.0)),
            (0.5..30.0f64).prop_map(|r1| (Shape::RimmedBowl { r1, r2: 1.4 * r1 }, 0.3)),
            (0.5..30.0f64).prop_map(|r1| (Shape::FlatFloor { r1, r2: 2.0 * r1, r3: 2.6 * r1 }, 0.4)),
        ];
        let place = (-20.0..120.0f64, -40.0..40.0f64);
        (place, shape).prop_map(|((x, y), (shape, rim))| Crater::new([x, y], shape, 1.0, rim).unwrap())
    }

    /// Of any number of sub-generators.
    pub(crate) fn schedule(features: &Features) -> Schedule<'_> {
        Schedule {
            features,
            parts: FeatureParts { sub_generators: None, organisation: Organisation::Scheduled },
            region_origin: [0.0; 2],
            region_size: 100.0,
            among: None,
            absent: &[],
        }
    }

    /// All sweeps pass the centre of crater 0 at a range.
    fn over_the_middle(range: f64) -> Passings {
        let from = [f64::NEG_INFINITY; LANES];
        let passing = Passing { crater: 0, middle: [range; LANES], side: [0.0; LANES], from };
        Passings { craters: vec![passing], ends: [29.0; LANES] }
    }

    /// Unit vectors that far apart (rad).
    fn directions(turn: f64) -> [[f64; 2]; LANES] {
        std::array::from_fn(|lane| {
            let (sin, cos) = quantities::sin_cos(turn * (lane as f64 - 3.5));
            [cos, sin]
        })
    }

    #[test]
    fn a_kink_beside_a_sample_leaves_it_its_share() {
        let crater = Crater::new([10.3, 0.0], Shape::Bowl { r1: 5.0 }, 1.0, 0.0).unwrap();
        let (features, ranges) = (Features::new(vec![crater]), (1..30).map(f64::from).collect::<Vec<_>>());
        let passings = over_the_middle(10.3);
        let mut sums: [Vec<Lanes<f64>>; 3] = std::array::from_fn(|_| vec![Lanes::splat(0.0); 29]);
        let [height, along, across] = &mut sums;
        let generator = FeatureGenerator { ranges: &ranges };
        generator.lay(&features, &passings, |range| range - 1.0, Surface { height, along, across });
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
        let passings = over_the_middle(10.0);
        let mut profile = FeatureProfile::<f64>::default();
        FeatureGenerator { ranges: &ranges }.lay_apart(
            &features,
            &passings,
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
            let schedule = schedule(&features);
            let mut programs: [FeatureProgram; LANES] = Default::default();
            for (program, direction) in programs.iter_mut().zip(directions(0.02)) {
                schedule.write([0.0; 2], direction, [ranges[0], end], program);
                for (load, &from) in program.loads.iter_mut().zip(&late) {
                    load.from = from;
                }
            }
            let mut passings = Passings::default();
            passings.follow(&programs);
            let mut profile = FeatureProfile::<f64>::default();
            let generator = FeatureGenerator { ranges: &ranges };
            generator.run(&features, &programs, &mut profile);
            let zero = vec![Lanes::splat(0.0); ranges.len()];
            let (mut height, mut along, mut across) = (zero.clone(), zero.clone(), zero);
            let surface = Surface { height: &mut height, along: &mut along, across: &mut across };
            let place = |range: f64| if range <= 1.0 { -0.5 } else { ((range - 1.0) / 0.37).min(299.5) };
            generator.lay(&features, &passings, place, surface);
            for sample in 0..ranges.len() {
                for lane in 0..LANES {
                    prop_assert!((height[sample][lane] - profile.height[sample][lane]).abs() < 1e-12);
                    let is_near = |kink: &Kink<f64>| (place(kink.range) - sample as f64).abs() <= 0.5 + 1e-9;
                    let is_late = |passing: &Passing| (place(passing.from[lane]) - sample as f64).abs() <= 0.5 + 1e-9;
                    // Beyond the last sample of the profile nobody looks for kinks.
                    let is_last = ranges.get(sample + 1).is_none_or(|&next| next > end);
                    if is_last || profile.kinks[lane].iter().any(is_near) || passings.craters.iter().any(is_late) {
                        continue;
                    }
                    prop_assert!((along[sample][lane] - profile.along[sample][lane]).abs() < 1e-12);
                    prop_assert!((across[sample][lane] - profile.across[sample][lane]).abs() < 1e-12);
                }
            }
        }

        /// Eight sweeps at once meet what each meets alone: to the bit.
        #[test]
        fn passings_that_are_found_are_those_of_the_programs(
            craters in proptest::collection::vec(crater(), 1..40),
            turn in 0.001..0.3f64,
            start in 0.5..30.0f64,
            ends in proptest::array::uniform8(20.0..110.0f64),
        ) {
            let features = Features::new(craters);
            let mut programs: [FeatureProgram; LANES] = Default::default();
            for lane in 0..LANES {
                let span = [start, ends[lane]];
                schedule(&features).write([3.0, -1.0], directions(turn)[lane], span, &mut programs[lane]);
            }
            let (mut followed, mut found) = (Passings::default(), Passings::default());
            followed.follow(&programs);
            let among: Vec<u32> = (0..features.craters().len() as u32).collect();
            found.find(&features, &among, [3.0, -1.0], &directions(turn), (start, ends));
            prop_assert_eq!(found.ends, followed.ends);
            prop_assert_eq!(found.craters.len(), followed.craters.len());
            for (found, followed) in found.craters.iter_mut().zip(&followed.craters) {
                // Where a sweep does not meet a crater nobody asks where it passes.
                for lane in (0..LANES).filter(|&lane| followed.side[lane].is_infinite()) {
                    found.middle[lane] = followed.middle[lane];
                }
                prop_assert_eq!(found, followed);
            }
            for (lane, program) in programs.iter().enumerate() {
                prop_assert_eq!(found.count(lane), program.loads.len());
            }
        }

        /// A sweep beside others is the sweep alone, whatever the width of the vectors: to the bit.
        #[test]
        fn neighbours_and_vectors_change_no_bit(
            craters in proptest::collection::vec(crater(), 1..12),
            turn in 0.001..0.2f64,
            end in 20.0..110.0f64,
            lane in 0..LANES,
        ) {
            let features = Features::new(craters);
            let ranges: Vec<f64> = (0..300).map(|k| 1.0 + 0.37 * f64::from(k)).collect();
            let (mut passings, among) = (Passings::default(), (0..features.craters().len() as u32).collect::<Vec<_>>());
            passings.find(&features, &among, [0.0; 2], &directions(turn), (ranges[0], [end; LANES]));
            let mut alone = passings.clone();
            for passing in &mut alone.craters {
                passing.side = std::array::from_fn(|n| if n == lane { passing.side[n] } else { f64::INFINITY });
            }
            let lay = |vectors, passings: &Passings| {
                let mut sums: [Vec<Lanes<f32>>; 4] = std::array::from_fn(|_| vec![Lanes::splat(0.0); ranges.len()]);
                let [height, along, across, present] = &mut sums;
                let place = |range: f64| if range <= 1.0 { -0.5 } else { ((range - 1.0) / 0.37).min(299.5) };
                let surface = Surface { height, along, across };
                FeatureGenerator { ranges: &ranges }.lay_all(vectors, &features, passings, place, surface, Some(present));
                sums.map(|signal| signal.iter().map(|sample| sample[lane].to_bits()).collect::<Vec<_>>())
            };
            let together = lay(Level::new(), &passings);
            prop_assert_eq!(&together, &lay(Level::new(), &alone));
            prop_assert_eq!(&together, &lay(Level::baseline(), &passings));
        }
    }
}
