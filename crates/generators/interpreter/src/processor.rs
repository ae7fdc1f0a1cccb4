//! The central processor through one frame, tick by tick (hardware section 4.6; sheet of the DPU).

use hardware_model::{Cpu, CrossingServer};

use crate::clock::starts;
use crate::event::{Event, Happening};
use crate::frame::FrameGiven;
use crate::scene::SceneData;

/// The program of a sweep that is being made; no sweep for the first one of the frame that follows.
#[derive(Debug, Clone, Copy)]
struct SetUp {
    sweep: Option<u32>,
    rest: u64,
}

struct Processor<'a> {
    cpu: &'a Cpu,
    /// Starts of the sweeps, and the end of the frame.
    starts: &'a [i64],
    /// Whether a crossing waits until the set-up that runs is done.
    unbroken: bool,
    in_work: Option<SetUp>,
    /// Whether the set-up of the next sweep may still begin in the time of this one.
    may_begin: bool,
    /// Ticks of work on tables and polyhedra that are left.
    left: u64,
    /// When nothing of it was left.
    ready: i64,
    /// Programs that are made, and when.
    made: Vec<(u32, i64)>,
    /// Ticks of set-ups in each sweep.
    at_set_ups: Vec<i64>,
    events: Vec<Event>,
}

/// What the processor does in a frame.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Processed {
    /// Events of the set-ups and tables.
    pub events: Vec<Event>,
    /// The sweep whose set-up each sweep is drawn with: its own where the processor takes no time.
    pub set_ups: Vec<u32>,
    /// Ticks of each sweep, from its start, in which a set-up runs that no interrupt breaks; empty if interrupts break all.
    pub held: Vec<i64>,
}

/// Follows the processor through the frame.
pub fn processor(scene: &SceneData<'_>, given: &FrameGiven<'_>) -> Processed {
    let settings = scene.settings;
    let serves = settings.loader.served_by == CrossingServer::CpuInterrupt;
    if !settings.cpu.is_timed() && !serves {
        return Processed { set_ups: (0..settings.raster.sweeps).collect(), ..Processed::default() };
    }
    let starts = starts(scene, scene.frame);
    let mut processor = Processor {
        cpu: &settings.cpu,
        starts: &starts,
        unbroken: serves && settings.cpu.priority_levels == Some(1),
        in_work: None,
        may_begin: false,
        left: settings.cpu.frame_tables + settings.cpu.vertex * given.vertices,
        ready: starts[0],
        made: Vec::new(),
        at_set_ups: vec![0; starts.len() - 1],
        events: Vec::new(),
    };
    // The first sweep is set up in a time before the frame that is as long as the first sweep's; its crossings are those of the
    // last sweep.
    let crossings = |sweep: Option<usize>| match sweep {
        None => given.crossings.last().copied().unwrap_or(0),
        Some(sweep) => given.crossings.get(sweep).copied().unwrap_or(0),
    };
    let before = [2 * starts[0] - starts[1], starts[0]];
    processor.sweep(None, before, crossings(None));
    for sweep in 0..starts.len() - 1 {
        processor.sweep(Some(sweep), [starts[sweep], starts[sweep + 1]], crossings(Some(sweep)));
    }
    processor.finish()
}

impl Processor<'_> {
    /// The time of one sweep, or of none before the first.
    fn sweep(&mut self, sweep: Option<usize>, [begin, end]: [i64; 2], mut crossings: u64) {
        let next = sweep.map_or(0, |sweep| sweep + 1);
        let next = (next + 1 < self.starts.len()).then_some(next as u32);
        if next.is_none() {
            // No sweep could be drawn with it any more.
            self.in_work = None;
        }
        self.may_begin = true;
        for tick in begin..end {
            if !self.unbroken && crossings > 0 {
                crossings -= 1;
                continue;
            }
            if self.set_up(next, tick) {
                sweep.into_iter().for_each(|sweep| self.at_set_ups[sweep] += 1);
                continue;
            }
            if crossings > 0 {
                crossings -= 1;
            } else if sweep.is_some() && self.left > 0 {
                self.left -= 1;
                self.ready = tick + 1;
            }
        }
    }

    /// Gives a tick to a set-up; whether one took it.
    fn set_up(&mut self, next: Option<u32>, tick: i64) -> bool {
        if self.in_work.is_none() && self.may_begin {
            self.in_work = Some(SetUp { sweep: next, rest: self.cpu.sweep_setup });
            self.may_begin = false;
            if let Some(sweep) = next {
                self.note(tick, Happening::SetUpBegins { sweep });
            }
            if self.cpu.sweep_setup == 0 {
                self.is_made(tick);
            }
        }
        let Some(work) = &mut self.in_work else { return false };
        if self.unbroken {
            self.may_begin = false;
        }
        work.rest -= 1;
        if work.rest == 0 {
            self.is_made(tick + 1);
        }
        true
    }

    fn is_made(&mut self, tick: i64) {
        if let Some(sweep) = self.in_work.take().and_then(|work| work.sweep) {
            self.made.push((sweep, tick));
            self.note(tick, Happening::SetUp { sweep, slack: self.starts[sweep as usize] - tick });
        }
    }

    /// Each sweep takes the last program that is made as it begins; the next one's is not its own.
    fn finish(mut self) -> Processed {
        let mut set_ups = Vec::new();
        for (sweep, &start) in (0..).zip(&self.starts[..self.starts.len() - 1]) {
            let made = self.made.iter().filter(|&&(made, tick)| made <= sweep && tick <= start);
            let drawn = made.map(|&(made, _)| made).next_back().unwrap_or(0);
            if drawn != sweep {
                self.note(start, Happening::OldSetUp { sweep, drawn });
            }
            set_ups.push(drawn);
        }
        let end = self.starts[self.starts.len() - 1];
        match self.left {
            0 => self.note(self.ready, Happening::Tables { slack: end - self.ready }),
            left => self.note(end, Happening::Tables { slack: -(left as i64) }),
        }
        let held = if self.unbroken { self.at_set_ups } else { Vec::new() };
        Processed { events: self.events, set_ups, held }
    }

    /// Nothing is before the mission, which begins at tick 0.
    fn note(&mut self, tick: i64, what: Happening) {
        self.events.push(Event { tick: tick.max(0), level: None, what });
    }
}
