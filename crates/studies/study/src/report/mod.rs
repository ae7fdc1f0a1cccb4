//! What came of a study, for people and programs: text, a document, tables and plots in a folder.

mod economy;
mod error;
mod folder;
mod judged;
mod ladder_plots;
mod levels;
mod lights;
mod matrix_plot;
mod pops;
mod sea;
mod shadow;
mod shadow_plots;
mod stability;
mod tracks;

pub use economy::EconomyReport;
pub use error::ErrorReport;
pub use folder::{ReportError, is_of, make_folder};
pub use judged::JudgedReport;
pub use levels::LevelReport;
pub use lights::LightReport;
pub use pops::PopReport;
pub use sea::SeaReport;
pub use shadow::ShadowReport;
pub use stability::StabilityReport;
pub use tracks::{LadderTracks, TrackReport};
