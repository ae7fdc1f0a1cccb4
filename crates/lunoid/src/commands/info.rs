//! `lunoid info`: what a file or a run folder holds.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use clap::Args;
use front_door::{KNOWN, Kind, read_scenario};
use hardware_model::HardwareModel;
use landscape::bank_file;
use quantities::degrees;
use replay::HeldRun;
use scenario::{Ground, Length, Scenario};
use serde_json::{Value, json};
use survey::{Elevation, Frame, Method, ReadOptions, SurveyError};

use crate::commands::bank::shortened;
use crate::commands::{bank, model};
use crate::output::{print, print_json};
use crate::{Failure, Verdict};

/// Say what a file or a run folder holds.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid info moon.bank\n\n\
    Knows banks, elevation files, scenarios, hardware models, pictures (PNG, JPEG), and run folders.")]
pub struct Info {
    /// File or folder.
    file: PathBuf,
    /// Print as JSON.
    #[arg(long)]
    json: bool,
}

impl Info {
    /// Looks.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let (document, text) = look(&self.file)?;
        if self.json {
            print_json(&document)?
        } else {
            print(&text)?
        }
        Ok(Verdict::Yes)
    }
}

fn look(path: &Path) -> Result<(Value, String), Failure> {
    if path.is_dir() {
        return run(path);
    }
    let start = first_bytes(path)?;
    match start.as_slice() {
        [b'L', b'U', b'N', b'O', b'B', b'A', b'N', b'K', ..] => {
            let bank = bank_file::read(path)?;
            Ok((bank::document(path, &bank), bank::describe(&bank)))
        }
        [0x89, b'P', b'N', b'G', ..] | [0xFF, 0xD8, 0xFF, ..] => picture(path),
        _ if path.extension().is_some_and(|extension| extension == "toml") => match Kind::of(path) {
            Kind::Scenario => scenario(path),
            Kind::Sidecar => Err(Failure::input(format!(
                "{}: the description of a bank; expected the bank itself, the same name without .toml",
                path.display()
            ))),
            Kind::Overlay => Err(Failure::input(format!(
                "{0}: differences from a hardware model; expected a model. `lunoid model show ideal --overlay {0}` has them",
                path.display()
            ))),
            Kind::Gear(row) => Err(Failure::input(format!(
                "{}: what {} ran on; `lunoid check` reads it, docs/blocks/{}.md describes it",
                path.display(),
                row.name,
                row.name
            ))),
            Kind::Cartridge => Err(Failure::input(format!(
                "{}: a cartridge; `lunoid cartridge run --folder` runs it with those beside its folder",
                path.display()
            ))),
            Kind::Unknown => {
                Err(Failure::input(format!("{}: a file of no known kind; expected {KNOWN}", path.display())))
            }
            Kind::Model => {
                let loaded = HardwareModel::read(path, &[], &[])?;
                Ok((model::document(&loaded), loaded.effective()))
            }
        },
        _ => elevation(path),
    }
}

fn first_bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    let mut start = Vec::new();
    match File::open(path).and_then(|file| file.take(8).read_to_end(&mut start)) {
        Ok(_) => Ok(start),
        // The reader of whole files has the words for what can go wrong.
        Err(_) => Ok(files::read_all(path, 8)?),
    }
}

fn run(folder: &Path) -> Result<(Value, String), Failure> {
    let run = HeldRun::read(folder)?;
    let document = json!(*run);
    let word = |pointer: &str| match document.pointer(pointer) {
        Some(Value::String(text)) => text.clone(),
        Some(other) => other.to_string(),
        None => "unknown".into(),
    };
    let text = format!(
        "{}: frames {} of \"{}\" by {} ({}), {} sweeps of {} samples, {} x {} pixels of {} bits\n  \
         {} {} (commit {}), fingerprint {}\n",
        folder.display(),
        word("/range").trim_matches(['[', ']']).replace(',', ".."),
        word("/scenario/title"),
        word("/generator"),
        word("/model/name"),
        word("/settings/raster/sweeps"),
        word("/settings/raster/samples_per_sweep"),
        word("/view/columns"),
        word("/view/lines"),
        word("/pictures/depth"),
        word("/program/name"),
        word("/program/version"),
        word("/program/commit"),
        &run.fingerprint,
    );
    Ok((document, text))
}

fn picture(path: &Path) -> Result<(Value, String), Failure> {
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
    Ok((
        document,
        format!("{}: {columns} x {lines} pixels of {bits} bits{colour}, pixel hash {hash}\n", path.display()),
    ))
}

fn scenario(path: &Path) -> Result<(Value, String), Failure> {
    let scenario = read_scenario(path)?;
    let ground = match &scenario.ground {
        Ground::Bank(bank) => format!("bank {}", bank.display()),
        Ground::Generated(relief) => format!("generated from seed {}", relief.seed),
    };
    let length = match scenario.length {
        Length::Frames(frames) => format!("{frames} frames"),
        Length::Seconds(seconds) => format!("{seconds} s"),
    };
    let (azimuth, elevation) = (degrees(scenario.sun.azimuth), degrees(scenario.sun.elevation));
    let waypoints = scenario.path.waypoints().len();
    let document = json!({
        "schema": "lunoid.info.scenario/1",
        "file": path.display().to_string(),
        "title": scenario.title,
        "shows": scenario.shows,
        "machine": scenario.machine,
        "length": length,
        "ground": ground,
        "sun_deg": [azimuth, elevation],
        "waypoints": waypoints,
        "contents": contents(&scenario),
        "files": scenario.files().iter().map(|file| file.display().to_string()).collect::<Vec<_>>(),
    });
    let text = format!(
        "{}: {}\n  {}\n  {length} by machine {}; ground {ground}; sun at azimuth {azimuth:.1}, elevation \
         {elevation:.1} deg; {waypoints} waypoints\n{}",
        path.display(),
        scenario.title,
        scenario.shows,
        scenario.machine,
        contained(&contents(&scenario)),
    );
    Ok((document, text))
}

/// What a scenario has beside terrain, one sun and a path.
fn contents(scenario: &Scenario) -> Value {
    json!({
        "listed_craters": scenario.features.list.as_ref().map_or(0, |list| list.craters.len()),
        "crater_populations": scenario.features.populations.len(),
        "rocks": scenario.rocks.is_some(),
        "objects": scenario.objects.len(),
        "events": scenario.events.len(),
        "tracks": scenario.tracks.is_some(),
        "remote_shadow": scenario.shadows.is_some(),
        "moving_sun": scenario.drift.is_some(),
        "texture": scenario.texture.is_some(),
        "silhouettes": scenario.silhouettes.len(),
        "coarse_ground": scenario.coarse.is_some(),
    })
}

/// The same in a line, if there is anything.
fn contained(contents: &Value) -> String {
    let word = |(key, value): (&String, &Value)| match value {
        Value::Bool(true) => Some(key.replace('_', " ")),
        Value::Number(number) if number.as_u64() != Some(0) => {
            Some(format!("{number} {}", key.replace('_', " ")))
        }
        _ => None,
    };
    let words: Vec<String> = contents.as_object().into_iter().flatten().filter_map(word).collect();
    if words.is_empty() { String::new() } else { format!("  with {}\n", words.join(", ")) }
}

fn elevation(path: &Path) -> Result<(Value, String), Failure> {
    let (elevation, is_placed) = read_elevation(path)?;
    let Elevation { lines, columns, affine, frame, title, notes, .. } = &elevation;
    let (unit, scale, places): (&str, f64, usize) = match frame {
        Frame::Plane(_) => ("m", 1.0, 3),
        Frame::Geographic { .. } => ("deg", degrees(1.0), 6),
    };
    let extent = elevation.extent().map(|edge| edge * scale);
    let spacing = affine.step.map(|step| step.abs() * scale);
    let (range, voids, projection) = (elevation.range(), elevation.voids(), projection(*frame));
    let document = json!({
        "schema": "lunoid.info.elevation/1",
        "file": path.display().to_string(),
        "title": title,
        "lines": lines,
        "columns": columns,
        "unit": unit,
        "extent": is_placed.then_some(extent),
        "spacing": is_placed.then_some(spacing),
        "projection": projection,
        "heights_m": range,
        "voids": voids,
        "notes": notes,
    });
    let heights = range.map_or("no heights".into(), |[low, high]| format!("{low:.2} to {high:.2} m"));
    let place = if is_placed {
        let [south, west, north, east] = extent.map(|edge| shortened(edge, places));
        let [along, across] = spacing.map(|step| shortened(step, places));
        format!(
            "south {south}, west {west}, north {north}, east {east} {unit}\n  spacing {along} {unit} to the north, \
             {across} {unit} to the east; {projection}"
        )
    } else {
        "does not say where it lies or how far its samples are apart".into()
    };
    let mut text = format!(
        "{}: {title}\n  {lines} lines of {columns} samples, {heights}, {voids} void\n  {place}\n",
        path.display(),
    );
    text.extend(notes.iter().map(|note| format!("  note: {note}\n")));
    Ok((document, text))
}

/// An elevation file, and whether it says where it lies: that does not matter to someone who only looks.
fn read_elevation(path: &Path) -> Result<(Elevation, bool), Failure> {
    let anywhere = ReadOptions { spacing: Some([1.0; 2]), ..ReadOptions::default() };
    match survey::read(path, &ReadOptions::default()) {
        Ok(placed) => Ok((placed, true)),
        Err(SurveyError::UnknownFormat { found, .. }) => Err(Failure::input(format!(
            "{}: starts with {found}; expected a bank, an elevation file (GeoTIFF, PDS3, .npy), a scenario or a \
             hardware model (.toml), a grey PNG, or the folder of a run",
            path.display()
        ))),
        Err(refused) => match survey::read(path, &anywhere) {
            // It says where it lies; something else is wrong.
            Err(SurveyError::Option { .. }) => Err(refused.into()),
            read => Ok((read?, false)),
        },
    }
}

fn projection(frame: Frame) -> String {
    let (method, radius) = match frame {
        Frame::Plane(None) => return "projection unknown".into(),
        Frame::Geographic { radius } => ("latitude and longitude".to_owned(), radius),
        Frame::Plane(Some(projection)) => {
            let [latitude, longitude] =
                [projection.latitude, projection.longitude].map(|angle| shortened(degrees(angle), 6));
            let method = match projection.method {
                Method::Equirectangular { parallel } => {
                    format!("equirectangular, true along {} N", shortened(degrees(parallel), 6))
                }
                Method::PolarStereographic { .. } => "polar stereographic".into(),
                Method::Orthographic => "orthographic".into(),
            };
            (format!("{method}, centre {latitude} N, {longitude} E"), projection.radius)
        }
    };
    format!("{method}, on a sphere of {} m", shortened(radius, 3))
}
