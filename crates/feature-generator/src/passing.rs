//! Craters as the sweeps of a group pass them: neighbours pass mostly the same ones.

use signal::LANES;

use crate::{FeatureLoad, FeatureProgram};

/// A crater, and how each sweep of a group passes it.
#[derive(Debug, Clone, Copy)]
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

/// The craters of all programs of a group, ascending.
pub(crate) struct Passings<'p> {
    /// What each program still has.
    loads: [&'p [FeatureLoad]; LANES],
}

impl<'p> Passings<'p> {
    pub fn of(programs: &'p [FeatureProgram; LANES]) -> Self {
        Self { loads: programs.each_ref().map(|program| program.loads.as_slice()) }
    }
}

impl Iterator for Passings<'_> {
    type Item = Passing;

    fn next(&mut self) -> Option<Passing> {
        let crater = self.loads.iter().filter_map(|loads| loads.first()).map(|load| load.crater).min()?;
        let mut passing = Passing {
            crater,
            middle: [0.0; LANES],
            side: [f64::INFINITY; LANES],
            from: [f64::NEG_INFINITY; LANES],
        };
        for (lane, loads) in self.loads.iter_mut().enumerate() {
            let Some((load, rest)) = loads.split_first().filter(|(load, _)| load.crater == crater) else {
                continue;
            };
            *loads = rest;
            (passing.middle[lane], passing.side[lane], passing.from[lane]) =
                (load.middle, load.side, load.from);
        }
        Some(passing)
    }
}
