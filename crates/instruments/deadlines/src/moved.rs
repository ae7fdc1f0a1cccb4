//! The first event in which two runs of a mission differ.

use event_list::told;
use machine::DigitalEvent;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use timing::MovedEvent;

use crate::{DeadlineError, Rehearsal};

/// The first event of `frames`, ascending, that `found` has not where `baseline` has it, with its ticks in both: those of the frame
/// first, then sweep by sweep. Slack is not asked: it follows from what moved.
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
    let (baseline, found) = (&baseline[first..], &found[first..]);
    let tick = |event: &Option<&DigitalEvent>| event.map_or(i64::MAX, |event| event.tick.0 as i64);
    let ours = baseline.first().map(|event| [Some(event), same_event(found, event)]);
    let theirs = found.first().map(|event| [same_event(baseline, event), Some(event)]);
    // Of the two that stand first, the earlier one moved; one that is there at the same tick did not.
    let moved = ours.into_iter().chain(theirs);
    let [before, after] = moved.min_by_key(|pair| {
        let [before, after] = pair.each_ref().map(tick);
        (before == after, before.min(after))
    })?;
    Some(MovedEvent { frame, sweep, baseline: before.map(told), found: after.map(told) })
}

/// The first of some events that is `event` but for its tick.
fn same_event<'a>(events: &'a [DigitalEvent], event: &DigitalEvent) -> Option<&'a DigitalEvent> {
    events.iter().find(|other| DigitalEvent { tick: event.tick, ..**other } == *event)
}

#[cfg(test)]
mod tests {
    use machine::{DigitalEvent, DigitalUnit, EventWord};
    use quantities::Tick;

    use super::differing;

    fn event(tick: u64, event: EventWord) -> DigitalEvent {
        DigitalEvent::new(Tick(tick), event, DigitalUnit::Cpu)
    }

    /// One event is told with both of its ticks, whatever stands in its place in the other list.
    #[test]
    fn an_event_that_moved_is_told_with_its_new_tick() {
        use EventWord::{Access, Load, SetUp, SetUpBegins, Stop};
        for (baseline, found, ticks) in [
            // Later than another event now, and earlier than it.
            (
                vec![(1, Stop), (2, Load), (3, Access)],
                vec![(1, Stop), (3, Access), (4, Load)],
                [Some(2), Some(4)],
            ),
            (
                vec![(1, Stop), (3, Access), (4, Load)],
                vec![(1, Stop), (2, Load), (3, Access)],
                [Some(4), Some(2)],
            ),
            // Beside one of the same tick that stays.
            (vec![(0, SetUpBegins), (0, SetUp)], vec![(0, SetUpBegins), (5, SetUp)], [Some(0), Some(5)]),
            (vec![(0, SetUpBegins), (3, SetUp)], vec![(0, SetUp), (0, SetUpBegins)], [Some(3), Some(0)]),
            // Both moved: the earlier of all.
            (vec![(2, Load), (5, Access)], vec![(1, Access), (6, Load)], [Some(5), Some(1)]),
            // There in one alone.
            (vec![(1, Stop), (2, Load)], vec![(1, Stop)], [Some(2), None]),
            (vec![(2, Load)], vec![(1, Stop), (2, Load)], [None, Some(1)]),
        ] {
            let list = |events: &[(u64, EventWord)]| {
                events.iter().map(|(tick, word)| event(*tick, *word)).collect::<Vec<_>>()
            };
            let moved = differing([list(&baseline), list(&found)], 0, None).expect("they differ");
            let words = [&moved.baseline, &moved.found].map(Option::as_ref);
            for (told, tick) in words.into_iter().zip(ticks) {
                assert_eq!(told.is_some(), tick.is_some(), "{moved:?}");
                let (Some(told), Some(tick)) = (told, tick) else { continue };
                assert!(told.starts_with(&format!("tick {tick}:")), "{told}: expected tick {tick}");
            }
        }
        let same = vec![event(1, Stop)];
        assert_eq!(differing([same.clone(), same], 0, None), None);
    }
}
