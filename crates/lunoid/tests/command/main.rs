//! What a user types and sees.

mod bad_input;
mod banks;
mod help;
mod models;
mod replays;
mod scene;
mod timing;
