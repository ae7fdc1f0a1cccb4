//! Light points of the hybrid machine: lamps, beacons and stars in display-plane position.
//!
//! ```text
//!            ┌────── digital, once a frame ──────┐   ┌────────── analog, sweep by sweep ───────────┐
//! lights ──▶ place on the view-plane ─▶ Disc ─▶ chords ─▶ cut by ground, mountains, polyhedra ─▶ pieces
//!                                                                ▲ dpp.hold      ▲ runs of VS3      │
//!                     raster points:        sm.write ─▶ C ┐                                         │
//!                                 tau C + I c ────────▶ S ┴ VS3 ◀── gate: where a piece is ─────────┤
//!                     calligraphic points:  veil, shares ◀── sampling points (sweep, line) ─────────┘
//!                                             └──▶ list of the frame ─▶ spots of a second beam
//! ```
//!
//! # Law
//!
//! - **Disc**: crate `light-points`, as in every other generator. Its least diameter is 1.5 pixels, or 1.5 spaces between sweeps where
//!   those lie farther apart than pixels. So every disc meets a sweep.
//! - **Chord**: along a sweep the picture runs straight ([`sweep_memory::Reading::shown`]), so a sweep covers a disc over one stretch
//!   of line positions.
//! - **Sight**: the held elevation at the light's range hides what lies below its line. Mountains of which only the outline is stored
//!   hide what lies beyond the last sample. Polyhedra hide what lies behind what the third video switch shows of them.
//! - **Raster points** enter at the third video switch, over polyhedra, far to near. Over a piece the line is `tau C + I c`, with
//!   `tau = 1 - min(I, 1)`; a line shows the share that the piece covers. I is the light of the disc over the area of all its chords,
//!   hidden or not, so a lamp does not twinkle as it moves over the sweeps. The machine is grey: c is the luminance of the colour.
//! - **Calligraphic points** leave the machine as a list. Sampling points are [`SAMPLES_A_LINE`] places a line on every sweep. The
//!   fading of a point is the share of those under its disc that see it, through the veil of nearer points. A second beam draws a
//!   Gaussian spot of the light that is left over the picture.
//!
//! # Our choices
//!
//! Light points stand in true perspective under every projection law, as polyhedra do. Their places and chords are ready as the frame
//! begins. The beam has time for every point. A line shows its mean under either [`scenario::PixelRule`].

mod beam;
mod chords;
mod placing;
mod sight;
mod switch;
mod table;

pub use beam::{beam_entries, draw_beam};
pub use placing::{Optics, Point};
pub use sight::Before;
pub use switch::{LightSwitch, SAMPLES_A_LINE, Third};
pub use table::{Chord, PointTable};
