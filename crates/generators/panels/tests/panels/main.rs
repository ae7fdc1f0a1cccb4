//! Photographs over panels of ground: what pictures, panels and explanations show.

mod identity;
mod light;
mod moffett;
mod panels_of_cells;
mod program;
mod refused;
mod shots;
mod views;
