//! Waves of wind against closed forms: integrals of the spectrum, dispersion, slopes, directions, and bad input.

mod integrals;
mod refused;
mod sums;
mod surface;

use wind_waves::Wind;

/// A fresh breeze to the north-east.
pub const BREEZE: Wind = Wind { speed: 10.0, towards: 0.7, seed: 1, components: 64, shortest: 5.0 };
