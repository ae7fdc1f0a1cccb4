//! Pictures of lists of faces against closed forms and against one another.

mod delay;
mod faults;
mod gear;
mod judged;
mod levels;
mod lines;
mod orders;
mod pitch;
mod roads;
mod schedule;
mod sea;
mod shots;
mod slots;
mod timed;
mod told;
