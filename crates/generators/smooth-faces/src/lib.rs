//! Smooth-shaded faces on vertical scan lines: the digital image generator of Link's study of sea state, wakes and ships for NASA Ames
//! (about 1980).
//!
//! ```text
//!  sea, wakes, ships, effects (faces) --+
//!  bodies of the stage (faces) ---------+--> lists by priority --> shown faces --> cut, clipped, projected: pieces
//!  ground (ground-mesh) ----------------+          |                                  |
//!  suns of the lists, frame by frame ---> brightness at corners ----------------------+--> crossings of each scan line
//!                                                                                               |
//!             planes <-- levels of detail added <-- by priority or by depth <-- ramps <----------+
//! ```
//!
//! # Law
//!
//! - **Lists.** The sea, its levels, ships, wakes and effects have the priorities of the scenario. Behind them come bodies, the nearest
//!   first, each a list of its own; the ground is last. Under `order = "lists"` the lower number wins a sample, inside a list the face
//!   stored first. Under `depth` the nearest face wins, of two that coincide the
//!   earlier one. Samples where the two disagree are counted.
//! - **Brightness** of a corner is that of `faces`: normals averaged or given, times the list's own sun. Ground has the light of the scene's law
//!   at its vertices.
//! - **Pieces.** Faces of more than three corners are cut in triangles. Each piece is clipped at the near plane before it is projected; one that
//!   lies between samples is left out.
//! - **Ramps.** On a scan line brightness runs linearly between the two edges of a piece, and along these between their corners: on the screen, or in
//!   space. A sample is in the piece where its middle lies between both edges, the first one with it. Neighbours share each sample once.
//! - **Levels of detail.** A list that adds is laid upon what its samples show, where that is not before it: `min(1, a + b)`, or
//!   `1 - (1 - a)(1 - b)`, or in its place.
//! - **Slots.** A scan line holds `edges_line` pieces. Those beyond are left out of this line: the last list loses first, in it the face stored
//!   last. A frame holds `edges_frame` edges: levels of detail that are laid upon lists fall first, then whole faces go in the same order.
//! - Perspective is the true one under every law of projection; roll is the yoke's. One sample a pixel.
//!
//! # Run parameters
//!
//! | key | range | default | what it is |
//! |---|---|---|---|
//! | `faces.order` | `depth`, `lists` | `depth` | which face wins a sample; `depth` wherever a ship asks for it |
//! | `faces.interpolation` | `screen`, `perspective` | `screen` | where brightness runs linearly |
//! | `faces.shading` | `smooth`, `as-written`, `flat` | `smooth` | how bodies and ground are shaded; `flat` makes all lists flat |
//! | `faces.cut` | true, false | true | faces of more than three corners are cut in triangles |
//! | `faces.scan` | `vertical`, `horizontal` | `vertical` | direction of scan lines |
//! | `faces.animate` | `sun`, `normals` | `sun` | what moves a sea |
//! | `faces.hull` | `as-written`, `sea-first`, `deep-hull` | `as-written` | wrong orders and models of ships, for teaching; under `lists` alone |
//! | `faces.channels` | 1 to 64 | 1 | channels that share the real-time computer |
//! | `faces.delayed` | true, false | false | a picture shows the frame `delay_frames` before its own |
//! | `faces.ambient` | 0 to 1 | 0 | share of light from everywhere |
//! | `faces.ground` | true, false | true | whether the ground is drawn |
//! | `faces.ground_cells` | 8 to 512, a multiple of 4 | 64 | cells along half the side of each ring of the ground |
//! | `faces.ground_half_side_m` | 0.1 to 100000 | 32 | half the side of the innermost ring |
//! | `faces.limit` | 1 to 10000000 | 200000 | most faces of a list |
//!
//! # Timing
//!
//! ```text
//!  rt: sequences, sun vectors, bodies, normals --> transfer --> geometry --> edge slots --> video: samples, ramps
//!      spare_us of a frame (Schedule)                                        (slots)
//! ```
//!
//! The real-time computer works for a frame in the spare time of the frame before, in the order of the kinds and lists. What does not fit is done in
//! what is left of several frames; its list shows what it showed before (`schedule.rs`). So a frame is a function of its number. A record counts
//! nanoseconds. Its deadlines are `frame-tasks`, `update`, and where slots are limited `edge` and `edge-store`.
//!
//! # Gear
//!
//! The keys stand in `hardware-models/programs/smooth-faces.toml`, their ranges in `docs/blocks/smooth-faces.md`.
//!
//! # Threads
//!
//! Scan lines are functions of their own: the bits do not depend on the number of threads.
//!
//! # Not modelled
//!
//! Lamps, sheets, overlays, discs of the sky, remote shadow, texture, far silhouettes and vehicle tracks are listed as omissions.

mod bodies;
mod deadlines;
mod drawn_lists;
mod faults;
mod frame_lists;
mod ground;
mod hardware;
mod inputs;
mod judged;
mod list;
mod name;
mod parameters;
mod piece;
mod planes;
mod prepared;
mod row;
mod scan_line;
mod scene;
mod schedule;
mod session;
mod shown;
mod signals;
mod sizing;
mod slots;
mod smooth_faces;
mod timed;
mod work;

pub use hardware::{Hardware, RealTime};
pub use parameters::{Hull, Parameters};
pub use row::ROW;
pub use smooth_faces::SmoothFaces;
pub use timed::Clocked;
