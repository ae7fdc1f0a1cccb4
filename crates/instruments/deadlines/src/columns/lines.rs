//! Lines of the timing record, by sweep, and from where in the sweep they can be seen.

use std::ops::RangeInclusive;

use quantities::{SweepTime, Timebase};
use sweep_generator::RangeTable;
use timing::{Deadline, FrameTiming, Missed};

/// The lines of one frame.
pub struct Lines<'a> {
    pub frame: u64,
    misses: &'a [Missed],
    /// Ground range of each miss from which on it can show (m).
    starts: Vec<f64>,
    /// The nearest of them, by sweep.
    nearest: Vec<Option<f64>>,
    /// Lines of no sweep: bodies of the whole frame.
    tasks: Vec<&'a Missed>,
    /// The sweep whose set-up each is drawn with.
    drawn: Vec<u32>,
}

impl<'a> Lines<'a> {
    /// The lines of a frame of `sweeps` sweeps.
    pub fn of(timing: &'a FrameTiming, table: &RangeTable, timebase: &Timebase, sweeps: u32) -> Self {
        let clock = |sweep| timebase.sweep_clock(timing.frame, sweep);
        let begins: Vec<u64> =
            (0..sweeps).map(|sweep| clock(sweep).tick_at_or_after(SweepTime(0.0)).0).collect();
        Self::new(timing.frame, &timing.misses, table, &begins, timebase.ticks_per_sample())
    }

    /// `misses` of frame `frame`, whose sweeps begin at the ticks `begins`.
    fn new(frame: u64, misses: &'a [Missed], table: &RangeTable, begins: &[u64], per_sample: f64) -> Self {
        let starts: Vec<f64> = misses.iter().map(|missed| start_of(missed, table)).collect();
        let mut nearest: Vec<Option<f64>> = vec![None; begins.len()];
        for (missed, &start) in misses.iter().zip(&starts).filter(|(missed, _)| is_of_a_sweep(missed)) {
            let nearest = &mut nearest[missed.sweep as usize];
            *nearest = Some(nearest.map_or(start, |known| known.min(start)));
        }
        let tasks = misses.iter().filter(|missed| !is_of_a_sweep(missed)).collect();
        Self { frame, misses, starts, nearest, tasks, drawn: drawn_with(misses, begins, per_sample) }
    }

    /// Whether a line of `sweep` begins by `reach` (m).
    pub fn reaches(&self, sweep: u32, reach: f64) -> bool {
        self.nearest[sweep as usize].is_some_and(|nearest| nearest <= reach)
    }

    /// Whether bodies were not ready for this frame.
    pub fn has_late_bodies(&self) -> bool {
        !self.tasks.is_empty()
    }

    /// Lines of bodies that were not ready.
    pub fn late_bodies(&self) -> impl Iterator<Item = &'a Missed> {
        self.tasks.iter().copied()
    }

    /// Lines of `sweep` that begin by `reach` (m), in the order of the record, with where they begin.
    pub fn of_sweep(&self, sweep: u32, reach: f64) -> impl Iterator<Item = (f64, &'a Missed)> {
        let misses = self.misses;
        let first = misses.partition_point(|missed| missed.sweep < sweep);
        let last = misses.partition_point(|missed| missed.sweep <= sweep);
        let ours = misses[first..last].iter().zip(&self.starts[first..last]);
        let begun = ours.filter(move |(missed, start)| is_of_a_sweep(missed) && **start <= reach);
        begun.map(|(missed, start)| (*start, missed))
    }

    /// The sweeps among `sweeps` that are drawn with another's set-up, with that other.
    pub fn drawn_otherwise(&self, sweeps: &RangeInclusive<u32>) -> Vec<[u32; 2]> {
        let pairs = sweeps.clone().map(|sweep| [sweep, self.drawn[sweep as usize]]);
        pairs.filter(|[sweep, drawn]| sweep != drawn).collect()
    }
}

fn is_of_a_sweep(missed: &Missed) -> bool {
    missed.deadline != Deadline::FRAME_TASKS
}

/// What comes too late shows from the fold that wanted it on; a set-up from the start of the sweep.
fn start_of(missed: &Missed, table: &RangeTable) -> f64 {
    match missed.deadline {
        Deadline::SWEEP_SET_UP | Deadline::FRAME_TASKS => 0.0,
        _ => missed.range_m.unwrap_or_else(|| table.range_at(SweepTime(missed.due))),
    }
}

/// A sweep is drawn with the last set-up that is made when it begins (docs of `dpu`): its own, or that of the last sweep
/// before whose set-up was in time, or late by no more than has gone by since. `begins` are the first ticks of the sweeps.
fn drawn_with(misses: &[Missed], begins: &[u64], per_sample: f64) -> Vec<u32> {
    let mut made: Vec<Option<u64>> = begins.iter().copied().map(Some).collect();
    for missed in misses.iter().filter(|missed| missed.deadline == Deadline::SWEEP_SET_UP) {
        let own = missed.sweep as usize;
        made[own] = missed.lateness().map(|late| begins[own] + (late * per_sample).round() as u64);
    }
    let last_made = |sweep: usize| {
        let is_made = |own: &usize| made[*own].is_some_and(|tick| tick <= begins[sweep]);
        (0..=sweep).rev().find(is_made).unwrap_or(0) as u32
    };
    (0..begins.len()).map(last_made).collect()
}

#[cfg(test)]
mod tests {
    use hardware_model::HardwareModel;
    use sweep_generator::RangeTable;
    use timing::{Cause, Deadline, Missed};

    use super::Lines;

    fn missed(deadline: Deadline, sweep: u32, range_m: Option<f64>, came: Option<f64>) -> Missed {
        Missed { range_m, came, ..Missed::of(deadline, sweep, Cause::Processor) }
    }

    #[test]
    fn a_line_shows_from_its_fold_on() {
        let table = RangeTable::new(&HardwareModel::ideal().range, 100);
        let misses = [
            missed(Deadline::TRANSFER, 1, Some(50.0), None),
            missed(Deadline::TRANSFER, 1, Some(300.0), None),
            missed(Deadline::FRAME_TASKS, 3, None, None),
        ];
        let lines = Lines::new(7, &misses, &table, &[0, 60, 120, 180], 0.5);
        assert!(lines.reaches(1, 50.0) && !lines.reaches(1, 49.0));
        assert!(!lines.reaches(0, f64::INFINITY) && !lines.reaches(3, f64::INFINITY));
        assert_eq!([lines.of_sweep(1, 100.0).count(), lines.of_sweep(1, 400.0).count()], [1, 2]);
        assert_eq!((lines.has_late_bodies(), lines.late_bodies().count()), (true, 1));
    }

    /// Sweeps of 60 ticks, two samples each: 1 comes a sweep and a half late, 2 is never set up, 3 comes a little late.
    #[test]
    fn a_late_set_up_leaves_the_last_that_is_made() {
        let table = RangeTable::new(&HardwareModel::ideal().range, 100);
        let set_up = |sweep, came| missed(Deadline::SWEEP_SET_UP, sweep, None, came);
        let misses = [set_up(1, Some(180.0)), set_up(2, None), set_up(3, Some(20.0))];
        let lines = Lines::new(7, &misses, &table, &[0, 60, 120, 180, 240], 0.5);
        assert_eq!(lines.drawn, [0, 0, 0, 1, 4]);
        assert_eq!(lines.drawn_otherwise(&(2..=4)), [[2, 0], [3, 1]]);
        assert!(lines.reaches(2, 0.0));
    }
}
