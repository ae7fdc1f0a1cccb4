//! Pictures of `exact` against closed forms and against brute force.

mod closed_forms;
mod many_rays;
mod scenes;
mod second_opinion;
mod session;
