//! An analog chain as the machine steps it and as a circuit simulator does: ramp, smoother, multiplier, lag,
//! sample-and-hold, comparator.
//!
//! ```text
//! triangle u ─▶ smoother ─▶ a ─┐
//! constant b ──────────────────┴▶ multiplier ─▶ lag ─▶ m ─┬▶ sample-and-hold ─▶ held
//!                                                         └▶ comparator ──────────┘ command
//! ```

mod circuit;
mod parts_alone;

pub use circuit::{Simulated, simulate};
pub use parts_alone::Stepped;

use parts::{MultiplierLaw, SampleHoldLaw, SecondOrder};

/// Time of a rise and of a fall of the triangle (s).
const RISE: f64 = 2e-6;
/// The constant input.
const B: f64 = 0.9;
const SMOOTHER: SecondOrder = SecondOrder { natural: 1.6 / 40e-9, damping: 0.8 };
const TAU_M: f64 = 20e-9;
const MULTIPLIER: MultiplierLaw =
    MultiplierLaw { gain: 0.002, feed_a: 0.003, feed_b: -0.002, offset: 0.001, nonlinearity: 0.0025 };
const THRESHOLD: f64 = 0.4;
const DELAY: f64 = 40e-9;
const HOLD: SampleHoldLaw =
    SampleHoldLaw { acquisition: 400e-9, aperture: 0.0, jitter: 0.0, pedestal: 0.0, droop: 0.0 };
/// Time constant of the tracking switch: 400 ns over ln 1000.
const TAU_H: f64 = 400e-9 / 6.907_755_278_982_137;
/// Times at which outputs are compared (s apart).
pub const RASTER: f64 = 50e-9;

/// The triangle at a time (s).
fn triangle(time: f64) -> f64 {
    let turns = time / RISE;
    let phase = turns - 2.0 * (0.5 * turns).floor();
    if phase <= 1.0 { phase } else { 2.0 - phase }
}

/// Root mean square of the difference of two outputs, and its largest value.
pub fn difference(a: &[f64], b: &[f64]) -> [f64; 2] {
    let gaps = || a.iter().zip(b).map(|(a, b)| (a - b).abs());
    let count = a.len().min(b.len()).max(1) as f64;
    [(gaps().map(|gap| gap * gap).sum::<f64>() / count).sqrt(), gaps().fold(0.0, f64::max)]
}
