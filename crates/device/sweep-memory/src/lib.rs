//! Sweep memory (section 16): sweeps are written as they come, the picture is read in any raster.
//!
//! ```text
//! dpp.y ─────────▶ write deflection ┐
//! mu.reflectivity ▶ beam intensity ─┴▶ sm.write ─▶ store [sweep, line] ─▶ read-out ─▶ video
//! breaks of both ▶ when they jump or bend                                    ↑ yoke
//!
//! of real parts:
//! position ─▶ deflection ─┐
//! intensity ─▶ current ───┴▶ charge ─▶ store ─▶ + residue ─▶ spot, registration ─▶ read-out ─▶ video
//! stretches ─▶ on, off ───┘                     of earlier pictures
//! ```
//!
//! **Law.** While a profile is in sight its beam moves up the lines of its sweep; what a line shows is the mean of
//! the intensity over the line, or the intensity at its centre ([`PixelRule`]). Lines that no beam covers are sky
//! (0); a line that is partly covered is partly sky.
//! **Between samples** the wires are continuous: where position or intensity bends, the step is drawn along the
//! cubic through the samples around it, or straight from sample to sample ([`Steps`]); the beam is cut off at the
//! instant where local shadow begins.
//! **Breaks** ([`BeamBreaks`]) divide a step: a bend (a rim) divides position and intensity, an edge of shadow the
//! intensity alone, since the line stays the same curve. Each part is the parabola through three places of its own
//! smooth piece, and no curve reaches across a break: between smooth neighbours the cubic is the mean, by distance,
//! of two such parabolas, beside a break one of them is left, between two breaks the chord. Against a dense integral
//! of the profile a line of broken ground is within 0.006 of its mean (tested).
//! **Far strokes** ([`FarStroke`]). Behind the last sample silhouettes of mountains rise from the held line, nearest
//! first, each with one intensity (section 8).
//! **Read-out.** [`Memory::ScanConverter`]: any raster; a pixel lies between two sweeps and takes their mean by distance,
//! which is the spot of the reading beam. [`Memory::Digital`]: column n is sweep n, whatever its azimuth. A picture is read
//! in tiles ([`Reading`]): each asks for a few sweeps alone.
//! **Yoke** (section 18). A turned yoke shows the raster counter-clockwise by the roll: the picture of a camera that
//! is truly rolled, since roll turns the view-plane in itself. [`View`] holds the angle, the raster that is written and
//! the field of the screen; [`covering`] is the raster whose corners fill the screen at any angle of a travel. A
//! sweep then keeps several cells a line, and the scan converter reads their mean under its beam, and across sweeps a
//! cubic, kept between the two nearest; [`Memory::DigitalTurned`] shows cells as cells.
//! Upright, with one raster for both, nothing of this is computed.
//! **Timing.** A frame is read when its last sweep is written; the emulator reads a tile as soon as its sweeps are there.
//! **Write gun** ([`WriteGun`]; hardware-1969, sections 3.8 and 6). The beam is on in stretches of time. Between two
//! samples its position and its current run straight; where the current jumps or bends between them, the stroke is divided. Deflection is of second order, with the bandwidth of the part
//! and Butterworth damping; the intensity is delayed as much as the nominal part delays a ramp, so that what is left is
//! its transients and how far the part is off. The amplifier stops half a picture beyond the edges.
//! Charge is current times time, and adds: `i(w) c(v) dt` along the stroke, v the speed of the beam. `c` is v within the
//! range of the compensation (its greatest over its least, about the nominal speed of all lines in all steps), constant
//! without one. A line of charge q, in those of a white line, shows `(1 - e^-q) / (1 - 1/e)`; the current of an
//! intensity is the inverse of this, so that a grey comes out as itself at the right exposure.
//! With exact compensation the store keeps levels: the mean over the line, as from the ideal beam, and what is written
//! again is written over.
//! **Tube** ([`Tube`]). The k-th picture before this one in the same tube is left with `rho^k`. The spot is Gaussian,
//! `0.375 / n` of the picture's height, for half response at `n / 2` cycles a height: that of both guns together. A tube
//! reads with a displacement and a scale of its own, along and across; where there are two, every second frame has the
//! other. n shades that can be told
//! apart are noise in the video, which the display adds (crate `picture-tube`).
//! **Words** ([`Words`]) of a digital memory: what is written is rounded to the nearest of 2^b levels from 0 to the white of the display.
//! **Elaboration.** Exact compensation, no deflection, no spot, no residue: each is a stage that is not there. Charge
//! and levels are two guns, chosen once a group.
//! **Our choices.** Linear spot; the outermost sweeps serve pixels beyond them by at most half a sweep; a turned screen
//! is dark beyond the raster. White is 1 - 1/e of the whole charge. Residue adds in levels. Both spots at the reading.
//! **Not modelled.** Slew of the deflection, decay while reading, blemishes, the spot's growth with the current. A gun
//! of real parts knows no cubic between samples, no bends of position and no [`PixelRule::Centre`]. Polyhedra (VS3) are laid on
//! the store by the polyhedron generator.

mod aim;
mod broken;
mod cubic;
mod curve;
mod deflection;
mod exposure;
mod read_out;
mod screen;
mod side_by_side;
mod stroke;
mod tiles;
mod tube;
mod turned;
mod upright;
mod words;
mod write;
mod write_gun;

pub use broken::BeamBreaks;
pub use read_out::{View, covering};
pub use scenario::PixelRule;
pub use tiles::{Memory, Reading, Sweeps, Tile};
pub use tube::{Tube, TubeRaster};
pub use words::Words;
pub use write::{Beam, FarStroke, SIGNALS, Steps, write_group};
pub use write_gun::{Drive, GunWork, WriteGun};
