//! The folder of a data set: its names, and whose files are in it.

use std::path::{Path, PathBuf};

use files::Folder;

use crate::{DatasetError, Split};

/// Name of the record.
pub const RECORD: &str = "dataset.json";
/// Name of the manifest: one line a sample.
pub const MANIFEST: &str = "manifest.jsonl";
/// Name of the data card.
pub const CARD: &str = "README.md";
/// Name of the licence.
pub const LICENCE: &str = "LICENSE.txt";
/// Name of the plan's copy.
pub const PLAN: &str = "plan.toml";
/// Name of the contact sheet.
pub const SHEET: &str = "contact-sheet.png";
/// Name of the journal of samples that are there while the data set is not whole.
pub const JOURNAL: &str = "samples.journal";
/// Programs that read the data set, by name.
pub const LOADERS: [(&str, &str); 2] = [
    ("load_numpy.py", include_str!("../../../../docs/clients/load_numpy.py")),
    ("load_torch.py", include_str!("../../../../docs/clients/load_torch.py")),
];

/// Folders of the samples.
const BELOW: [&str; 3] = ["train", "validation", "test"];
/// Files beside the samples.
const OWN: [&str; 7] = [RECORD, MANIFEST, CARD, LICENCE, PLAN, SHEET, JOURNAL];

/// Path of a sample's file from the folder on.
pub fn sample_name(split: Split, sample: u64) -> String {
    format!("{}/sample-{sample:06}.npz", split.name())
}

fn is_own(name: &str) -> bool {
    let is_sample = |name: &str| {
        let number = name.strip_prefix("sample-").and_then(|rest| rest.strip_suffix(".npz"));
        number.is_some_and(|number| number.len() >= 6 && number.bytes().all(|byte| byte.is_ascii_digit()))
    };
    match name.split_once('/') {
        Some((below, name)) => BELOW.contains(&below) && is_sample(name),
        None => OWN.contains(&name) || LOADERS.iter().any(|(loader, _)| *loader == name),
    }
}

/// A file that lies in the folder, or in one of the folders of the samples.
fn first_file(folder: &Folder) -> Result<Option<String>, DatasetError> {
    for name in folder.names("")? {
        if !BELOW.contains(&name.as_str()) {
            return Ok(Some(name));
        }
        if let Some(below) = folder.names(&name)?.first() {
            return Ok(Some(format!("{name}/{below}")));
        }
    }
    Ok(None)
}

/// A folder that this process, and no other, writes a data set into.
#[derive(Debug)]
pub struct DataFolder(Folder);

impl DataFolder {
    /// Makes the folder if need be, locks it, and clears what a killed run left half-written.
    ///
    /// # Errors
    /// If the folder cannot be made or written, another process writes into it, or it holds files that are not of a data set.
    pub fn claim(path: &Path) -> Result<Self, DatasetError> {
        let folder = Folder::claim(path, &BELOW, is_own)?;
        if [RECORD, JOURNAL].iter().any(|name| folder.join(name).is_file()) {
            folder.remove_leftovers(is_own)?;
            return Ok(Self(folder));
        }
        match first_file(&folder)? {
            None => Ok(Self(folder)),
            Some(found) if is_own(&found) => {
                let reason = format!(
                    "this file is gone, and `{found}` lies here; remove the folder, or name an empty one"
                );
                Err(DatasetError::Record { path: folder.join(RECORD), reason })
            }
            Some(found) => Err(DatasetError::Foreign { path: path.to_owned(), found }),
        }
    }

    /// Path of the folder.
    pub fn path(&self) -> &Path {
        self.0.path()
    }

    /// Path of a file in it.
    pub(crate) fn join(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    /// Makes the folders of the samples. Those that stay empty go again.
    pub(crate) fn make_splits(&self) -> Result<(), DatasetError> {
        Ok(BELOW.iter().try_for_each(|name| self.0.make(name))?)
    }

    /// Writes a file beside the samples.
    pub(crate) fn write(&self, name: &str, bytes: &[u8]) -> Result<(), DatasetError> {
        Ok(files::write_atomic(self.join(name), |out| out.write_all(bytes))?)
    }
}
