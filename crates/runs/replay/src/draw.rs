//! Frames from pose to disk.

use std::collections::BTreeMap;
use std::io::Write;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use generator::{PlaneKind, Planes, Session};
use picture::{AnyPicture, Encoder, PictureError};
use rayon::ThreadPool;
use scenario::{PoseRow, View};
use signal::Probe;

use crate::ReplayError;
use crate::folder::RunFolder;
use crate::job::{Control, Progress};
use crate::journal::Journal;
use crate::names::picture_name;
use crate::performance::StepTimes;
use crate::picture_png::picture_png;
use run_record::FrameRecord;
use run_record::Program;
use run_record::{FileRecord, hash};

/// More frames on their way than threads, so that threads draw while frames are written.
const FRAMES_BEYOND_THREADS: usize = 2;

/// Everything that a frame needs beside its pose.
pub(crate) struct Drawing<'a> {
    pub session: &'a dyn Session,
    pub view: &'a View,
    pub program: &'a Program,
    pub encoder: Encoder,
    /// Whether frames are in colour.
    pub colour: bool,
    /// Pictures that the tube shows of one update; 1 where only updates are kept.
    pub showings: u64,
    pub folder: &'a RunFolder,
    pub journal: &'a Journal,
    pub times: &'a StepTimes,
}

/// Draws the frames of `rows`; each that is in the result is on the disk and in the journal. Ends early, with
/// whole frames only, when told to.
///
/// Every carrier brings one frame at a time from pose to disk, so memory does not grow with the number of frames.
pub(crate) fn draw_all(
    drawing: &Drawing,
    rows: &[PoseRow],
    kept: u64,
    control: &Control,
) -> Result<BTreeMap<u64, FrameRecord>, ReplayError> {
    let ledger = Ledger { done: AtomicU64::new(kept), ..Ledger::default() };
    let carry = || {
        let (columns, lines) = (drawing.view.columns as usize, drawing.view.lines as usize);
        let mut planes = Planes::new(columns, lines, drawing.kinds());
        while !control.cancel.load(Ordering::Relaxed) {
            let Some(row) = ledger.next(rows) else { break };
            let drawn = || drawing.frame(row, &mut planes, control.pool);
            match drawing.times.of_frame(row.frame, drawn) {
                Ok(record) => (control.progress)(Progress::Frame { done: ledger.keep(record) }),
                Err(error) => ledger.fail(row.frame, error),
            }
        }
    };
    let carriers = (control.pool.current_num_threads() + FRAMES_BEYOND_THREADS).min(rows.len());
    thread::scope(|scope| {
        for _ in 0..carriers {
            scope.spawn(carry);
        }
    });
    ledger.close()
}

/// What the carriers have in common.
#[derive(Default)]
struct Ledger {
    next: AtomicUsize,
    done: AtomicU64,
    has_failed: AtomicBool,
    failure: Mutex<Option<(u64, ReplayError)>>,
    records: Mutex<BTreeMap<u64, FrameRecord>>,
}

impl Ledger {
    fn next<'a>(&self, rows: &'a [PoseRow]) -> Option<&'a PoseRow> {
        if self.has_failed.load(Ordering::Relaxed) {
            return None;
        }
        rows.get(self.next.fetch_add(1, Ordering::Relaxed))
    }

    /// Keeps a frame; tells how many there are.
    fn keep(&self, record: FrameRecord) -> u64 {
        self.records.lock().unwrap_or_else(PoisonError::into_inner).insert(record.frame, record);
        self.done.fetch_add(1, Ordering::Relaxed) + 1
    }

    /// Ends the run. Of several failures the one of the earliest frame is told.
    fn fail(&self, frame: u64, error: ReplayError) {
        self.has_failed.store(true, Ordering::Relaxed);
        let mut failure = self.failure.lock().unwrap_or_else(PoisonError::into_inner);
        if failure.as_ref().is_none_or(|(earlier, _)| frame < *earlier) {
            *failure = Some((frame, error));
        }
    }

    fn close(self) -> Result<BTreeMap<u64, FrameRecord>, ReplayError> {
        match self.failure.into_inner().unwrap_or_else(PoisonError::into_inner) {
            Some((_, error)) => Err(error),
            None => Ok(self.records.into_inner().unwrap_or_else(PoisonError::into_inner)),
        }
    }
}

impl Drawing<'_> {
    /// Planes that a frame is made of.
    fn kinds(&self) -> &'static [PlaneKind] {
        if self.colour { &PlaneKind::COLOUR } else { &[PlaneKind::Intensity] }
    }

    fn encode(&self, planes: &Planes) -> Result<AnyPicture, PictureError> {
        let (columns, lines) = (planes.columns(), planes.lines());
        match planes.colour() {
            Some(colour) => Ok(self.encoder.encode_colour(colour, columns, lines)?.into()),
            None => {
                let intensity = planes.get(PlaneKind::Intensity).unwrap_or_default();
                Ok(self.encoder.encode(intensity, columns, lines)?.into())
            }
        }
    }

    fn frame(
        &self,
        row: &PoseRow,
        planes: &mut Planes,
        pool: &ThreadPool,
    ) -> Result<FrameRecord, ReplayError> {
        let frame = row.frame;
        let refused = |source| ReplayError::Picture { frame, source };
        let draw = || self.session.frame(frame, &row.pose, planes, &mut Probe::off());
        let counts = pool.install(|| self.times.draw.time(draw))?;
        let encode = |planes: &Planes| {
            pool.install(|| self.times.encode.time(|| self.encode(planes))).map_err(refused)
        };
        let update = encode(planes)?;
        let mut files = Vec::new();
        for showing in 0..self.showings {
            let index = frame * self.showings + showing;
            let repeat = || self.session.repeat(frame, &row.pose, showing, planes);
            let is_other = self.showings > 1 && pool.install(|| self.times.draw.time(repeat))?;
            let repeated = is_other.then(|| encode(planes)).transpose()?;
            let picture = repeated.as_ref().unwrap_or(&update);
            let png = || self.png(row, index, picture);
            let png = pool.install(|| self.times.encode.time(png)).map_err(refused)?;
            files.push(self.times.write.time(|| self.write(picture_name(index), &png))?);
        }
        let (time_s, pixels_blake3) = (row.pose.time, update.pixel_hash());
        let record = FrameRecord { frame, time_s, pixels_blake3, files, counts };
        self.times.write.time(|| self.journal.add(&record))?;
        Ok(record)
    }

    fn png(&self, row: &PoseRow, index: u64, picture: &AnyPicture) -> Result<Vec<u8>, PictureError> {
        let is_update = self.showings == 1;
        let rate = if is_update { self.view.update } else { self.view.refresh };
        picture_png(self.program, (index, rate), row, picture)
    }

    fn write(&self, file: String, bytes: &[u8]) -> Result<FileRecord, ReplayError> {
        files::write_atomic(self.folder.join(&file), |out: &mut dyn Write| out.write_all(bytes))?;
        Ok(FileRecord { file, blake3: hash(bytes) })
    }
}
