//! Programs and profiles of sweeps over craters.

mod common;
mod kinks;
mod loads;
mod profiles;
mod schedules;
