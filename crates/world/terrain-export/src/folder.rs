//! The folder of an export: the old one or the new one, whole.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use files::{Npy, NpyData, folder_of, make_folder, rename, write_atomic, write_npy};
use landscape::bank_file;

use crate::error::ExportError;
use crate::exported::Exported;

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
    expect_ours(out)?;
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

fn expect_ours(out: &Path) -> Result<(), ExportError> {
    if !out.exists() {
        return Ok(());
    }
    let system = |source| ExportError::System { path: out.into(), doing: "list this folder", source };
    let mut names = Vec::new();
    for entry in fs::read_dir(out).map_err(system)? {
        names.push(entry.map_err(system)?.file_name().to_string_lossy().into_owned());
    }
    names.sort();
    match names.into_iter().find(|name| !FILES.contains(&name.as_str())) {
        Some(found) => Err(ExportError::Strange { path: out.into(), found }),
        None => Ok(()),
    }
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
