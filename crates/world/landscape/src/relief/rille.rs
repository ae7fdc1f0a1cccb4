//! Winding valleys and ridges.

use super::error::{ReliefError, above, finite, within};
use super::grid::Grid;
use super::jet::Jet;
use super::waves::REGIONS_A_WAVE;
use crate::CornerWords;
use quantities::{sin_cos, unit_interval};
use std::f64::consts::PI;

/// Beyond this exponent a cross profile is below 1e-16 of its depth.
const FARTHEST: f64 = 37.0;

/// Least width, in regions.
const LEAST_REGIONS: f64 = 4.0;

/// A valley across the whole area, of cross profile `-depth exp(-(2 t / width)^4)` at distance t from its middle:
/// steep walls and a flat floor, as of Hadley Rille (1500 m wide, 300 m deep).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rille {
    /// A point of its middle line, were it straight: north, east (m).
    pub through: [f64; 2],
    /// Its direction, clockwise from north (rad).
    pub azimuth: f64,
    /// Width where the depth is 1/e of the full (m), at least 4 regions.
    pub width: f64,
    /// Depth of the floor (m); negative makes a ridge.
    pub depth: f64,
    /// Winding; none makes it straight.
    pub meander: Option<Meander>,
}

/// Winding of a rille: two sines of incommensurable lengths, their phases by the seed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meander {
    /// Largest swing to either side (m).
    pub swing: f64,
    /// Length of a bend (m).
    pub length: f64,
}

impl Meander {
    /// Offset of the middle line at `along` (m).
    fn offset(&self, along: Jet, seed: u64) -> Jet {
        let k = 2.0 * PI / self.length;
        let sine = |ratio: f64, which: u64| {
            along.scaled(k * ratio).plus(2.0 * PI * unit_interval(seed, &[which])).sin()
        };
        sine(1.0, 0).scaled(0.6 * self.swing) + sine(0.618, 1).scaled(0.4 * self.swing)
    }
}

impl Rille {
    pub(super) fn check(&self, name: &str, region_size: f64) -> Result<(), ReliefError> {
        finite(format!("{name}.through north"), self.through[0])?;
        finite(format!("{name}.through east"), self.through[1])?;
        finite(format!("{name}.azimuth"), self.azimuth)?;
        within(format!("{name}.width"), self.width, LEAST_REGIONS * region_size, 1e7)?;
        within(format!("{name}.depth"), self.depth, -1e5, 1e5)?;
        if let Some(meander) = &self.meander {
            within(format!("{name}.meander.swing"), meander.swing, 0.0, 1e7)?;
            above(format!("{name}.meander.length"), meander.length, REGIONS_A_WAVE * region_size)?;
        }
        Ok(())
    }

    pub(super) fn add_to(&self, grid: &Grid, seed: u64, words: &mut [CornerWords]) {
        let d = grid.region_size;
        if self.width < LEAST_REGIONS * d {
            return;
        }
        grid.for_rows(words, |m, row| {
            for (n, words) in row.iter_mut().enumerate() {
                let at = [grid.north(m) - self.through[0], grid.east(n) - self.through[1]];
                self.add_corner(at, d, seed, words);
            }
        });
    }

    fn add_corner(&self, [north, east]: [f64; 2], d: f64, seed: u64, words: &mut CornerWords) {
        let (sin, cos) = sin_cos(self.azimuth);
        let across = Jet::linear(east * cos - north * sin, [-d * sin, d * cos]);
        let swing = self.meander.map_or(0.0, |meander| meander.swing);
        if 2.0 * (across.value().abs() - swing) / self.width > FARTHEST.sqrt().sqrt() {
            return;
        }
        let along = Jet::linear(north * cos + east * sin, [d * cos, d * sin]);
        let offset = self.meander.map(|meander| meander.offset(along, seed));
        let t = offset.map_or(across, |offset| across - offset).scaled(2.0 / self.width);
        t.square().square().scaled(-1.0).exp().scaled(-self.depth).add_to(words);
    }
}
