//! Pictures of lists of faces against closed forms and against one another.

mod levels;
mod lines;
mod orders;
mod pitch;
mod roads;
mod sea;
mod shots;
mod told;
