//! What the page knows of scenarios before it opens one.

use front_door::Opened;
use serde_json::{Value, json};

/// Name of the file that lists the scenarios.
pub const LIST: &str = "scenarios.json";

/// The list of `rows`.
pub fn list(rows: &[Value]) -> Value {
    json!({ "schema": "lunoid.site.scenarios/1", "scenarios": rows })
}

/// The row of a scenario: its `name` in menus, the word that a request `open` has for it, and the files that go with that request.
pub fn row(name: &str, scenario: &str, opened: &Opened, files: &[String]) -> Value {
    json!({
        "name": name,
        "title": opened.scenario.title,
        "shows": opened.scenario.shows,
        "machine": opened.scenario.machine,
        "frames": opened.frames(),
        "scenario": scenario,
        "files": files,
    })
}
