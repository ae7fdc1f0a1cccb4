//! One sweep being written: fold by fold, with what comes between them.

mod deliveries;
mod requests;
mod settling;
mod stored;

use quantities::{SweepClock, SweepTime, Tick};
use smallvec::SmallVec;
use sweep_program::{
    Event, Fold, Load, Miss, MissCause, NO_CORNER, RampAxis, RegisterCorners, Step, Stop, SweepProgram,
    SweepStart, WordMask, last_tick,
};

use self::deliveries::Delivery;
use crate::home::Pointers;
use crate::server::Server;
use crate::unit::{CrossingService, TimedFold};
use crate::watch::{ServiceEvent, Watch};

/// The program being written.
pub(crate) struct Service<'a, 's, 'w, W> {
    unit: &'s CrossingService<'a>,
    watch: &'w mut W,
    frame: u64,
    sweep: u32,
    clock: SweepClock,
    pointers: Pointers,
    server: Server<'s>,
    /// Words on their way, in the order in which they come.
    pending: SmallVec<[Delivery; 8]>,
    /// When the last word of each preload register comes; `None` while nobody has fetched it, and at sweep start.
    ready: [[Option<Tick>; 2]; 4],
    /// When the diagonal register of a colour was filled; `None` while it waits.
    diagonals: [Option<Tick>; 4],
    /// The last tick that is not after the fold that is served.
    due: Tick,
    /// Stop that each ramp meets next; `None` for one that stands.
    next_stop: [Option<Stop>; 2],
    crossing: u32,
    requests: u32,
    /// Corners in the registers, if anyone listens.
    held: Option<RegisterCorners>,
}

impl<'a, 's, 'w, W: Watch> Service<'a, 's, 'w, W> {
    /// A sweep that begins with full registers and an empty queue.
    pub fn new(
        unit: &'s CrossingService<'a>,
        (frame, sweep): (u64, u32),
        start: &SweepStart,
        pointers: Pointers,
        watch: &'w mut W,
    ) -> Self {
        let clock = unit.timebase.sweep_clock(frame, sweep);
        let place = [frame, u64::from(sweep)];
        Self {
            unit,
            watch,
            frame,
            sweep,
            clock,
            pointers,
            server: Server::new(unit.loader, unit.cpu, unit.seed, place, unit.held_until(&clock)),
            pending: SmallVec::new(),
            ready: Default::default(),
            diagonals: [Some(Tick(0)); 4],
            due: Tick(0),
            next_stop: start.ramps.map(|ramp| (ramp.rate != 0.0).then(|| ramp.first_stop().1)),
            crossing: 0,
            requests: 0,
            held: None,
        }
    }

    /// What is still to come once the last fold is past.
    pub fn finish(mut self, range_at: &impl Fn(SweepTime) -> f64, program: &mut SweepProgram) {
        self.run_server(None, program);
        self.deliver_until(SweepTime(f64::INFINITY), range_at, program);
        self.tell_late(range_at, program);
        self.watch.end(&self.server.use_of_lines());
    }

    /// Everything up to a fold.
    pub fn reach(
        &mut self,
        fold: TimedFold,
        range_at: &impl Fn(SweepTime) -> f64,
        program: &mut SweepProgram,
    ) {
        if !self.unit.loader.is_wired_through() {
            self.run_server(Some(self.seen(fold.time)), program);
        }
        self.deliver_until(fold.time, range_at, program);
    }

    /// One fold: transfer, pointers, requests.
    pub fn serve(&mut self, fold: TimedFold, program: &mut SweepProgram) {
        let enabled = self.unit.loader.stop_after_crossings.is_none_or(|last| self.crossing < last);
        let kind = if enabled { Event::Fold(fold.kind) } else { Event::BareFold(fold.kind) };
        program.steps.push(Step::new(fold.time, fold.range, kind));
        let seen = self.seen(fold.time);
        self.due = last_tick(&self.clock, fold.time, seen);
        self.watch.tell(seen, ServiceEvent::Stop { crossing: self.crossing, fold: fold.kind });
        self.pass_stop(fold.kind);
        if enabled {
            self.settle(fold, seen, program);
            self.pointers.follow(fold.kind);
            for colour in fold.kind.colours() {
                self.renew(colour, fold, seen, program);
            }
        } else {
            self.stand_still(fold, program);
        }
        self.crossing += 1;
    }

    /// Nothing is transferred any more: what the fold should have brought never comes.
    fn stand_still(&self, fold: TimedFold, program: &mut SweepProgram) {
        let missed = |colour| Miss {
            crossing: self.crossing,
            time: fold.time,
            arrival: None,
            colour,
            register: fold.kind.axis.register(),
            corner: NO_CORNER,
            words: WordMask::ALL,
            cause: MissCause::HeldBack,
        };
        program.misses.extend(fold.kind.colours().into_iter().map(missed));
    }

    fn pass_stop(&mut self, fold: Fold) {
        self.next_stop[usize::from(fold.axis == RampAxis::Y)] = Some(match fold.stop {
            Stop::Zero => Stop::One,
            Stop::One => Stop::Zero,
        });
    }

    /// Words that came late: when, is known now.
    fn tell_late(&mut self, range_at: &impl Fn(SweepTime) -> f64, program: &SweepProgram) {
        if W::LISTENS {
            for &miss in &program.misses {
                let range = range_at(miss.time);
                self.watch.tell(self.clock.tick_at_or_after(miss.time), ServiceEvent::Late { miss, range });
            }
        }
    }

    /// Words stand in a register.
    fn tell_load(held: &mut Option<RegisterCorners>, watch: &mut W, tick: Tick, load: Load) {
        if W::LISTENS {
            if let Some(held) = held {
                held.follow(&Event::Load(load));
            }
            watch.tell(tick, ServiceEvent::Load(load));
        }
    }

    /// The tick at which the digital side sees an instant.
    fn seen(&self, time: SweepTime) -> Tick {
        self.clock.tick_at_or_after(time)
    }

    fn instant_of(&self, tick: Tick) -> SweepTime {
        self.clock.instant_of(tick)
    }
}
