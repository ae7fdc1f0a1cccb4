//! Seeded landscapes with a realistic height spectrum, whose nine words a corner are exact derivatives.
//!
//! Every part of a [`Relief`] is a closed form, differentiated to order 2 in u and 2 in v by the algebra of
//! truncated Taylor series, so the bank holds the field's own derivatives and no fit stands between. Parts add:
//!
//! - [`Undulation`]: Gaussian ground of a power-law spectrum (Hurst exponent, the Moon 0.8 to 0.95).
//! - [`Craters`]: bowls with raised rims, `N(> D) = density D^-2`, fresh to subdued.
//! - [`Massif`]: mountains with spurs and several tops. [`Rille`]: a winding valley or, upside down, a ridge.
//! - A general tilt.
//!
//! Randomness is a hash of seed and place in the list (never a stream), so a part can be taken away without
//! moving the others, and any number of threads gives the same bits.

mod craters;
mod error;
mod grid;
mod jet;
mod massif;
mod rille;
mod undulation;
mod waves;

pub use craters::{Crater, Craters};
pub use error::ReliefError;
pub use massif::Massif;
pub use rille::{Meander, Rille};
pub use undulation::{MAX_WAVES, Undulation};

use limits::Limit;

use crate::{CornerWords, Level, WORDS};
use error::{above, within};
use grid::Grid;

/// A landscape to be made: all lengths in metres, all angles in radians, axes x north and y east.
#[derive(Debug, Clone, PartialEq)]
pub struct Relief {
    /// Names the landscape: the same seed and parameters give the same bits.
    pub seed: u64,
    /// Length to the north and to the east from the origin (0, 0), each a whole number of regions (m).
    pub extent: [f64; 2],
    /// Side of a region, d (m).
    pub region_size: f64,
    /// Rise to the north and to the east of the whole ground (m/m), each within -1..=1.
    pub tilt: [f64; 2],
    /// Gaussian ground under everything else.
    pub undulation: Option<Undulation>,
    /// Bowls of all sizes.
    pub craters: Option<Craters>,
    /// Mountains, each placed by hand.
    pub massifs: Vec<Massif>,
    /// Valleys and ridges, each placed by hand.
    pub rilles: Vec<Rille>,
}

impl Relief {
    /// Level ground of the given extent and region size (m), to be filled in.
    pub fn flat(seed: u64, extent: [f64; 2], region_size: f64) -> Self {
        let (undulation, craters) = (None, None);
        Self {
            seed,
            extent,
            region_size,
            tilt: [0.0; 2],
            undulation,
            craters,
            massifs: vec![],
            rilles: vec![],
        }
    }

    /// Whether every parameter is in its range.
    ///
    /// # Errors
    /// The first parameter that is not, by name.
    pub fn check(&self) -> Result<(), ReliefError> {
        self.grid()?;
        for (axis, name) in ["tilt north", "tilt east"].into_iter().enumerate() {
            within(name, self.tilt[axis], -1.0, 1.0)?;
        }
        if let Some(undulation) = &self.undulation {
            undulation.check(self.region_size)?;
        }
        if let Some(craters) = &self.craters {
            craters.check(self.region_size, self.extent)?;
        }
        for (index, massif) in self.massifs.iter().enumerate() {
            massif.check(&format!("massifs[{index}]"), self.region_size)?;
        }
        for (index, rille) in self.rilles.iter().enumerate() {
            rille.check(&format!("rilles[{index}]"), self.region_size)?;
        }
        Ok(())
    }

    /// The level of nine words a corner, its origin at (0, 0).
    ///
    /// # Errors
    /// As [`check`](Self::check).
    pub fn build(&self) -> Result<Level, ReliefError> {
        self.check()?;
        level(self.grid()?, &[(self, [0.0; 2])])
    }

    /// Whether `coarse` can lie around this relief as its coarse level ([`build_two`](Self::build_two)).
    ///
    /// # Errors
    /// The first parameter that is not in its range, by name.
    pub fn check_two(&self, coarse: &Relief) -> Result<(), ReliefError> {
        self.check()?;
        coarse.check()?;
        let ratio = coarse.region_size / self.region_size;
        if !is_whole(ratio) || ratio < 1.5 {
            let expected = format!("2 or more regions of the fine level, {} m each", self.region_size);
            let (name, value) = ("coarse.region_size".into(), coarse.region_size);
            return Err(ReliefError::Parameter { name, value, expected });
        }
        for (axis, name) in ["coarse.extent north", "coarse.extent east"].into_iter().enumerate() {
            let margin = 0.5 * (coarse.extent[axis] - self.extent[axis]);
            if !is_whole(margin / self.region_size) || margin <= 0.0 {
                let whole = 2.0 * self.region_size;
                let expected = format!("{} m and a whole number of {whole} m more", self.extent[axis]);
                let value = coarse.extent[axis];
                return Err(ReliefError::Parameter { name: name.into(), value, expected });
            }
        }
        Ok(())
    }

    /// Two levels of one ground, the fine one of this relief and around it, sharing its centre, that of `coarse`,
    /// whose corners lie on fine ones (section 8).
    ///
    /// The ground is the sum of both reliefs, each made of the parts that it names, everywhere. Each level leaves out
    /// what its regions cannot hold, so the step from one to the other is what only the fine level holds: waves
    /// shorter than 3 coarse regions, and craters, massifs and rilles too small for them.
    ///
    /// # Errors
    /// As [`check_two`](Self::check_two).
    pub fn build_two(&self, coarse: &Relief) -> Result<[Level; 2], ReliefError> {
        self.check_two(coarse)?;
        let origin = [0, 1].map(|axis| 0.5 * (self.extent[axis] - coarse.extent[axis]));
        let parts = [(self, [0.0; 2]), (coarse, origin)];
        let around = Grid { origin, ..coarse.grid()? };
        Ok([level(self.grid()?, &parts)?, level(around, &parts)?])
    }

    /// Adds the relief, whose craters are strewn from `origin` on, to the words of `grid`.
    fn add_to(&self, grid: &Grid, origin: [f64; 2], words: &mut [CornerWords]) {
        self.add_tilt(grid, words);
        if let Some(undulation) = &self.undulation {
            undulation.add_to(grid, self.seed, words);
        }
        for (index, rille) in self.rilles.iter().enumerate() {
            rille.add_to(grid, stream(self.seed, Part::Rille, index), words);
        }
        for (index, massif) in self.massifs.iter().enumerate() {
            massif.add_to(grid, stream(self.seed, Part::Massif, index), words);
        }
        if let Some(craters) = &self.craters {
            let drawn = craters.draw(stream(self.seed, Part::Craters, 0), origin, self.extent);
            craters::add_to(&drawn, grid, words);
        }
    }

    fn grid(&self) -> Result<Grid, ReliefError> {
        above("region_size", self.region_size, 0.0)?;
        let mut regions = [0.0; 2];
        for (axis, name) in ["extent north", "extent east"].into_iter().enumerate() {
            above(name, self.extent[axis], 0.0)?;
            let count = self.extent[axis] / self.region_size;
            regions[axis] = count.round();
            if regions[axis] < 1.0 || !is_whole(count) {
                let expected = format!("a whole number of regions of {} m", self.region_size);
                return Err(ReliefError::Parameter { name: name.into(), value: self.extent[axis], expected });
            }
        }
        let [north, east] = regions.map(|count| count + 1.0);
        if north * east > Limit::Corners.value() as f64 {
            return Err(ReliefError::TooManyCorners { north, east });
        }
        Ok(Grid { origin: [0.0; 2], region_size: self.region_size, corners: [north as usize, east as usize] })
    }

    fn add_tilt(&self, grid: &Grid, words: &mut [CornerWords]) {
        let rise = self.tilt.map(|slope| slope * grid.region_size);
        let at_origin = self.tilt[0] * grid.origin[0] + self.tilt[1] * grid.origin[1];
        grid.for_rows(words, |m, row| {
            for (n, words) in row.iter_mut().enumerate() {
                words[0] += rise[0] * m as f64 + rise[1] * n as f64 + at_origin;
                words[3] += rise[0];
                words[1] += rise[1];
            }
        });
    }
}

/// The level over `grid` of the sum of reliefs.
fn level(grid: Grid, parts: &[(&Relief, [f64; 2])]) -> Result<Level, ReliefError> {
    let mut words = vec![[0.0; WORDS]; grid.corners[0] * grid.corners[1]];
    for (relief, origin) in parts {
        relief.add_to(&grid, *origin, &mut words);
    }
    Ok(Level::new(grid.region_size, grid.origin, grid.corners, words)?)
}

/// Kinds of part, each with its own random numbers.
enum Part {
    Rille = 2,
    Massif = 3,
    Craters = 4,
}

fn stream(seed: u64, part: Part, index: usize) -> u64 {
    quantities::hash_words(seed, &[part as u64, index as u64])
}

/// Whole but for the last bits of the decimals that made it: 0.3 m over 0.1 m.
fn is_whole(count: f64) -> bool {
    (count - count.round()).abs() <= 1e-9 * count.abs()
}

#[cfg(test)]
mod tests;
