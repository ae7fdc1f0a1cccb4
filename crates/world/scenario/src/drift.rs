//! A sun that moves: its light and shadows are renewed step by step.

use landscape::Sun;
use quantities::wrap_heading;

use crate::path::shortest_turn;

/// Where the sun goes after the start.
#[derive(Debug, Clone, PartialEq)]
pub struct Drift {
    /// Times (s, ascending, above 0) and the sun then.
    pub stations: Vec<(f64, Sun)>,
    /// Time from one sun to the next (s).
    pub step: f64,
}

impl Drift {
    /// Every sun of a mission that starts with `first`, with the time from which on it holds (s): straight in azimuth
    /// (the shorter way) and elevation from station to station, sampled at the begin of each step. Azimuths are 0 to 2 pi.
    pub fn suns(&self, first: Sun) -> Vec<(f64, Sun)> {
        let steps = self.steps();
        let at = |step: usize| {
            let time = step as f64 * self.step;
            (time, self.sun(first, time))
        };
        (0..=steps).map(at).collect()
    }

    /// Steps to the last station.
    pub(crate) fn steps(&self) -> usize {
        let end = self.stations.last().map_or(0.0, |station| station.0);
        // A last station on a step is reached by it, whatever the last bits of the division.
        (end / self.step - 1e-9).ceil().max(0.0) as usize
    }

    fn sun(&self, first: Sun, time: f64) -> Sun {
        let after = self.stations.partition_point(|station| station.0 <= time);
        let (from, before) = match after {
            0 => (0.0, first),
            _ => self.stations[after - 1],
        };
        let Some(&(to, next)) = self.stations.get(after) else {
            return Sun { azimuth: wrap_heading(before.azimuth), ..before };
        };
        let share = (time - from) / (to - from);
        Sun {
            azimuth: wrap_heading(before.azimuth + share * shortest_turn(before.azimuth, next.azimuth)),
            elevation: before.elevation + share * (next.elevation - before.elevation),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Drift;
    use crate::path::shortest_turn;
    use landscape::Sun;
    use proptest::prelude::{prop_assert, prop_assert_eq, proptest};
    use quantities::{degrees, radians};

    fn sun(azimuth: f64, elevation: f64) -> Sun {
        Sun { azimuth: radians(azimuth), elevation: radians(elevation) }
    }

    #[test]
    fn a_sun_goes_the_shorter_way_step_by_step() {
        let drift = Drift { stations: vec![(10.0, sun(10.0, 4.0)), (20.0, sun(10.0, 2.0))], step: 2.5 };
        let suns = drift.suns(sun(350.0, 8.0));
        let found: Vec<[f64; 3]> = suns
            .iter()
            .map(|(time, sun)| [*time, degrees(sun.azimuth).rem_euclid(360.0), degrees(sun.elevation)])
            .collect();
        let expected = [
            [0.0, 350.0, 8.0],
            [2.5, 355.0, 7.0],
            [5.0, 0.0, 6.0],
            [7.5, 5.0, 5.0],
            [10.0, 10.0, 4.0],
            [12.5, 10.0, 3.5],
            [15.0, 10.0, 3.0],
            [17.5, 10.0, 2.5],
            [20.0, 10.0, 2.0],
        ];
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().zip(expected) {
            let turn = (found[1] - expected[1] + 180.0).rem_euclid(360.0) - 180.0;
            assert!(found[0] == expected[0] && turn.abs() < 1e-9, "{found:?} {expected:?}");
            assert!((found[2] - expected[2]).abs() < 1e-9, "{found:?} {expected:?}");
        }
    }

    #[test]
    fn the_last_step_holds_the_last_station() {
        let drift = Drift { stations: vec![(1.0, sun(0.0, 5.0))], step: 0.3 };
        let suns = drift.suns(sun(0.0, 6.0));
        assert_eq!(suns.len(), 5);
        assert_eq!(suns[4].1, sun(0.0, 5.0));
    }

    proptest! {
        /// From any azimuth to any other, over 0 and 360 or not: equal steps, together half a turn at most.
        #[test]
        fn there_is_no_seam(from in -360.0..360.0f64, to in -360.0..360.0f64, steps in 1..40usize) {
            let drift = Drift { stations: vec![(steps as f64, sun(to, 4.0))], step: 1.0 };
            let suns = drift.suns(sun(from, 4.0));
            prop_assert_eq!(suns.len(), steps + 1);
            let whole = degrees(shortest_turn(radians(from), radians(to)));
            for pair in suns.windows(2) {
                let turn = degrees(shortest_turn(pair[0].1.azimuth, pair[1].1.azimuth));
                prop_assert!((turn - whole / steps as f64).abs() < 1e-9, "{} {}", turn, whole);
            }
            for (_, sun) in &suns {
                prop_assert!((0.0..std::f64::consts::TAU).contains(&sun.azimuth));
            }
            let off = degrees(suns[steps].1.azimuth) - to;
            prop_assert!((off - 360.0 * (off / 360.0).round()).abs() < 1e-9);
        }
    }
}
