//! Tiles against what they must show: rays cast to the sun, closed forms, far mountains, files.

mod against_rays;
mod bodies;
mod closed_forms;
mod common;
mod files_and_threads;
