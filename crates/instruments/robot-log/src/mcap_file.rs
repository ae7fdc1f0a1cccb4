//! The robot log: a finished run in MCAP.

use std::collections::BTreeMap;
use std::io::{self, Read, Write};
use std::path::Path;
use std::sync::atomic::Ordering;

use files::Kind;
use foxglove::Encode;
use foxglove::messages::{
    CameraCalibration, CompressedImage, FrameTransforms, Log, PosesInFrame, RawImage, Timestamp,
};
use generator::Label;
use mcap::read::{LinearReader, Options};
use mcap::records::{MessageHeader, Record};
use mcap::write::{Metadata, NoSeek, WriteOptions, Writer};
use mcap::{McapError, McapResult};
use quantities::Rate;
use replay::{Control, Pinhole, Progress, TruthItem};
use scenario::PoseRow;

use crate::messages::{calibration, depth, labels, late_words, path, picture, timestamp, transforms};
use crate::{
    FinishedRun, FrameFiles, LateWord, LateWords, LogError, Outcome, expect_truth_of_log, nanoseconds,
};

/// First word of the library in the header of our logs.
const LIBRARY: &str = "lunoid";
/// Bytes of a file in which its header is looked for.
const HEAD_BYTES: u64 = 4096;

/// Refuses to replace a file that is no log of this program.
///
/// # Errors
/// [`LogError::NotOurs`], or if the file cannot be read.
pub fn expect_own_log(file: &Path) -> Result<(), LogError> {
    if !matches!(Kind::of(file), Ok(Kind::File)) {
        return Ok(());
    }
    let mut head = Vec::new();
    let read = files::open(file)?.take(HEAD_BYTES).read_to_end(&mut head);
    let is_ours = read.is_ok() && library(&head).is_some_and(|library| library.starts_with(LIBRARY));
    if is_ours { Ok(()) } else { Err(LogError::NotOurs { path: file.to_owned() }) }
}

/// The library that wrote the log which begins with `head`.
fn library(head: &[u8]) -> Option<String> {
    let mut records = LinearReader::new_with_options(head, Options::IgnoreEndMagic.into()).ok()?;
    match records.next()?.ok()? {
        Record::Header(header) => Some(header.library),
        _ => None,
    }
}

/// Writes the frames of `run` as a robot log into `file`, whole or not at all. `late` knows the late words, where a hybrid machine
/// drew.
///
/// # Errors
/// If the truth lacks distance or label, the file is no log of this program, a frame cannot be read, or the file cannot be written.
pub fn write_mcap(
    run: &FinishedRun,
    late: Option<&LateWords>,
    file: &Path,
    control: &Control,
) -> Result<Outcome, LogError> {
    expect_own_log(file)?;
    expect_truth_of_log(run.items())?;
    let mut failure = None;
    let mut outcome = Outcome { frames: run.rows().len() as u64, done: 0 };
    let written = files::write_atomic(file, |out| {
        write(run, late, out, (control, &mut outcome)).map_err(|error| match error {
            Fault::File(error) => error,
            Fault::Run(error) => {
                failure = Some(error);
                io::ErrorKind::Other.into()
            }
            Fault::Cancelled => io::ErrorKind::Interrupted.into(),
        })
    });
    match (written, failure) {
        (_, Some(error)) => Err(error),
        (Err(_), None) if outcome.done < outcome.frames && control.cancel.load(Ordering::Relaxed) => {
            Ok(outcome)
        }
        (written, None) => Ok(written.map(|()| outcome)?),
    }
}

/// Why a log is not whole.
enum Fault {
    /// The file cannot be written.
    File(io::Error),
    /// The run has not what is needed.
    Run(LogError),
    /// The command was told to end.
    Cancelled,
}

impl From<LogError> for Fault {
    fn from(error: LogError) -> Self {
        Self::Run(error)
    }
}

impl From<McapError> for Fault {
    fn from(error: McapError) -> Self {
        Self::File(match error {
            McapError::Io(error) => error,
            other => io::Error::other(other),
        })
    }
}

fn write(
    run: &FinishedRun,
    late: Option<&LateWords>,
    out: &mut dyn Write,
    (control, outcome): (&Control, &mut Outcome),
) -> Result<(), Fault> {
    let mut log = RobotLog::begin(run, out)?;
    (control.progress)(Progress::Begins { what: "robot log", frames: outcome.frames, kept: 0 });
    for row in run.rows() {
        if control.cancel.load(Ordering::Relaxed) {
            return Err(Fault::Cancelled);
        }
        let files = run.frame(row.frame)?;
        log.frame(run, row, files)?;
        let words = late.map(|late| control.pool.install(|| late.of(row))).transpose();
        log.late(row.frame, &words.map_err(LogError::from)?.unwrap_or_default())?;
        outcome.done += 1;
        (control.progress)(Progress::Frame { done: outcome.done });
    }
    Ok(log.writer.finish().map(drop)?)
}

/// A log that is being written, with the numbers of its channels.
struct RobotLog<'a> {
    writer: Writer<NoSeek<&'a mut dyn Write>>,
    picture: u16,
    depth: u16,
    labels: u16,
    calibration: u16,
    transforms: u16,
    path: u16,
    late: u16,
    /// Messages so far: the number of the next.
    sequence: u32,
}

impl<'a> RobotLog<'a> {
    /// The header, what the log is of, the channels, and the path.
    fn begin(run: &FinishedRun, out: &'a mut dyn Write) -> Result<Self, Fault> {
        let program = &run.record().program;
        let options = WriteOptions::new()
            .compression(None)
            .library(format!("{LIBRARY} {} (commit {})", program.version, program.commit))
            .disable_seeking(true);
        let mut writer = options.create(NoSeek::new(out))?;
        writer.write_metadata(&about(run))?;
        let mut log = Self {
            picture: channel::<CompressedImage>(&mut writer, "/camera/image")?,
            depth: channel::<RawImage>(&mut writer, "/camera/depth")?,
            labels: channel::<RawImage>(&mut writer, "/camera/labels")?,
            calibration: channel::<CameraCalibration>(&mut writer, "/camera/calibration")?,
            transforms: channel::<FrameTransforms>(&mut writer, "/tf")?,
            path: channel::<PosesInFrame>(&mut writer, "/path")?,
            late: channel::<Log>(&mut writer, "/late_words")?,
            writer,
            sequence: 0,
        };
        if let Some(first) = run.rows().first() {
            let (time, stamp) = instant(first.frame, run.view().update, first.frame)?;
            log.add(log.path, time, &path(stamp, run.rows().iter().map(|row| &row.pose)))?;
        }
        Ok(log)
    }

    /// Everything of a frame but its late words.
    fn frame(&mut self, run: &FinishedRun, row: &PoseRow, files: FrameFiles) -> Result<(), Fault> {
        let (view, frame) = (run.view(), row.frame);
        let (time, stamp) = instant(frame, view.update, frame)?;
        self.add(self.transforms, time, &transforms(stamp, &row.pose))?;
        self.add(self.calibration, time, &calibration(stamp, view))?;
        let number = |item| files.array(item).map(|array| array.data());
        if let Some(files::NpyData::F32(distance)) = number(TruthItem::Distance) {
            let metres = crate::depth(view, &row.pose, distance);
            self.add(self.depth, time, &depth(stamp, view, &metres))?;
        }
        if let Some(files::NpyData::U8(codes)) = number(TruthItem::Label) {
            self.add(self.labels, time, &labels(stamp, view, codes.clone()))?;
        }
        let showings = files.pictures.len() as u64;
        let clock = if showings > 1 { view.refresh } else { view.update };
        for (showing, png) in (frame * showings..).zip(files.pictures) {
            let (time, stamp) = instant(showing, clock, frame)?;
            self.add(self.picture, time, &picture(stamp, png))?;
        }
        Ok(())
    }

    /// A message for each sweep with late words.
    fn late(&mut self, frame: u64, words: &[LateWord]) -> Result<(), Fault> {
        for words in words.chunk_by(|one, next| one.sweep == next.sweep) {
            let time = words[0].time;
            let stamp = timestamp(time).ok_or(LogError::Late { frame })?;
            self.add(self.late, time, &late_words(stamp, frame, words))?;
        }
        Ok(())
    }

    fn add<M: Encode>(&mut self, channel_id: u16, time: u64, message: &M) -> Result<(), Fault> {
        let mut data = Vec::with_capacity(message.encoded_len().unwrap_or_default());
        message.encode(&mut data).map_err(|error| Fault::File(io::Error::other(error.to_string())))?;
        let header =
            MessageHeader { channel_id, sequence: self.sequence, log_time: time, publish_time: time };
        self.sequence = self.sequence.wrapping_add(1);
        Ok(self.writer.write_to_known_channel(&header, &data)?)
    }
}

/// A channel of messages of one schema.
fn channel<M: Encode>(writer: &mut Writer<NoSeek<&mut dyn Write>>, topic: &str) -> McapResult<u16> {
    let schema = match M::get_schema() {
        Some(schema) => writer.add_schema(&schema.name, &schema.encoding, &schema.data)?,
        None => 0,
    };
    writer.add_channel(schema, topic, &M::get_message_encoding(), &BTreeMap::new())
}

/// When `count` periods of `clock` are over; `frame` is for the message.
fn instant(count: u64, clock: Rate, frame: u64) -> Result<(u64, Timestamp), LogError> {
    let late = LogError::Late { frame };
    let Some(time) = nanoseconds(count, clock) else { return Err(late) };
    timestamp(time).map(|stamp| (time, stamp)).ok_or(late)
}

/// What the log is of, and what its numbers mean.
fn about(run: &FinishedRun) -> Metadata {
    let (record, frames) = (run.record(), run.frames());
    let codes = Label::ALL.iter().map(|label| format!("{} {}", label.code(), label.name()));
    let fingerprint = run.truth().map_or_else(String::new, |truth| truth.fingerprint.clone());
    let metadata = [
        ("schema", "lunoid.robot-log/1".to_owned()),
        ("scenario", record.scenario.title.clone()),
        ("generator", record.generator.clone()),
        ("model", record.model.name.clone()),
        ("run_fingerprint", record.fingerprint.clone()),
        ("truth_fingerprint", fingerprint),
        ("frames", format!("{}..{}", frames.start, frames.end)),
        ("time", "nanoseconds since the start of the mission, simulated".into()),
        ("depth", "metres ahead along the axis of view, by `exact` at the centre of the pixel; sky is infinity".into()),
        ("labels", codes.collect::<Vec<_>>().join(", ")),
        ("projection", Pinhole::reach(run.view().laws.projection).into()),
        ("axes", "site: east, north, up; vehicle: forward, port, up, origin at the eye; camera: right, down, ahead".into()),
    ];
    let metadata = metadata.map(|(key, value)| (key.to_owned(), value)).into();
    Metadata { name: LIBRARY.into(), metadata }
}
