//! What a unit is at over a sweep, from stretches of ticks.

use std::ops::Range;

use quantities::{SweepClock, SweepTime, Tick};

use crate::stage::MachineStage;
use crate::waveforms::Changes;

/// A sweep on the master clock, retrace included.
#[derive(Debug, Clone)]
pub(crate) struct SweepTicks {
    clock: SweepClock,
    /// Master ticks from the start of the sweep to the start of the next sweep.
    pub(crate) ticks: Range<u64>,
}

impl SweepTicks {
    /// Sweep `sweep` of frame `frame`.
    pub(crate) fn new(stage: &MachineStage, frame: u64, sweep: u32) -> Self {
        let timebase = &stage.settings.timebase;
        let clock = timebase.sweep_clock(frame, sweep);
        let tick = |time: f64| clock.tick_at_or_after(SweepTime(time)).0;
        Self { ticks: tick(0.0)..tick(f64::from(timebase.sweep_samples())), clock }
    }

    /// A tick on the clock of the sweep (samples).
    pub(crate) fn at(&self, tick: u64) -> f64 {
        self.clock.instant_of(Tick(tick)).0
    }

    /// A value that each stretch of ticks has, in order of time; `idle` between them.
    pub(crate) fn held(&self, stretches: impl IntoIterator<Item = (Range<u64>, f64)>, idle: f64) -> Changes {
        let mut changes = Changes::default();
        changes.becomes(0.0, idle);
        for (stretch, value) in stretches {
            let [from, until] =
                [stretch.start, stretch.end].map(|tick| tick.clamp(self.ticks.start, self.ticks.end));
            if from < until {
                changes.becomes(self.since(from), value);
                if until < self.ticks.end {
                    changes.becomes(self.since(until), idle);
                }
            }
        }
        changes
    }

    /// When a state holds that is there from a tick on: what is there at the first one is there as the sweep begins.
    fn since(&self, tick: u64) -> f64 {
        if tick == self.ticks.start { 0.0 } else { self.at(tick) }
    }
}

#[cfg(test)]
mod tests {
    use quantities::{Rate, Timebase};

    use super::SweepTicks;

    /// Ten ticks a sample, 90 samples and ten of retrace.
    fn sweep() -> SweepTicks {
        let rate = |hertz| Rate::new(hertz, 1).unwrap();
        let timebase = Timebase::new(rate(10_000), rate(1), 10, 90, 10).unwrap();
        SweepTicks { clock: timebase.sweep_clock(0, 1), ticks: 1000..2000 }
    }

    #[test]
    fn stretches_are_told_within_the_sweep_and_side_by_side() {
        let stretches =
            [(500..1200, 1.0), (1200..1300, 2.0), (1300..1300, 3.0), (1900..2500, 4.0), (2600..2700, 5.0)];
        let changes = sweep().held(stretches, -1.0);
        assert_eq!(changes.times, [0.0, 20.0, 30.0, 90.0]);
        assert_eq!(changes.values, [1.0, 2.0, -1.0, 4.0]);
        assert_eq!(sweep().held([], 7.0).values, [7.0]);
        // What ends with the sweep before it is not told.
        assert_eq!(sweep().held([(900..1000, 1.0)], 0.0).values, [0.0]);
    }
}
