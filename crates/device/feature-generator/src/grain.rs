//! What craters add to the gain of texture ([`landscape`'s law](features::Features::nearness)): rubble or dust of each crater type.
//!
//! ```text
//! sum of squares of the footprint ─▶ 1 - rho^2 / R^2 ─▶ limiter ─▶ × parameter of the crater type ─▶ sum of all ─▶ fg.grain
//! ```
//!
//! It is taken where the comparator of the footprint is, in front of the parabola and its lag. A crater of which the words come late
//! adds nothing until they are there.

use features::{Crater, Features};
use signal::{LANES, Lanes, Real};

use crate::chord::half_chord;
use crate::{FeatureGenerator, FeatureLoad, Passings};

/// The footprint of a crater on a sweep.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Footprint {
    /// Radius of its circle (m).
    pub radius: f64,
    /// Ground range at which the sweep passes the centre (m).
    pub middle: f64,
    /// Distance of the centre beside the sweep (m).
    pub side: f64,
    /// Ground range from which the crater is drawn (m).
    pub from: f64,
}

impl Footprint {
    pub fn of(crater: &Crater, load: &FeatureLoad) -> Self {
        Self { radius: crater.outer(), middle: load.middle, side: load.side, from: load.from }
    }

    /// Adds `added` times how near each sample of a lane is to the centre.
    pub fn add<S: Real>(&self, added: f64, ranges: &[f64], lane: usize, grain: &mut [Lanes<S>]) {
        let half = half_chord(self.radius, self.side);
        let beyond = |range: f64| ranges.partition_point(|&sample| sample <= range);
        let first = beyond((self.middle - half).max(self.from));
        let last = beyond(self.middle + half).max(first);
        let square = self.radius * self.radius;
        for (range, grain) in ranges[first..last].iter().zip(&mut grain[first..last]) {
            let offset = range - self.middle;
            let near = 1.0 - (offset * offset + self.side * self.side) / square;
            grain[lane] += S::from_f64(added * near);
        }
    }
}

impl FeatureGenerator<'_> {
    /// What the craters that sweeps pass add to the gain of texture at each sample. A crater of a type (1 to 3) adds `added` in its middle.
    pub fn grain<S: Real>(
        &self,
        features: &Features,
        passings: &Passings,
        added: impl Fn(u32) -> f64,
        grain: &mut Vec<Lanes<S>>,
    ) {
        begin(self.ranges, grain);
        for passing in &passings.craters {
            let crater = features.crater(passing.crater);
            for lane in (0..LANES).filter(|&lane| passing.side[lane].is_finite()) {
                let ranges = up_to(self.ranges, passings.ends[lane]);
                let (middle, side, from) = (passing.middle[lane], passing.side[lane], passing.from[lane]);
                let footprint = Footprint { radius: crater.outer(), middle, side, from };
                footprint.add(added(crater.type_number()), ranges, lane, grain);
            }
        }
    }
}

/// Nothing yet, at each of the `ranges`.
pub(crate) fn begin<S: Real>(ranges: &[f64], grain: &mut Vec<Lanes<S>>) {
    grain.clear();
    grain.resize(ranges.len(), Lanes::default());
}

/// Ranges of the samples of a profile that ends at `end` (m).
pub(crate) fn up_to(ranges: &[f64], end: f64) -> &[f64] {
    &ranges[..ranges.partition_point(|&range| range <= end)]
}

#[cfg(test)]
mod tests {
    use features::{Crater, Features, Shape};
    use proptest::prelude::{prop_assert, prop_assert_eq, proptest};
    use signal::{LANES, Lanes};

    use crate::preview::tests::schedule;
    use crate::{FeatureGenerator, FeatureProgram, Passings};

    fn features(places: &[(f64, f64, f64)]) -> Features {
        let shape = |number: usize, r: f64| match number % 3 {
            0 => Shape::Bowl { r1: r },
            1 => Shape::RimmedBowl { r1: r, r2: 1.4 * r },
            _ => Shape::FlatFloor { r1: r, r2: 1.5 * r, r3: 1.9 * r },
        };
        let crater = |(number, &(x, y, r)): (usize, &(f64, f64, f64))| {
            let rim = if number % 3 == 0 { 0.0 } else { 0.1 };
            Crater::new([x, y], shape(number, r), 1.0, rim).unwrap()
        };
        Features::new(places.iter().enumerate().map(crater).collect())
    }

    fn passings(features: &Features, directions: &[[f64; 2]; LANES], from: f64) -> Passings {
        let schedule = schedule(features);
        let programs = directions.map(|direction| {
            let mut program = FeatureProgram::default();
            schedule.write([0.0; 2], direction, [0.5, 90.0], &mut program);
            program.loads.iter_mut().for_each(|load| load.from = from);
            program
        });
        let mut passings = Passings::default();
        passings.follow(&programs);
        passings
    }

    proptest! {
        /// The law of the ground, read along sweeps.
        #[test]
        fn sweeps_read_the_gain_of_the_ground(
            places in proptest::collection::vec((1.0..80.0f64, -20.0..20.0f64, 0.5..15.0f64), 1..9),
        ) {
            let features = features(&places);
            let directions: [[f64; 2]; LANES] = std::array::from_fn(|lane| {
                let (sin, cos) = quantities::sin_cos(0.04 * (lane as f64 - 3.5));
                [cos, sin]
            });
            let ranges: Vec<f64> = (1..300).map(|k| 0.35 * f64::from(k)).collect();
            let added = |kind: u32| [2.0, -1.0, 0.5][kind as usize - 1];
            let passings = passings(&features, &directions, f64::NEG_INFINITY);
            let mut found = vec![Lanes::splat(9.0_f64); 3];
            FeatureGenerator { ranges: &ranges }.grain(&features, &passings, added, &mut found);
            prop_assert_eq!(found.len(), ranges.len());
            for (range, grain) in ranges.iter().zip(&found) {
                for (lane, [cos, sin]) in directions.iter().enumerate() {
                    let expected = features.nearness(range * cos, range * sin, added);
                    let expected = if *range <= 90.0 { expected } else { 0.0 };
                    prop_assert!((grain[lane] - expected).abs() < 1e-12, "{} {expected}", grain[lane]);
                }
            }
        }
    }

    #[test]
    fn late_words_add_nothing_until_they_are_there() {
        let features = features(&[(20.0, 0.0, 10.0)]);
        let ranges: Vec<f64> = (1..40).map(f64::from).collect();
        let mut grain: Vec<Lanes<f64>> = Vec::new();
        let mut at = |from: f64| {
            let passings = passings(&features, &[[1.0, 0.0]; LANES], from);
            FeatureGenerator { ranges: &ranges }.grain(&features, &passings, |_| 1.0, &mut grain);
            [grain[17][3], grain[18][3]]
        };
        assert_eq!(at(f64::NEG_INFINITY), [0.96, 0.99], "at 18 and 19 m");
        assert_eq!(at(18.0), [0.0, 0.99]);
    }
}
