//! Pictures of `exact` against closed forms and against brute force.

mod any_attitude;
mod bodies;
mod closed_forms;
mod colour;
mod craters;
mod effects;
mod from_above;
mod from_aside;
mod guests;
mod levels;
mod light;
mod lists;
mod many_rays;
mod open_sea;
mod roll;
mod scenes;
mod second_opinion;
mod session;
mod shadows;
mod sphere;
mod truth;
