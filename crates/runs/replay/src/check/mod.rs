//! Random sweeps of a run against `exact`.
//!
//! **Sample.** `N` sweeps, one from each of `N` equal parts of the run's sweeps in the order of time, drawn by a hash of the
//! run's fingerprint: spread over the frames, and the same ones whenever and however often the run is resumed.
//! **Compared.** The signals of the sweep with the ground straight below it, sample by sample inside the problem area,
//! and the column of the picture at the sweep's place, as the file holds it, with the same column by `exact`, encoded
//! alike. Where pitch or the yoke turns the sweeps in the picture that column is of several sweeps.

mod interval;
mod sweep;

use std::sync::atomic::{AtomicBool, Ordering};

use exact::Columns;
use generator::Session;
use picture::{Encoder, Transfer};
use quantities::hash_words;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scenario::PoseTable;

use crate::{Job, ReplayError, RunFolder};
use interval::{CONFIDENCE, RESAMPLES, interval};
use run_record::{CheckRecord, CheckedSweep, ErrorRecord, FrameRecord};
use sweep::{NAMES, max_of, square_of};

/// What a check looks at.
pub(crate) struct Check<'a> {
    pub job: &'a Job<'a>,
    pub session: &'a dyn Session,
    pub folder: &'a RunFolder,
    pub poses: &'a PoseTable,
    /// Frames of the run, ascending without a gap.
    pub frames: &'a [FrameRecord],
    pub fingerprint: &'a str,
    pub cancel: &'a AtomicBool,
}

/// Refuses to check more sweeps than a run of so many frames has.
pub fn expect_available(job: &Job, frames: u64) -> Result<(), ReplayError> {
    let (asked, available) = (job.check, available(job, frames));
    if u64::from(asked) > available { Err(ReplayError::TooManyChecks { asked, available }) } else { Ok(()) }
}

/// Sweeps of so many frames.
fn available(job: &Job, frames: u64) -> u64 {
    frames * u64::from(sweeps(job))
}

/// Sweeps of a frame; 0 of a generator without signals.
fn sweeps(job: &Job) -> u32 {
    job.generator.scan(&job.stage.view).map_or(0, |scan| scan.timebase.sweeps)
}

impl Check<'_> {
    /// Checks `count` sweeps; `None` if told to end. The threads of the current pool share the sweeps.
    pub fn run(&self, count: u32) -> Result<Option<CheckRecord>, ReplayError> {
        let view = &self.job.stage.view;
        let available = available(self.job, self.frames.len() as u64);
        let display = &view.display;
        let transfer =
            Transfer::new(display.white as f32, display.gamma as f32).map_err(ReplayError::Display)?;
        let bench = sweep::Bench {
            session: self.session,
            exact: Columns::new(self.job.stage.clone()),
            encoder: Encoder::new(transfer, self.job.pictures.depth),
            size: [view.columns as usize, view.lines as usize],
            sweeps: sweeps(self.job),
            folder: self.folder.path(),
        };
        let seed = seed(self.fingerprint);
        let sweeps = u64::from(sweeps(self.job));
        let one = |index: u64| {
            if self.cancel.load(Ordering::Relaxed) {
                return Ok(None);
            }
            let place = place(seed, index, u64::from(count), available);
            let (frame, sweep) = ((place / sweeps) as usize, (place % sweeps) as u32);
            bench.sweep(&self.frames[frame], &self.poses.rows()[frame].pose, sweep).map(Some)
        };
        let checked: Result<Vec<_>, ReplayError> = (0..u64::from(count)).into_par_iter().map(one).collect();
        let checked: Option<Vec<CheckedSweep>> = checked?.into_iter().collect();
        Ok(checked.map(|checked| record(seed, count, checked)))
    }
}

fn record(seed: u64, count: u32, checked: Vec<CheckedSweep>) -> CheckRecord {
    let error = |(index, &(error, unit)): (usize, &(&'static str, &'static str))| {
        let squares: Vec<f64> = checked.iter().filter_map(|sweep| square_of(sweep, index)).collect();
        (!squares.is_empty()).then(|| ErrorRecord {
            error: error.into(),
            unit: unit.into(),
            rms: (squares.iter().sum::<f64>() / squares.len() as f64).sqrt(),
            interval: interval(seed, &squares).map(|ends| ends.map(f64::sqrt)),
            max: checked.iter().filter_map(|sweep| max_of(sweep, index)).fold(0.0, f64::max),
        })
    };
    CheckRecord {
        against: registry::judge().name.into(),
        sweeps: count,
        confidence: CONFIDENCE,
        interval_by: format!("bootstrap over the sweeps, {RESAMPLES} resamples"),
        errors: NAMES.iter().enumerate().filter_map(error).collect(),
        checked,
    }
}

/// The first 64 bits of a fingerprint.
fn seed(fingerprint: &str) -> u64 {
    fingerprint.get(..16).and_then(|digits| u64::from_str_radix(digits, 16).ok()).unwrap_or_default()
}

/// Place in the run of check `index` of `count`, among `available`.
fn place(seed: u64, index: u64, count: u64, available: u64) -> u64 {
    let part = |index: u64| (u128::from(index) * u128::from(available) / u128::from(count)) as u64;
    let (from, to) = (part(index), part(index + 1));
    from + hash_words(seed, &[index]) % (to - from)
}

#[cfg(test)]
mod tests {
    use super::{place, seed};

    #[test]
    fn places_are_different_and_in_their_parts() {
        let seed = seed("00000000000000ff0123");
        assert_eq!(seed, 255);
        for (count, available) in [(1, 1), (7, 7), (20, 480), (33, 40)] {
            let places: Vec<u64> = (0..count).map(|index| place(seed, index, count, available)).collect();
            assert!(places.windows(2).all(|pair| pair[0] < pair[1]), "{places:?}");
            assert!(places.iter().all(|place| *place < available), "{places:?}");
        }
        let other = |seed| (0..20).map(|index| place(seed, index, 20, 480)).collect::<Vec<_>>();
        assert_ne!(other(1), other(2));
    }
}
