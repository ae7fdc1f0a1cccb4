//! The folder of an export: the old one or the new one, whole.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use files::{Npy, NpyData, folder_of, make_folder, read_all, rename, write_atomic, write_npy};
use landscape::bank_file;
use limits::Limit;
use serde_json::Value;

use crate::error::ExportError;
use crate::exported::Exported;
use crate::told::SCHEMA;

/// Names of all files and folders of an export, in alphabetical order.
pub const FILES: [&str; 10] = [
    "albedo.png",
    "boulders",
    "craters.csv",
    "export.json",
    "ground.bank",
    "ground.bank.toml",
    "light.npy",
    "residuals.npy",
    "scenario.toml",
    "terrain.lod",
];

/// Writes an export into a folder. Its files are written under another name, and the folder then takes the place of an earlier export.
///
/// # Errors
/// If the folder holds anything but an earlier export, or the system refuses; the old folder then stays.
pub fn write_folder(exported: &Exported, out: &Path) -> Result<(), ExportError> {
    let (new, old) = (hidden(out, "new"), hidden(out, "old"));
    restore(out, &old)?;
    expect_folder(out)?;
    make_folder(folder_of(out))?;
    remove(&new)?;
    make_folder(&new)?;
    let written = write_files(exported, &new).and_then(|()| replace(out, &new, &old));
    if written.is_err() {
        // The failure is told; what is left of the new folder helps nobody.
        let _ = remove(&new);
    }
    written
}

/// Name beside the folder that nobody else uses.
fn hidden(out: &Path, word: &str) -> PathBuf {
    let mut name = OsString::from(".");
    name.push(out.file_name().unwrap_or_default());
    name.push(format!(".{word}"));
    folder_of(out).join(name)
}

/// Puts the old folder back that an export moved aside before it was killed.
fn restore(out: &Path, old: &Path) -> Result<(), ExportError> {
    if old.is_dir() && !out.exists() { Ok(rename(old, out)?) } else { remove(old) }
}

/// Sees that an export may take the place of what is there: nothing, an empty folder, or an earlier export and nothing else.
///
/// # Errors
/// If there is something else.
pub fn expect_folder(out: &Path) -> Result<(), ExportError> {
    if out.is_symlink() || out.is_file() {
        return Err(ExportError::NoFolder { path: out.into() });
    }
    if !out.exists() {
        return Ok(());
    }
    let names = listed(out)?;
    let strange = match names.iter().find(|name| !FILES.contains(&name.as_str())) {
        Some(name) => Some(name.clone()),
        None if !names.is_empty() && !is_export(out) => names.first().cloned(),
        None => strange_boulder(out)?,
    };
    strange.map_or(Ok(()), |found| Err(ExportError::Strange { path: out.into(), found }))
}

/// Names in a folder, sorted.
fn listed(folder: &Path) -> Result<Vec<String>, ExportError> {
    let system = |source| ExportError::System { path: folder.into(), doing: "list this folder", source };
    let mut names = Vec::new();
    for entry in fs::read_dir(folder).map_err(system)? {
        names.push(entry.map_err(system)?.file_name().to_string_lossy().into_owned());
    }
    names.sort();
    Ok(names)
}

/// Whether a folder says of itself that an export wrote it.
fn is_export(folder: &Path) -> bool {
    let text = read_all(folder.join("export.json"), Limit::BankBytes);
    let told: Option<Value> = text.ok().and_then(|text| serde_json::from_slice(&text).ok());
    told.is_some_and(|told| told["schema"] == SCHEMA)
}

/// The first name in the folder of the boulders that no export gives.
fn strange_boulder(out: &Path) -> Result<Option<String>, ExportError> {
    let folder = out.join("boulders");
    if !folder.exists() {
        return Ok(None);
    }
    let is_ours =
        |name: &String| name.strip_suffix(".obj").is_some_and(|number| number.parse::<u64>().is_ok());
    let names = if folder.is_symlink() { vec![String::new()] } else { listed(&folder)? };
    Ok(names.into_iter().find(|name| !is_ours(name)).map(|name| format!("boulders/{name}")))
}

fn write_files(exported: &Exported, folder: &Path) -> Result<(), ExportError> {
    exported.database.write(folder.join("terrain.lod"))?;
    bank_file::write(folder.join("ground.bank"), &exported.survey.bank)?;
    let residuals = &exported.survey.residuals;
    array(&folder.join("residuals.npy"), [residuals.lines, residuals.columns], &residuals.values)?;
    text(&folder.join("craters.csv"), &exported.craters.crater_list())?;
    if let Some(light) = &exported.light {
        let [columns, rows] = exported.database.contents().places.each_ref().map(Vec::len);
        array(&folder.join("light.npy"), [rows, columns], light.shares())?;
    }
    if let Some(albedo) = &exported.albedo {
        let bytes = albedo.encode_png(&[])?;
        write_atomic(folder.join("albedo.png"), |file| file.write_all(&bytes))?;
    }
    make_folder(&folder.join("boulders"))?;
    for object in &exported.objects {
        text(&folder.join(&object.file), &object.shape)?;
    }
    text(&folder.join("scenario.toml"), &exported.scenario)?;
    text(&folder.join("export.json"), &format!("{:#}\n", exported.told))
}

fn text(path: &Path, text: &str) -> Result<(), ExportError> {
    Ok(write_atomic(path, |file| file.write_all(text.as_bytes()))?)
}

fn array(path: &Path, shape: [usize; 2], values: &[f64]) -> Result<(), ExportError> {
    let array = Npy::new(shape.to_vec(), NpyData::F64(values.to_vec()))
        .map_err(|source| files::NpyFileError::Format { path: path.into(), source })?;
    Ok(write_npy(path, &array)?)
}

/// Puts the new folder in the place of the old one, which stands aside in between.
fn replace(out: &Path, new: &Path, old: &Path) -> Result<(), ExportError> {
    let has_old = out.exists();
    if has_old {
        rename(out, old)?;
    }
    if let Err(error) = rename(new, out) {
        if has_old {
            rename(old, out)?;
        }
        return Err(error.into());
    }
    remove(old)
}

fn remove(folder: &Path) -> Result<(), ExportError> {
    if !folder.is_dir() {
        return Ok(());
    }
    let system = |source| ExportError::System { path: folder.into(), doing: "remove this folder", source };
    fs::remove_dir_all(folder).map_err(system)
}
