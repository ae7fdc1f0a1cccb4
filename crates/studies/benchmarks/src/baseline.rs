//! Instructions that kernels once took, held against what they take now.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

use files::{FileError, read_all, write_atomic};
use serde::{Deserialize, Serialize};

/// Version of the file.
const FORMAT: u32 = 1;
/// Largest file that is read (bytes).
const MAX_BYTES: u64 = 1 << 20;

/// What counts depend on beside the code.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Circumstances {
    /// Compiler and level of optimisation.
    pub built_by: String,
    /// Vectors that kernels choose where they are counted.
    pub vectors: String,
}

/// Counts of instructions, kernel by kernel, as a file keeps them.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Baseline {
    format: u32,
    /// Where they were counted.
    pub circumstances: Circumstances,
    /// Instructions counted for each kernel, by its name.
    pub instructions: BTreeMap<String, u64>,
}

/// A baseline that could not be read or written.
#[derive(Debug, thiserror::Error)]
pub enum BaselineError {
    /// The system said no.
    #[error(transparent)]
    File(#[from] FileError),
    /// Not JSON, not of this shape, or of another format.
    #[error("{}: {message}; expected counts of format {FORMAT}, as `instructions --record` writes them", .path.display())]
    Damaged {
        /// The path as given.
        path: PathBuf,
        /// What was found, and where.
        message: String,
    },
}

/// A kernel's count beside the one of the baseline.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference<'b> {
    /// Name of the kernel.
    pub name: &'b str,
    /// Instructions of the baseline.
    pub before: u64,
    /// Instructions that are counted now.
    pub now: u64,
}

impl Baseline {
    /// Of counts by name.
    pub fn new(circumstances: Circumstances, instructions: BTreeMap<String, u64>) -> Self {
        Self { format: FORMAT, circumstances, instructions }
    }

    /// Reads a file.
    ///
    /// # Errors
    /// If it cannot be read, or is no baseline of this format.
    pub fn read(path: &Path) -> Result<Self, BaselineError> {
        let bytes = read_all(path, MAX_BYTES)?;
        let damaged = |message| BaselineError::Damaged { path: path.to_owned(), message };
        let read: Self = serde_json::from_slice(&bytes).map_err(|error| damaged(error.to_string()))?;
        match read.format {
            FORMAT => Ok(read),
            other => Err(damaged(format!("format: found {other}"))),
        }
    }

    /// Writes it to a file, whole or not at all.
    ///
    /// # Errors
    /// If the system says no.
    pub fn write(&self, path: &Path) -> Result<(), BaselineError> {
        Ok(write_atomic(path, |out| {
            serde_json::to_writer_pretty(&mut *out, self)?;
            out.write_all(b"\n")
        })?)
    }

    /// Each of its kernels beside `now`; a kernel that was not counted now is left out.
    pub fn differences<'b>(&'b self, now: &BTreeMap<String, u64>) -> Vec<Difference<'b>> {
        let both = self.instructions.iter();
        both.filter_map(|(name, &before)| Some(Difference { name, before, now: *now.get(name)? })).collect()
    }
}

impl Difference<'_> {
    /// Instructions now for each one of before.
    pub fn ratio(&self) -> f64 {
        self.now as f64 / self.before as f64
    }

    /// Whether there are more or fewer now than the part `tolerance` of those before.
    pub fn beyond(&self, tolerance: f64) -> Ordering {
        let differ = self.now.abs_diff(self.before) as f64 > tolerance * self.before as f64;
        if differ { self.now.cmp(&self.before) } else { Ordering::Equal }
    }
}

impl fmt::Display for Circumstances {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}", self.built_by, self.vectors)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn baseline(counts: &[(&str, u64)]) -> Baseline {
        let circumstances = Circumstances { built_by: "rustc 1".into(), vectors: "Avx2".into() };
        Baseline::new(circumstances, counts_of(counts))
    }

    fn counts_of(counts: &[(&str, u64)]) -> BTreeMap<String, u64> {
        counts.iter().map(|&(name, count)| (name.to_owned(), count)).collect()
    }

    #[test]
    fn a_file_is_read_as_it_was_written() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("counts.json");
        let written = baseline(&[("terrain/f32", 1000), ("video", 7)]);
        written.write(&path).unwrap();
        assert_eq!(Baseline::read(&path).unwrap(), written);
    }

    #[test]
    fn what_is_no_baseline_is_refused_by_name() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("counts.json");
        baseline(&[("video", 7)]).write(&path).unwrap();
        let good = std::fs::read_to_string(&path).unwrap();
        for (bad, told) in [
            (good.replace("\"format\": 1", "\"format\": 2"), "format: found 2"),
            (good.replace(": 7", ": -7"), "line"),
            (good.replace("vectors", "victors"), "victors"),
            (String::new(), "line 1"),
        ] {
            std::fs::write(&path, bad).unwrap();
            let error = Baseline::read(&path).unwrap_err().to_string();
            assert!(error.contains("counts.json") && error.contains(told), "{error}");
        }
    }

    #[test]
    fn more_and_fewer_are_told_beyond_the_tolerance_alone() {
        let before = baseline(&[("less", 1000), ("more", 1000), ("near", 1000), ("not counted", 1)]);
        let now = counts_of(&[("less", 970), ("more", 1021), ("near", 1020), ("new", 3)]);
        let beyond: Vec<_> =
            before.differences(&now).iter().map(|one| (one.name.to_owned(), one.beyond(0.02))).collect();
        let expected = [("less", Ordering::Less), ("more", Ordering::Greater), ("near", Ordering::Equal)];
        assert_eq!(beyond, expected.map(|(name, order)| (name.to_owned(), order)));
    }
}
