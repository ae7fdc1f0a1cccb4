//! Laws of size: how many items are small and how many are large.

use crate::refused::{Refused, expect};

/// Value at which the chi-squared distribution is cut off: it stands for the largest radius (chosen).
pub const CHI_SQUARED_END: f64 = 12.0;

/// The distribution of radii between a smallest and a largest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SizeLaw {
    /// Chi-squared of 2 degrees of freedom, truncated at [`CHI_SQUARED_END`]: most items near the smallest radius. The document
    /// names the distribution; the degrees of freedom and the end are our choice.
    ChiSquared,
    /// Cumulative power law of this exponent, as counts on the Moon follow it.
    PowerLaw(f64),
}

impl SizeLaw {
    /// Refuses a law or radii that make no distribution.
    pub(crate) fn check(&self, [least, most]: [f64; 2]) -> Result<(), Refused> {
        let ascends = least >= 1e-3 && most > least && most <= 1e7;
        let expected = "two lengths in ascending order, from 0.001 m to 1e7 m";
        expect(ascends, "radius_m", format!("[{least}, {most}]"), expected)?;
        let Self::PowerLaw(exponent) = *self else { return Ok(()) };
        let falls = (0.01..=20.0).contains(&exponent);
        expect(falls, "power", exponent, "a number from 0.01 to 20")
    }

    /// Radius (m) below which a share (0 to 1) of the items lies.
    pub fn radius(&self, share: f64, [least, most]: [f64; 2]) -> f64 {
        let radius = match *self {
            Self::ChiSquared => {
                let kept = 1.0 - libm::exp(-0.5 * CHI_SQUARED_END);
                least - (most - least) * 2.0 * libm::log(1.0 - share * kept) / CHI_SQUARED_END
            }
            Self::PowerLaw(exponent) => {
                let [from, to] = [least, most].map(|radius| libm::pow(radius, -exponent));
                libm::pow(from - share * (from - to), -1.0 / exponent)
            }
        };
        radius.clamp(least, most)
    }
}
