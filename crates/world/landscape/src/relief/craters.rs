//! Bowls with raised rims, drawn from a size-frequency law.

use super::error::{ReliefError, above, within};
use super::grid::Grid;
use crate::{CornerWords, WORDS};
use limits::Limit;
use quantities::unit_interval;
use std::f64::consts::{E, SQRT_2};

/// Beyond this `2 (rho/r)^2` a crater is below 1e-16 of its depth.
const FARTHEST: f64 = 41.0;

/// Least radius, in regions.
const LEAST_REGIONS: f64 = 1.5;

/// Craters of all sizes: `N(> D) = density D^-2` a square metre, sizes stratified so that each seed has its
/// share of large ones, places uniform, freshness from subdued to fresh with its logarithm uniform.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Craters {
    /// Smallest radius of the rim crest (m), at least 1.5 regions.
    pub smallest_radius: f64,
    /// Largest radius of the rim crest (m).
    pub largest_radius: f64,
    /// 0..=1; the Moon's small craters are in equilibrium at about 0.08 (Trask 1966: `10^-1.1 D^-2`).
    pub density: f64,
    /// Depth over diameter of the most subdued, above 0; 0.03 is nearly gone.
    pub subdued: f64,
    /// Depth over diameter of the freshest, at most 0.25; 0.2 is a new bowl (Pike 1977).
    pub fresh: f64,
}

/// One crater: height `depth (q - 1) e^-q` above the ground around, `q = 2 (rho/r)^2`.
///
/// The rim crest stands at `rho = r`, `depth e^-2` high, and holds exactly the volume that the bowl lost, so the
/// mean level of the ground does not depend on the number of craters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crater {
    /// Centre: north, east (m).
    pub at: [f64; 2],
    /// Radius of the rim crest (m).
    pub radius: f64,
    /// Centre of the floor below the ground around (m).
    pub depth: f64,
}

impl Crater {
    /// A crater of `ratio` depth over diameter, depth counted from the rim crest as surveys do.
    pub fn new(at: [f64; 2], radius: f64, ratio: f64) -> Self {
        let from_rim = 2.0 * radius * ratio;
        Self { at, radius, depth: from_rim / (1.0 + 1.0 / (E * E)) }
    }

    fn reach(&self) -> f64 {
        self.radius * (FARTHEST / 2.0).sqrt()
    }

    fn add_row(&self, grid: &Grid, m: usize, row: &mut [CornerWords]) {
        let d = grid.region_size;
        let north = grid.north(m) - self.at[0];
        let reach = self.reach();
        if north.abs() > reach {
            return;
        }
        let half_chord = (reach * reach - north * north).sqrt();
        let along = self.profile(north, d);
        for n in grid.columns_near(self.at[1], half_chord) {
            let across = self.profile(grid.east(n) - self.at[1], d);
            self.add_corner(&along, &across, &mut row[n]);
        }
    }

    /// One axis of the crater at `offset` (m) from its centre, derivatives per region.
    fn profile(&self, offset: f64, d: f64) -> Profile {
        let step = SQRT_2 * d / self.radius;
        let z = SQRT_2 * offset / self.radius;
        let (q, rise, bend) = (z * z, 2.0 * z * step, 2.0 * step * step);
        let e = libm::exp(-q);
        Profile {
            bell: [e, -rise * e, (rise * rise - bend) * e],
            weighted: [q * e, rise * (1.0 - q) * e, (bend * (1.0 - q) + rise * rise * (q - 2.0)) * e],
        }
    }

    /// `(q - 1) e^-q` with `q = a(u) + b(v)` is `a e^-a . e^-b + e^-a . (b - 1) e^-b`: two products of one-axis laws.
    fn add_corner(&self, along: &Profile, across: &Profile, words: &mut CornerWords) {
        for index in 0..WORDS {
            let (p, q) = (index / 3, index % 3);
            let lowered = across.weighted[q] - across.bell[q];
            words[index] += self.depth * (along.weighted[p] * across.bell[q] + along.bell[p] * lowered);
        }
    }
}

/// `e^-a` and `a e^-a` for the square a of one coordinate, with their first and second derivatives.
struct Profile {
    bell: [f64; 3],
    weighted: [f64; 3],
}

impl Craters {
    pub(super) fn check(&self, region_size: f64, extent: [f64; 2]) -> Result<(), ReliefError> {
        within("craters.smallest_radius", self.smallest_radius, LEAST_REGIONS * region_size, f64::MAX)?;
        above("craters.largest_radius", self.largest_radius, self.smallest_radius)?;
        within("craters.density", self.density, 0.0, 1.0)?;
        above("craters.subdued", self.subdued, 0.0)?;
        within("craters.fresh", self.fresh, self.subdued, 0.25)?;
        let count = self.count(extent);
        if count <= Limit::GroundCraters.value() as f64 {
            Ok(())
        } else {
            Err(ReliefError::TooManyCraters(count))
        }
    }

    /// The craters of `seed` that reach into `extent` (m) from `origin`, largest first.
    pub(super) fn draw(&self, seed: u64, origin: [f64; 2], extent: [f64; 2]) -> Vec<Crater> {
        let count = self.count(extent);
        (0..count as u64).map(|index| self.one(seed, index, count, origin, extent)).collect()
    }

    /// Rims may overlap the border from outside.
    fn margin(&self) -> f64 {
        2.0 * self.largest_radius
    }

    fn count(&self, extent: [f64; 2]) -> f64 {
        let area = extent.iter().map(|side| side + 2.0 * self.margin()).product::<f64>();
        let larger_than = |radius: f64| self.density / (4.0 * radius * radius);
        (area * (larger_than(self.smallest_radius) - larger_than(self.largest_radius))).round()
    }

    fn one(&self, seed: u64, index: u64, count: f64, origin: [f64; 2], extent: [f64; 2]) -> Crater {
        let random = |which: u64| unit_interval(seed, &[index, which]);
        // Inverse of the cumulative law: 1 / r^2 is uniform.
        let share = (index as f64 + random(0)) / count;
        let [few, many] = [self.largest_radius, self.smallest_radius].map(|radius| 1.0 / (radius * radius));
        let radius = 1.0 / (few + share * (many - few)).sqrt();
        let place = |which: usize| {
            let along = random(1 + which as u64) * (extent[which] + 2.0 * self.margin()) - self.margin();
            origin[which] + along
        };
        let ratio = self.subdued * libm::pow(self.fresh / self.subdued, random(3));
        Crater::new([place(0), place(1)], radius, ratio)
    }
}

pub(super) fn add_to(craters: &[Crater], grid: &Grid, words: &mut [CornerWords]) {
    let is_held = |crater: &&Crater| crater.radius >= LEAST_REGIONS * grid.region_size;
    grid.for_rows(words, |m, row| {
        craters.iter().filter(is_held).for_each(|crater| crater.add_row(grid, m, row));
    });
}
