//! A photograph of a landscape, drawn by `exact`, with everything that a check of it needs.
//!
//! ```text
//!  Wishes --> Stand: pose, camera, field --> exact --> light --> noise --> codes --> photo.png
//!                      |                       \--> what is seen --+
//!                      v                                           v
//!                 camera.json <-- sun, grey curve      ray of each pixel --> ground.npy
//!                      |                                           |
//!                      +--> residual: ground points projected back-+--> points.csv, elevation.asc
//!
//!  georeferenced raster --> light of 16 bits --> photo.png, camera.json (a map)
//! ```
//!
//! # Law
//!
//! - **Axes** of the camera file are those of a landscape: x east, y north, z up (m). The ground is a plane: curvature is off.
//! - **Stand.** The optical axis meets the ground at the centre. The camera stands back along the axis until the ground sample
//!   there is the one that was asked for: `pixel = focal_length * ground_sample / distance`.
//! - **Pixels.** One ray through each centre, no mean over the pixel. A picture has square pixels.
//! - **Light** is that of the scenario at a time, with its shadows, from the finest level of the ground. The vehicle casts no shadow.
//!   Lamps, sheets, overlays and stars are left out.
//! - **Truth.** The ground point of a pixel is the first meeting of its ray with terrain and craters, in f64. A pixel that shows a
//!   rock, an object or the sky has no ground point.
//! - **Noise** is Gaussian, added to light before coding. It follows from seed and pixel alone.
//! - **Residual.** The camera file is read back from its text, and every ground point is projected by that camera. The residual is
//!   the largest distance from the centre of the pixel.
//!
//! # See also
//!
//! `tests/photo_make`: closed loop, closed forms, faults of the wishes. `docs/photo.md`: the command.

mod elevation;
mod error;
mod folder;
mod import;
mod light;
mod made;
mod points;
mod record;
mod stand;
mod truth;
mod wishes;

pub use elevation::ElevationGrid;
pub use error::{MakeError, WriteError};
pub use folder::{FILES, write_folder};
pub use import::{IMPORTED_FILES, ImportError, Imported, import, write_imported};
pub use made::{Made, make};
pub use record::record;
pub use stand::Stand;
pub use wishes::{Reach, Wishes};
