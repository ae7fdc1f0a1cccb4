//! The note of a shard that was set aside.

use std::fs;
use std::path::{Path, PathBuf};

use limits::Limit;
use serde::{Deserialize, Serialize};

/// Schema of the note.
pub const FAILED_SCHEMA: &str = "lunoid.farm.failed/1";

/// Why a shard was set aside, as whoever started it wrote down.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Failure {
    /// Name of the schema: [`FAILED_SCHEMA`].
    pub schema: String,
    /// How often the shard was tried.
    pub tries: u32,
    /// Message of the last try.
    pub why: String,
    /// Command that draws the shard.
    pub command: String,
}

/// Path of the note that lies beside the folder of a shard.
pub fn note_of(folder: &Path) -> PathBuf {
    let mut name = folder.as_os_str().to_owned();
    name.push(".failed.json");
    name.into()
}

/// The note beside `folder`, if there is one; why it cannot be read, in words.
pub(crate) fn read(folder: &Path) -> Result<Option<Failure>, String> {
    let path = note_of(folder);
    if fs::symlink_metadata(&path).is_err() {
        return Ok(None);
    }
    let bytes = files::read_all(&path, Limit::RecordBytes).map_err(|error| error.to_string())?;
    let refused = |reason: String| format!("{}: {reason}; remove the file", path.display());
    let failure: Failure = serde_json::from_slice(&bytes).map_err(|error| refused(error.to_string()))?;
    match failure.schema == FAILED_SCHEMA {
        true => Ok(Some(failure)),
        false => Err(refused(format!("schema {:?}, expected {FAILED_SCHEMA:?}", failure.schema))),
    }
}
