//! Spread from part to part: drawn once for each part from the seed of the model.
//!
//! **Law** (section 0: tolerances are one sigma, drawn once per part). A figure that cannot be negative is
//! `nominal e^(q z)`, `q = sqrt(ln(1 + sigma^2))`, z the part's deviate: the median is nominal, the relative deviation
//! sigma. A static error, whose nominal value is 0, is `sigma z` ([`Spread::error`]).
//! **Parameters.** [`Tolerance`]; defaults by kind in [`relative_sigma`].
//! **Our choices.** A deviate beyond 4 sigma is 4 sigma: no part is sold that is further off.

use crate::NoiseSource;

/// The deviates of all parts of one machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Spread {
    seed: u64,
}

/// A figure with its spread.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Median, 0 or more, in the figure's unit; may be infinite.
    pub nominal: f64,
    /// Relative deviation, 0 or more: 0.2 is 20 %.
    pub sigma: f64,
}

impl Spread {
    /// Of the machine with this seed.
    pub fn new(seed: u64) -> Self {
        Self { seed }
    }

    /// The deviate, -4..=4, of the figure `part` of the part with number `index`.
    pub fn deviate(&self, part: &str, index: u64) -> f64 {
        // Sweep 0 of a source of its own: noise is drawn under the name of the part alone.
        NoiseSource::new(self.seed ^ SPREAD, part, index).normal(0, 0).clamp(-4.0, 4.0)
    }

    /// The figure of that part.
    pub fn figure(&self, part: &str, index: u64, tolerance: &Tolerance) -> f64 {
        tolerance.at(self.deviate(part, index))
    }

    /// The static error of that part, from its deviation `sigma` (share of full scale).
    pub fn error(&self, part: &str, index: u64, sigma: f64) -> f64 {
        sigma * self.deviate(part, index)
    }
}

/// Keeps spread apart from noise of the same seed.
const SPREAD: u64 = 0x7370_7265_6164_0000;

impl Tolerance {
    /// The figure at `deviate`.
    pub fn at(&self, deviate: f64) -> f64 {
        self.nominal * libm::exp(libm::log1p(self.sigma * self.sigma).sqrt() * deviate)
    }
}

/// Relative deviations of figures that name none (section 0). Bits and counts have none; static errors are
/// deviations themselves.
pub mod relative_sigma {
    /// Rates of clocks and rasters.
    pub const CLOCK: f64 = 1e-4;
    /// Speed of the drums.
    pub const DRUM_SPEED: f64 = 0.005;
    /// Delays of memory and logic.
    pub const LOGIC_DELAY: f64 = 0.05;
    /// Bandwidths and time constants.
    pub const BANDWIDTH: f64 = 0.20;
    /// Slew rates of amplifiers.
    pub const SLEW: f64 = 0.15;
    /// Delays of comparators and switches.
    pub const SWITCH_DELAY: f64 = 0.25;
    /// Settling and acquisition times.
    pub const SETTLING: f64 = 0.30;
    /// Area of glitches, charge.
    pub const GLITCH: f64 = 0.50;
}

#[cfg(test)]
mod tests {
    use super::{Spread, Tolerance, relative_sigma};

    #[test]
    fn figures_have_their_median_and_deviation() {
        let tolerance = Tolerance { nominal: 8e6, sigma: relative_sigma::BANDWIDTH };
        let mut figures: Vec<f64> =
            (0..20_000).map(|i| Spread::new(5).figure("mul.bandwidth", i, &tolerance) / 8e6).collect();
        figures.sort_by(f64::total_cmp);
        let mean = figures.iter().sum::<f64>() / 20_000.0;
        let variance = figures.iter().map(|f| (f - mean) * (f - mean)).sum::<f64>() / 20_000.0;
        assert!((figures[10_000] - 1.0).abs() < 0.01);
        assert!((variance.sqrt() / mean - 0.2).abs() < 0.006, "{}", variance.sqrt());
        assert!(figures[0] > 0.0);
    }

    #[test]
    fn nothing_is_further_off_than_four_sigma() {
        let wild = Tolerance { nominal: 1.0, sigma: 0.5 };
        let most = libm::exp(4.0 * libm::log(1.25).sqrt());
        for i in 0..100_000 {
            let figure = Spread::new(1).figure("glitch", i, &wild);
            assert!(figure <= most && figure >= 1.0 / most);
        }
    }

    #[test]
    fn no_spread_is_the_figure_itself() {
        for nominal in [0.0, 20e-9, f64::INFINITY] {
            assert_eq!(Tolerance { nominal, sigma: 0.0 }.at(-3.1), nominal);
        }
        assert_eq!(Tolerance { nominal: 0.0, sigma: 0.3 }.at(2.0), 0.0);
        assert_eq!(Tolerance { nominal: f64::INFINITY, sigma: 0.3 }.at(2.0), f64::INFINITY);
    }

    #[test]
    fn parts_draw_apart_and_stay() {
        let spread = Spread::new(9);
        assert_ne!(spread.deviate("mul.gain", 0), spread.deviate("mul.gain", 1));
        assert_ne!(spread.deviate("mul.gain", 0), spread.deviate("mul.offset", 0));
        assert_eq!(spread.error("mul.gain", 4, 0.002), 0.002 * spread.deviate("mul.gain", 4));
        // Machines are named by their seed: the value never changes.
        assert_eq!(spread.deviate("mul.gain", 0).to_bits(), 4603826302830747141);
    }
}
