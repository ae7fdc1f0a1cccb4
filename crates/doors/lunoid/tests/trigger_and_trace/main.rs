//! `lunoid trigger` and `lunoid trace`, by the command itself.

#[path = "../command/scene.rs"]
mod scene;

mod conditions;
mod listing;
mod places;
mod registers;

use serde_json::Value;

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// `tiny.toml` on the nominal machine with a buffer that holds all of it, slow enough for late sets.
const NOMINAL: [&str; 6] =
    ["--machine", "pra-nominal", "--set", "buffer.words=unlimited", "--set", "loader.access_ns=100000"];

fn with<'a>(command: &[&'a str], more: &[&'a str]) -> Vec<&'a str> {
    command.iter().chain(&NOMINAL).chain(more).copied().collect()
}
