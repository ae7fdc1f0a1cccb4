//! A drive has the bits of the command's crates; a loop is a run that can be drawn again.

mod errors;
mod looped;
mod same;
mod scene;
mod wires;
