//! Runs of a tiny scene: same bytes for any number of threads and interruptions, and whose files may be touched.

mod checks;
mod colour;
mod folders;
mod outputs;
mod resume;
mod stage;
mod truth;
