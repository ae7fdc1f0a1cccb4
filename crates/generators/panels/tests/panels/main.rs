//! Photographs over panels of ground: what pictures, panels and explanations show.

mod coarser;
mod faults;
mod identity;
mod labels;
mod light;
mod moffett;
mod panels_of_cells;
mod program;
mod refused;
mod rows;
mod shots;
mod time;
mod timed_set;
mod views;
