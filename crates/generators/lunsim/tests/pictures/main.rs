//! Pictures of LUNSIM in closed form, its restrictions, and its session.

mod closed_forms;
mod explained;
mod program;
mod restrictions;
mod rows;
mod scenes;
mod session;
