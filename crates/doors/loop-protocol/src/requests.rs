//! What a session knows to do, and the keys of each request.

use serde_json::{Value, json};

/// A kind of request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RequestRow {
    /// Word of the key `do`.
    pub name: &'static str,
    /// What the request does, in a sentence.
    pub about: &'static str,
    /// Keys beside `id` and `do`.
    pub keys: &'static [&'static str],
}

/// Keys of every request.
pub const COMMON: [&str; 2] = ["id", "do"];

/// All kinds of requests, in the order of the documentation.
pub const REQUESTS: [RequestRow; 22] = [
    row("hello", "Say what is known and what is opened.", &[]),
    row("open", "Open a scenario.", &["scenario", "machine", "overlays", "channel", "set"]),
    row("frame", "Draw a frame of the path.", &["frame", "planes"]),
    row("look", "Draw what is seen from a pose.", &["pose", "frame", "planes"]),
    row("step", "Drive the next frame of the loop to a pose and draw it.", &["pose", "planes"]),
    row("ahead", "Say where the vehicle is after a turn and a way.", &["pose", "metres", "turn_deg"]),
    row("set", "Change the settings and keep the loop.", &["machine", "overlays", "channel", "set"]),
    row("state", "Hand out the state of the loop.", &["frames"]),
    row("restore", "Take a state up.", &[]),
    row("record", "Hand out what was driven, as files that `lunoid replay` draws.", &["name"]),
    row("probe", "Record signals.", &["signals", "frame", "pose", "sweeps"]),
    row("explain", "Explain a pixel.", &["frame", "pose", "column", "line"]),
    row(
        "events",
        "List digital events.",
        &["frame", "pose", "sweeps", "unit", "event", "colour", "level", "from", "to", "limit"],
    ),
    row(
        "trigger",
        "Find where in a frame a condition on signals is met.",
        &["on", "frame", "pose", "sweeps", "samples", "after", "limit"],
    ),
    row("effect", "Say which pixels late words changed.", &["late", "frame", "pose"]),
    row("timing", "Count the deadlines of a frame, and those that were missed.", &["frame", "pose"]),
    row("omissions", "List what was left out, and why.", &[]),
    row("signals", "List the signals.", &[]),
    row("blocks", "List the blocks with their signals.", &[]),
    row("parameters", "List the values that decide how the machine draws.", &[]),
    row("faults", "List the overlays of one fault that ship.", &[]),
    row("planes", "List the planes that a picture can have.", &[]),
];

const fn row(name: &'static str, about: &'static str, keys: &'static [&'static str]) -> RequestRow {
    RequestRow { name, about, keys }
}

impl RequestRow {
    /// The row of a word.
    pub fn find(name: &str) -> Option<&'static Self> {
        REQUESTS.iter().find(|row| row.name == name)
    }

    /// The row as JSON.
    pub(crate) fn json(&self) -> Value {
        json!({ "name": self.name, "about": self.about, "keys": self.keys })
    }
}
