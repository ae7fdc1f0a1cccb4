//! What a loop has driven, as a scenario and a path.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use diagnostics::Problem;
use files::{make_folder, read_all, rename, write_atomic};
use front_door::Opened;
use limits::Limit;
use quantities::Rate;
use toml::{Table, Value};

use crate::{DriveError, EyePose};

/// Name of the scenario's file in the folder.
const SCENARIO: &str = "scenario.toml";

/// Name of the file with one pose a frame.
const DRIVEN: &str = "driven.csv";

/// Writes `told`, one pose a frame at `update` frames a second, and the scenario of `opened` that follows them.
pub(crate) fn save(opened: &Opened, update: Rate, told: &[EyePose], folder: &Path) -> Result<(), DriveError> {
    if folder.exists() {
        let problem = Problem::of_file(folder.display().to_string(), "the folder is there already");
        return Err(problem.expected("a folder that is not there").help("name another, or remove it").into());
    }
    let scenario = scenario(opened, told.len())?;
    let half = half_written(folder);
    let written = write(opened, &half, [(SCENARIO, scenario), (DRIVEN, rows(update, told))]);
    let written = written.and_then(|()| rename(&half, folder).map_err(|error| failed(folder, &error)));
    if written.is_err() && half.exists() {
        fs::remove_dir_all(&half).map_err(|error| failed(&half, &error))?;
    }
    written
}

fn half_written(folder: &Path) -> PathBuf {
    let mut name = folder.file_name().unwrap_or_default().to_owned();
    name.push(".half");
    folder.with_file_name(name)
}

fn failed(path: &Path, error: &impl std::fmt::Display) -> DriveError {
    DriveError::of(&path.display().to_string(), error)
}

/// The files of the scenario beside it, then its own.
fn write(opened: &Opened, half: &Path, own: [(&str, String); 2]) -> Result<(), DriveError> {
    make_folder(half).map_err(|error| failed(half, &error))?;
    let from = opened.folder();
    for file in opened.scenario.files() {
        let Ok(name) = file.strip_prefix(from) else { continue };
        let to = half.join(name);
        make_folder(to.parent().unwrap_or(half)).map_err(|error| failed(&to, &error))?;
        let bytes = read_all(file, Limit::BankBytes).map_err(|error| failed(file, &error))?;
        write_atomic(&to, |out| out.write_all(&bytes)).map_err(|error| failed(&to, &error))?;
    }
    for (name, text) in own {
        let path = half.join(name);
        write_atomic(&path, |out| out.write_all(text.as_bytes())).map_err(|error| failed(&path, &error))?;
    }
    Ok(())
}

/// The text of the scenario with its length and its `path.driven`.
fn scenario(opened: &Opened, frames: usize) -> Result<String, DriveError> {
    let path = opened.path();
    let text = read_all(path, Limit::TextBytes).map_err(|error| failed(path, &error))?;
    let table = String::from_utf8_lossy(&text).parse::<Table>();
    let mut table = table.map_err(|error| failed(path, &error))?;
    table.remove("duration_s");
    table.insert("frames".into(), Value::Integer(frames as i64));
    if let Some(Value::Table(path)) = table.get_mut("path") {
        path.insert("driven".into(), Value::String(DRIVEN.into()));
    }
    Ok(table.to_string())
}

/// One row a frame, and the last pose once more: a curve has its waypoints to the bit but for the last one.
fn rows(update: Rate, told: &[EyePose]) -> String {
    let mut text = String::from("t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg\n");
    for (frame, pose) in told.iter().chain(told.last()).enumerate() {
        let EyePose { eye_m: [x, y, z], heading_deg, pitch_deg, roll_deg, .. } = pose;
        let time = frame as f64 / update.hertz();
        let written = writeln!(text, "{time},{x},{y},{z},{heading_deg},{pitch_deg},{roll_deg}");
        written.expect("a String takes everything");
    }
    text
}
