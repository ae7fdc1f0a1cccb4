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

/// A file of a saved loop.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SavedFile {
    /// Path inside the folder, with `/`.
    pub name: String,
    /// All bytes of the file.
    pub bytes: Vec<u8>,
}

/// The scenario of `opened` that follows `told`, one pose a frame at `update` frames a second; and these poses.
pub(crate) fn own(opened: &Opened, update: Rate, told: &[EyePose]) -> Result<[SavedFile; 2], DriveError> {
    let file = |name: &str, text: String| SavedFile { name: name.into(), bytes: text.into_bytes() };
    Ok([file(SCENARIO, scenario(opened, told.len())?), file(DRIVEN, rows(update, told))])
}

/// `own` files behind those that the scenario of `opened` names.
pub(crate) fn files(opened: &Opened, own: &[SavedFile]) -> Result<Vec<SavedFile>, DriveError> {
    let named = named(opened).map(|(name, path)| read(&name, path));
    named.chain(own.iter().cloned().map(Ok)).collect()
}

/// Writes `own` files, `more` and those that the scenario of `opened` names into `folder`, which is made.
pub(crate) fn save(
    opened: &Opened,
    own: &[SavedFile],
    more: &[SavedFile],
    folder: &Path,
) -> Result<(), DriveError> {
    if folder.exists() {
        let problem = Problem::of_file(folder.display().to_string(), "the folder is there already");
        return Err(problem.expected("a folder that is not there").help("name another, or remove it").into());
    }
    let half = half_written(folder);
    let written = write(opened, &half, own.iter().chain(more));
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

/// Files of the scenario inside its folder: name and path.
fn named(opened: &Opened) -> impl Iterator<Item = (String, &Path)> {
    let from = opened.folder();
    let inside = move |path: &'_ Path| {
        let parts = path.strip_prefix(from).ok()?.iter().map(|part| part.to_string_lossy());
        Some(parts.collect::<Vec<_>>().join("/"))
    };
    opened.scenario.files().into_iter().filter_map(move |path| Some((inside(path)?, path)))
}

fn read(name: &str, path: &Path) -> Result<SavedFile, DriveError> {
    let bytes = read_all(path, Limit::BankBytes).map_err(|error| failed(path, &error))?;
    Ok(SavedFile { name: name.into(), bytes })
}

/// The files of the scenario beside it, one in memory at a time, then `others`.
fn write<'a>(
    opened: &Opened,
    half: &Path,
    others: impl Iterator<Item = &'a SavedFile>,
) -> Result<(), DriveError> {
    make_folder(half).map_err(|error| failed(half, &error))?;
    named(opened).try_for_each(|(name, path)| put(half, &read(&name, path)?))?;
    others.into_iter().try_for_each(|file| put(half, file))
}

fn put(folder: &Path, SavedFile { name, bytes }: &SavedFile) -> Result<(), DriveError> {
    let to = folder.join(name);
    make_folder(to.parent().unwrap_or(folder)).map_err(|error| failed(&to, &error))?;
    write_atomic(&to, |out| out.write_all(bytes)).map_err(|error| failed(&to, &error))
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
