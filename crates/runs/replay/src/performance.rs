//! Wall times: all that differs between equal runs, apart from them.

use std::collections::BTreeMap;
use std::fs;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use generator::Counter;
use limits::Limit;
use quantities::Rate;
use serde_json::{Value, json};

use crate::ReplayError;
use crate::folder::RunFolder;
use crate::held::{pretty, write_changed};
use crate::names::PERFORMANCE;
use crate::phases::Phases;
use run_record::{FrameRecord, total_work};

/// Key of the seconds of each frame in the document.
pub(crate) const FRAMES_S: &str = "frames_s";
/// Key of the phases in the document.
const PHASES: &str = "phases";
/// The check, as a phase.
pub(crate) const CHECK: &str = "check";

/// Wall times of this session, as in `performance.json`.
#[derive(Debug, Clone, PartialEq)]
pub struct Performance {
    document: Value,
    /// Whether it is in the folder. A session that drew nothing leaves the file of the one that did.
    is_in_folder: bool,
}

impl Performance {
    /// The times of a session that drew, which stand in `folder` from now on.
    pub(crate) fn of_drawing(document: Value, folder: &RunFolder) -> Result<Self, ReplayError> {
        let performance = Self { document, is_in_folder: true };
        performance.write(folder)?;
        Ok(performance)
    }

    /// The times of a session that drew nothing. The file of the one that drew stays, if there is one, with the time of the check
    /// where one was made now.
    pub(crate) fn of_rest(
        document: Value,
        folder: &RunFolder,
        has_checked: bool,
    ) -> Result<Self, ReplayError> {
        let path = folder.join(PERFORMANCE);
        if !path.is_file() {
            return Self::of_drawing(document, folder);
        }
        if has_checked {
            let earlier = files::read_all(&path, Limit::RecordBytes)?;
            match with_check(&earlier, &document) {
                Some(checked) => write_document(folder, &checked)?,
                None => return Self::of_drawing(document, folder),
            }
        }
        Ok(Self { document, is_in_folder: false })
    }

    /// The document of this session.
    pub fn document(&self) -> &Value {
        &self.document
    }

    /// Takes the phases over that followed the run, in the file of `folder` as well.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn follow(&mut self, phases: &Phases, folder: &RunFolder) -> Result<(), ReplayError> {
        self.document[PHASES] = json!(phases.list());
        if self.is_in_folder { self.write(folder) } else { Ok(()) }
    }

    fn write(&self, folder: &RunFolder) -> Result<(), ReplayError> {
        write_document(folder, &self.document)
    }
}

fn write_document(folder: &RunFolder, document: &Value) -> Result<(), ReplayError> {
    write_changed(folder.path(), PERFORMANCE, pretty(document).as_bytes()).map(drop)
}

/// The times of an earlier session with the time of the check of `now`.
fn with_check(earlier: &[u8], now: &Value) -> Option<Value> {
    let mut times: Value = serde_json::from_slice(earlier).ok()?;
    let is_check = |phase: &Value| phase["phase"] == CHECK;
    let check = now[PHASES].as_array()?.iter().find(|phase| is_check(phase))?;
    let held = times.get_mut(PHASES)?.as_array_mut()?;
    held.retain(|phase| !is_check(phase));
    held.push(check.clone());
    Some(times)
}

/// Time spent in the steps of all frames; steps of different frames overlap.
#[derive(Debug, Default)]
pub(crate) struct StepTimes {
    pub draw: Stopwatch,
    pub encode: Stopwatch,
    pub write: Stopwatch,
    /// Seconds from pose to disk, frame by frame.
    frames: Mutex<BTreeMap<u64, f64>>,
}

impl StepTimes {
    /// Brings `frame` from pose to disk, and notes how long it took.
    pub fn of_frame<T>(&self, frame: u64, step: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = step();
        let seconds = start.elapsed().as_secs_f64();
        self.frames.lock().unwrap_or_else(PoisonError::into_inner).insert(frame, seconds);
        result
    }

    /// Frames with their seconds, ascending.
    fn frames(&self) -> Vec<(u64, f64)> {
        let frames = self.frames.lock().unwrap_or_else(PoisonError::into_inner);
        frames.iter().map(|(frame, seconds)| (*frame, *seconds)).collect()
    }
}

/// A sum of durations.
#[derive(Debug, Default)]
pub(crate) struct Stopwatch(AtomicU64);

impl Stopwatch {
    /// Runs `step` and adds its time.
    pub fn time<T>(&self, step: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = step();
        self.0.fetch_add(start.elapsed().as_nanos() as u64, Ordering::Relaxed);
        result
    }

    fn seconds(&self) -> f64 {
        Duration::from_nanos(self.0.load(Ordering::Relaxed)).as_secs_f64()
    }
}

/// The document of one session: frames that were there before do not count.
pub(crate) fn performance(
    phases: &Phases,
    steps: &StepTimes,
    threads: usize,
    drawn: &[&FrameRecord],
    drawing: f64,
    (update, counters): (Rate, &[Counter]),
) -> Value {
    let work = total_work(drawn.iter().copied(), counters);
    let frames_per_s = drawn.len() as f64 / drawing;
    json!({
        "schema": "lunoid.performance/1",
        "threads": threads,
        PHASES: phases.list(),
        "frames_drawn": drawn.len(),
        "drawing_s": drawing,
        "frames_per_s": frames_per_s,
        "samples_per_s": work.get("samples").unwrap_or(0) as f64 / drawing,
        "real_time_factor": frames_per_s / update.hertz(),
        "steps_of_all_frames_s": {
            "draw": steps.draw.seconds(),
            "encode": steps.encode.seconds(),
            "write": steps.write.seconds(),
        },
        FRAMES_S: steps.frames(),
        "peak_memory_kib": peak_memory(),
    })
}

/// Largest resident memory of this process so far (KiB), where the system tells it.
pub fn peak_memory() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?.split_whitespace().next()?.parse().ok()
}
