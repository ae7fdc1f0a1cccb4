//! Display: video amplifier and picture tube (hardware-1969, section 3.9).
//!
//! ```text
//! read-out ─▶ correction ─▶ lag ─▶ + noise ─▶ contrast ─▶ cut-off, gamma ─▶ phosphor ─▶ spot ─▶ light [line, column]
//!             w^(1/correction)     new in each field      ((v - c)/(1 - c))^gamma   of earlier fields
//! ```
//!
//! **Law.** Reflectivity w, as it is read, is corrected to the video `w^(1 / correction)`. The video amplifier is a lag along
//! the line; noise of the same band joins the video. Contrast is set so that `display.white` drives the tube to 1. A drive v
//! gives the light `((v - c) / (1 - c))^gamma` of white's, none up to the cut-off c. So noise in black stays dark, and noise in
//! white is brightest.
//! **Noise.** n shades of grey that can be told apart between black and full video (`sweep_memory.grey`) are a deviation of
//! `1 / 6n` in the band. Along a line it is correlated as `e^(-dt / tau)`; two lines and two fields have nothing in common. Its
//! address is field and line, so a field can be made alone, by any number of threads.
//! **Interlace.** With two fields a picture, field f scans the lines of the parity of f. A line shows its last scan: lines of the
//! other parity are those of the field before.
//! **Phosphor.** Light decays to a tenth in the time of the part. A line shows the light from its last scan to its next. Of a
//! scan k scans before, `(1 - d) d^k` is left, d what is left after one scan.
//! **Spot.** [`parts::Spot`] over the light, along lines and across them; it keeps the sum of the light.
//! **Signals.** `tube.video` is the drive of the tube along the lines that the beam scans, in the order of time ([`SIGNALS`]).
//! **Units.** Light is in the unit of reflectivity: `display.white` is white. Times in seconds, bandwidths in hertz.
//! **State and timing.** None of its own: the caller hands over the pictures that were read in the frames before
//! ([`PictureTube::frames_before`]). Before the first frame the tube has shown the first frame.
//! **Elaboration.** A display without figures is not there. Noise and spot are stages that may be missing.
//! **Our choices.** Noise of the storage tube is told at the corrected video. A line begins settled. An update is kept as
//! its last showing. What is below a millionth of white is forgotten.
//! **Not modelled.** Growth of the spot with the beam current, a current that saturates, shading, retrace between fields.

mod amplifier;
mod law;
mod scans;
mod tube;

pub use tube::{PictureTube, ScanRaster};

use signal::{Signal, Unit};

/// Name of the signal that drives the tube.
pub const TUBE_VIDEO: &str = "tube.video";

/// Signals of the block, along the lines of the read-out.
pub const SIGNALS: &[Signal] = &[Signal::line(
    TUBE_VIDEO,
    Unit::Number,
    "video that drives the picture tube, behind the video amplifier, its noise and its contrast: 1 for white",
    "section 16",
)];
