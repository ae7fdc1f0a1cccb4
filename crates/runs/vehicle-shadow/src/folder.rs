//! The folder of the new pictures: whose files are in it, and who may write.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use files::Folder;
use serde_json::Value;

use crate::kept::stamp_of;
use crate::{AugmentError, Sequence};

/// What was done, beside the pictures.
const RECORD: &str = "augment.json";
const SCHEMA: &str = "lunoid.augment/1";
/// The record's key of the hash of everything that decides its pictures but the old ones.
const INPUTS: &str = "inputs_blake3";
/// Largest record that is read back (bytes).
const MAX_BYTES: u64 = 1 << 30;

/// What the pictures of a folder are made from beside the old ones.
#[derive(Debug, Clone)]
pub struct MadeFrom {
    /// Hash of all of it, hexadecimal.
    pub inputs: String,
    /// Keys of the record that decide pictures, with their values.
    pub keys: Value,
}

/// A folder that this process, and no other, writes new pictures into: those of one augmentation.
#[derive(Debug)]
pub struct ShadowFolder {
    folder: Folder,
    /// Names of the new pictures.
    made: BTreeSet<String>,
}

impl ShadowFolder {
    /// Makes the folder `out` if need be, locks it, and clears what a killed command left. `fresh` removes what an earlier one has made, and
    /// nothing else.
    ///
    /// # Errors
    /// If `out` is the folder of the old pictures, another process writes into it, it holds files of somebody else or an augmentation
    /// from something else, or a file of it is a link.
    pub fn claim(
        out: &Path,
        sequence: &Sequence,
        from: &MadeFrom,
        fresh: bool,
    ) -> Result<Self, AugmentError> {
        expect_other_folder(sequence.folder(), out)?;
        let names = sequence.frames().iter().map(|frame| frame.made().to_string_lossy().into_owned());
        let made: BTreeSet<String> = names.collect();
        let folder = Folder::claim(out, &[], is_ours)?;
        let claimed = Self { folder, made };
        let earlier = claimed.earlier()?;
        match &earlier {
            None => claimed.expect_room(fresh)?,
            Some(earlier) if !fresh => claimed.expect_same(earlier, from)?,
            Some(_) => claimed.remove_pictures(|_| false)?,
        }
        claimed.folder.remove_leftovers(|name| name == RECORD || claimed.made.contains(name))?;
        if fresh && claimed.path().join(RECORD).is_file() {
            claimed.folder.remove(RECORD)?;
        }
        Ok(claimed)
    }

    /// Returns the path of the folder.
    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    /// Writes the record, with the hash of what the pictures are made from, and removes pictures that an earlier command made of frames that are gone.
    ///
    /// # Errors
    /// If a file cannot be written or removed.
    pub fn finish(&self, record: &mut Value, from: &MadeFrom) -> Result<(), AugmentError> {
        record[INPUTS] = from.inputs.clone().into();
        files::write_atomic(self.path().join(RECORD), |out| writeln!(out, "{record:#}"))?;
        self.remove_pictures(|name| self.made.contains(name))
    }

    /// What an earlier command has made here: the record, or the hash that the first picture tells.
    fn earlier(&self) -> Result<Option<Earlier>, AugmentError> {
        let path = self.path().join(RECORD);
        if path.is_file() {
            let bytes = files::read_all(&path, MAX_BYTES)?;
            let record: Option<Value> = serde_json::from_slice(&bytes).ok();
            return match record.filter(|record| record["schema"] == SCHEMA) {
                Some(record) => Ok(Some(Earlier::Record(record))),
                None => {
                    Err(AugmentError::WouldReplace { path: self.path().to_owned(), found: RECORD.into() })
                }
            };
        }
        let names = self.folder.names("")?;
        let mut stamps =
            names.iter().filter(|name| is_ours(name)).filter_map(|name| stamp_of(&self.path().join(name)));
        Ok(stamps.next().map(|stamp| Earlier::Picture { inputs: stamp.inputs }))
    }

    /// A folder in which no earlier command has made anything holds nothing that would be replaced, and unless `fresh` nothing.
    fn expect_room(&self, fresh: bool) -> Result<(), AugmentError> {
        let (path, mut names) = (self.path().to_owned(), self.folder.names("")?);
        names.retain(|name| !self.is_leftover(name));
        match (names.iter().find(|name| self.made.contains(*name)), names.first()) {
            (Some(found), _) => Err(AugmentError::WouldReplace { path, found: found.clone() }),
            (None, Some(found)) if !fresh => Err(AugmentError::Foreign { path, found: found.clone() }),
            _ => Ok(()),
        }
    }

    /// Whether a killed command left this file: a new picture that was not whole yet.
    fn is_leftover(&self, name: &str) -> bool {
        let target = name.strip_prefix('.').filter(|_| name.ends_with(".tmp"));
        target.is_some_and(|target| self.made.iter().any(|made| target.starts_with(made.as_str())))
    }

    fn expect_same(&self, earlier: &Earlier, from: &MadeFrom) -> Result<(), AugmentError> {
        let (inputs, differences) = match earlier {
            Earlier::Record(record) => {
                (record[INPUTS].as_str().unwrap_or_default(), differences(record, &from.keys))
            }
            Earlier::Picture { inputs } => (inputs.as_str(), None),
        };
        if inputs == from.inputs {
            return Ok(());
        }
        let differences =
            differences.unwrap_or_else(|| "what its pictures are made from has other content".into());
        Err(AugmentError::Other { path: self.path().to_owned(), differences })
    }

    /// Removes pictures that an earlier command has made and that are not `kept`.
    fn remove_pictures(&self, is_kept: impl Fn(&str) -> bool) -> Result<(), AugmentError> {
        let names = self.folder.names("")?;
        let strays = names.iter().filter(|name| is_ours(name) && !is_kept(name));
        let mut strays = strays.filter(|name| stamp_of(&self.path().join(name)).is_some());
        strays.try_for_each(|name| Ok(self.folder.remove(name)?))
    }
}

/// What tells of an earlier command.
enum Earlier {
    Record(Value),
    /// It was interrupted before it wrote a record.
    Picture {
        inputs: String,
    },
}

/// What differs in the keys of `now`.
fn differences(then: &Value, now: &Value) -> Option<String> {
    let keys = now.as_object().into_iter().flatten();
    let then: Value = keys.map(|(key, _)| (key.clone(), then[key].clone())).collect();
    run_record::differences(&then, now)
}

/// Whether the command writes files of this name.
fn is_ours(name: &str) -> bool {
    name == RECORD || name.len() > 4 && name.to_ascii_lowercase().ends_with(".png")
}

/// The new pictures do not replace the old ones.
fn expect_other_folder(pictures: &Path, out: &Path) -> Result<(), AugmentError> {
    let real = |path: &Path| -> Option<PathBuf> { fs::canonicalize(path).ok() };
    match real(out) {
        Some(ref found) if real(pictures).as_ref() == Some(found) => {
            Err(AugmentError::SameFolder { path: out.to_owned() })
        }
        _ => Ok(()),
    }
}
