//! Places of a mission, and steps from one to another.

use std::fmt;

use quantities::{SweepTime, Tick, Timebase};
use serde::{Deserialize, Serialize};

/// A place of a mission: the start of a sweep, and the way gone in it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Place {
    /// Frame, from 0, counted at the update rate.
    pub frame: u64,
    /// Sweep of the frame, from 0 at the left.
    pub sweep: u32,
    /// How far the machine has gone in the sweep.
    pub gone: Gone,
}

/// The way gone in a sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Gone {
    /// The sweep begins: its first sample, and the first tick that sees it.
    Nothing,
    /// Ticks of the master clock since the first one of the sweep; 1 or more.
    Ticks(u64),
    /// Samples since the first one; 1 or more, and less than a sweep draws.
    Samples(u32),
}

impl Place {
    /// The start of a sweep.
    pub fn start(frame: u64, sweep: u32) -> Self {
        Self { frame, sweep, gone: Gone::Nothing }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "frame {}, sweep {}", self.frame, self.sweep)?;
        match self.gone {
            Gone::Nothing => f.write_str(", start"),
            Gone::Ticks(ticks) => write!(f, ", {ticks} ticks on"),
            Gone::Samples(samples) => write!(f, ", sample {samples}"),
        }
    }
}

/// What is stepped by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// Ticks of the master clock.
    Tick,
    /// Ticks at which something happens on the digital side, or a sweep begins.
    Event,
    /// Samples that are drawn.
    Sample,
    /// Starts of the sweeps.
    Sweep,
    /// Starts of the same sweep in other frames.
    Frame,
}

/// Why there is no such place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum PlaceError {
    /// A step would lead to before the mission.
    #[error("this leads to before the start of frame 0, where the mission begins; step less far back")]
    Before,
    /// A step would lead to behind the mission.
    #[error("this leads to behind the end of frame {last}, the last of the mission; step less far")]
    Behind {
        /// Last frame of the mission.
        last: u64,
    },
    /// The mission has no such frame.
    #[error("frame {frame}: the mission has frames 0..{frames}; expected one of them")]
    Frame {
        /// Frame that was named.
        frame: u64,
        /// Frames of the mission.
        frames: u64,
    },
    /// A frame has no such sweep.
    #[error("sweep {sweep}: a frame has sweeps 0..{sweeps}; expected one of them")]
    Sweep {
        /// Sweep that was named.
        sweep: u32,
        /// Sweeps of a frame.
        sweeps: u32,
    },
    /// The sweep is not so long.
    #[error(
        "{gone} {unit} in a sweep: this sweep has {unit} 1..{end} behind its start; expected one of them"
    )]
    Gone {
        /// Way that was named.
        gone: u64,
        /// What is counted: "ticks" or "samples".
        unit: &'static str,
        /// The first number that is too large.
        end: u64,
    },
}

/// The clocks of a mission as places go by them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Clock {
    timebase: Timebase,
    frames: u64,
}

impl Clock {
    /// The clock of a mission of `frames` frames, at least one.
    pub fn new(timebase: Timebase, frames: u64) -> Self {
        Self { timebase, frames }
    }

    /// Frames of the mission.
    pub fn frames(&self) -> u64 {
        self.frames
    }

    /// Refuses a place that the mission does not have.
    ///
    /// # Errors
    /// Which part of the place is beyond what.
    pub fn expect(&self, place: Place) -> Result<(), PlaceError> {
        let (frames, sweeps) = (self.frames, self.timebase.sweeps);
        let Place { frame, sweep, gone } = place;
        if frame >= frames {
            return Err(PlaceError::Frame { frame, frames });
        }
        if sweep >= sweeps {
            return Err(PlaceError::Sweep { sweep, sweeps });
        }
        let (gone, unit, end) = match gone {
            Gone::Nothing => return Ok(()),
            Gone::Ticks(ticks) => (ticks, "ticks", self.ticks_of(self.number(place))),
            Gone::Samples(samples) => (samples.into(), "samples", self.timebase.active_samples.into()),
        };
        if (1..end).contains(&gone) { Ok(()) } else { Err(PlaceError::Gone { gone, unit, end }) }
    }

    /// The tick at which the digital side sees a place of the mission.
    pub fn tick(&self, place: Place) -> Tick {
        let start = self.start(self.number(place));
        match place.gone {
            Gone::Nothing => start,
            Gone::Ticks(ticks) => Tick(start.0 + ticks),
            Gone::Samples(_) => {
                self.timebase.sweep_clock(place.frame, place.sweep).tick_at_or_after(self.time(place))
            }
        }
    }

    /// The instant of a place in its sweep (samples).
    pub fn time(&self, place: Place) -> SweepTime {
        match place.gone {
            Gone::Nothing => SweepTime(0.0),
            Gone::Ticks(_) => {
                self.timebase.sweep_clock(place.frame, place.sweep).instant_of(self.tick(place))
            }
            Gone::Samples(samples) => SweepTime(samples.into()),
        }
    }

    /// Time of a place from the start of the mission (s).
    pub fn seconds(&self, place: Place) -> f64 {
        let samples = self.number(place) as f64 * f64::from(self.timebase.sweep_samples());
        (samples + self.time(place).0) / self.timebase.sample_rate().hertz()
    }

    /// The place that a tick is; `None` behind the end of the mission.
    pub fn place_of(&self, tick: Tick) -> Option<Place> {
        let (mut first, mut behind) = (0, self.sweeps());
        if tick >= self.start(behind) {
            return None;
        }
        while behind - first > 1 {
            let middle = first + (behind - first) / 2;
            if self.start(middle) <= tick { first = middle } else { behind = middle }
        }
        let gone = match tick.0.saturating_sub(self.start(first).0) {
            0 => Gone::Nothing,
            ticks => Gone::Ticks(ticks),
        };
        Some(Place { gone, ..self.sweep(first) })
    }

    /// `count` steps of `unit` from `place`, backwards below 0: to the next places of that kind. [`Unit::Event`] steps by ticks here;
    /// events are known to the machine alone.
    ///
    /// # Errors
    /// If that leads out of the mission.
    pub fn step(&self, place: Place, unit: Unit, count: i64) -> Result<Place, PlaceError> {
        if count == 0 {
            return Ok(place);
        }
        let (floor, is_exact) = self.floor(place, unit);
        let from = if count < 0 && !is_exact { floor + 1 } else { floor };
        let to = u64::try_from(i128::from(from) + i128::from(count));
        let to = to.map_err(|_| if count < 0 { PlaceError::Before } else { self.behind() })?;
        self.at(unit, place.sweep, to).ok_or_else(|| self.behind())
    }

    /// Number of the last place of a kind at or before a place, and whether it is that place.
    fn floor(&self, place: Place, unit: Unit) -> (u64, bool) {
        let (sweep, is_start) = (self.number(place), place.gone == Gone::Nothing);
        match unit {
            Unit::Frame => (place.frame, is_start),
            Unit::Sweep => (sweep, is_start),
            Unit::Sample => {
                let (sample, is_exact) = self.sample(place);
                (sweep * u64::from(self.timebase.active_samples) + u64::from(sample), is_exact)
            }
            Unit::Tick | Unit::Event => self.tick_before(place),
        }
    }

    /// The last sample of its sweep at or before a place, and whether it is that place.
    fn sample(&self, place: Place) -> (u32, bool) {
        let last = self.timebase.active_samples - 1;
        let time = self.time(place).0;
        let sample = (time as u32).min(last);
        // A start is the first sample, and no tick behind it is.
        let is_exact = f64::from(sample) == time && (sample > 0 || place.gone == Gone::Nothing);
        (sample, is_exact)
    }

    /// The last tick at or before a place, and whether it is that place. The first tick of a sweep counts as its start.
    pub(crate) fn tick_before(&self, place: Place) -> (u64, bool) {
        let (tick, start) = (self.tick(place), self.start(self.number(place)));
        match place.gone {
            Gone::Nothing | Gone::Ticks(_) => (tick.0, true),
            Gone::Samples(_) if tick <= start => (start.0, false),
            Gone::Samples(_) => {
                let clock = self.timebase.sweep_clock(place.frame, place.sweep);
                let is_exact = clock.instant_of(tick) == self.time(place);
                (tick.0 - u64::from(!is_exact), is_exact)
            }
        }
    }

    /// The place of a kind with that number; of frames that of `sweep`.
    fn at(&self, unit: Unit, sweep: u32, number: u64) -> Option<Place> {
        match unit {
            Unit::Frame => (number < self.frames).then_some(Place::start(number, sweep)),
            Unit::Sweep => (number < self.sweeps()).then(|| self.sweep(number)),
            Unit::Sample => {
                let active = u64::from(self.timebase.active_samples);
                let gone = match (number % active) as u32 {
                    0 => Gone::Nothing,
                    sample => Gone::Samples(sample),
                };
                let sweep = number / active;
                (sweep < self.sweeps()).then(|| Place { gone, ..self.sweep(sweep) })
            }
            Unit::Tick | Unit::Event => self.place_of(Tick(number)),
        }
    }

    pub(crate) fn behind(&self) -> PlaceError {
        PlaceError::Behind { last: self.frames - 1 }
    }

    /// Sweeps of the mission.
    fn sweeps(&self) -> u64 {
        self.frames * u64::from(self.timebase.sweeps)
    }

    /// Number of a place's sweep in the mission.
    fn number(&self, place: Place) -> u64 {
        place.frame * u64::from(self.timebase.sweeps) + u64::from(place.sweep)
    }

    /// The start of a sweep by its number in the mission.
    fn sweep(&self, number: u64) -> Place {
        let sweeps = u64::from(self.timebase.sweeps);
        Place::start(number / sweeps, (number % sweeps) as u32)
    }

    fn start(&self, number: u64) -> Tick {
        let Place { frame, sweep, .. } = self.sweep(number);
        self.timebase.sweep_clock(frame, sweep).tick_at_or_after(SweepTime(0.0))
    }

    /// Ticks of a sweep, up to the first one of the next.
    fn ticks_of(&self, number: u64) -> u64 {
        self.start(number + 1).0 - self.start(number).0
    }
}
