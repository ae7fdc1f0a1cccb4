//! Craters at the samples alone: no list of zones, no kinks.

use features::{Crater, Features};
use signal::{LANES, Real};

use crate::sub_generator::{SubGenerator, Zone};
use crate::{FeatureGenerator, FeatureLoad, FeatureProgram, Surface};

/// Where a sweep is in a crater, in the order in which it is met: zone by zone, first samples of each and the one beyond
/// the last.
struct Stretches([usize; 4]);

impl Stretches {
    const ZONES: [Zone; 3] = [Zone::Ring, Zone::Hollow, Zone::Ring];

    /// Of a crater on a sweep of which samples before `last` are drawn; `not_nearer` is the first sample at or beyond a range.
    fn of(crater: &Crater, load: &FeatureLoad, last: usize, not_nearer: &impl Fn(f64) -> usize) -> Self {
        let half = |radius: f64| (radius * radius - load.side * load.side).max(0.0).sqrt();
        let (outer, foot) = (half(crater.outer()), half(crater.foot()));
        let places = [-outer, -foot, foot, outer].map(|way| (load.middle + way).max(load.from));
        Self(places.map(|place| not_nearer(place).min(last)))
    }
}

impl FeatureGenerator<'_> {
    /// Adds the craters of a group to `surface`, in the order of the programs; `features` are those from which the programs
    /// were written, `not_nearer` the first sample at or beyond a range (m). At the samples it is what
    /// [`run`](Self::run) adds.
    pub fn lay<S: Real>(
        &self,
        features: &Features,
        programs: &[FeatureProgram; LANES],
        not_nearer: impl Fn(f64) -> usize,
        surface: &mut Surface<'_, S>,
    ) {
        for (lane, program) in programs.iter().enumerate() {
            let last = self.ranges.partition_point(|&range| range <= program.end_range);
            for load in &program.loads {
                let crater = &features.craters()[load.crater as usize];
                let Stretches(begins) = Stretches::of(crater, load, last, &not_nearer);
                if begins[0] == begins[3] {
                    continue;
                }
                let generator = SubGenerator::new(crater, load);
                for (zone, ends) in Stretches::ZONES.into_iter().zip(begins.windows(2)) {
                    if ends[0] < ends[1] {
                        generator.add(zone, self.ranges, ends[0]..ends[1], lane, surface);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use features::{Crater, Features, Shape};
    use hardware_model::{FeatureParts, Organisation};
    use proptest::prelude::{Strategy, prop_assert, prop_assert_eq, prop_oneof, proptest};
    use signal::{LANES, Lanes};

    use crate::{FeatureGenerator, FeatureProfile, FeatureProgram, Schedule, Surface};

    fn crater() -> impl Strategy<Value = Crater> {
        let shape = prop_oneof![
            (0.5..30.0f64).prop_map(|r1| (Shape::Bowl { r1 }, 0.0)),
            (0.5..30.0f64).prop_map(|r1| (Shape::RimmedBowl { r1, r2: 1.4 * r1 }, 0.3)),
            (0.5..30.0f64).prop_map(|r1| (Shape::FlatFloor { r1, r2: 2.0 * r1, r3: 2.6 * r1 }, 0.4)),
        ];
        let place = (-20.0..120.0f64, -40.0..40.0f64);
        (place, shape).prop_map(|((x, y), (shape, rim))| Crater::new([x, y], shape, 1.0, rim).unwrap())
    }

    proptest! {
        #[test]
        fn the_samples_are_those_of_the_way_with_kinks(
            craters in proptest::collection::vec(crater(), 1..12),
            end in 20.0..110.0f64,
            late in proptest::collection::vec(prop_oneof![3 => proptest::strategy::Just(f64::NEG_INFINITY), 1 => 0.0..80.0f64], 12),
        ) {
            let features = Features::new(craters);
            let ranges: Vec<f64> = (0..300).map(|k| 1.0 + 0.37 * f64::from(k)).collect();
            let schedule = Schedule {
                features: &features,
                parts: FeatureParts { sub_generators: None, organisation: Organisation::Scheduled, ..FeatureParts::default() },
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
            let not_nearer = |range: f64| ranges.partition_point(|&at| at < range);
            generator.lay(&features, &listed, not_nearer, &mut surface);
            prop_assert!(height == profile.height && along == profile.along && across == profile.across);
        }
    }
}
