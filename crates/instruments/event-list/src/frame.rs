//! A frame of the digital side, and instants of it.

use std::str::FromStr;

use generator::FrameError;
use landscape::Level;
use machine::{ControlPlane, DigitalEvent, FrameSweeps, MachineStage};
use quantities::{SweepTime, Tick, Timebase};
use scenario::Pose;
use serde_json::Value;

use crate::EventListError;
use crate::listing::document;

/// An instant of a frame: `TICK`, or `SWEEP:SAMPLE`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum At {
    /// A tick of the master clock since the start of the mission.
    Tick(Tick),
    /// A sample of a sweep, both from 0.
    Sample(u32, f64),
}

impl FromStr for At {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || format!("expected a tick, or sweep and sample as 500:412, not `{text}`");
        let Some((sweep, sample)) = text.split_once(':') else {
            return text.parse().map(|tick| Self::Tick(Tick(tick))).map_err(|_| wrong());
        };
        let sample: f64 = sample.parse().map_err(|_| wrong())?;
        match (sweep.parse(), sample.is_finite()) {
            (Ok(sweep), true) => Ok(Self::Sample(sweep, sample)),
            _ => Err(wrong()),
        }
    }
}

/// A frame whose digital side is looked at.
pub struct DigitalFrame<'a> {
    pub(crate) number: u64,
    pub(crate) timebase: Timebase,
    pub(crate) levels: &'a [Level],
    pub(crate) sweeps: FrameSweeps<'a>,
}

/// An instant of the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Instant {
    pub sweep: u32,
    pub time: SweepTime,
    pub tick: Tick,
}

impl<'a> DigitalFrame<'a> {
    /// Frame `number` of `control` on `stage`, seen from `pose`. `gates` says whether shadow gates are worked out, which
    /// takes longer than all else; without them there is no event of shadow boundaries.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn new(
        control: &'a ControlPlane,
        stage: &'a MachineStage,
        (number, pose): (u64, &Pose),
        gates: bool,
    ) -> Result<Self, FrameError> {
        let sweeps = match gates {
            true => control.sweeps_with_gates(number, pose),
            false => control.sweeps(number, pose),
        }?;
        let levels = stage.landscape.bank().levels();
        Ok(Self { number, timebase: stage.settings.timebase, levels, sweeps })
    }

    /// The sweeps of the frame.
    pub fn sweeps(&self) -> &FrameSweeps<'a> {
        &self.sweeps
    }

    /// An event of the frame as an object of the documents of schema `lunoid.trace/1`.
    pub fn event_json(&self, event: &DigitalEvent) -> Value {
        document(event, self.microseconds(event.tick))
    }

    /// When the digital side sees an instant of a sweep.
    pub(crate) fn tick(&self, sweep: u32, time: f64) -> Tick {
        self.timebase.sweep_clock(self.number, sweep).tick_at_or_after(SweepTime(time))
    }

    /// Returns the ticks at which the frame begins and ends.
    pub(crate) fn ticks(&self) -> [Tick; 2] {
        [self.tick(0, 0.0), self.tick(self.timebase.sweeps, 0.0)]
    }

    /// Time from the start of the frame (µs).
    pub(crate) fn microseconds(&self, tick: Tick) -> f64 {
        let start = self.timebase.sweep_clock(self.number, 0).instant_of(tick);
        start.0 * 1e6 / self.timebase.sample_rate().hertz()
    }

    pub(crate) fn instant(&self, at: At) -> Result<Instant, EventListError> {
        match at {
            At::Tick(tick) => self.of_tick(tick),
            At::Sample(sweep, sample) => self.of_sample(sweep, sample),
        }
    }

    fn of_tick(&self, tick: Tick) -> Result<Instant, EventListError> {
        let [start, end] = self.ticks();
        if tick < start || tick >= end {
            return Err(EventListError::OtherFrame { tick, frame: self.number, ticks: [start, end] });
        }
        let sweeps: Vec<u32> = (0..self.timebase.sweeps).collect();
        let sweep = sweeps.partition_point(|&sweep| self.tick(sweep, 0.0) <= tick) as u32 - 1;
        let time = self.timebase.sweep_clock(self.number, sweep).instant_of(tick);
        Ok(Instant { sweep, time, tick })
    }

    fn of_sample(&self, sweep: u32, sample: f64) -> Result<Instant, EventListError> {
        let Timebase { sweeps, active_samples, .. } = self.timebase;
        if sweep >= sweeps || !(0.0..f64::from(active_samples)).contains(&sample) {
            return Err(EventListError::BeyondSweeps { sweep, sample, sweeps, samples: active_samples });
        }
        Ok(Instant { sweep, time: SweepTime(sample), tick: self.tick(sweep, sample) })
    }
}

#[cfg(test)]
mod tests {
    use super::{At, Tick};

    #[test]
    fn instants() {
        assert_eq!("123".parse(), Ok(At::Tick(Tick(123))));
        assert_eq!("5:12.5".parse(), Ok(At::Sample(5, 12.5)));
        for wrong in ["", "1.5", "-1", "5:", ":5", "5:nan", "5:1:2", "a:b"] {
            assert!(wrong.parse::<At>().is_err(), "{wrong}");
        }
    }
}
