//! A photograph's camera: from ground to picture and back.
//!
//! ```text
//!  text --> angle --> Geodetic --> Ellipsoid --> ground point
//!                                                    |
//!  angles or axes --> Orientation --> Camera --> project --> pixel
//!                        Affine ---^     |
//!                     CameraFile <--> |  \-- check: control points --> Residuals
//!                                       ray <-- pixel;  ray --> plane, body --> ground point
//!
//!  heights with voids --> holes --> fill: harmonic and four other ways --> Filled
//! ```
//!
//! # Units
//!
//! Metres and radians. The affine alone is in micrometres, as photogrammetry writes it.
//!
//! # See also
//!
//! `tests/photo_camera`: check values, closed forms, second evaluators, bad input.

mod affine;
mod angle;
mod axes;
mod camera;
mod check;
mod ellipsoid;
mod error;
mod file;
mod frame;
mod light;
mod orientation;
pub mod voids;

pub use affine::Affine;
pub use angle::{Axis, parse_angle, write_angle};
pub use axes::Axes;
pub use camera::{Camera, Image, Ray};
pub use check::{ControlPoint, Residuals, check, check_by};
pub use ellipsoid::{Ellipsoid, Geodetic, LocalFrame};
pub use error::CameraError;
pub use file::CameraFile;
pub use frame::FramePixel;
pub use light::Light;
pub use orientation::Orientation;
