//! A landscape as a text file of features over a base.

mod boulder;
mod crater;
mod distribution;
mod draw;
mod frame;
mod grid;
mod growth;
mod height_grid;
mod refused;
mod roughness;
mod size_law;

pub use boulder::{Boulder, Shape, USUAL_BURIAL, USUAL_FACES};
pub use crater::{Crater, CraterForm, Decay, Nearest, NoNearest, USUAL_CONSTANT, USUAL_EXTENT};
pub use distribution::{Distribution, Item, MOST_ITEMS};
pub use frame::{Frame, FrameWarning, MOON_RADIUS};
pub use grid::{Axis, Grid, MOST_EXPONENT};
pub use growth::{ControlPoint, Growth, GrowthReported, Pick, runs};
pub use height_grid::{Area, HeightGrid, Posts, bilinear};
pub use refused::Refused;
pub use roughness::Roughness;
pub use size_law::{CHI_SQUARED_END, SizeLaw};
