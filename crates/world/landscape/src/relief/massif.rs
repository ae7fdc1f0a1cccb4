//! Mountains with spurs and several tops.

use super::error::{ReliefError, finite, within};
use super::grid::Grid;
use super::jet::Jet;
use super::waves::{REGIONS_A_WAVE, Spectrum, WaveTable};
use crate::{CornerWords, WORDS};

/// Waves in each of the three fields that roughen a massif.
const WAVES: usize = 96;
/// Shift of the outline at ruggedness 1, as a share of the radius (our choice by eye: Apennine-like spurs).
const SHIFT: f64 = 0.15;
/// Variation of the height at ruggedness 1, as a share of the height (our choice by eye).
const VARIATION: f64 = 0.4;

/// Least radius, in regions.
const LEAST_REGIONS: f64 = 6.0;

/// A mountain: `height (1 - s)^5 (1 + a n)`, `s = (rho/radius)^2`, the place shifted by two random fields and the
/// height varied by a third, all with wavelengths from the radius down to `detail`.
///
/// Beyond the foot it is exactly 0 and joins the ground with all nine words. A smooth one is steepest at a third
/// of its radius, with slope `2.08 height / radius`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Massif {
    /// Centre: north, east (m).
    pub at: [f64; 2],
    /// Height of a smooth one (m); negative makes a basin.
    pub height: f64,
    /// Foot of a smooth one (m), at least 6 regions.
    pub radius: f64,
    /// Shortest wavelength of its roughness (m), from 3 regions to half its radius.
    pub detail: f64,
    /// 0 a smooth dome, 1 spurs, gullies and several tops.
    pub ruggedness: f64,
}

impl Massif {
    pub(super) fn check(&self, name: &str, region_size: f64) -> Result<(), ReliefError> {
        finite(format!("{name}.at north"), self.at[0])?;
        finite(format!("{name}.at east"), self.at[1])?;
        within(format!("{name}.height"), self.height, -1e5, 1e5)?;
        within(format!("{name}.radius"), self.radius, LEAST_REGIONS * region_size, 1e7)?;
        within(format!("{name}.detail"), self.detail, REGIONS_A_WAVE * region_size, 0.5 * self.radius)?;
        within(format!("{name}.ruggedness"), self.ruggedness, 0.0, 1.0)
    }

    /// Whether regions of this size can hold it.
    fn is_held(&self, region_size: f64) -> bool {
        self.radius >= LEAST_REGIONS * region_size
    }

    pub(super) fn add_to(&self, grid: &Grid, seed: u64, words: &mut [CornerWords]) {
        let d = grid.region_size;
        let (shift, variation) = (self.shift(), self.variation());
        if !self.is_held(d) {
            return;
        }
        let reach = self.radius + shift.bound();
        let columns = grid.columns_near(self.at[1], reach);
        let table = |spectrum: &Spectrum, field: u64| {
            WaveTable::new(spectrum, quantities::hash_words(seed, &[field]), grid, columns.clone())
        };
        let fields = [table(&shift, 0), table(&shift, 1), table(&variation, 2)];
        grid.for_rows(words, |m, row| {
            let north = grid.north(m) - self.at[0];
            if north.abs() > reach {
                return;
            }
            let fields = fields.each_ref().map(|field| {
                let mut row = vec![[0.0; WORDS]; columns.len()];
                field.add_row(m, &mut row);
                row
            });
            for (index, n) in columns.clone().enumerate() {
                let east = grid.east(n) - self.at[1];
                let fields = fields.each_ref().map(|row| Jet::from_words(&row[index]));
                self.add_corner([north, east], d, fields, &mut row[n]);
            }
        });
    }

    fn add_corner(&self, [north, east]: [f64; 2], d: f64, fields: [Jet; 3], words: &mut CornerWords) {
        let [shift_north, shift_east, variation] = fields;
        let x = Jet::linear(north, [d, 0.0]) + shift_north;
        let y = Jet::linear(east, [0.0, d]) + shift_east;
        let inside = (x.square() + y.square()).scaled(-1.0 / (self.radius * self.radius)).plus(1.0);
        if inside.value() > 0.0 {
            let bump = inside * inside.square().square();
            (bump * variation.plus(1.0)).scaled(self.height).add_to(words);
        }
    }

    fn shift(&self) -> Spectrum {
        self.spectrum(SHIFT * self.ruggedness * self.radius)
    }

    fn variation(&self) -> Spectrum {
        self.spectrum(VARIATION * self.ruggedness)
    }

    fn spectrum(&self, rms: f64) -> Spectrum {
        Spectrum { longest: self.radius, shortest: self.detail, hurst: 1.6, rms, count: WAVES }
    }
}

#[cfg(test)]
mod tests {
    use super::Massif;
    use crate::relief::Relief;

    #[test]
    fn a_smooth_one_is_the_closed_form() {
        let massif =
            Massif { at: [1000.0, 1000.0], height: 300.0, radius: 900.0, detail: 300.0, ruggedness: 0.0 };
        let relief = Relief { massifs: vec![massif], ..Relief::flat(1, [2000.0, 2000.0], 100.0) };
        let level = relief.build().unwrap();
        let inside = 1.0 - 1.0 / 9.0;
        let slope = -300.0 * 5.0 * inside * inside * inside * inside * 2.0 / 3.0 / 900.0;
        let corner = level.words()[13 * 21 + 10];
        assert!((corner[0] - 300.0 * inside * inside * inside * inside * inside).abs() < 1e-9);
        assert!((corner[3] - slope * 100.0).abs() < 1e-9);
        assert_eq!(level.words()[20 * 21 + 10], [0.0; 9]);
    }
}
