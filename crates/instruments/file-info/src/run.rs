//! The folder of a run, and a picture.

use std::path::Path;

use replay::HeldRun;
use serde_json::{Value, json};

use crate::{Held, InfoError};

pub fn run(folder: &Path) -> Result<Held, InfoError> {
    let run = HeldRun::read(folder)?;
    let document = json!(*run);
    let word = |pointer: &str| match document.pointer(pointer) {
        Some(Value::String(text)) => text.clone(),
        Some(other) => other.to_string(),
        None => "unknown".into(),
    };
    // Only the hybrid machine draws sweep by sweep.
    let sweeps = match (
        document.pointer("/settings/raster/sweeps"),
        document.pointer("/settings/raster/samples_per_sweep"),
    ) {
        (Some(sweeps), Some(samples)) => format!("{sweeps} sweeps of {samples} samples, "),
        _ => String::new(),
    };
    let text = format!(
        "{}: frames {} of \"{}\" by {} ({}), {sweeps}{} x {} pixels of {} bits\n  \
         {} {} (commit {}), fingerprint {}\n",
        folder.display(),
        word("/range").trim_matches(['[', ']']).replace(',', ".."),
        word("/scenario/title"),
        word("/generator"),
        word("/model/name"),
        word("/view/columns"),
        word("/view/lines"),
        word("/pictures/depth"),
        word("/program/name"),
        word("/program/version"),
        word("/program/commit"),
        &run.fingerprint,
    );
    Ok(Held { document, text })
}

pub fn picture(path: &Path) -> Result<Held, InfoError> {
    let picture = photographs::read(path)?;
    let (columns, lines, bits) = (picture.columns(), picture.lines(), picture.depth().bits());
    let colour = if picture.is_colour() { ", colour" } else { "" };
    let mut document = json!({
        "schema": "lunoid.info.png/1",
        "columns": columns,
        "lines": lines,
        "depth": bits,
        "pixels_blake3": picture.pixel_hash(),
    });
    if picture.is_colour() {
        document["channels"] = json!(["red", "green", "blue"]);
    }
    let hash = picture.pixel_hash();
    let text =
        format!("{}: {columns} x {lines} pixels of {bits} bits{colour}, pixel hash {hash}\n", path.display());
    Ok(Held { document, text })
}
