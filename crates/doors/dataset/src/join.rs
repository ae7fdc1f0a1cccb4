//! Folders of one data set into one.

use std::collections::BTreeMap;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use replay::{Control, Journal, Progress};
use run_record::{differences_of, hash};
use serde_json::json;

use crate::DatasetError;
use crate::finish::{Texts, finish};
use crate::folder::{DataFolder, JOURNAL, LICENCE, PLAN, RECORD};
use crate::record::Record;
use crate::row::Row;
use crate::run::kept;

/// What came of joining.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Joined {
    /// All samples of the plan are in one folder.
    Whole {
        /// Number of all samples.
        samples: u64,
        /// Samples that more than one folder had.
        overlap: u64,
    },
    /// Samples that no folder has; nothing was written.
    Gaps {
        /// Numbers of the samples, ascending.
        gaps: Vec<Range<u64>>,
        /// Path of the plan, as the user gave it.
        plan: String,
    },
    /// Told to end; the same call goes on.
    Interrupted,
}

/// Whether `folder` holds a data set.
pub fn is_data_set(folder: &Path) -> bool {
    folder.join(RECORD).is_file()
}

/// Joins the data sets in `folders`, given in any order, into `out`. The joined folder is byte for byte the one that is made at once.
///
/// # Errors
/// If the folders are not of one data set, have a sample differently, or a file is not as its record lists it. Nothing is written then.
pub fn join(folders: &[PathBuf], out: &DataFolder, control: &Control) -> Result<Joined, DatasetError> {
    expect_folders(folders, out.path())?;
    let records = folders.iter().map(|folder| read(folder)).collect::<Result<Vec<Record>, _>>()?;
    let first = &records[0];
    records
        .iter()
        .zip(folders)
        .try_for_each(|(record, folder)| expect_same(first, record, &folders[0], folder))?;
    let (rows, overlap) = rows(folders, &records)?;
    let gaps = gaps(&rows, first.of);
    if !gaps.is_empty() {
        return Ok(Joined::Gaps { gaps, plan: first.made_from.plan.file.clone() });
    }
    let fingerprint = first.made_from.fingerprint(&(0..first.of));
    let there = kept(out, &fingerprint, control)?;
    let verified = |(row, from): &(Row, usize)| match row.file.is_whole(&folders[*from]) {
        true => Ok(()),
        false => Err(changed(&folders[*from].join(&row.file.file))),
    };
    (control.progress)(Progress::Verifying { frames: first.of });
    rows.values().try_for_each(verified)?;
    let texts = Texts { plan: text(&folders[0], first, PLAN)?, licence: text(&folders[0], first, LICENCE)? };
    let journal = Journal::begin(out.join(JOURNAL), &fingerprint, &there.values().collect::<Vec<_>>())?;
    out.make_splits()?;
    (control.progress)(Progress::Begins { what: "samples", frames: first.of, kept: there.len() as u64 });
    for (done, (row, from)) in rows.values().enumerate() {
        if control.cancel.load(Ordering::Relaxed) {
            return Ok(Joined::Interrupted);
        }
        if there.get(&row.sample) != Some(row) {
            copy(&folders[*from], out, row)?;
            journal.add(row)?;
        }
        (control.progress)(Progress::Frame { done: done as u64 + 1 });
    }
    (control.progress)(Progress::Finishing);
    let rows: Vec<Row> = rows.into_values().map(|(row, _)| row).collect();
    let record = Record::of([0, first.of], first.of, first.made_from.clone(), first.plan.clone());
    finish(out, record, &rows, &texts)?;
    journal.end()?;
    Ok(Joined::Whole { samples: first.of, overlap })
}

fn read(folder: &Path) -> Result<Record, DatasetError> {
    let reason = "no data set is finished here; make it first";
    Record::read(folder)?.ok_or_else(|| DatasetError::Folders { path: folder.to_owned(), reason })
}

fn expect_folders(folders: &[PathBuf], out: &Path) -> Result<(), DatasetError> {
    let real = |path: &Path| fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let all: Vec<PathBuf> = folders.iter().map(|folder| real(folder)).collect();
    let refuse = |at: usize, reason| Err(DatasetError::Folders { path: folders[at].clone(), reason });
    if let Some(at) = (1..all.len()).find(|at| all[..*at].contains(&all[*at])) {
        return refuse(at, "given twice; give each folder once");
    }
    match all.iter().position(|folder| *folder == real(out)) {
        Some(at) => {
            refuse(at, "this folder is to be joined; expected another folder for the joined data set")
        }
        None => Ok(()),
    }
}

/// Program, plan and files are those of the first folder.
fn expect_same(first: &Record, other: &Record, at: &Path, there: &Path) -> Result<(), DatasetError> {
    let [one, two] = [first, other].map(|record| json!([record.made_from, record.plan, record.of]));
    match differences_of([&one, &two], ["in the first", "in the second"]) {
        None => Ok(()),
        Some(differences) => {
            Err(DatasetError::OtherSet { first: at.to_owned(), second: there.to_owned(), differences })
        }
    }
}

type Rows = BTreeMap<u64, (Row, usize)>;

/// Every sample with the folder that has it first, and how many others have it too.
fn rows(folders: &[PathBuf], records: &[Record]) -> Result<(Rows, u64), DatasetError> {
    let (mut all, mut overlap) = (Rows::new(), 0);
    for (from, (folder, record)) in folders.iter().zip(records).enumerate() {
        for row in record.rows(folder)? {
            let Some((known, there)) = all.get(&row.sample) else {
                all.insert(row.sample, (row, from));
                continue;
            };
            let [one, two] = [known, &row].map(|row| json!(row));
            if let Some(differences) = differences_of([&one, &two], ["in the first", "in the second"]) {
                let (sample, first, second) = (row.sample, folders[*there].clone(), folder.clone());
                return Err(DatasetError::Overlap { sample, first, second, differences });
            }
            overlap += 1;
        }
    }
    Ok((all, overlap))
}

/// Ranges of samples that are not there.
fn gaps(rows: &Rows, of: u64) -> Vec<Range<u64>> {
    let mut gaps = Vec::new();
    let mut next = 0;
    for sample in rows.keys().copied().chain([of]) {
        if sample > next {
            gaps.push(next..sample);
        }
        next = sample + 1;
    }
    gaps
}

fn text(folder: &Path, record: &Record, name: &str) -> Result<Vec<u8>, DatasetError> {
    let path = folder.join(name);
    let bytes = files::read_all(&path, limits::Limit::TextBytes)?;
    let listed = record.outputs.iter().find(|file| file.file == name);
    match listed.is_some_and(|file| file.blake3 == hash(&bytes)) {
        true => Ok(bytes),
        false => Err(changed(&path)),
    }
}

/// Copies a sample, whose bytes must still be those of its record.
fn copy(from: &Path, out: &DataFolder, row: &Row) -> Result<(), DatasetError> {
    let path = from.join(&row.file.file);
    let bytes = files::read_all(&path, limits::Limit::BankBytes)?;
    match hash(&bytes) == row.file.blake3 {
        true => out.write(&row.file.file, &bytes),
        false => Err(changed(&path)),
    }
}

fn changed(path: &Path) -> DatasetError {
    let reason = "not as its record lists it: missing or changed; make its sample anew".into();
    DatasetError::Record { path: path.to_owned(), reason }
}
