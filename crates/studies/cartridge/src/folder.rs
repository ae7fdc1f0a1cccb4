//! Where cartridges are: in the program, or in a folder of one's own.

use std::fs;
use std::path::Path;

use files::FileError;

use crate::file::{Cartridge, CartridgeError};

/// Name of the file in each folder.
const FILE: &str = "cartridge.toml";

/// Larger than any cartridge that a person writes.
const MAX_BYTES: u64 = 1 << 20;

macro_rules! carried {
    ($($name:literal)*) => {
        /// Cartridges that the program carries, by name, with their text.
        pub const CARRIED: &[(&str, &str)] =
            &[$(($name, include_str!(concat!("../../../../tests/cartridges/", $name, "/cartridge.toml")))),*];
    };
}

carried! {
    "axis-parallel"
    "beam-budget"
    "calm-sea"
    "coefficient-steps"
    "comparator-delay"
    "comparator-delay-small"
    "comparator-ramp"
    "converter-bits"
    "converter-on-plane"
    "crater-crossed"
    "crater-hidden"
    "crater-shadow"
    "degree-five"
    "display-line"
    "drum-wait"
    "dust-by-path"
    "flat-plane"
    "fold-table"
    "folds-of-every-machine"
    "folds-on-the-ramp"
    "gain-error"
    "ground-distance"
    "lag-fold"
    "lag-step"
    "lamp-by-distance"
    "lamp-through-sheets"
    "late-word"
    "late-word-tick"
    "light-of-level-ground"
    "lod-fine-side"
    "lod-morphing"
    "lod-neighbours"
    "lod-one-level"
    "lod-per-tile"
    "lod-real-time"
    "lod-shared-slots"
    "lod-two-levels"
    "lunoid-horizon"
    "lunoid-horizon-eye"
    "near-axis"
    "near-boundary"
    "near-corner"
    "no-transfer"
    "noise-of-height"
    "noise-source"
    "on-a-boundary"
    "one-coefficient-even-even"
    "one-coefficient-even-odd"
    "one-coefficient-odd-even"
    "one-coefficient-odd-odd"
    "one-slot-a-line"
    "one-square"
    "panel-depth"
    "panel-mean"
    "panel-void-mean"
    "photo-checker"
    "photo-inferred"
    "photo-ramp"
    "photo-relit"
    "pixel-ray-pixel"
    "quadratic"
    "ridge-hides-valley"
    "saturation"
    "sea-channels"
    "sea-late"
    "sea-one-normal"
    "sea-words"
    "set-up-just-fits"
    "set-up-overload"
    "settling-amplifier"
    "slewing-amplifier"
    "smoothed-fold"
    "stack-of-sheets"
    "stale-word"
    "star-by-magnitude"
    "task-set"
    "through-a-corner"
    "tilted-plane"
    "triangle-on-the-glass"
    "turning-four-kinds"
    "turning-in-blocks"
    "turning-one-kind"
    "two-lamps-in-line"
    "two-pole-fold"
    "two-pole-step"
    "wake-clamped"
    "wire-slews-into-shadow"
    "wires-at-a-rim"
}

/// JSON schema of `cartridge.toml`, as the structs of this crate read it.
pub const SCHEMA: &str = include_str!("../../../../tests/cartridges/cartridge.schema.json");

/// The cartridges that the program carries, in alphabetical order.
///
/// # Errors
/// None: a test reads them all.
pub fn carried() -> Result<Vec<Cartridge>, CartridgeError> {
    let one = |(name, text): &(&str, &str)| Cartridge::parse(name, &format!("built-in {name}/{FILE}"), text);
    CARRIED.iter().map(one).collect()
}

/// The cartridges of a folder, one in each folder in it, in alphabetical order.
///
/// # Errors
/// A folder that cannot be read or holds none, and every fault of a file.
pub fn of_folder(folder: &Path) -> Result<Vec<Cartridge>, CartridgeError> {
    let refuse = |message: String| CartridgeError { place: folder.display().to_string(), message };
    let entries =
        fs::read_dir(folder).map_err(|error| refuse(format!("cannot read this folder: {error}")))?;
    let mut files = Vec::new();
    for entry in entries {
        let path = entry.map_err(|error| refuse(format!("cannot read this folder: {error}")))?.path();
        if path.is_dir() && path.join(FILE).is_file() {
            files.push(path);
        }
    }
    if files.is_empty() {
        return Err(refuse(format!("no cartridge: expected folders with a {FILE} in each")));
    }
    files.sort();
    files.iter().map(|path| of_file(&path.join(FILE))).collect()
}

/// The cartridge of a file, called as the folder that it is in.
///
/// # Errors
/// A file that cannot be read, and every fault of it.
pub fn of_file(path: &Path) -> Result<Cartridge, CartridgeError> {
    let place = path.display().to_string();
    let refuse = |message: String| CartridgeError { place: place.clone(), message };
    let folder = path.parent().unwrap_or(Path::new(""));
    let bytes = files::read_all(path, MAX_BYTES).map_err(|error: FileError| CartridgeError {
        place: folder.display().to_string(),
        message: error.to_string(),
    })?;
    let text = String::from_utf8(bytes).map_err(|_| refuse("not in UTF-8: expected text".into()))?;
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    Cartridge::parse(&name, &place, &text)
}
