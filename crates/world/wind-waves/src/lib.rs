//! Waves that wind raises on deep water: a spectrum, and a sum of travelling sines that has it.
//!
//! ```text
//!  wind --> WindSpectrum --> variance and slope variance of each band --+
//!                                                                       +--> WindWaves, time --> WaveSurface --> height, slopes
//!  seed --> phase and direction of each band ---------------------------+
//! ```
//!
//! # Law
//!
//! - **Spectrum** of a fully developed sea (Pierson and Moskowitz, Journal of Geophysical Research 69, 1964):
//!   `S(w) = a g^2 / w^5 exp(-b (g / (U w))^4)`, w in rad/s, U the wind at 19.5 m. The factors a = 0.0081 and b = 0.74 are those of the
//!   paper ([`ALPHA`], [`BETA`]).
//! - **Integrals** are closed: the variance below w is `a U^4 / (4 b g^2) exp(-b (g / (U w))^4)`, and the variance of slopes
//!   `a / 4 E1(b (g / (U w))^4)`, with E1 the exponential integral.
//! - **Dispersion** of deep water: `w^2 = g k`, k in rad/m.
//! - **Components.** The band from half of the peak to the shortest wave is cut into parts of equal ratio. Each part is one sine. Its
//!   amplitude has the variance of the part, and its frequency is the one whose slopes have the slope variance of the part. So the sum
//!   has both integrals to rounding, whatever the seed.
//! - **Direction** of each component is drawn from `2 / pi cos^2` of the angle to the wind, by seed and number: a counter, no stream.
//! - **Time.** A surface is a function of its time: no state.
//!
//! # Limits
//!
//! Waves are linear: crests are as round as troughs, and nothing breaks. Water is deep, wind is steady, and no wave is shorter than the
//! shortest one that is asked for.

mod components;
mod exponential_integral;
mod spectrum;
mod surface;

pub use components::{Wind, WindWaves};
pub use exponential_integral::exponential_integral;
pub use spectrum::{ALPHA, BETA, GRAVITY, WaveError, WindSpectrum, wave_number};
pub use surface::{Rise, WaveSurface};
