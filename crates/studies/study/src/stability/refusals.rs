//! What a scenario may not say: every limit of the format named by its key, and numbers that are none.

use std::time::Instant;

use features::{Crater, Shape};
use landscape::Level;
use scenario::Scenario;

use super::cell::{Cell, Found, Theory};

/// A scenario that is in order; each case changes one line of it.
pub const BASE: &str = include_str!("small.toml");

/// Line of the base, what it becomes, and what the message names.
const CASES: [(&str, &str, &str); 12] = [
    ("elevation_deg = 12", "elevation_deg = nan", "elevation_deg"),
    ("elevation_deg = 12", "elevation_deg = 0", "elevation_deg"),
    ("elevation_deg = 12", "elevation_deg = 90.1", "elevation_deg"),
    ("azimuth_deg = 70", "azimuth_deg = inf", "azimuth_deg"),
    ("samples_per_sweep = 400", "samples_per_sweep = 1", "samples_per_sweep"),
    ("samples_per_sweep = 400", "samples_per_sweep = 1000000", "samples_per_sweep"),
    ("start_m = 2", "start_m = 1e-4", "start_m"),
    ("start_m = 2", "start_m = 900", "end_m"),
    ("start_m = 2", "start_m = nan", "start_m"),
    ("field_of_view_deg = [50, 30]", "field_of_view_deg = [0, 30]", "field_of_view_deg"),
    ("field_of_view_deg = [50, 30]", "field_of_view_deg = [180, 30]", "field_of_view_deg"),
    ("rms_height_m = 6", "rms_height_m = nan", "rms_height_m"),
];

/// Returns a cell for every input that readers must refuse.
pub fn refusals() -> Vec<Cell> {
    let texts = CASES.iter().map(|(line, wrong, key)| {
        let start = Instant::now();
        let found = match Scenario::parse("stability", &BASE.replace(line, wrong)) {
            Ok(_) => answered(),
            Err(problems) => naming(problems.to_string(), key),
        };
        cell(&format!("scenario with {wrong}"), Found { time_s: start.elapsed().as_secs_f64(), ..found })
    });
    let words = |value: f64| vec![[value; 9]; 4];
    let level =
        |value: f64| Level::new(10.0, [0.0; 2], [2, 2], words(value)).map(|_| ()).map_err(|e| e.to_string());
    let bowl =
        |r1: f64| Crater::new([0.0; 2], Shape::Bowl { r1 }, 1.0, 0.0).map(|_| ()).map_err(|e| e.to_string());
    let place = |x: f64| {
        Crater::new([x, 0.0], Shape::Bowl { r1: 1.0 }, 1.0, 0.0).map(|_| ()).map_err(|e| e.to_string())
    };
    let data = [
        ("words of NaN", level(f64::NAN), "word"),
        ("words of infinity", level(f64::INFINITY), "word"),
        ("words of 1e300 m", level(1e300), "word"),
        ("a crater of radius NaN", bowl(f64::NAN), "radii"),
        ("a crater of radius 0", bowl(0.0), "radii"),
        ("a crater at NaN", place(f64::NAN), "centre"),
    ];
    let data = data.into_iter().map(|(case, result, key)| {
        cell(case, result.map_or_else(|message| naming(message, key), |()| answered()))
    });
    texts.chain(data).collect()
}

fn cell(case: &str, found: Found) -> Cell {
    Cell::own("input", case, "reader", Theory::Refuses, found)
}

fn answered() -> Found {
    Found { action: super::cell::Action::Exact, ..Found::refused(String::new()) }
}

/// A refusal; one that does not name what is wrong says nothing.
fn naming(message: String, key: &str) -> Found {
    let names = message.to_lowercase().contains(key);
    Found::refused(if names { message } else { String::new() })
}
