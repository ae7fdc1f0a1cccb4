//! A viewshed by xarray-spatial, which follows GRASS.

use std::env;
use std::fs;
use std::path::Path;
use std::process::Command;

use serde::Deserialize;

/// The program that calls it.
const SOURCE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/peers/viewshed.py");
/// Names the Python that has it.
const PYTHON: &str = "LUNOID_XRSPATIAL_PYTHON";

/// Where an observer stands, and how often it looks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lookout {
    /// Row and column of the observer's post.
    pub post: [usize; 2],
    /// Height of the observer over it (m).
    pub height: f64,
    /// Distance between posts (m).
    pub spacing: f64,
    /// Calls that are timed, after one that compiles.
    pub turns: usize,
}

/// What it found of the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Seen {
    /// Version of xarray-spatial that answered.
    pub version: String,
    /// Time of each call (s).
    pub seconds: Vec<f64>,
    /// Whether each post is seen, row by row.
    pub visible: Vec<bool>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Said {
    version: String,
    seconds: Vec<f64>,
}

/// Its viewshed over square ground of `heights` (m), row by row. The inner error is a line that names what is missing here.
///
/// # Errors
/// If it does not answer as it should.
pub fn viewshed(heights: &[f64], lookout: &Lookout) -> Result<Result<Seen, String>, String> {
    let Some(python) = env::var_os(PYTHON).filter(|python| !python.is_empty()) else {
        let line = format!(
            "skipped: no Python with xarray-spatial is named by {PYTHON}; install xarray-spatial and name it"
        );
        return Ok(Err(line));
    };
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let side = heights.len().isqrt();
    fs::write(folder.path().join("heights.npy"), npy(heights, side)).map_err(|error| error.to_string())?;
    let Lookout { post: [row, column], height, spacing, turns } = lookout;
    let numbers =
        [row.to_string(), column.to_string(), height.to_string(), spacing.to_string(), turns.to_string()];
    let arguments =
        [SOURCE, "heights.npy"].into_iter().chain(numbers.iter().map(String::as_str)).chain(["seen.npy"]);
    let ended = Command::new(&python).args(arguments).current_dir(folder.path()).output();
    let ended = ended.map_err(|error| format!("{PYTHON}: {}: {error}", python.to_string_lossy()))?;
    if !ended.status.success() {
        return Err(format!("{SOURCE}: {}", String::from_utf8_lossy(&ended.stderr)));
    }
    let Said { version, seconds } =
        serde_json::from_slice(&ended.stdout).map_err(|error| format!("{SOURCE}: {error}"))?;
    let visible = read_bytes(&folder.path().join("seen.npy"), heights.len())?;
    Ok(Ok(Seen { version, seconds, visible }))
}

/// Square heights as a file of NumPy.
fn npy(heights: &[f64], side: usize) -> Vec<u8> {
    let head = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({side}, {side}), }}");
    // Ten bytes stand before the head, and all of it is a multiple of 64 bytes long.
    let length = (10 + head.len() + 1).next_multiple_of(64) - 10;
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((length as u16).to_le_bytes());
    bytes.extend(format!("{head:<width$}\n", width = length - 1).into_bytes());
    bytes.extend(heights.iter().flat_map(|height| height.to_le_bytes()));
    bytes
}

/// The last `count` bytes of a file of NumPy.
fn read_bytes(path: &Path, count: usize) -> Result<Vec<bool>, String> {
    let bytes = fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let first = bytes.len().checked_sub(count).ok_or_else(|| format!("{}: too short", path.display()))?;
    Ok(bytes[first..].iter().map(|byte| *byte != 0).collect())
}

#[cfg(test)]
mod tests {
    use super::npy;

    #[test]
    fn heights_stand_behind_a_head_of_whole_lines() {
        let bytes = npy(&[1.0, 2.0, 3.0, 4.0], 2);
        let length = usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
        assert_eq!((10 + length) % 64, 0);
        assert_eq!((bytes[9 + length], bytes.len()), (b'\n', 10 + length + 32));
        let head = String::from_utf8_lossy(&bytes[10..10 + length]);
        assert!(head.contains("'shape': (2, 2)"), "{head}");
        assert_eq!(bytes[10 + length..][..8], 1f64.to_le_bytes());
    }
}
