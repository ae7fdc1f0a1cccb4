//! Gaussian random fields as sums of plane waves.

use super::grid::Grid;
use crate::{CornerWords, WORDS};
use quantities::unit_interval;
use std::f64::consts::{PI, SQRT_2};
use std::ops::Range;

/// Fraction of a half turn between the directions of successive waves: the golden ratio, whose multiples
/// cover all directions evenly at every scale.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Shortest wave that a lattice of corners holds, in regions.
pub(super) const REGIONS_A_WAVE: f64 = 3.0;

/// A power-law spectrum: wavelengths spaced evenly in their logarithm, amplitude as wavelength^hurst.
///
/// Variance per octave goes as k^-2H, hence the power density of a profile as k^-(2H+1).
#[derive(Debug, Clone, Copy)]
pub(super) struct Spectrum {
    /// Longest wavelength of the spectrum (m).
    pub longest: f64,
    /// Shortest wavelength of the spectrum (m).
    pub shortest: f64,
    /// Hurst exponent H of the spectrum.
    pub hurst: f64,
    /// Root mean square of the field (m).
    pub rms: f64,
    /// Number of plane waves in the sum.
    pub count: usize,
}

impl Spectrum {
    /// Wavelength (m) of wave `index`: the middle of its share of the logarithmic band.
    fn wavelength(&self, index: usize) -> f64 {
        let share = (index as f64 + 0.5) / self.count as f64;
        self.longest * libm::exp(-share * libm::log(self.longest / self.shortest))
    }

    /// Amplitude (m) of every wave, longest first; half their sum of squares is rms^2.
    fn amplitudes(&self) -> Vec<f64> {
        let raw: Vec<f64> =
            (0..self.count).map(|i| libm::pow(self.wavelength(i) / self.longest, self.hurst)).collect();
        let norm = raw.iter().map(|a| a * a).sum::<f64>().sqrt();
        raw.iter().map(|a| a * self.rms * SQRT_2 / norm).collect()
    }

    /// Root mean square of the gradient (m/m).
    pub fn rms_slope(&self) -> f64 {
        let slope = |(index, amplitude): (usize, &f64)| amplitude * 2.0 * PI / self.wavelength(index);
        let slopes: Vec<f64> = self.amplitudes().iter().enumerate().map(slope).collect();
        (slopes.iter().map(|s| s * s / 2.0).sum::<f64>()).sqrt()
    }

    /// What the field never exceeds (m).
    pub fn bound(&self) -> f64 {
        self.amplitudes().iter().sum()
    }

    fn waves(&self, seed: u64) -> Vec<Wave> {
        let turn = unit_interval(seed, &[0]);
        let wave = |(index, amplitude)| {
            let phase = 2.0 * PI * unit_interval(seed, &[1, index as u64]);
            let direction = (turn + index as f64 * GOLDEN) * PI;
            let (sin, cos) = libm::sincos(direction);
            let k = 2.0 * PI / self.wavelength(index);
            Wave { amplitude, vector: [k * cos, k * sin], phase, length: self.wavelength(index) }
        };
        self.amplitudes().into_iter().enumerate().map(wave).collect()
    }
}

/// `amplitude sin(vector . (x, y) + phase)`.
struct Wave {
    amplitude: f64,
    /// To the north and east (rad/m).
    vector: [f64; 2],
    phase: f64,
    /// Wavelength of the wave (m).
    length: f64,
}

impl Wave {
    /// Its argument at corner `index` of an axis that begins at `origin` (m), without the phase.
    fn along(&self, axis: usize, index: usize, region_size: f64, origin: f64) -> f64 {
        self.vector[axis] * region_size * index as f64 + self.vector[axis] * origin
    }
}

/// Waves ready for a range of columns: the sine of a sum needs only the sines of each column and row.
pub(super) struct WaveTable {
    waves: Vec<TabledWave>,
    region_size: f64,
    origin: [f64; 2],
}

struct TabledWave {
    wave: Wave,
    /// `(kx d)^p (ky d)^q` with the sign of derivative p + q of a sine.
    shape: CornerWords,
    /// Sine and cosine of `ky y` for each column.
    columns: Vec<(f64, f64)>,
}

impl WaveTable {
    /// The waves of `spectrum` under `seed` over `columns` of `grid`, without those that its regions cannot hold.
    pub fn new(spectrum: &Spectrum, seed: u64, grid: &Grid, columns: Range<usize>) -> Self {
        let d = grid.region_size;
        let tabled = |wave: Wave| TabledWave {
            shape: shape(wave.vector.map(|k| k * d)),
            columns: columns.clone().map(|n| libm::sincos(wave.along(1, n, d, grid.origin[1]))).collect(),
            wave,
        };
        let is_held = |wave: &Wave| wave.length >= REGIONS_A_WAVE * d;
        let waves = spectrum.waves(seed).into_iter().filter(is_held).map(tabled).collect();
        Self { waves, region_size: d, origin: grid.origin }
    }

    /// Adds the field and its derivatives along row `m` to the words of the tabled columns.
    pub fn add_row(&self, m: usize, row: &mut [CornerWords]) {
        for TabledWave { wave, shape, columns } in &self.waves {
            let along = wave.along(0, m, self.region_size, self.origin[0]);
            let (sin_m, cos_m) = libm::sincos(along + wave.phase);
            let (sin_m, cos_m) = (sin_m * wave.amplitude, cos_m * wave.amplitude);
            for (words, (sin_n, cos_n)) in row.iter_mut().zip(columns) {
                let even_and_odd = [sin_m * cos_n + cos_m * sin_n, cos_m * cos_n - sin_m * sin_n];
                for index in 0..WORDS {
                    words[index] += shape[index] * even_and_odd[(index / 3 + index % 3) % 2];
                }
            }
        }
    }
}

fn shape([ku, kv]: [f64; 2]) -> CornerWords {
    let signs = [1.0, 1.0, -1.0, -1.0, 1.0];
    let (u, v) = ([1.0, ku, ku * ku], [1.0, kv, kv * kv]);
    std::array::from_fn(|index| signs[index / 3 + index % 3] * u[index / 3] * v[index % 3])
}
