//! A photograph's camera: from ground to picture and back.
//!
//! ```text
//!  text --> angle --> Geodetic --> Ellipsoid --> ground point
//!                                                    |
//!  angles or axes --> Orientation --> Camera --> project --> pixel
//!                        Affine ---^     |
//!                                       ray <-- pixel;  ray --> plane, body --> ground point
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
mod camera;
mod check;
mod ellipsoid;
mod error;
mod orientation;
pub mod voids;

pub use affine::Affine;
pub use angle::{Axis, parse_angle, write_angle};
pub use camera::{Camera, Image, Ray};
pub use check::{ControlPoint, Residuals, check};
pub use ellipsoid::{Ellipsoid, Geodetic, LocalFrame};
pub use error::CameraError;
pub use orientation::Orientation;
