//! Tables of poses, a row for each frame.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use replay::{CAMERA, POSES, ReplayError, TRUTH, read_listed};
use run_record::FileRecord;
use serde_json::Value;

use crate::MergeError;
use crate::source::Source;

/// A table of poses that grows by those of other folders.
#[derive(Default)]
pub(crate) struct Rows {
    heading: String,
    lines: BTreeMap<u64, String>,
}

impl Rows {
    /// Takes over the rows of the table at `path`, whose bytes are `table`. A row that is there must be the same.
    pub fn add(&mut self, table: &[u8], path: &Path) -> Result<(), MergeError> {
        let refused = |reason: &str| MergeError::Table { path: path.to_owned(), reason: reason.into() };
        let text = str::from_utf8(table).map_err(|_| refused("its bytes are no text"))?;
        let mut lines = text.lines();
        let heading = lines.next().unwrap_or_default();
        if self.heading.is_empty() {
            self.heading = heading.to_owned();
        } else if self.heading != heading {
            return Err(refused("its columns are not those of the other folders"));
        }
        for line in lines {
            let number = line.split(',').next().and_then(|number| number.parse().ok());
            let number = number.ok_or_else(|| refused("a row begins with no frame"))?;
            let held = self.lines.entry(number).or_insert_with(|| line.to_owned());
            if held != line {
                return Err(refused(&format!("its row of frame {number} is not that of the other folders")));
            }
        }
        Ok(())
    }

    /// The table of all rows, ascending.
    pub fn table(&self) -> Vec<u8> {
        let lines = self.lines.values().map(|line| format!("{line}\n"));
        format!("{}\n{}", self.heading, lines.collect::<String>()).into_bytes()
    }

    /// Numbers of the frames, ascending.
    pub fn frames(&self) -> impl Iterator<Item = u64> {
        self.lines.keys().copied()
    }
}

/// The table of poses and the camera of all runs.
pub(crate) fn poses_and_camera(sources: &[Source]) -> Result<(Rows, Vec<u8>), MergeError> {
    let (mut rows, mut camera) = (Rows::default(), Vec::new());
    for source in sources {
        rows.add(&output(&source.folder, &source.run.outputs, POSES)?, &source.folder.join(POSES))?;
        let own = output(&source.folder, &source.run.outputs, CAMERA)?;
        if camera.is_empty() {
            camera = own;
        } else if camera != own {
            let [first, second] = [&sources[0], source].map(|source| source.folder.join(CAMERA));
            return Err(MergeError::OtherRun { first, second, differences: "their bytes".into() });
        }
    }
    Ok((rows, camera))
}

/// The tables of poses of all truths, where poses are part of the truth.
pub(crate) fn poses_of_truth(sources: &[Source]) -> Result<Option<(Rows, Value)>, MergeError> {
    let (mut rows, mut document, mut frames) = (Rows::default(), None, BTreeMap::new());
    for source in sources {
        let Some(truth) = source.truth.as_ref().filter(|truth| !truth.outputs.is_empty()) else { continue };
        let folder = source.folder.join(TRUTH);
        rows.add(&output(&folder, &truth.outputs, POSES)?, &folder.join(POSES))?;
        let path = folder.join(POSES_JSON);
        let refused = |reason: String| MergeError::Table { path: path.clone(), reason };
        let bytes = output(&folder, &truth.outputs, POSES_JSON)?;
        let mut own: Value = serde_json::from_slice(&bytes).map_err(|error| refused(error.to_string()))?;
        for frame in own["frames"].as_array_mut().map(std::mem::take).unwrap_or_default() {
            let number = frame["frame"].as_u64().ok_or_else(|| refused("an entry has no frame".into()))?;
            frames.insert(number, frame);
        }
        let document = document.get_or_insert_with(|| own.clone());
        if *document != own {
            return Err(refused("its camera or its words are not those of the other folders".into()));
        }
    }
    Ok(document.map(|mut document: Value| {
        document["frames"] = frames.into_values().collect();
        (rows, document)
    }))
}

/// The poses of the truth with the camera.
const POSES_JSON: &str = "poses.json";

/// The bytes of the output `name` of a folder.
fn output(folder: &Path, outputs: &[FileRecord], name: &str) -> Result<Vec<u8>, MergeError> {
    let refused = || MergeError::Table {
        path: PathBuf::from(folder).join(name),
        reason: "the record of its run does not list it".into(),
    };
    let listed = outputs.iter().find(|output| output.file == name).ok_or_else(refused)?;
    read_listed(folder, listed).map_err(|error: ReplayError| error.into())
}
