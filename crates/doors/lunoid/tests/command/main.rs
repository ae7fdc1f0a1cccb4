//! What a user types and sees.

mod augment;
mod bad_input;
mod banks;
mod cartridges;
mod changed;
mod checks;
mod colour;
mod columns;
mod explain;
mod first_minutes;
mod help;
mod lockstep;
mod lunsim;
mod models;
mod netlist;
mod overlays;
mod refusals;
mod replays;
mod scene;
mod shadow;
mod side_by_side;
mod stability;
mod state;
mod sun;
mod timing;
mod wishes;
