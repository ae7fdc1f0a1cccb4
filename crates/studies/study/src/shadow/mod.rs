//! The vehicle's shadow: the error of flat ground, and the laws and methods of `lunoid augment` against run time.

mod flat_ground;
mod laws;

pub use flat_ground::{
    FLAT_ERROR_ROUNDING, FlatGroundFigures, FlatGroundOutcome, FlatGroundPlan, SeenEdge, csv, flat_ground,
    table,
};
pub use laws::{LawOutcome, laws, laws_table};
