//! Commands about the ground: banks, elevation files, landscapes and their exports, what ground hides, photographs, and where the Sun stands
//! over it. Each module is a command of `lunoid`: its arguments and help, its calls of a library, what it prints.
//!
//! # See also
//! `command-line`: what commands share. `survey`, `sight`, `terrain-builder`, `terrain-export`, `photo-make`, `photo-check`, `photo-drape`,
//! `ephemeris`: the libraries that do the work.

pub mod bank;
mod elevation;
pub mod photo;
pub mod sight;
pub mod sun;
pub mod survey;
pub mod terrain;
