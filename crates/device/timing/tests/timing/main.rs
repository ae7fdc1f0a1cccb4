//! Timing records against damage, against each other, and against themselves read back.

mod comparison;
mod event_hash;
mod file;
mod junit;
mod samples;
mod slack;
mod tables;
