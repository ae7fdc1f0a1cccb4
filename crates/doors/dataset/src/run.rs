//! A data set from beginning to end: what is there is verified, the rest made, the record written.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use files::{Npy, write_npz};
use rayon::prelude::*;
use replay::{Control, Fingerprint, Journal, Progress, differences, read_journal};
use run_record::{Program, file_hash};

use crate::DatasetError;
use crate::finish::{Texts, finish};
use crate::folder::{DataFolder, JOURNAL, MANIFEST};
use crate::plan::Plan;
use crate::record::{MadeFrom, PlanRecord, Record};
use crate::row::Row;
use crate::sample::{Made, Maker};

/// A data set to be made, or a part of one.
#[derive(Debug, Clone)]
pub struct Job<'a> {
    /// What it is drawn from.
    pub plan: &'a Plan,
    /// The program that draws.
    pub program: Program,
    /// Numbers of its samples.
    pub samples: Range<u64>,
}

/// How the making ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Outcome {
    /// All samples are there.
    Finished {
        /// Samples made now; the others were there.
        made: u64,
    },
    /// Told to end: the samples there are whole, and the same job goes on from them.
    Interrupted {
        /// Samples that are there.
        done: u64,
        /// Samples of the job.
        of: u64,
    },
}

/// Makes the samples of `job` in `folder`, or what is missing of them. The bytes do not depend on the number of threads, and not on how
/// often the making was interrupted.
///
/// # Errors
/// If the folder holds another data set, or a sample cannot be made or written. What was finished before stays, and the same job goes on
/// from there.
pub fn run(job: &Job, folder: &DataFolder, control: &Control) -> Result<Outcome, DatasetError> {
    let Job { plan, program, samples } = job;
    if samples.is_empty() || samples.end > plan.samples() {
        let asked = format!("{}..{}", samples.start, samples.end);
        return Err(DatasetError::NoSamples { asked, of: plan.samples() });
    }
    let made_from = MadeFrom::of(plan, program.clone())?;
    let fingerprint = made_from.fingerprint(samples);
    let kept = kept(folder, &fingerprint, control)?;
    let journal = Journal::begin(folder.join(JOURNAL), &fingerprint, &kept.values().collect::<Vec<_>>())?;
    folder.make_splits()?;
    let texts = Texts::of(plan)?;
    let all = samples.end - samples.start;
    (control.progress)(Progress::Begins { what: "samples", frames: all, kept: kept.len() as u64 });
    let known = kept.len() as u64;
    let (made, error) = make(job, folder, &journal, kept, control);
    if let Some(error) = error {
        // Without a sample there is nothing to go on from.
        if made.is_empty() {
            journal.end()?;
        }
        return Err(error);
    }
    let drawn = made.len() as u64 - known;
    if (made.len() as u64) < all {
        return Ok(Outcome::Interrupted { done: made.len() as u64, of: all });
    }
    (control.progress)(Progress::Finishing);
    let rows: Vec<Row> = made.into_values().collect();
    let record = Record::of([samples.start, samples.end], plan.samples(), made_from, PlanRecord::of(plan));
    finish(folder, record, &rows, &texts)?;
    journal.end()?;
    Ok(Outcome::Finished { made: drawn })
}

/// Samples that are there and whole, by number.
pub(crate) fn kept(
    folder: &DataFolder,
    fingerprint: &Fingerprint,
    control: &Control,
) -> Result<BTreeMap<u64, Row>, DatasetError> {
    let expect = |found: &Fingerprint| match found.hash == fingerprint.hash {
        true => Ok(()),
        false => Err(DatasetError::Other {
            path: folder.path().to_owned(),
            differences: differences(found, fingerprint),
        }),
    };
    let mut rows = Vec::new();
    if let Some(record) = Record::read(folder.path())? {
        let [start, end] = record.samples;
        expect(&record.made_from.fingerprint(&(start..end)))?;
        // Without the manifest nothing says which samples are whole: all of them are made again.
        if folder.join(MANIFEST).exists() {
            rows = record.rows(folder.path())?;
        }
    }
    if let Some(found) = read_journal::<Row>(&folder.join(JOURNAL))? {
        expect(&found.fingerprint)?;
        rows.extend(found.frames);
    }
    (control.progress)(Progress::Verifying { frames: rows.len() as u64 });
    let whole = |row: &Row| row.file.is_whole(folder.path());
    let rows: Vec<Row> = control.pool.install(|| rows.into_par_iter().filter(whole).collect());
    Ok(rows.into_iter().map(|row| (row.sample, row)).collect())
}

/// Makes what is missing beside `kept`; returns what is there in the end, and what went wrong before that.
fn make(
    job: &Job,
    folder: &DataFolder,
    journal: &Journal,
    kept: BTreeMap<u64, Row>,
    control: &Control,
) -> (BTreeMap<u64, Row>, Option<DatasetError>) {
    let mut missing: Vec<u64> = job.samples.clone().filter(|sample| !kept.contains_key(sample)).collect();
    // Neighbours in time share their ground.
    missing.sort_by_key(|sample| (job.plan.combination(*sample), *sample));
    let (maker, next, failed) = (Maker::new(job.plan), AtomicUsize::new(0), AtomicBool::new(false));
    let done = AtomicU64::new(kept.len() as u64);
    let rows = Mutex::new(kept);
    let work = || -> Result<(), DatasetError> {
        while !control.cancel.load(Ordering::Relaxed) && !failed.load(Ordering::Relaxed) {
            let Some(sample) = missing.get(next.fetch_add(1, Ordering::Relaxed)) else { break };
            let row = write(folder, maker.make(*sample)?)?;
            let mut rows = rows.lock().unwrap_or_else(PoisonError::into_inner);
            expect_shape(rows.values().next(), &row)?;
            journal.add(&row)?;
            rows.insert(row.sample, row);
            (control.progress)(Progress::Frame { done: done.fetch_add(1, Ordering::Relaxed) + 1 });
        }
        Ok(())
    };
    let ended = control.pool.broadcast(|_| {
        let ended = work();
        failed.fetch_or(ended.is_err(), Ordering::Relaxed);
        ended
    });
    let rows = rows.into_inner().unwrap_or_else(PoisonError::into_inner);
    (rows, ended.into_iter().find_map(Result::err))
}

/// Writes the arrays of a sample; its row gets the hash of the file.
fn write(folder: &DataFolder, made: Made) -> Result<Row, DatasetError> {
    let Made { mut row, arrays } = made;
    let path = folder.join(&row.file.file);
    let named: Vec<(&str, &Npy)> = arrays.iter().map(|(name, array)| (*name, array)).collect();
    write_npz(&path, named)?;
    row.file.blake3 = file_hash(&path)?;
    Ok(row)
}

/// All pictures of a data set have one shape.
pub(crate) fn expect_shape(first: Option<&Row>, row: &Row) -> Result<(), DatasetError> {
    match first.filter(|first| first.shape != row.shape) {
        None => Ok(()),
        Some(first) => Err(DatasetError::Shapes {
            first: first.sample,
            second: row.sample,
            first_shape: first.shape.clone(),
            second_shape: row.shape.clone(),
        }),
    }
}
