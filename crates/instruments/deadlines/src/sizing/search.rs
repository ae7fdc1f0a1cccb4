//! The slowest parts with which no tear shows.

use generator::FrameError;
use hardware_model::{CrossingServer, Loader};
use machine::MachineStage;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scenario::PoseRow;
use serde::Serialize;

use super::tear::TearLaw;
use crate::Rehearsal;
use crate::levels::drawn_levels;

/// What is made slower.
#[derive(Debug, Clone, Serialize)]
pub struct Search {
    /// Name of the searched value, ending in its unit.
    pub key: &'static str,
    /// What is made slower, in words.
    pub what: &'static str,
    /// The slowest with which no tear shows (master ticks); none if tears show even at 0.
    pub slowest_ticks: Option<u64>,
    /// The same in nanoseconds.
    pub slowest_ns: Option<f64>,
    /// Whether a whole sweep would not be too slow: the search ends there.
    pub any: bool,
    /// As it is in the model (ns).
    pub is_ns: Option<f64>,
}

/// Both searches of a model.
pub fn all(rehearsal: &Rehearsal, poses: &[PoseRow], law: &TearLaw) -> Result<Vec<Search>, FrameError> {
    let stage = &rehearsal.stage;
    let loader = &stage.settings.loader;
    let slower_access = |access: u64| Loader { access, ..loader.clone() };
    let whole_set = |access: u64| Loader {
        served_by: CrossingServer::WiredPointers,
        words_per_access: 9,
        access,
        pointer: 0,
        strobe: 0,
        ..loader.clone()
    };
    let ns = 1e9 / stage.settings.timebase.master.hertz();
    let run = |key, what, loader_of: &dyn Fn(u64) -> Loader, is_ns| {
        let limit = sweep_ticks(stage);
        let slowest_ticks = slowest(limit, |ticks| tears_show(rehearsal, poses, law, &loader_of(ticks)))?;
        let slowest_ns = slowest_ticks.map(|ticks| ticks as f64 * ns);
        Ok(Search { key, what, slowest_ticks, slowest_ns, any: slowest_ticks == Some(limit), is_ns })
    };
    let is_wired = loader.served_by == CrossingServer::WiredPointers;
    let set =
        u64::from(9_u32.div_ceil(loader.words_per_access)) * loader.access + loader.pointer + loader.strobe;
    [
        run(
            "loader.access_ns",
            "one access, all else as it is",
            &slower_access,
            Some(loader.access as f64 * ns),
        ),
        run("t_u", "a whole set in four banks", &whole_set, is_wired.then_some(set as f64 * ns)),
    ]
    .into_iter()
    .collect()
}

fn sweep_ticks(stage: &MachineStage) -> u64 {
    let timebase = &stage.settings.timebase;
    (timebase.ticks_per_sample() * f64::from(timebase.sweep_samples())) as u64
}

/// The largest of 0..=`limit` for which `fails` does not hold, if it holds from some number on; none if at once.
fn slowest<E>(limit: u64, fails: impl Fn(u64) -> Result<bool, E>) -> Result<Option<u64>, E> {
    if fails(0)? {
        return Ok(None);
    }
    let (mut good, mut bad) = (0, 1);
    while bad <= limit && !fails(bad)? {
        (good, bad) = (bad, 2 * bad);
    }
    if bad > limit && !fails(limit)? {
        return Ok(Some(limit));
    }
    bad = bad.min(limit);
    while bad - good > 1 {
        let middle = good + (bad - good) / 2;
        if fails(middle)? { bad = middle } else { good = middle }
    }
    Ok(Some(good))
}

/// Whether a tear shows in any sweep of the frames behind `loader`.
fn tears_show(
    rehearsal: &Rehearsal,
    poses: &[PoseRow],
    law: &TearLaw,
    loader: &Loader,
) -> Result<bool, FrameError> {
    let levels = drawn_levels(&rehearsal.stage);
    let sweeps = rehearsal.stage.settings.raster.sweeps;
    for row in poses {
        let frame = rehearsal.control.sweeps_behind(loader, row.frame, &row.pose)?;
        let is_torn = |sweep: u32| {
            let programs = frame.programs(sweep);
            levels.iter().any(|of| {
                let program = &programs[of.number];
                program.misses.iter().any(|miss| law.is_seen(miss, program, of.level, frame.table()))
            })
        };
        if (0..sweeps).into_par_iter().any(is_torn) {
            return Ok(true);
        }
    }
    Ok(false)
}

#[cfg(test)]
mod tests {
    use super::slowest;

    fn found(limit: u64, fails: impl Fn(u64) -> bool) -> Option<u64> {
        slowest(limit, |ticks| Ok::<_, ()>(fails(ticks))).unwrap()
    }

    #[test]
    fn the_last_that_does_is_found() {
        for last in 0..40 {
            assert_eq!(found(40, |ticks| ticks > last), Some(last));
        }
        assert_eq!(found(40, |_| false), Some(40));
        assert_eq!(found(40, |_| true), None);
        assert_eq!(found(0, |_| false), Some(0));
    }
}
