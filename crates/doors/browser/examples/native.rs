//! Hashes and times of pictures by the native program on one thread, for comparison with a page.
//!
//! Standard input: a JSON array of `{ "scenario", "frame", "machine", "set" }`. Standard output: the same with `hash`, `open_ms`, `frame_ms`.

use std::io;
use std::path::Path;
use std::time::Instant;

use drive::{Drive, Wishes};
use serde_json::{Value, json};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cases: Vec<Value> = serde_json::from_reader(io::stdin())?;
    let told: Result<Vec<Value>, _> = cases.iter().map(told).collect();
    println!("{}", Value::from(told?));
    Ok(())
}

fn told(case: &Value) -> Result<Value, Box<dyn std::error::Error>> {
    let scenario = case["scenario"].as_str().ok_or("a case without a scenario")?;
    let settings = case["set"].as_object().into_iter().flatten();
    let wishes = Wishes {
        machine: case["machine"].as_str().map(str::to_owned),
        set: settings.map(|(key, value)| (key.clone(), value.to_string())).collect(),
        ..Wishes::default()
    };
    let begun = Instant::now();
    let drive = Drive::open(Path::new(scenario), &wishes, 1)?;
    let opened = Instant::now();
    let seen = drive.frame(case["frame"].as_u64().unwrap_or(0))?;
    let drawn = Instant::now();
    let milliseconds = |from: Instant, to: Instant| (to - from).as_secs_f64() * 1e3;
    let mut told = case.clone();
    told["hash"] = json!(seen.hash());
    told["open_ms"] = json!(milliseconds(begun, opened));
    told["frame_ms"] = json!(milliseconds(opened, drawn));
    Ok(told)
}
