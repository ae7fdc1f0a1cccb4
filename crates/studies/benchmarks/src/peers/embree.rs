//! The machine against a ray tracer over Embree: the same ground, eye and sun, with cast shadows. Other generators are held
//! against it over their own faces.
//!
//! `peers/ground.toml` is the scene. Each side has a ladder of settings. Of each ladder the fastest setting counts whose picture is
//! close enough to `exact` at the centres of the same pixels. Both use two threads and take turns.

mod comparison;
mod mesh;
mod program;
mod scene;
mod scene_file;
mod screen_mesh;

pub use comparison::table;
pub use mesh::{EyeMesh, Grading};
pub use program::{Embree, Program};
pub use scene::{Fineness, PeerScene, Setting};
pub use scene_file::{Sight, scene_file};
pub use screen_mesh::{camera_sight, screen_mesh};
