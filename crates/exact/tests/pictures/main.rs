//! Pictures of `exact` against closed forms and against brute force.

mod closed_forms;
mod scenes;
mod second_opinion;
mod session;
