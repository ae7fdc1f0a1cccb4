//! A run whose frames were drawn into other folders.

use std::io::Write;
use std::ops::Range;
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};

use limits::Limit;
use quantities::Rate;
use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};
use run_record::{FileRecord, FrameRecord, MAX_BYTES, RunRecord, hash};

use crate::ReplayError;
use crate::film::{write_animation, write_sheet};
use crate::fingerprint::Fingerprint;
use crate::folder::RunFolder;
use crate::held::{RUN_RECORD, frame_range, write_changed};
use crate::job::{Control, Job, Progress, REFRESH};
use crate::journal::{self, JOURNAL, Journal};
use crate::listed::Listed;
use crate::names::{ANIMATION, CAMERA, CONTACT_SHEET, FRAMES, POSES};
use crate::world::World;

/// A run that is put together from frames of other folders.
#[derive(Debug)]
pub struct JoinedRun<'a> {
    /// Record of the run; its outputs are not read.
    pub record: RunRecord,
    /// For each frame of the record, the run folder that has its files.
    pub sources: Vec<&'a Path>,
    /// Bytes of the file `poses.csv`.
    pub poses: Vec<u8>,
    /// Bytes of the file `camera.json`.
    pub camera: Vec<u8>,
    /// An animated PNG as well.
    pub film: bool,
}

/// Frames of the unfinished run in `folder`, ascending; `None` if the folder has no journal.
///
/// # Errors
/// If the journal cannot be read.
pub fn unfinished_frames(folder: &Path) -> Result<Option<Vec<u64>>, ReplayError> {
    let found = journal::read::<FrameRecord>(&folder.join(JOURNAL))?;
    let numbers = |frames: &[FrameRecord]| {
        let mut numbers: Vec<u64> = frames.iter().map(|frame| frame.frame).collect();
        numbers.sort_unstable();
        numbers.dedup();
        numbers
    };
    Ok(found.map(|found| numbers(&found.frames)))
}

/// Refuses a folder with a run of something else than `job`.
///
/// # Errors
/// If the record cannot be read, or is of another run.
pub fn expect_run_of(job: &Job, folder: &RunFolder) -> Result<(), ReplayError> {
    Listed::read(folder)?.expect_same(folder, &Fingerprint::of_job(job, &World::of(job)))
}

impl JoinedRun<'_> {
    /// Writes the run into `folder`, and returns the number of whole frames: fewer than all if told to end. The threads of the
    /// pool each have one file in memory. What is there and right is not written again. A folder that was left in the middle
    /// holds an unfinished run; the same call goes on from there.
    ///
    /// # Errors
    /// If the folder holds another run, or one with other frames; if a frame is not what the record says; if a file cannot be
    /// written.
    pub fn write(mut self, folder: &RunFolder, control: &Control) -> Result<u64, ReplayError> {
        let range = frame_range(&self.record.frames).ok_or(ReplayError::NoFrames(0..0))?;
        let fingerprint = Fingerprint::of_record(&self.record);
        expect_part(folder, &fingerprint, &range)?;
        self.expect_room(folder)?;
        let journal = Journal::begin(folder.join(JOURNAL), &fingerprint, &self.record.frames)?;
        folder.make(FRAMES)?;
        let showings = self.record.frames.first().map_or(1, |frame| frame.files.len() as u64);
        let pictures = range.start * showings..range.end * showings;
        folder.remove_strays(|index| pictures.contains(&index))?;
        let done = self.copy_frames(folder, control)?;
        if done == self.record.frames.len() as u64 {
            (control.progress)(Progress::Finishing);
            self.record.outputs = self.write_outputs(folder)?;
            write_changed(folder.path(), RUN_RECORD, self.record.text().as_bytes())?;
            journal.end()?;
        }
        Ok(done)
    }

    /// Nobody else has a file where one is to be written.
    fn expect_room(&self, folder: &RunFolder) -> Result<(), ReplayError> {
        let pictures = self.record.frames.iter().flat_map(|frame| &frame.files).map(|file| file.file.clone());
        let film = self.film.then_some(ANIMATION);
        let outputs = [POSES, CAMERA, CONTACT_SHEET].into_iter().chain(film).map(str::to_owned);
        folder.expect_own(pictures.chain(outputs))
    }

    /// Copies the frames, and returns how many are there.
    fn copy_frames(&self, folder: &RunFolder, control: &Control) -> Result<u64, ReplayError> {
        let frames = self.record.frames.len() as u64;
        (control.progress)(Progress::Begins { what: "frames", frames, kept: 0 });
        let done = AtomicU64::new(0);
        let one = |(frame, source): (&FrameRecord, &&Path)| {
            if control.cancel.load(Ordering::Relaxed) {
                return Ok(());
            }
            frame.files.iter().try_for_each(|file| copy(source, folder.path(), file))?;
            (control.progress)(Progress::Frame { done: done.fetch_add(1, Ordering::Relaxed) + 1 });
            Ok::<(), ReplayError>(())
        };
        control.pool.install(|| self.record.frames.par_iter().zip(&self.sources).try_for_each(one))?;
        Ok(done.into_inner())
    }

    /// Everything that follows from the frames.
    fn write_outputs(&self, folder: &RunFolder) -> Result<Vec<FileRecord>, ReplayError> {
        let files = self.record.frames.iter().flat_map(|frame| &frame.files);
        let pictures: Vec<_> = files.map(|file| folder.join(&file.file)).collect();
        let mut outputs = vec![
            write_changed(folder.path(), POSES, &self.poses)?,
            write_changed(folder.path(), CAMERA, &self.camera)?,
            write_sheet(folder, &pictures)?,
        ];
        if self.film {
            outputs.push(write_animation(folder, &pictures, self.picture_rate(folder)?)?);
        }
        Ok(outputs)
    }

    /// Rate of the pictures that are kept.
    fn picture_rate(&self, folder: &RunFolder) -> Result<Rate, ReplayError> {
        let (view, pictures) = (&self.record.view, &self.record.pictures);
        let clock = if pictures.one_file_for_each == REFRESH { &view.refresh } else { &view.update };
        rate(clock).ok_or_else(|| ReplayError::Record {
            path: folder.join(RUN_RECORD),
            reason: format!("its clock is {clock:?}, expected a rate such as 30 Hz or 30000/1001 Hz"),
        })
    }
}

/// A clock as a record writes it: `30 Hz`, `30000/1001 Hz`.
fn rate(clock: &str) -> Option<Rate> {
    let fraction = clock.strip_suffix(" Hz")?;
    let (above, below) = fraction.split_once('/').unwrap_or((fraction, "1"));
    Rate::new(above.parse().ok()?, below.parse().ok()?)
}

/// The folder holds nothing, or a part of the run of `range`.
fn expect_part(folder: &RunFolder, fingerprint: &Fingerprint, range: &Range<u64>) -> Result<(), ReplayError> {
    let listed = Listed::read(folder)?;
    listed.expect_same(folder, fingerprint)?;
    let frames = listed.frames();
    match frames.keys().find(|frame| !range.contains(frame)) {
        None => Ok(()),
        Some(&frame) => {
            Err(ReplayError::OtherFrames { path: folder.path().to_owned(), frame, range: range.clone() })
        }
    }
}

/// Copies a file from the run folder `from` to `to`, if it is what the record says.
pub(crate) fn copy(from: &Path, to: &Path, file: &FileRecord) -> Result<(), ReplayError> {
    let path = from.join(&file.file);
    let bytes = files::read_all(&path, MAX_BYTES)?;
    if hash(&bytes) != file.blake3 {
        return Err(ReplayError::Changed { path });
    }
    let target = to.join(&file.file);
    if !files::holds(&target, &bytes) {
        files::write_atomic(&target, |out: &mut dyn Write| out.write_all(&bytes))?;
    }
    Ok(())
}

/// The bytes of a file of the run folder `folder`, if it is what the record says.
///
/// # Errors
/// If the file cannot be read, or was changed.
pub fn read_listed(folder: &Path, file: &FileRecord) -> Result<Vec<u8>, ReplayError> {
    let path = folder.join(&file.file);
    let bytes = files::read_all(&path, Limit::RecordBytes)?;
    if hash(&bytes) == file.blake3 { Ok(bytes) } else { Err(ReplayError::Changed { path }) }
}

#[cfg(test)]
mod tests {
    use quantities::Rate;

    use super::rate;

    #[test]
    fn clocks_are_read_as_they_are_written() {
        for (above, below) in [(30, 1), (30_000, 1001), (1, 60), (u64::MAX, 2)] {
            let written = Rate::new(above, below).expect("a rate");
            assert_eq!(rate(&written.to_string()), Some(written));
        }
        for wrong in ["", "30", "0 Hz", "30/0 Hz", "-1 Hz", "1.5 Hz", "1/2/3 Hz"] {
            assert_eq!(rate(wrong), None, "{wrong}");
        }
    }
}
