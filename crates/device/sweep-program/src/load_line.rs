//! Words of craters and of shadow boundaries on their way to the parts that wait for them (hardware section 3.7).

use quantities::{SweepClock, SweepTime, Tick, Timebase};

use crate::MissCause;

/// The line over which loads of one kind come, one after another, from the retrace before a sweep on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadLine {
    clock: SweepClock,
    /// Ticks of one load.
    ticks: u64,
    free_at: Tick,
    busy: u64,
}

/// When the words of one sweep's loads come, and what happens if they are late.
#[derive(Debug, Clone, Copy)]
pub struct LoadTiming<T, R> {
    /// The line on which they come.
    pub line: LoadLine,
    /// Whether late words act from when they come; else not in this sweep.
    pub strobes_through: bool,
    /// When the sweep passes a ground range (m).
    pub time_of: T,
    /// Ground range at an instant (m).
    pub range_at: R,
    /// Number of the load whose words are taken as in time whenever they come; none in the machine as it is.
    pub on_time: Option<u32>,
}

/// No timing: loads take no time.
pub type NoTiming = LoadTiming<fn(f64) -> SweepTime, fn(SweepTime) -> f64>;

impl<T: Fn(f64) -> SweepTime, R: Fn(SweepTime) -> f64> LoadTiming<T, R> {
    /// The load of this number in the sweep, into a part that is free from ground range `free` on, wanted at `due`; words that could
    /// not set out before `end` do not (m). A load that is to be on time takes the line for as long as it does late.
    pub fn load(&mut self, number: u32, [free, due, end]: [f64; 3]) -> TimedLoad {
        let timed = self.brought(free, due, end);
        match self.on_time == Some(number) {
            true => TimedLoad { slack: timed.slack.max(0), ..timed },
            false => timed,
        }
    }

    /// What the line makes of a load.
    fn brought(&mut self, free: f64, due: f64, end: f64) -> TimedLoad {
        // A part that was never used is free before all time.
        let instant = |range: f64| match range {
            f64::NEG_INFINITY => SweepTime(range),
            range => (self.time_of)(range),
        };
        let [free, due, end] = [free, due, end].map(instant);
        match self.line.load(free, due, end) {
            Some(Loaded { arrival, slack, cause }) => {
                let range = (self.range_at)(arrival);
                TimedLoad { due, arrival: Some(arrival), range, slack, cause }
            }
            None => {
                let slack = self.line.never(due, end);
                TimedLoad { due, arrival: None, range: f64::INFINITY, slack, cause: MissCause::Queue }
            }
        }
    }
}

/// What became of a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimedLoad {
    /// When it was wanted.
    pub due: SweepTime,
    /// When its last word came; none if it was given up.
    pub arrival: Option<SweepTime>,
    /// Ground range then (m); infinite if it was given up.
    pub range: f64,
    /// Ticks before its time; below 0 it is late.
    pub slack: i64,
    /// What held it up.
    pub cause: MissCause,
}

/// A load that has come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Loaded {
    /// When its last word came, on the sweep clock.
    pub arrival: SweepTime,
    /// Ticks from its last word to the last one that is not after its time; below 0 it is late.
    pub slack: i64,
    /// What held it up.
    pub cause: MissCause,
}

impl LoadLine {
    /// The line of sweep `sweep` of frame `frame`, with loads of `words` words at `rate` words a second: whole ticks.
    pub fn new(timebase: &Timebase, (frame, sweep): (u64, u32), words: u32, rate: f64) -> Self {
        let clock = timebase.sweep_clock(frame, sweep);
        let ticks = f64::from(words) * timebase.master.hertz() / rate;
        // As times of a model are rounded: a last bit makes no tick.
        let ticks = (ticks - 1e-9 * ticks).ceil() as u64;
        let retrace = SweepTime(-f64::from(timebase.retrace_samples));
        Self { clock, ticks, free_at: clock.tick_at_or_after(retrace), busy: 0 }
    }

    /// One load into a part that is free at `from`, wanted at `due`; `None` if it could not even begin before `end`, when
    /// nobody waits for it any more.
    pub fn load(&mut self, from: SweepTime, due: SweepTime, end: SweepTime) -> Option<Loaded> {
        let part = self.clock.tick_at_or_after(from);
        let begin = part.max(self.free_at);
        if self.clock.instant_of(begin) >= end {
            return None;
        }
        let cause = if self.free_at > part { MissCause::Queue } else { MissCause::Access };
        self.free_at = Tick(begin.0 + self.ticks);
        self.busy += self.ticks;
        let arrival = self.clock.instant_of(self.free_at);
        Some(Loaded { arrival, slack: slack(&self.clock, due, self.free_at), cause })
    }

    /// Slack of a load that was given up at `end`: it counts with the instant at which that was.
    fn never(&self, due: SweepTime, end: SweepTime) -> i64 {
        slack(&self.clock, due, self.clock.tick_at_or_after(end)).min(-1)
    }

    /// Ticks of all loads.
    pub fn busy(&self) -> u64 {
        self.busy
    }
}

/// Ticks from `ready` to the last tick that is not after `due`; below 0 it is late. Before the mission, which begins at tick
/// 0, nothing is due.
#[inline]
pub fn slack(clock: &SweepClock, due: SweepTime, ready: Tick) -> i64 {
    last_tick(clock, due, clock.tick_at_or_after(due)).0 as i64 - ready.0 as i64
}

/// The last tick that is not after `due`, where `seen` is the first that is not before it; at least tick 0.
#[inline]
pub fn last_tick(clock: &SweepClock, due: SweepTime, seen: Tick) -> Tick {
    let after = u64::from(clock.instant_of(seen) > due);
    Tick(seen.0.saturating_sub(after))
}

#[cfg(test)]
mod tests {
    use super::{LoadLine, LoadTiming, slack};
    use crate::MissCause;
    use quantities::{Rate, SweepTime, Tick, Timebase};

    /// Ten ticks a sample, a retrace of ten samples, and loads of 8 words that take 40 ticks.
    fn line() -> LoadLine {
        let rate = |hertz| Rate::new(hertz, 1).unwrap();
        let timebase = Timebase::new(rate(10_000), rate(1), 9, 90, 20).unwrap();
        assert!((timebase.ticks_per_sample() - 10_000.0 / 990.0).abs() < 1e-12);
        LoadLine::new(&timebase, (3, 4), 8, 2000.0)
    }

    /// Lockstep found it: a fold before the first sample of the mission was told as late by a tick, of words that are always
    /// there. In any later sweep the tick before it counts.
    #[test]
    fn nothing_is_due_before_the_mission() {
        let rate = |hertz| Rate::new(hertz, 1).unwrap();
        let timebase = Timebase::new(rate(10_000), rate(1), 9, 90, 20).unwrap();
        let early = SweepTime(-0.05);
        assert_eq!(slack(&timebase.sweep_clock(0, 0), early, Tick(0)), 0);
        // 110 samples of 10.1 ticks a sweep: sweep 1 begins at tick 1111.1, and early is half a tick before.
        let second = timebase.sweep_clock(0, 1);
        assert_eq!([1110, 1111].map(|ready| slack(&second, early, Tick(ready))), [0, -1]);
    }

    /// Loads of 40 ticks from 20 samples before the first, all wanted two samples later: all are late, and the last could not even set
    /// out.
    #[test]
    fn a_load_that_is_to_be_on_time_is_and_no_other_moves() {
        let loads = |on_time: Option<u32>| {
            let (time_of, range_at) = (SweepTime, |SweepTime(time): SweepTime| time);
            let mut timing = LoadTiming { line: line(), strobes_through: true, time_of, range_at, on_time };
            let ends = [f64::NEG_INFINITY, -18.0, 80.0];
            let mut all: Vec<_> = (0..3).map(|number| timing.load(number, ends)).collect();
            all.push(timing.load(3, [f64::NEG_INFINITY, -18.0, -9.0]));
            (all, timing.line.busy())
        };
        let (as_it_is, busy) = loads(None);
        let late: Vec<bool> = as_it_is.iter().map(|load| load.slack < 0).collect();
        assert_eq!(late, [true; 4]);
        assert!(as_it_is[3].arrival.is_none());
        for number in 0..4 {
            let (again, busy_again) = loads(Some(number));
            assert_eq!(busy_again, busy);
            for (index, (before, after)) in as_it_is.iter().zip(&again).enumerate() {
                let slack = if index == number as usize { 0 } else { before.slack };
                assert_eq!((after.arrival, after.slack), (before.arrival, slack), "{number}: {index}");
            }
        }
    }

    #[test]
    fn loads_come_one_after_another_from_the_retrace_on() {
        let mut line = line();
        let (always, end) = (SweepTime(f64::NEG_INFINITY), SweepTime(80.0));
        let samples = 990.0 / 10_000.0;
        let first = line.load(always, SweepTime(0.0), end).unwrap();
        let second = line.load(always, SweepTime(0.0), end).unwrap();
        assert!((first.arrival.0 + 20.0 - 40.0 * samples).abs() < samples, "{first:?}");
        assert!((second.arrival.0 - first.arrival.0 - 40.0 * samples).abs() < 1e-9);
        assert_eq!((first.slack - second.slack, second.cause), (40, MissCause::Queue));
        // A part that is free later only is waited for.
        let third = line.load(SweepTime(50.0), SweepTime(51.0), end).unwrap();
        assert_eq!(third.cause, MissCause::Access);
        assert!(third.slack < 0 && third.arrival.0 > 53.9, "{third:?}");
        assert_eq!((line.load(always, SweepTime(60.0), SweepTime(52.0)), line.busy()), (None, 120));
    }
}
