//! Populations: craters from a seed and a size-frequency law.
//!
//! | kind | type | depth below the ground / diameter | rim / diameter | outer foot / inner foot |
//! |---|---|---|---|---|
//! | fresh | 2 | 0.16, +-10 % | 0.036, +-10 % | 1.4 |
//! | degraded | 1 (every third), 2 | 0.02 to 0.12 | 0 (type 1) to 0.02, fading with the square of the depth | 1.8 |
//! | flat-floored | 3, floor 0.3 to 0.4 of the inner foot | 0.06 to 0.085 | a third of the depth | 1.4 |
//! | secondaries | 2 | 0.04 to 0.08 | 0.008 to 0.016 | 1.4 |
//!
//! **Sources.** Fresh: rim to floor 0.196 D, rim 0.036 D (Pike 1977, simple craters; his exponents of 1.01 are taken as 1),
//! hence 0.16 D below the ground; radius at ground level 0.83 of the radius of the crest (Pike 1977), hence 1.4.
//! Secondaries are about half as deep as primaries of their size (Pike and Wilhelms 1978). **Our choices.** Every
//! spread, all figures of degraded and flat-floored craters (walls stay below 35 degrees), the broad rims of the
//! degraded, and how secondaries lie ([`Kind::Secondaries`]).
//!
//! Diameters are those of the rim crest, or of the edge where there is no rim. Every draw is a hash of seed, kind,
//! number of the crater and purpose, so that nothing depends on an order.

mod draw;
mod secondaries;
mod shapes;

pub use secondaries::Primary;

use limits::Limit;

use crate::Crater;
use draw::{Draw, Purpose};
use secondaries::Throw;

/// Cumulative size-frequency law: `density (D / reference)^-slope` craters a square metre are larger than D, between the
/// smallest and the largest; none are outside.
///
/// The Moon's small craters are in equilibrium at `0.079 D^-2` (Trask 1966); younger ground has fewer, and a slope
/// nearer to 3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SizeLaw {
    /// Craters a square metre larger than `reference`.
    pub density: f64,
    /// Diameter at which `density` is given (m).
    pub reference: f64,
    /// Exponent of the law without its sign; positive.
    pub slope: f64,
    /// Smallest crater radius drawn (m).
    pub smallest: f64,
    /// Largest crater radius drawn (m).
    pub largest: f64,
}

/// What the craters are like.
#[derive(Debug, Clone, PartialEq)]
pub enum Kind {
    /// Young simple craters: deep bowls with sharp rims.
    Fresh,
    /// Old ones: shallow, rims low or gone.
    Degraded,
    /// Large ones: flat floor, wall, rim.
    FlatFloored,
    /// Shallow craters that the throw-out of larger ones made: about a dozen together, half of the groups in chains
    /// that point at their primary, half in clusters; 2 to 8 radii from its centre, densest near it.
    Secondaries(Vec<Primary>),
}

/// Craters of one kind over an area.
#[derive(Debug, Clone, PartialEq)]
pub struct Population {
    /// Seed of all draws.
    pub seed: u64,
    /// South, west, north, east edge (m). Every crater lies wholly inside.
    pub area: [f64; 4],
    /// How many of which size.
    pub sizes: SizeLaw,
    /// What they are like.
    pub kind: Kind,
}

/// Why a population cannot be.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PopulationError {
    /// Edges that enclose nothing.
    #[error(
        "area {0:?} m: expected south, west, north, east edges in ascending order, each at most 1e9 m either way"
    )]
    Area([f64; 4]),
    /// A number out of range.
    #[error("{what} {found}: expected {low} to {high}")]
    Range {
        /// Name of the number that is out of range.
        what: &'static str,
        /// Value that was given.
        found: f64,
        /// Least value that is allowed.
        low: f64,
        /// Greatest value that is allowed.
        high: f64,
    },
    /// The largest crater does not fit the area.
    #[error(
        "largest radius {radius} m: its rim reaches {outer} m, expected less than half of {side} m, the side of the area"
    )]
    TooLarge {
        /// Largest crater radius that was asked for (m).
        radius: f64,
        /// Outer foot of its rim (m).
        outer: f64,
        /// Shorter side of the area (m).
        side: f64,
    },
    /// More craters than can be held.
    #[error(
        "{found:.0} craters: expected at most {limit}; raise the smallest radius or lower the density; {advice}",
        limit = Limit::Craters.value(),
        advice = Limit::Craters
    )]
    TooMany {
        /// What the law comes to.
        found: f64,
    },
    /// Secondary craters were asked for without a primary crater.
    #[error("secondaries without primaries: expected at least one")]
    NoPrimaries,
    /// Secondaries that find no room.
    #[error(
        "no room for secondaries inside the area: expected primaries of which parts of the ring from 2 to 8 radii are inside"
    )]
    NoRoom,
}

impl SizeLaw {
    /// Craters a square metre larger than a diameter (m), were there no largest.
    pub fn larger_than(&self, diameter: f64) -> f64 {
        self.density * libm::pow(diameter / self.reference, -self.slope)
    }

    /// Craters a square metre in all.
    pub fn all(&self) -> f64 {
        self.larger_than(2.0 * self.smallest) - self.larger_than(2.0 * self.largest)
    }

    /// Radius (m) that a share (0..=1) of the craters exceed.
    fn exceeded_by(&self, share: f64) -> f64 {
        let [small, large] = [self.smallest, self.largest].map(|radius| self.larger_than(2.0 * radius));
        let larger = (large + share * (small - large)) / self.density;
        let radius = 0.5 * self.reference * libm::pow(larger, -1.0 / self.slope);
        radius.clamp(self.smallest, self.largest)
    }

    fn check(&self) -> Result<(), PopulationError> {
        within("density", self.density, 1e-18, 1e6)?;
        within("reference diameter (m)", self.reference, 1e-3, 1e6)?;
        within("slope", self.slope, 0.1, 10.0)?;
        within("smallest radius (m)", self.smallest, 1e-3, 1e6)?;
        within("largest radius (m)", self.largest, self.smallest, 1e6)
    }
}

impl Population {
    /// The craters, the largest first. Their number is that of the law, rounded; their sizes are spread over it evenly,
    /// so that every seed has its share of large ones.
    ///
    /// # Errors
    /// If a number is out of range, or secondaries find no room.
    pub fn craters(&self) -> Result<Vec<Crater>, PopulationError> {
        let count = self.count()?;
        let throw = match &self.kind {
            Kind::Secondaries(primaries) => Some(Throw::new(self, primaries, count)?),
            _ => None,
        };
        let mut craters = Vec::with_capacity(count as usize);
        for number in 0..count {
            craters.push(self.crater(number, count, throw.as_ref())?);
        }
        Ok(craters)
    }

    fn crater(&self, number: u64, count: u64, throw: Option<&Throw>) -> Result<Crater, PopulationError> {
        let draw = Draw::new(self, number);
        let radius = self.sizes.exceeded_by((number as f64 + draw.unit(Purpose::Size)) / count as f64);
        let (shape, depth, rim) = shapes::draw(&self.kind, radius, &draw);
        let outer = shapes::outer(&shape);
        let centre = match throw {
            Some(throw) => throw.place(&draw, outer)?,
            None => self.place(&draw, outer),
        };
        Ok(Crater::new(centre, shape, depth, rim).expect("all ranges have been checked"))
    }

    /// Uniform over the part of the area in which a crater of this outer radius is wholly inside.
    fn place(&self, draw: &Draw, outer: f64) -> [f64; 2] {
        let at = |axis: usize, purpose| {
            let (low, high) = (self.area[axis] + outer, self.area[axis + 2] - outer);
            low + draw.unit(purpose) * (high - low)
        };
        [at(0, Purpose::North), at(1, Purpose::East)]
    }

    /// Whether a crater lies wholly inside.
    fn holds(&self, centre: [f64; 2], outer: f64) -> bool {
        (0..2).all(|axis| {
            centre[axis] - outer >= self.area[axis] && centre[axis] + outer <= self.area[axis + 2]
        })
    }

    /// Number of craters, once all is in order.
    fn count(&self) -> Result<u64, PopulationError> {
        let [south, west, north, east] = self.area;
        if !(south < north && west < east && self.area.iter().all(|edge| edge.abs() <= 1e9)) {
            return Err(PopulationError::Area(self.area));
        }
        self.sizes.check()?;
        let (radius, side) = (self.sizes.largest, (north - south).min(east - west));
        let outer = shapes::largest_outer(&self.kind) * radius;
        if 2.0 * outer >= side {
            return Err(PopulationError::TooLarge { radius, outer, side });
        }
        let found = self.sizes.all() * (north - south) * (east - west);
        if found > Limit::Craters.value() as f64 {
            Err(PopulationError::TooMany { found })
        } else {
            Ok(found.round() as u64)
        }
    }
}

fn within(what: &'static str, found: f64, low: f64, high: f64) -> Result<(), PopulationError> {
    // NaN is not in the range either.
    if (low..=high).contains(&found) {
        Ok(())
    } else {
        Err(PopulationError::Range { what, found, low, high })
    }
}
