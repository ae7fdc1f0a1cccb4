//! Frames from pose to disk.

use std::collections::BTreeMap;
use std::io::Write;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use generator::{PlaneKind, Planes, Session};
use hardware_model::Settings;
use landscape::Attitude;
use picture::{Encoder, GreyPicture, PictureError, encode_png};
use quantities::degrees;
use scenario::PoseRow;
use signal::Probe;

use crate::folder::{RunFolder, picture_name};
use crate::held::{FileRecord, FrameRecord, hash};
use crate::job::{Control, Progress};
use crate::journal::Journal;
use crate::performance::StepTimes;
use crate::{Program, ReplayError};

/// More frames on their way than threads, so that threads draw while frames are written.
const FRAMES_BEYOND_THREADS: usize = 2;

/// Everything that a frame needs beside its pose.
pub(crate) struct Drawing<'a> {
    pub session: &'a dyn Session,
    pub settings: &'a Settings,
    pub program: &'a Program,
    pub encoder: Encoder,
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
    let (next, done) = (AtomicUsize::new(0), AtomicU64::new(kept));
    let failed = AtomicBool::new(false);
    let failure: Mutex<Option<(u64, ReplayError)>> = Mutex::new(None);
    let records = Mutex::new(BTreeMap::new());
    let carry = || {
        let raster = &drawing.settings.raster;
        let kinds = [PlaneKind::Intensity];
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &kinds);
        while !failed.load(Ordering::Relaxed) && !control.cancel.load(Ordering::Relaxed) {
            let Some(row) = rows.get(next.fetch_add(1, Ordering::Relaxed)) else { break };
            match drawing.frame(row, &mut planes, control) {
                Ok(record) => {
                    let mut records = records.lock().unwrap_or_else(PoisonError::into_inner);
                    records.insert(record.frame, record);
                    let done = done.fetch_add(1, Ordering::Relaxed) + 1;
                    (control.progress)(Progress::Frame { done });
                }
                Err(error) => {
                    failed.store(true, Ordering::Relaxed);
                    let mut first = failure.lock().unwrap_or_else(PoisonError::into_inner);
                    if first.as_ref().is_none_or(|(frame, _)| row.frame < *frame) {
                        *first = Some((row.frame, error));
                    }
                }
            }
        }
    };
    let carriers = (control.pool.current_num_threads() + FRAMES_BEYOND_THREADS).min(rows.len());
    thread::scope(|scope| {
        for _ in 0..carriers {
            scope.spawn(carry);
        }
    });
    match failure.into_inner().unwrap_or_else(PoisonError::into_inner) {
        Some((_, error)) => Err(error),
        None => Ok(records.into_inner().unwrap_or_else(PoisonError::into_inner)),
    }
}

impl Drawing<'_> {
    fn frame(
        &self,
        row: &PoseRow,
        planes: &mut Planes,
        control: &Control,
    ) -> Result<FrameRecord, ReplayError> {
        let frame = row.frame;
        let draw = || self.session.frame(frame, &row.pose, planes, &mut Probe::off());
        let counts = control.pool.install(|| self.times.draw.time(draw))?;
        let intensity = planes.get(PlaneKind::Intensity).unwrap_or_default();
        let encode = || self.encode(row, intensity, planes.columns(), planes.lines());
        let (pixels, files) = control
            .pool
            .install(|| self.times.encode.time(encode))
            .map_err(|source| ReplayError::Picture { frame, source })?;
        let files = self.times.write.time(|| self.write(files))?;
        let record =
            FrameRecord { frame, time_s: row.pose.time, pixels_blake3: pixels, files, counts: counts.into() };
        self.times.write.time(|| self.journal.add(&record))?;
        Ok(record)
    }

    /// Hash of the pixels, and name and bytes of each picture.
    fn encode(
        &self,
        row: &PoseRow,
        intensity: &[f32],
        columns: usize,
        lines: usize,
    ) -> Result<(String, Vec<(String, Vec<u8>)>), PictureError> {
        let picture = self.encoder.encode(intensity, columns, lines)?;
        let indices = row.frame * self.showings..(row.frame + 1) * self.showings;
        let file = |index| Ok((picture_name(index), self.png(row, index, &picture)?));
        let files: Result<_, PictureError> = indices.map(file).collect();
        Ok((picture.pixel_hash(), files?))
    }

    fn png(&self, row: &PoseRow, index: u64, picture: &GreyPicture) -> Result<Vec<u8>, PictureError> {
        let rate =
            if self.showings == 1 { self.settings.timebase.update } else { self.settings.raster.refresh };
        let time = index as f64 / rate.hertz();
        let [x, y, z] = row.pose.eye;
        let Attitude { roll, pitch, heading } = row.pose.attitude;
        let [heading, pitch, roll] = [heading, pitch, roll].map(degrees);
        let texts = [
            ("Software", format!("{} {}", self.program.name, self.program.version)),
            ("Frame", index.to_string()),
            ("Time", format!("{time} s")),
            (
                "Pose",
                format!("x_m={x} y_m={y} z_m={z} heading_deg={heading} pitch_deg={pitch} roll_deg={roll}"),
            ),
        ];
        encode_png(picture, &texts.each_ref().map(|(key, text)| (*key, text.as_str())))
    }

    fn write(&self, files: Vec<(String, Vec<u8>)>) -> Result<Vec<FileRecord>, ReplayError> {
        let write = |(file, bytes): (String, Vec<u8>)| {
            files::write_atomic(self.folder.join(&file), |out: &mut dyn Write| out.write_all(&bytes))?;
            Ok(FileRecord { file, blake3: hash(&bytes) })
        };
        files.into_iter().map(write).collect()
    }
}
