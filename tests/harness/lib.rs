//! What the tests share.
//!
//! - [`scene`]: a scene is a level, a light, a pose and the settings of a run, each a plain field that a test may
//!   change; [`Scene::draw`] hands it to a generator.
//! - [`random`]: scenes from a seed.
//! - [`interpreter`]: the second opinion on the terrain path, in `second_opinion/interpreter/`.
//! - [`shipped`]: the scenarios of the folder `scenarios/`, and their agreement with `exact`.
//! - [`lockstep`]: machine and interpreter side by side, and the first difference between them.

#[path = "../second_opinion/interpreter/mod.rs"]
pub mod interpreter;
pub mod lockstep;
pub mod random;
pub mod scene;
pub mod shipped;

pub use lockstep::{Difference, Lockstep};
pub use random::Dice;
pub use scene::{Drawn, Scene, level_of, plane};
pub use shipped::Shipped;
