//! `lunoid trace`: the digital side of a frame as a listing, and its registers at an instant.

mod filter;
mod listing;
mod seen;
mod state;

use std::ops::Range;
use std::str::FromStr;

use clap::Args;
use machine::{DigitalEvent, EventWord, FrameSweeps};
use quantities::{SweepTime, Tick, Timebase};
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::frame::FrameArgs;
use crate::loading::of_models;
use crate::{Failure, Verdict, values};
use text::Span;

use filter::Filter;
use listing::{Form, Listing};
use seen::Seen;

const AFTER: &str = "Examples:
  lunoid trace scenarios/first-light.toml --frame 60 --sweep 500
  lunoid trace scenarios/nominal-drive.toml --frame 45 --event late,cancelled --csv
  lunoid trace scenarios/nominal-drive.toml --frame 45 --unit loader.red --from 30056000 --limit 40
  lunoid trace scenarios/first-light.toml --frame 60 --at 500:412

Ticks are those of the master clock since the start of the mission.";

/// Events that need the shadow gates of the frame.
const SEGMENTS: [EventWord; 3] = [EventWord::SegmentLoad, EventWord::SegmentLate, EventWord::SegmentDropped];

/// Sweeps that are worked out side by side.
const AT_ONCE: u32 = 32;

/// List the digital events of a frame in the order of their ticks, or show all registers at one of them.
#[derive(Debug, Args)]
#[command(after_help = AFTER, mut_args(of_models))]
pub struct Trace {
    #[command(flatten)]
    chosen: FrameArgs,
    /// Sweeps, from 0 at the left: S or S..T without T.
    #[arg(long, value_name = "S[..T]")]
    sweep: Option<Span>,
    #[command(flatten)]
    filter: Filter,
    /// List no more than so many events, and those of the same tick as the last.
    #[arg(long, value_name = "N", value_parser = values::at_least(1_u64))]
    limit: Option<u64>,
    /// Show the registers of all colours at a tick, or at a sample of a sweep, and list nothing.
    #[arg(long, value_name = "TICK|S:SAMPLE",
          conflicts_with_all = ["sweep", "unit", "event", "colour", "level", "from", "to", "limit", "csv"])]
    at: Option<At>,
    /// Print as JSON.
    #[arg(long)]
    json: bool,
    /// Print as CSV, a row an event.
    #[arg(long, conflicts_with = "json")]
    csv: bool,
}

/// An instant of a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
enum At {
    Tick(Tick),
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

impl Trace {
    /// Lists, or shows.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let mut sweeps = 0..0;
        let number = self.chosen.frame;
        let rehearsal = self.chosen.rehearse(|opened| {
            sweeps = self.sweeps(opened.settings.raster.sweeps)?;
            self.filter.expect_there(&opened.settings)
        })?;
        let pose = rehearsal.poses(&[number])?[0].pose;
        // Shadow boundaries take longer to find than all else takes.
        let gates = self.at.is_none() && self.filter.may_pass(&SEGMENTS, "shadow-controller.load");
        let frame = rehearsal.pool.install(|| match gates {
            true => rehearsal.control.sweeps_with_gates(number, &pose),
            false => rehearsal.control.sweeps(number, &pose),
        });
        let frame = Frame {
            number,
            timebase: rehearsal.stage.settings.timebase,
            levels: rehearsal.stage.landscape.bank().levels(),
            sweeps: frame.map_err(Failure::input)?,
        };
        match self.at {
            Some(at) => state::show(&frame, frame.instant(at)?, self.json)?,
            None => rehearsal.pool.install(|| self.list(&frame, sweeps))?,
        }
        Ok(Verdict::Yes)
    }

    fn sweeps(&self, count: u32) -> Result<Range<u32>, Failure> {
        let all = 0..u64::from(count);
        let Some(span) = self.sweep else { return Ok(0..count) };
        let found = span.within(&all).ok_or_else(|| {
            Failure::usage(format!("--sweep {span}: a frame has sweeps 0..{count}; expected a range inside"))
        })?;
        Ok(found.start as u32..found.end as u32)
    }

    /// Streams: a sweep's events are held back only while those of the next may come before them.
    fn list(&self, frame: &Frame<'_>, sweeps: Range<u32>) -> Result<(), Failure> {
        let is_meant = |event: &DigitalEvent| match event.sweep {
            Some(sweep) => sweeps.contains(&sweep),
            None => self.sweep.is_none(),
        };
        let mut listing = Listing::new(frame, self.form(), self.limit);
        let mut seen = Seen::default();
        let mut passes = |event: &DigitalEvent| {
            seen.look(event);
            self.filter.passes(event)
        };
        let mut waiting: Vec<DigitalEvent> = frame.sweeps.frame_events();
        waiting.retain(|event| is_meant(event) && passes(event));
        let mut next = sweeps.start;
        while next < sweeps.end && !listing.is_full() {
            let until = sweeps.end.min(next + AT_ONCE);
            let of = |sweep: u32| frame.sweeps.events(sweep);
            let found: Vec<Vec<DigitalEvent>> = (next..until).into_par_iter().map(of).collect();
            waiting.extend(found.into_iter().flatten().filter(&mut passes));
            waiting.sort_by_key(|event| event.tick);
            // Words of craters set out with the retrace before their sweep: nothing of a sweep comes before.
            let safe = frame.tick(until, -f64::from(frame.timebase.retrace_samples).max(1.0));
            let whole = waiting.partition_point(|event| until == sweeps.end || event.tick < safe);
            listing.add(waiting.drain(..whole))?;
            next = until;
        }
        if listing.is_empty() {
            self.filter.explain_none(&seen)?;
        }
        listing.end()
    }

    fn form(&self) -> Form {
        match (self.json, self.csv) {
            (true, _) => Form::Json,
            (_, true) => Form::Csv,
            _ => Form::Text,
        }
    }
}

/// A frame whose digital side is looked at.
struct Frame<'a> {
    number: u64,
    timebase: Timebase,
    levels: &'a [landscape::Level],
    sweeps: FrameSweeps<'a>,
}

/// An instant of the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Instant {
    sweep: u32,
    time: SweepTime,
    tick: Tick,
}

impl Frame<'_> {
    /// When the digital side sees an instant of a sweep.
    fn tick(&self, sweep: u32, time: f64) -> Tick {
        self.timebase.sweep_clock(self.number, sweep).tick_at_or_after(SweepTime(time))
    }

    /// Begin and end.
    fn ticks(&self) -> [Tick; 2] {
        [self.tick(0, 0.0), self.tick(self.timebase.sweeps, 0.0)]
    }

    /// Time from the start of the frame (µs).
    fn microseconds(&self, tick: Tick) -> f64 {
        let start = self.timebase.sweep_clock(self.number, 0).instant_of(tick);
        start.0 * 1e6 / self.timebase.sample_rate().hertz()
    }

    fn instant(&self, at: At) -> Result<Instant, Failure> {
        match at {
            At::Tick(tick) => self.of_tick(tick),
            At::Sample(sweep, sample) => self.of_sample(sweep, sample),
        }
    }

    fn of_tick(&self, tick: Tick) -> Result<Instant, Failure> {
        let [start, end] = self.ticks();
        if tick < start || tick >= end {
            return Err(Failure::usage(format!(
                "--at {}: frame {} has ticks {}..{}; expected one of them",
                tick.0, self.number, start.0, end.0
            )));
        }
        let sweeps: Vec<u32> = (0..self.timebase.sweeps).collect();
        let sweep = sweeps.partition_point(|&sweep| self.tick(sweep, 0.0) <= tick) as u32 - 1;
        let time = self.timebase.sweep_clock(self.number, sweep).instant_of(tick);
        Ok(Instant { sweep, time, tick })
    }

    fn of_sample(&self, sweep: u32, sample: f64) -> Result<Instant, Failure> {
        let Timebase { sweeps, active_samples, .. } = self.timebase;
        if sweep >= sweeps || !(0.0..f64::from(active_samples)).contains(&sample) {
            return Err(Failure::usage(format!(
                "--at {sweep}:{sample}: a frame has sweeps 0..{sweeps} of samples 0..{active_samples}; expected one of them"
            )));
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
