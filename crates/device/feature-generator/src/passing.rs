//! Craters as the sweeps of a group pass them: neighbours pass mostly the same ones.

use fearless_simd::prelude::{Select, SimdMask};
use fearless_simd::{Level, Simd, SimdBase, dispatch, f64x8};
use features::Features;
use signal::{Comparable, LANES, Number, eight};

use crate::chord::foot;
use crate::{FeatureLoad, FeatureProgram};

/// A crater, and how each sweep of a group passes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Passing {
    /// Index of the crater.
    pub crater: u32,
    /// Ground range at which each passes the centre (m).
    pub middle: [f64; LANES],
    /// Distance of the centre beside it, positive to the right; infinite where the crater is not drawn (m).
    pub side: [f64; LANES],
    /// Ground range from which it is drawn; negative infinity if its words are in time (m).
    pub from: [f64; LANES],
}

/// The craters that the sweeps of a group draw, ascending; used again from group to group.
#[derive(Debug, Clone, Default)]
pub struct Passings {
    pub(crate) craters: Vec<Passing>,
    /// Ground range at which the profile of each sweep ends (m).
    pub(crate) ends: [f64; LANES],
}

impl Passings {
    /// Number of craters that a sweep draws.
    pub fn count(&self, lane: usize) -> usize {
        self.craters.iter().filter(|passing| passing.side[lane].is_finite()).count()
    }

    /// Takes what the programs of a group draw.
    pub fn follow(&mut self, programs: &[FeatureProgram; LANES]) {
        self.craters.clear();
        self.ends = programs.each_ref().map(|program| program.end_range);
        let mut loads = programs.each_ref().map(|program| program.loads.as_slice());
        while let Some(passing) = next_of(&mut loads) {
            self.craters.push(passing);
        }
    }

    /// Finds what the sweeps from `eye` (north, east; m) along unit vectors meet between ground range `start` and the `ends`
    /// (m), where all is drawn in time: `among` ascending indices, which hold all that they can meet.
    pub fn find(
        &mut self,
        features: &Features,
        among: &[u32],
        eye: [f64; 2],
        directions: &[[f64; 2]; LANES],
        (start, ends): (f64, [f64; LANES]),
    ) {
        self.craters.clear();
        self.ends = ends;
        dispatch!(Level::new(), simd => self.find_by(simd, features, among, eye, directions, start));
    }

    #[inline(always)]
    fn find_by<V: Simd>(
        &mut self,
        simd: V,
        features: &Features,
        among: &[u32],
        eye: [f64; 2],
        directions: &[[f64; 2]; LANES],
        start: f64,
    ) {
        let [cos, sin] = [0, 1].map(|axis| eight(simd, &directions.map(|direction| direction[axis])));
        let ends = eight(simd, &self.ends);
        let splat = |value: f64| f64x8::splat(simd, value);
        for &crater in among {
            let (centre, outer) = features.craters().circle(crater);
            let (north, east) = (splat(centre[0] - eye[0]), splat(centre[1] - eye[1]));
            let [middle, side] = foot([north, east], [cos, sin]);
            let nearest = ends.at_most(middle.at_least(splat(start)));
            let (dx, dy) = (north - nearest * cos, east - nearest * sin);
            let is_met = (dx * dx + dy * dy).simd_lt(splat(outer * outer));
            if is_met.any_true() {
                let side = is_met.select(side, splat(f64::INFINITY));
                let (middle, side) = (middle.to_array(), side.to_array());
                self.craters.push(Passing { crater, middle, side, from: [f64::NEG_INFINITY; LANES] });
            }
        }
    }
}

/// Takes the next crater off what each program still has.
fn next_of(all: &mut [&[FeatureLoad]; LANES]) -> Option<Passing> {
    let crater = all.iter().filter_map(|loads| loads.first()).map(|load| load.crater).min()?;
    let mut passing = Passing {
        crater,
        middle: [0.0; LANES],
        side: [f64::INFINITY; LANES],
        from: [f64::NEG_INFINITY; LANES],
    };
    for (lane, loads) in all.iter_mut().enumerate() {
        let Some((load, rest)) = loads.split_first().filter(|(load, _)| load.crater == crater) else {
            continue;
        };
        *loads = rest;
        (passing.middle[lane], passing.side[lane], passing.from[lane]) = (load.middle, load.side, load.from);
    }
    Some(passing)
}
