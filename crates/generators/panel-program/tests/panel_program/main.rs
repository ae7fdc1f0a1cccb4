//! The thesis's program: check values, each finding alone, five ways to fill.

#![allow(dead_code, reason = "each module takes a part of the block")]

mod blends;
mod block;
mod check_values;
mod counts;
mod fills;
mod findings;
mod looks;
mod refused;
mod shipped;
mod work;
