//! Sweep memory (section 16): sweeps are written as they come, the picture is read in any raster.
//!
//! ```text
//! dpp.y ─────────▶ write deflection ┐
//! mu.reflectivity ▶ beam intensity ─┴▶ sm.write ─▶ store [sweep, line] ─▶ read-out ─▶ video
//! breaks of both ▶ when they jump or bend                                    ↑ yoke
//! ```
//!
//! **Law.** While a profile is in sight its beam moves up the lines of its sweep; what a line shows is the mean of
//! the intensity over the line, or the intensity at its centre ([`PixelRule`]). Lines that no beam covers are sky
//! (0); a line that is partly covered is partly sky.
//! **Between samples** the wires are continuous: where position or intensity bends, the step is drawn along the
//! cubic through the samples around it; the beam is cut off at the instant where local shadow begins.
//! **Breaks** ([`BeamBreaks`]) divide a step: a bend (a rim) divides position and intensity, an edge of shadow the
//! intensity alone, since the line stays the same curve. Each part is the parabola through three places of its own
//! smooth piece, and no curve reaches across a break: between smooth neighbours the cubic is the mean, by distance,
//! of two such parabolas, beside a break one of them is left, between two breaks the chord. Against a dense integral
//! of the profile a line of broken ground is within 0.006 of its mean (tested).
//! **Far strokes** ([`FarStroke`]). Behind the last sample silhouettes of mountains rise from the held line, nearest
//! first, each with one intensity (section 8).
//! **Read-out.** [`scan_converter`]: any raster; a pixel lies between two sweeps and takes their mean by distance,
//! which is the spot of the reading beam. [`digital_memory`]: column n is sweep n, whatever its azimuth.
//! **Yoke** (section 18). A turned yoke shows the raster counter-clockwise by the roll: the picture of a camera that
//! is truly rolled, since roll turns the view-plane in itself. [`View`] holds the angle, the raster that is written and
//! the field of the screen; [`covering`] is the raster whose corners fill the screen at any angle of a travel. A
//! sweep then keeps several cells a line, and the scan converter reads their mean under its beam, and across sweeps a
//! cubic, kept between the two nearest; [`digital_memory_turned`] shows cells as cells.
//! Upright, with one raster for both, nothing of this is computed.
//! **Timing.** A frame is read when its last sweep is written. Nothing is allocated while writing or reading.
//! **Our choices.** Linear spot; the outermost sweeps serve pixels beyond them by at most half a sweep; a turned screen
//! is dark beyond the raster.
//! **Not modelled.** Spot size, writing-speed exposure, residue, quantisation. Polyhedra (VS3) are laid on the store
//! by the polyhedron generator.

mod broken;
mod curve;
mod deflection;
mod exposure;
mod gather;
mod read_out;
mod stroke;
mod tube;
mod write;
mod write_gun;

pub use broken::BeamBreaks;
pub use read_out::{View, covering, digital_memory, digital_memory_turned, scan_converter};
pub use scenario::PixelRule;
pub use tube::{Tube, TubeRaster};
pub use write::{Beam, FarStroke, SIGNALS, write_group};
pub use write_gun::{Drive, GunWork, WriteGun};
