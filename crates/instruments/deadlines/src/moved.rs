//! The first event in which two runs of a mission differ.

use event_list::told;
use machine::DigitalEvent;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use timing::MovedEvent;

use crate::{DeadlineError, Rehearsal};

/// The first event of `frames`, ascending, that `found` has not where `baseline` has it: those of the frame first, then sweep
/// by sweep. Slack is not asked: it follows from what moved.
///
/// # Errors
/// If a frame cannot be drawn.
pub fn first_moved(
    baseline: &Rehearsal,
    found: &Rehearsal,
    frames: &[u64],
) -> Result<Option<MovedEvent>, DeadlineError> {
    let poses = [baseline.poses(frames)?, found.poses(frames)?];
    for (index, &frame) in frames.iter().enumerate() {
        let [ours, theirs] = [
            baseline.control.sweeps_with_gates(frame, &poses[0][index].pose)?,
            found.control.sweeps_with_gates(frame, &poses[1][index].pose)?,
        ];
        if let Some(moved) = differing([ours.frame_events(), theirs.frame_events()], frame, None) {
            return Ok(Some(moved));
        }
        let count = [baseline, found].map(|rehearsal| rehearsal.stage.settings.raster.sweeps);
        let of_sweep = |sweep: u32| {
            let events = |of: &machine::FrameSweeps<'_>, there: u32| {
                if sweep < there { of.events(sweep) } else { Vec::new() }
            };
            differing([events(&ours, count[0]), events(&theirs, count[1])], frame, Some(sweep))
        };
        let sweeps = 0..count[0].max(count[1]);
        let moved = found.pool.install(|| sweeps.into_par_iter().find_map_first(of_sweep));
        if moved.is_some() {
            return Ok(moved);
        }
    }
    Ok(None)
}

fn differing(mut lists: [Vec<DigitalEvent>; 2], frame: u64, sweep: Option<u32>) -> Option<MovedEvent> {
    for list in &mut lists {
        list.sort_by_key(|event| event.tick);
        list.iter_mut().for_each(|event| event.slack = None);
    }
    let [baseline, found] = &lists;
    let first = (0..baseline.len().max(found.len())).find(|&k| baseline.get(k) != found.get(k))?;
    let event = |list: &[DigitalEvent]| list.get(first).map(told);
    Some(MovedEvent { frame, sweep, baseline: event(baseline), found: event(found) })
}
