//! Sweep memory (section 16): sweeps are written as they come, the picture is read in any raster.
//!
//! ```text
//! dpp.y ─────────▶ write deflection ┐
//! mu.reflectivity ▶ beam intensity ─┴▶ sm.write ─▶ store [sweep, line] ─▶ read-out ─▶ video
//! ```
//!
//! **Law.** While a profile is in sight its beam moves up the lines of its sweep; what a line shows is the mean of
//! the intensity over the line, or the intensity at its centre ([`PixelRule`]). Lines that no beam covers are sky
//! (0); a line that is partly covered is partly sky.
//! **Between samples** the wires are continuous: where position or intensity bends, the step is drawn along the
//! cubic through the samples around it; the beam is cut off at the instant where local shadow begins.
//! **Read-out.** [`scan_converter`]: any raster; a pixel lies between two sweeps and takes their mean by distance, which is
//! the spot of the reading beam. [`digital_memory`]: column n is sweep n, whatever its azimuth.
//! **Timing.** A frame is read when its last sweep is written.
//! **Our choices.** Linear spot; the outermost sweeps serve pixels beyond them by at most half a sweep.
//! **Not modelled yet.** Spot size, writing-speed exposure, residue, quantisation; polyhedra (VS3).

mod read_out;
mod write;

pub use read_out::{View, digital_memory, scan_converter};
pub use scenario::PixelRule;
pub use write::{Beam, SIGNALS, write_group};
