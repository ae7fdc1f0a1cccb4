//! Wall times: all that differs between equal runs, apart from them.

use std::fs;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use generator::Counter;
use quantities::Rate;
use serde::Serialize;
use serde_json::{Value, json};

use run_record::{FrameRecord, total_work};

/// A part of a run and how long it took.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Phase {
    /// Name of what was done.
    pub phase: String,
    /// Wall time of the phase (s).
    pub seconds: f64,
}

impl Phase {
    /// The phase that began at `start` and ends now.
    pub fn since(phase: &str, start: Instant) -> Self {
        Self { phase: phase.into(), seconds: start.elapsed().as_secs_f64() }
    }
}

/// Time spent in the steps of all frames; steps of different frames overlap.
#[derive(Debug, Default)]
pub(crate) struct StepTimes {
    pub draw: Stopwatch,
    pub encode: Stopwatch,
    pub write: Stopwatch,
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
    phases: &[Phase],
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
        "phases": phases,
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
        "peak_memory_kib": peak_memory(),
    })
}

/// Largest resident memory of this process so far (KiB), where the system tells it.
pub fn peak_memory() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?.split_whitespace().next()?.parse().ok()
}
