//! Gaussian ground of a power-law spectrum.

use super::error::{ReliefError, above, within};
use super::grid::Grid;
use super::waves::{REGIONS_A_WAVE, Spectrum, WaveTable};
use crate::CornerWords;

/// Largest number of plane waves in one undulation.
pub const MAX_WAVES: usize = 20_000;

/// Stationary Gaussian ground: the power density of a profile falls as k^-(2H+1) between the two wavelengths.
///
/// Laser altimetry of the Moon gives H = 0.95 for highlands and 0.76 for mare at 17 m to 2.7 km, and median
/// slopes of 7.5 and 2.0 degrees over 17 m (Rosenburg and others 2011, LOLA).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Undulation {
    /// Root mean square of the height (m), 0 or more.
    pub rms_height: f64,
    /// Hurst exponent of the spectrum, 0..=1.
    pub hurst: f64,
    /// Longest wavelength of the spectrum (m).
    pub longest: f64,
    /// Shortest wavelength (m), at least 3 regions, so that the lattice resolves it.
    pub shortest: f64,
    /// Number of plane waves; several hundred make the ground look random.
    pub waves: usize,
}

impl Undulation {
    /// Root mean square of the slope (m/m), both axes together.
    pub fn rms_slope(&self) -> f64 {
        self.spectrum().rms_slope()
    }

    pub(super) fn check(&self, region_size: f64) -> Result<(), ReliefError> {
        within("undulation.rms_height", self.rms_height, 0.0, 1e5)?;
        within("undulation.hurst", self.hurst, 0.0, 1.0)?;
        within("undulation.shortest", self.shortest, REGIONS_A_WAVE * region_size, f64::MAX)?;
        above("undulation.longest", self.longest, self.shortest)?;
        within("undulation.waves", self.waves as f64, 1.0, MAX_WAVES as f64)
    }

    pub(super) fn add_to(&self, grid: &Grid, seed: u64, words: &mut [CornerWords]) {
        let table = WaveTable::new(&self.spectrum(), seed, grid, 0..grid.corners[1]);
        grid.for_rows(words, |m, row| table.add_row(m, row));
    }

    fn spectrum(&self) -> Spectrum {
        Spectrum {
            longest: self.longest,
            shortest: self.shortest,
            hurst: self.hurst,
            rms: self.rms_height,
            count: self.waves,
        }
    }
}
