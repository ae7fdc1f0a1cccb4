//! Function generators under one input.
//!
//! **Law.** That of [`FunctionGenerator`]. Generators of as many segments find the same cell: what they have there stands in
//! one row, and a group of sweeps goes through it side by side.

use fearless_simd::Simd;
use fearless_simd::prelude::{SimdBase, SimdFrom};
use signal::{LANES, Lanes, Real, turn_square};

use crate::FunctionGenerator;
use crate::whole::{WHOLE, whole_side_by_side};

/// Places in a row of a [`FunctionBank`].
pub const BANK: usize = LANES;

/// Function generators under one input: what they have at a cell stands side by side.
#[derive(Debug, Clone, PartialEq)]
pub struct FunctionBank<S> {
    cells: f64,
    rows: Vec<Row<S>>,
}

/// Where the inputs of a group fall: the computer asks for what stands there as soon as it knows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BankPlace<S> {
    /// Number of the cell beside [`WHOLE`].
    cell: [f64; LANES],
    /// How far into the cell (cells).
    beyond: Lanes<S>,
}

impl<S: Real> Default for BankPlace<S> {
    fn default() -> Self {
        Self { cell: [WHOLE; LANES], beyond: Lanes::default() }
    }
}

/// Starts and rises of a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
struct Row<S> {
    start: [S; BANK],
    rise: [S; BANK],
}

impl<S: Real> FunctionBank<S> {
    /// The bank of `generators`, at most [`BANK`] of as many cells each; places beyond them put out 0.
    pub fn new(generators: &[FunctionGenerator<S>]) -> Self {
        let cells = generators.first().map_or(0, |first| first.table.len());
        debug_assert!(generators.len() <= BANK && generators.iter().all(|one| one.table.len() == cells));
        let at = |cell: usize, part: usize| {
            std::array::from_fn(|place| generators.get(place).map_or(S::ZERO, |one| one.table[cell][part]))
        };
        let row = |cell: usize| Row { start: at(cell, 0), rise: at(cell, 1) };
        Self { cells: cells as f64, rows: (0..cells).map(row).collect() }
    }

    /// What the generators put out for input `z`, of each lane; to the bit as [`FunctionGenerator::value`] has it.
    #[inline(always)]
    pub fn values<L: Simd>(&self, simd: L, z: S::Vector<L>) -> [S::Vector<L>; BANK] {
        self.at::<L>(simd, &self.place(z))
    }

    /// Where input `z` of each lane falls.
    #[inline(always)]
    pub fn place<L: Simd>(&self, z: S::Vector<L>) -> BankPlace<S> {
        let place = z * S::from_f64(self.cells);
        let below = whole_side_by_side(S::widen(place)).max(0.0).min(self.cells - 1.0);
        let mut out = BankPlace::default();
        // A whole number stands in the lowest bits of what is beside WHOLE.
        (below + WHOLE).store_slice(&mut out.cell);
        (place - S::narrow(below)).store_slice(&mut out.beyond.0);
        out
    }

    /// What the generators put out there.
    #[inline(always)]
    pub fn at<L: Simd>(&self, simd: L, place: &BankPlace<S>) -> [S::Vector<L>; BANK] {
        let mut square = [S::Vector::<L>::simd_from(simd, S::ZERO); LANES];
        for lane in 0..LANES {
            let Row { start, rise } = &self.rows[place.cell[lane].to_bits() as u32 as usize];
            let rise = S::Vector::<L>::from_slice(simd, rise) * place.beyond.0[lane];
            square[lane] = S::Vector::<L>::from_slice(simd, start) + rise;
        }
        // Lanes by generators become generators by lanes.
        turn_square(&mut square);
        square
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::prelude::SimdBase;
    use fearless_simd::{Level, dispatch, f32x8};
    use signal::{LANES, Lanes};

    use super::{BANK, FunctionBank};
    use crate::{Ends, FunctionGenerator, FunctionLaw};

    fn found(bank: &FunctionBank<f32>, z: Lanes<f32>) -> [Lanes<f32>; BANK] {
        dispatch!(Level::new(), simd => {
            let found = bank.values(simd, f32x8::from_slice(simd, &z.0));
            found.map(|values| Lanes(values.into()))
        })
    }

    const CURVES: [fn(f64) -> f64; 3] = [|z| z * z, |z| z * (1.0 - z) * (1.0 - z), |z| 1.0 / (1.0 + z)];

    #[test]
    fn a_bank_has_the_bits_of_its_generators() {
        for rounding in [0.0, 0.005] {
            let law = FunctionLaw { segments: 20, rounding, ends: Ends::Trimmed([0.0; 2]) };
            let generators: Vec<_> = CURVES.iter().map(|f| FunctionGenerator::<f32>::new(&law, f)).collect();
            let bank = FunctionBank::new(&generators);
            for step in 0..2000_usize {
                let z = Lanes::from_fn(|lane| ((step * LANES + lane) as f32) / 12_000.0 - 0.15);
                let found = found(&bank, z);
                for (place, values) in found.iter().enumerate() {
                    let alone = z.map(|z| generators.get(place).map_or(0.0, |one| one.value(z)));
                    assert_eq!(*values, alone, "{place} of {step}");
                }
            }
        }
    }
}
