//! Programs and profiles of sweeps over craters.

mod common;
mod kinks;
mod profiles;
mod schedules;
