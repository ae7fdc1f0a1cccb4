//! Rocks over an area by a cumulative size law, each addressed by where it lies.
//!
//! **Law.** `N(>= D) = density (D / 1 m)^-slope` rocks a square metre, cut off at the smallest and largest
//! size. Counts of blocks on pictures of lunar landers' surroundings follow such powers: slopes between about
//! 1.8 (old mare regolith) and 2.6 (near blocky craters) were found at the Surveyor sites. The figures of a
//! field are our choice.
//!
//! **Method.** Sizes are parted into octaves, each with its own grid of cells that hold about [`IN_A_CELL`]
//! rocks. A cell's count is Poisson, and it and everything about its rocks is a hash of seed, octave and cell:
//! any box can be made alone, in any order, and far ground can be asked for its large rocks only.

use std::f64::consts::TAU;

use quantities::{hash_words, unit_interval};

use crate::rocks::SHAPES;

/// Mean number of rocks in a cell, unless the area holds fewer.
const IN_A_CELL: f64 = 8.0;
/// Names the use of a hash.
const FIELD: u64 = u64::from_be_bytes(*b"rock-fld");

/// How many rocks of which size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SizeLaw {
    /// Smallest rock size in the field (m).
    pub smallest: f64,
    /// Largest rock size in the field (m).
    pub largest: f64,
    /// Rocks of 1 m or more a square metre, if the law went on without end.
    pub density: f64,
    /// Slope of the cumulative law in a doubly logarithmic plot, without its sign.
    pub slope: f64,
}

/// A field of rocks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RockField {
    seed: u64,
    area: [[f64; 2]; 2],
    law: SizeLaw,
}

/// A rock of a field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rock {
    /// Where it lies: north, east (m).
    pub at: [f64; 2],
    /// Its greatest horizontal extent (m): the scale of its shape.
    pub size: f64,
    /// Which of the [`SHAPES`].
    pub shape: usize,
    /// Which way it is turned, clockwise from north (rad).
    pub heading: f64,
}

/// Why a field of rocks cannot be.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum RockFieldError {
    /// Sizes out of order.
    #[error("rocks of {0} m to {1} m: expected sizes in ascending order within 0.001 m and 1000 m")]
    Sizes(f64, f64),
    /// A law that is none.
    #[error("{what} {found}: expected {expected}")]
    Law {
        /// Name of the number at fault: `density` or `slope`.
        what: &'static str,
        /// Value that was given for that number.
        found: f64,
        /// What it may be.
        expected: &'static str,
    },
    /// An area that is none.
    #[error("area from {0:?} m to {1:?} m: expected ascending coordinates of at most 1e7 m either way")]
    Area([f64; 2], [f64; 2]),
    /// More rocks to the square metre than there is room for.
    #[error("{0:.1} rocks a square metre: expected at most 1000; make the smallest size larger")]
    Crowded(f64),
}

impl RockField {
    /// The field of `seed` over `area` ([low, high] corners: north, east; m).
    ///
    /// # Errors
    /// If sizes, law or area are out of range, or it holds more than 1000 rocks a square metre.
    pub fn new(seed: u64, area: [[f64; 2]; 2], law: SizeLaw) -> Result<Self, RockFieldError> {
        let SizeLaw { smallest, largest, density, slope } = law;
        if !(smallest >= 1e-3 && largest > smallest && largest <= 1e3) {
            return Err(RockFieldError::Sizes(smallest, largest));
        }
        if !(0.0..=1e3).contains(&density) {
            let expected = "0 to 1000 rocks a square metre";
            return Err(RockFieldError::Law { what: "density", found: density, expected });
        }
        if !(0.5..=6.0).contains(&slope) {
            return Err(RockFieldError::Law { what: "slope", found: slope, expected: "0.5 to 6" });
        }
        let [low, high] = area;
        let ascends = |axis: usize| low[axis] >= -1e7 && high[axis] > low[axis] && high[axis] <= 1e7;
        if !(ascends(0) && ascends(1)) {
            return Err(RockFieldError::Area(low, high));
        }
        let crowd = law.between(smallest, largest);
        if crowd > 1e3 {
            return Err(RockFieldError::Crowded(crowd));
        }
        Ok(Self { seed, area, law })
    }

    /// Law of the field.
    pub fn law(&self) -> SizeLaw {
        self.law
    }

    /// Mean number of rocks of `at_least` (m) or more in the part of the box from `low` to `high` that lies in
    /// the area.
    pub fn expected(&self, low: [f64; 2], high: [f64; 2], at_least: f64) -> f64 {
        let [low, high] = self.within(low, high);
        let sides = [0, 1].map(|axis| (high[axis] - low[axis]).max(0.0));
        sides[0] * sides[1] * self.law.between(at_least.max(self.law.smallest), self.law.largest)
    }

    /// The rocks whose place lies in the box: `low` (north, east; m) inclusive, `high` exclusive.
    pub fn rocks_in_box(&self, low: [f64; 2], high: [f64; 2]) -> Vec<Rock> {
        self.larger_in_box(low, high, 0.0)
    }

    /// Those of [`Self::rocks_in_box`] of `at_least` (m) or more, in the same order. Octaves of smaller rocks
    /// cost nothing.
    pub fn larger_in_box(&self, low: [f64; 2], high: [f64; 2], at_least: f64) -> Vec<Rock> {
        let [low, high] = self.within(low, high);
        let mut rocks = Vec::new();
        for octave in self.octaves().filter(|octave| octave.high > at_least) {
            let cells = |axis: usize| {
                let cell = |place: f64| (place / octave.cell).floor() as i64;
                cell(low[axis])..=cell(high[axis])
            };
            for north in cells(0) {
                for east in cells(1) {
                    octave.fill([north, east], self, &mut rocks);
                }
            }
        }
        let is_in = |at: [f64; 2]| (0..2).all(|axis| (low[axis]..high[axis]).contains(&at[axis]));
        rocks.retain(|rock| rock.size >= at_least && is_in(rock.at));
        rocks
    }

    fn within(&self, low: [f64; 2], high: [f64; 2]) -> [[f64; 2]; 2] {
        let [least, most] = self.area;
        [[0, 1].map(|axis| low[axis].max(least[axis])), [0, 1].map(|axis| high[axis].min(most[axis]))]
    }

    fn octaves(&self) -> impl Iterator<Item = Octave> {
        let SizeLaw { smallest, largest, .. } = self.law;
        let lows = std::iter::successors(Some(smallest), |low| Some(low * 2.0)).enumerate();
        lows.take_while(move |(_, low)| *low < largest).map(move |(number, low)| {
            let high = (low * 2.0).min(largest);
            let crowd = self.law.between(low, high);
            let [from, to] = self.area;
            let longest = (to[0] - from[0]).max(to[1] - from[1]);
            // An empty octave has one cell: the area.
            let cell = if crowd > 0.0 { (IN_A_CELL / crowd).sqrt().min(longest) } else { longest };
            Octave { number: number as u64, low, high, cell, mean: crowd * cell * cell }
        })
    }
}

impl SizeLaw {
    /// Rocks a square metre of a size from `low` to `high` (m).
    fn between(&self, low: f64, high: f64) -> f64 {
        let above = |size: f64| libm::pow(size, -self.slope);
        self.density * (above(low) - above(high)).max(0.0)
    }

    /// The size below which a `share` of the rocks between two sizes lies, from the large end.
    fn size_at(&self, low: f64, high: f64, share: f64) -> f64 {
        let above = |size: f64| libm::pow(size, -self.slope);
        let count = above(high) + share * (above(low) - above(high));
        libm::pow(count, -1.0 / self.slope).clamp(low, high)
    }
}

/// Rocks of one range of sizes, and the cells that they are found in.
#[derive(Debug, Clone, Copy)]
struct Octave {
    number: u64,
    low: f64,
    high: f64,
    cell: f64,
    mean: f64,
}

impl Octave {
    fn fill(&self, cell: [i64; 2], field: &RockField, rocks: &mut Vec<Rock>) {
        let [north, east] = cell.map(|index| index as u64);
        let seed = hash_words(field.seed, &[FIELD, self.number, north, east]);
        for number in 0..poisson(self.mean, unit_interval(seed, &[])) {
            let part = |part: u64| unit_interval(seed, &[number, part]);
            rocks.push(Rock {
                at: [0, 1].map(|axis| (cell[axis] as f64 + part(axis as u64)) * self.cell),
                size: field.law.size_at(self.low, self.high, part(2)),
                shape: (part(3) * SHAPES as f64) as usize,
                heading: TAU * part(4),
            });
        }
    }
}

/// The count at which the distribution of a `mean` passes `share`.
fn poisson(mean: f64, share: f64) -> u64 {
    // Beyond this the chance is less than a share can tell.
    const MOST: u64 = 100;
    let mut chance = libm::exp(-mean);
    let mut passed = chance;
    let mut count = 0;
    while passed < share && count < MOST {
        count += 1;
        chance *= mean / count as f64;
        passed += chance;
    }
    count
}
