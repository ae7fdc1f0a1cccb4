//! Economy: what a scene does not need, what leaving it out saves, and the waste that remains.
//!
//! **Law.** The machine is prepared several times for one stage: as it runs, without anything that changes a bit, with one
//! thing that has no work running all the same, and with all of them. Frames of all these are timed in turn, and those
//! that claim to be equal have one hash. What remains is counted from the signals of every sweep.

mod left_out;
mod sample;
mod waste;

use std::time::Instant;

use blake3::Hasher;
use control_plane::MachineStage;
use generator::{FrameCounts, PlaneKind, Planes, Session};
use hardware_model::{Economy, Forced};
use machine::Prepare;
use serde::Serialize;
use signal::Probe;

use crate::figures::Sum;
use crate::work::spread;
use crate::{StudyError, Subject};

pub use left_out::{LeftOut, Level, left_out};
pub use waste::{Waste, waste};

/// A machine of one economy, and what its frames took.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ModeOutcome {
    /// Name of the economy.
    pub name: String,
    /// Median, smallest and largest time (s a frame).
    pub time_s: [f64; 3],
    /// Least processor time of all threads (s a frame): other programs disturb it less. None where the system does not tell
    /// it, or counts it too coarsely to see frames as short as these.
    pub cpu_s: Option<f64>,
    /// BLAKE3 of the intensities of all frames, bit by bit.
    pub blake3: String,
    /// Whether it claims the bits of `lossless`.
    pub claims_equal: bool,
    /// Root of the mean squared difference of linear intensity from `lossless`, and the largest.
    pub off: [f64; 2],
}

/// What came of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EconomyOutcome {
    /// What is left out, level by level.
    pub left_out: Vec<LeftOut>,
    /// Machines of each economy; `lossless` comes second.
    pub modes: Vec<ModeOutcome>,
    /// What is computed and touches nothing.
    pub waste: Vec<Waste>,
}

impl EconomyOutcome {
    /// Whether every machine that claims it has the bits of `lossless`.
    pub fn holds(&self) -> bool {
        let lossless = &self.modes[LOSSLESS].blake3;
        self.modes.iter().all(|mode| !mode.claims_equal || mode.blake3 == *lossless)
    }
}

const LOSSLESS: usize = 1;

/// Studies the economy of `subject`; each frame is timed `repetitions` times by the threads of the current pool. `hear` is
/// told what is being done.
///
/// # Errors
/// If a frame cannot be drawn.
pub fn economy(
    subject: &Subject,
    repetitions: u32,
    hear: &mut dyn FnMut(&str),
) -> Result<EconomyOutcome, StudyError> {
    let mut modes = modes(&subject.stage)?;
    for turn in 0..=repetitions {
        hear(if turn == 0 { "pictures" } else { "times" });
        // The first turn is not timed: it warms up, and leaves the pictures.
        modes.iter_mut().try_for_each(|mode| mode.run(subject, turn > 0))?;
    }
    hear("what remains");
    let as_it_runs = &modes[0];
    let waste = waste(subject, &*as_it_runs.session)?;
    Ok(EconomyOutcome {
        left_out: left_out(&subject.stage, &*as_it_runs.session, &as_it_runs.counts, &waste),
        waste: waste.rows(),
        modes: modes.iter().map(|mode| mode.outcome(&modes[LOSSLESS])).collect(),
    })
}

struct Mode {
    name: String,
    claims_equal: bool,
    session: Box<dyn Session>,
    pictures: Vec<Vec<f32>>,
    counts: FrameCounts,
    times: Vec<f64>,
    processor: Vec<f64>,
}

fn modes(stage: &MachineStage) -> Result<Vec<Mode>, StudyError> {
    let forced = Forced::ALL.map(|forced| (forced.name(), Economy::LosslessBut(forced)));
    let whole = [("bounded", Economy::Bounded), ("lossless", Economy::Lossless)];
    let last = [("everything", Economy::Everything), ("preview", Economy::Instants(1))];
    let all = whole.into_iter().chain(forced).chain(last);
    let mode = |(name, economy): (&str, Economy)| {
        let mut stage = stage.clone();
        stage.settings.economy = economy;
        Ok(Mode {
            name: match economy {
                Economy::LosslessBut(_) => format!("lossless, but {name} runs"),
                _ => name.to_owned(),
            },
            claims_equal: !matches!(economy, Economy::Bounded | Economy::Instants(_)),
            session: stage.prepare(),
            pictures: Vec::new(),
            counts: FrameCounts::default(),
            times: Vec::new(),
            processor: Vec::new(),
        })
    };
    all.map(mode).collect()
}

impl Mode {
    fn run(&mut self, subject: &Subject, is_timed: bool) -> Result<(), StudyError> {
        let raster = subject.stage.settings.raster;
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &[PlaneKind::Intensity]);
        let (mut seconds, processor) = (0.0, processor_time());
        for (frame, pose) in &subject.frames {
            let start = Instant::now();
            let counts = self.session.frame(*frame, pose, &mut planes, &mut Probe::off())?;
            seconds += start.elapsed().as_secs_f64();
            if !is_timed {
                self.counts.join(&counts, machine::COUNTERS);
                self.pictures.push(planes.get(PlaneKind::Intensity).unwrap_or_default().to_vec());
            }
        }
        if is_timed {
            let frames = subject.frames.len() as f64;
            self.times.push(seconds / frames);
            let spent = processor_time().zip(processor).map(|(now, before)| (now - before) / frames);
            self.processor.extend(spent);
        }
        Ok(())
    }

    fn outcome(&self, lossless: &Self) -> ModeOutcome {
        let mut off = Sum::default();
        let pixels = self.pictures.iter().flatten().zip(lossless.pictures.iter().flatten());
        pixels.for_each(|(a, b)| off.add(f64::from(*a) - f64::from(*b)));
        ModeOutcome {
            name: self.name.clone(),
            time_s: spread(&self.times),
            cpu_s: least_seen(&self.processor),
            blake3: hash(&self.pictures),
            claims_equal: self.claims_equal,
            off: [off.rms(), off.max()],
        }
    }
}

/// The least of processor times; none if the counter did not move, which says no more than that it is coarse.
fn least_seen(times: &[f64]) -> Option<f64> {
    times.iter().copied().reduce(f64::min).filter(|&least| least > 0.0)
}

/// Processor time of all threads of this process so far (s), where the system tells it.
fn processor_time() -> Option<f64> {
    let of_thread = |entry: std::io::Result<std::fs::DirEntry>| -> Option<f64> {
        let text = std::fs::read_to_string(entry.ok()?.path().join("schedstat")).ok()?;
        text.split_whitespace().next()?.parse().ok()
    };
    let threads = std::fs::read_dir("/proc/self/task").ok()?;
    threads.map(of_thread).sum::<Option<f64>>().map(|nanoseconds| 1e-9 * nanoseconds)
}

fn hash(pictures: &[Vec<f32>]) -> String {
    let mut hasher = Hasher::new();
    for value in pictures.iter().flatten() {
        hasher.update(&value.to_bits().to_le_bytes());
    }
    hasher.finalize().to_hex().to_string()
}

#[cfg(test)]
mod tests {
    use super::least_seen;

    #[test]
    fn a_counter_that_stands_still_measures_nothing() {
        assert_eq!(least_seen(&[3e-4, 2e-4]), Some(2e-4));
        assert_eq!([least_seen(&[0.0, 2e-4]), least_seen(&[])], [None, None]);
    }
}
