//! Service of the crossings: from folds to a sweep program.

use hardware_model::{Cpu, LatePolicy, LoadDelay, Loader};
use landscape::Level;
use quantities::{SweepClock, SweepTime, Tick, Timebase};
use sweep_program::{
    Colour, Fold, Load, Miss, MissCause, NO_CORNER, PreloadRegister, RampAxis, Step, StepKind, Stop,
    SweepProgram, SweepStart, Target, WordMask, slack,
};

use crate::Pointers;
use crate::server::{Job, Served, Server, Wanted};
use crate::watch::{AskedCorner, CornerArrival, Watch};

/// A fold and its instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimedFold {
    /// When, on the sweep clock.
    pub time: SweepTime,
    /// Ground range then (m).
    pub range: f64,
    /// Which stop.
    pub fold: Fold,
}

/// A corner that a sweep may ask for and that the data bank has not delivered when the frame begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MissingCorner {
    /// Index in the level.
    pub corner: u32,
    /// When it comes; `None` if not in this frame.
    pub arrival: Option<Tick>,
}

/// The unit that answers folds with coefficient words.
#[derive(Debug, Clone, Copy)]
pub struct CrossingService<'a> {
    /// Terrain whose corners are delivered.
    pub level: &'a Level,
    /// How fast, and what happens to late words.
    pub loader: &'a Loader,
    /// Processor, which serves folds itself in some models.
    pub cpu: &'a Cpu,
    /// Clocks of the run.
    pub timebase: &'a Timebase,
    /// What is not in the storage buffer, in order of corners.
    pub missing: &'a [MissingCorner],
    /// Ticks from the start of the sweep in which a processor that serves the crossings is at a set-up that no interrupt
    /// breaks.
    pub held: u64,
    /// Seed of the model.
    pub seed: u64,
}

/// Words on their way.
#[derive(Debug, Clone, Copy)]
struct Delivery {
    tick: Tick,
    arrival: SweepTime,
    /// Number of the request: what arrives in one instant keeps the order in which it was asked for.
    number: u32,
    load: Load,
    /// The preload register that asked.
    register: PreloadRegister,
    cause: MissCause,
}

/// Who asks for a corner.
#[derive(Debug, Clone, Copy)]
struct Asking {
    crossing: Option<u32>,
    colour: Colour,
    register: Option<PreloadRegister>,
}

/// The program being written.
struct Service<'a, 's, 'w, W> {
    unit: &'s CrossingService<'a>,
    watch: &'w mut W,
    frame: u64,
    sweep: u32,
    clock: SweepClock,
    pointers: Pointers,
    server: Server<'s>,
    pending: Vec<Delivery>,
    /// When the last word of each preload register comes; `None` while nobody has fetched it, and at sweep start.
    ready: [[Option<Tick>; 2]; 4],
    /// When the diagonal register of a colour was filled; `None` while it waits.
    diagonals: [Option<Tick>; 4],
    /// Stop that each ramp meets next; `None` for one that stands.
    next_stop: [Option<Stop>; 2],
    crossing: u32,
    requests: u32,
}

impl CrossingService<'_> {
    /// Writes the program of sweep `sweep` of frame `frame` into `program`, whose buffers are reused. `folds`
    /// ends where the profile ends, at `end_range` (m); `range_at` gives the range of an instant. `watch` is told
    /// what happens, `&mut ()` if nobody wants to know.
    pub fn write_program(
        &self,
        (frame, sweep): (u64, u32),
        start: SweepStart,
        folds: impl Iterator<Item = TimedFold>,
        end_range: f64,
        range_at: impl Fn(SweepTime) -> f64,
        program: &mut SweepProgram,
        watch: &mut impl Watch,
    ) {
        let pointers = Pointers::at_start(&start);
        program.start = start;
        program.registers = pointers.home_registers(self.level);
        program.end_range = end_range;
        program.steps.clear();
        program.misses.clear();
        let clock = self.timebase.sweep_clock(frame, sweep);
        let mut service = Service {
            unit: self,
            watch,
            frame,
            sweep,
            clock,
            pointers,
            server: Server::new(
                self.loader,
                self.cpu,
                self.seed,
                [frame, u64::from(sweep)],
                self.held_until(&clock),
            ),
            pending: Vec::new(),
            ready: Default::default(),
            diagonals: [Some(Tick(0)); 4],
            next_stop: start.ramps.map(|ramp| (ramp.rate != 0.0).then(|| ramp.first_stop().1)),
            crossing: 0,
            requests: 0,
        };
        service.look_up_home(program);
        for fold in folds {
            service.reach(fold, &range_at, program);
            service.serve(fold, program);
        }
        service.run_server(None, program);
        service.deliver_until(SweepTime(f64::INFINITY), &range_at, program);
        service.watch.end(&service.server.use_of_lines());
        while program.steps.last().is_some_and(|step| step.range > end_range) {
            program.steps.pop();
        }
    }

    fn delays(&self, frame: u64, sweep: u32, crossing: u32) -> impl Iterator<Item = &LoadDelay> {
        self.loader.delays.iter().filter(move |delay| {
            delay.frame.is_none_or(|wanted| wanted == frame)
                && delay.sweep == sweep
                && delay.crossing == crossing
        })
    }

    /// When a processor that serves the crossings is done with the set-up that no interrupt breaks.
    fn held_until(&self, clock: &SweepClock) -> Tick {
        match self.held {
            0 => Tick(0),
            held => Tick(clock.tick_at_or_after(SweepTime(0.0)).0 + held),
        }
    }

    /// When `corner` is in the storage buffer.
    fn arrival_of(&self, corner: u32) -> CornerArrival {
        match self.missing.binary_search_by_key(&corner, |missing| missing.corner) {
            Ok(index) => self.missing[index].arrival.map_or(CornerArrival::NotInFrame, CornerArrival::At),
            Err(_) => CornerArrival::BeforeFrame,
        }
    }
}

impl<W: Watch> Service<'_, '_, '_, W> {
    /// Everything up to a fold.
    fn reach(&mut self, fold: TimedFold, range_at: &impl Fn(SweepTime) -> f64, program: &mut SweepProgram) {
        if !self.unit.loader.is_wired_through() {
            self.run_server(Some(self.seen(fold.time)), program);
        }
        self.deliver_until(fold.time, range_at, program);
    }

    /// The tick at which the digital side sees an instant.
    fn seen(&self, time: SweepTime) -> Tick {
        self.clock.tick_at_or_after(time)
    }

    fn instant_of(&self, tick: Tick) -> SweepTime {
        self.clock.instant_of(tick)
    }

    /// One fold: transfer, pointers, requests.
    fn serve(&mut self, fold: TimedFold, program: &mut SweepProgram) {
        let enabled = self.unit.loader.stop_after_crossings.is_none_or(|last| self.crossing < last);
        let kind = if enabled { StepKind::Fold(fold.fold) } else { StepKind::BareFold(fold.fold) };
        program.steps.push(Step::new(fold.time, fold.range, kind));
        let seen = self.seen(fold.time);
        self.watch.fold(seen, fold.fold);
        self.pass_stop(fold.fold);
        if enabled {
            self.settle(fold, program);
            self.pointers.follow(fold.fold);
            for colour in Colour::ALL {
                if fold.fold.axis.takes(fold.fold.stop, colour) {
                    self.renew(colour, fold, seen, program);
                }
            }
        } else {
            self.stand_still(fold, program);
        }
        self.crossing += 1;
    }

    /// Nothing is transferred any more: what the fold should have brought never comes.
    fn stand_still(&self, fold: TimedFold, program: &mut SweepProgram) {
        let Fold { axis, stop } = fold.fold;
        let missed = |colour| Miss {
            crossing: self.crossing,
            time: fold.time,
            arrival: None,
            colour,
            register: axis.register(),
            corner: NO_CORNER,
            words: WordMask::ALL,
            cause: MissCause::HeldBack,
        };
        program.misses.extend(Colour::ALL.into_iter().filter(|&colour| axis.takes(stop, colour)).map(missed));
    }

    fn pass_stop(&mut self, fold: Fold) {
        self.next_stop[usize::from(fold.axis == RampAxis::Y)] = Some(match fold.stop {
            Stop::Zero => Stop::One,
            Stop::One => Stop::Zero,
        });
    }

    /// Both preload registers of a colour that has moved, and its diagonal one.
    fn renew(&mut self, colour: Colour, fold: TimedFold, seen: Tick, program: &mut SweepProgram) {
        let other = match fold.fold.axis {
            RampAxis::X => PreloadRegister::YFirst,
            RampAxis::Y => PreloadRegister::XFirst,
        };
        let loader = self.unit.loader;
        let has_diagonal = loader.diagonal_register && !loader.is_wired_through();
        let at_hand = has_diagonal && self.diagonals[colour as usize].is_some_and(|ready| ready <= seen);
        for register in [PreloadRegister::XFirst, PreloadRegister::YFirst] {
            if at_hand && register == other {
                self.take_diagonal(colour, register, fold, seen, program);
            } else {
                self.request(colour, register, register == other, fold, seen, program);
            }
        }
        if has_diagonal {
            self.diagonals[colour as usize] = None;
            let [m, n] = self.pointers.diagonal(colour);
            let corner = self.unit.level.clamped_index(m, n) as u32;
            self.ask(colour, Wanted::Diagonal, corner, false, seen);
        }
    }

    /// The corner beyond both stops is at hand: it moves over with the fold itself.
    fn take_diagonal(
        &mut self,
        colour: Colour,
        register: PreloadRegister,
        fold: TimedFold,
        seen: Tick,
        program: &mut SweepProgram,
    ) {
        let [m, n] = self.pointers.ahead(colour, register);
        let asking = Asking { crossing: Some(self.crossing), colour, register: Some(register) };
        let corner = self.stored(self.unit.level.clamped_index(m, n) as u32, seen, asking);
        let load = Load { colour, target: Target::Preload(register), corner, words: WordMask::ALL };
        program.steps.push(Step::new(fold.time, fold.range, StepKind::Load(load)));
        self.ready[colour as usize][register as usize] = Some(seen);
        self.watch.arrival(seen, &load);
    }

    /// What is still on its way for a colour that has just been transferred has come too late or moved on.
    fn settle(&mut self, fold: TimedFold, program: &mut SweepProgram) {
        let axis = fold.fold.axis;
        for colour in Colour::ALL.into_iter().filter(|_| W::LISTENS) {
            if axis.takes(fold.fold.stop, colour) {
                self.settle_ready(colour, axis.register(), fold.time);
            }
        }
        self.settle_queue(fold, program);
        self.settle_pending(fold, program);
    }

    /// One set of a colour is used, and the other is not.
    fn settle_ready(&mut self, colour: Colour, used: PreloadRegister, time: SweepTime) {
        for register in [PreloadRegister::XFirst, PreloadRegister::YFirst] {
            let Some(ready) = self.ready[colour as usize][register as usize].take() else { continue };
            let slack = slack(&self.clock, time, ready);
            if register == used {
                self.watch.transfer(slack);
            } else if slack >= 0 {
                self.watch.wasted();
            }
        }
    }

    fn settle_queue(&mut self, fold: TimedFold, program: &mut SweepProgram) {
        let (axis, stop, crossing) = (fold.fold.axis, fold.fold.stop, self.crossing);
        let strobe = self.unit.loader.late_policy == LatePolicy::StrobeThrough;
        let watch = &mut *self.watch;
        self.server.retain(|job| {
            if !axis.takes(stop, job.colour) {
                return true;
            }
            let needed = job.wanted == Wanted::Register(axis.register()) && !job.late;
            if needed {
                let register = axis.register();
                let miss = Miss {
                    crossing,
                    time: fold.time,
                    arrival: None,
                    colour: job.colour,
                    register,
                    corner: job.corner,
                    words: WordMask::ALL,
                    cause: MissCause::Queue,
                };
                program.misses.push(miss);
                job.late = true;
            }
            let kept = needed && strobe;
            if !kept {
                watch.cancelled();
            }
            kept
        });
    }

    fn settle_pending(&mut self, fold: TimedFold, program: &mut SweepProgram) {
        let crossing = self.crossing;
        let strobe = self.unit.loader.late_policy == LatePolicy::StrobeThrough;
        self.pending.retain_mut(|delivery| {
            let load = &mut delivery.load;
            if !fold.fold.axis.takes(fold.fold.stop, load.colour) {
                return true;
            }
            let missed = delivery.register == fold.fold.axis.register() && load.target != Target::Hold;
            if missed {
                let Delivery { arrival, register, cause, .. } = *delivery;
                let Load { colour, corner, words, .. } = *load;
                let miss = Miss {
                    crossing,
                    time: fold.time,
                    arrival: Some(arrival),
                    colour,
                    register,
                    corner,
                    words,
                    cause,
                };
                note_miss(&mut program.misses, miss);
                load.target = Target::Hold;
            }
            missed && strobe
        });
    }

    fn request(
        &mut self,
        colour: Colour,
        register: PreloadRegister,
        across: bool,
        fold: TimedFold,
        seen: Tick,
        program: &mut SweepProgram,
    ) {
        let unit = self.unit;
        let [m, n] = self.pointers.ahead(colour, register);
        let corner = unit.level.clamped_index(m, n) as u32;
        if unit.loader.is_wired_through() {
            return self.transfer_at_once(colour, register, corner, fold, seen, program);
        }
        let other = usize::from(register == PreloadRegister::YFirst);
        let next = self.next_stop[other].filter(|_| across);
        let urgent = next.is_some_and(|stop| axis_of(register).takes(stop, colour));
        self.ask(colour, Wanted::Register(register), corner, urgent, seen);
    }

    /// Words that come with the fold that asks for them, but those that the model holds back.
    fn transfer_at_once(
        &mut self,
        colour: Colour,
        register: PreloadRegister,
        corner: u32,
        fold: TimedFold,
        seen: Tick,
        program: &mut SweepProgram,
    ) {
        self.watch.wanted();
        self.watch.loaded();
        let asking = Asking { crossing: Some(self.crossing), colour, register: Some(register) };
        let corner = self.stored(corner, seen, asking);
        // Wired, it is there with the fold itself: not later than the last tick before it.
        if W::LISTENS {
            let slack = slack(&self.clock, fold.time, seen).min(0);
            self.is_ready(colour, register, Tick(seen.0.saturating_add_signed(slack)));
        }
        let words = self.hold_back(colour, register, corner, self.crossing, seen);
        if !words.is_empty() {
            let load = Load { colour, target: Target::Preload(register), corner, words };
            program.steps.push(Step::new(fold.time, fold.range, StepKind::Load(load)));
            self.watch.arrival(seen, &load);
        }
    }

    /// Sends the words that the model holds back, later than `tick`, when their set comes; the words that are left.
    fn hold_back(
        &mut self,
        colour: Colour,
        register: PreloadRegister,
        corner: u32,
        crossing: u32,
        tick: Tick,
    ) -> WordMask {
        let mut in_time = WordMask::ALL;
        let unit = self.unit;
        for delay in unit.delays(self.frame, self.sweep, crossing) {
            if delay.colour == colour && delay.register == register && delay.ticks > 0 {
                let words = WordMask::only(delay.word);
                in_time = in_time.without(words);
                let tick = Tick(tick.0 + delay.ticks);
                let load = Load { colour, target: Target::Preload(register), corner, words };
                self.send(load, register, tick, self.requests, MissCause::HeldBack);
                self.requests += 1;
                self.is_ready(colour, register, tick);
            }
        }
        in_time
    }

    fn ask(&mut self, colour: Colour, wanted: Wanted, corner: u32, urgent: bool, asked: Tick) {
        let (number, crossing) = (self.requests, self.crossing);
        self.requests += 1;
        self.server.ask(Job { number, colour, wanted, corner, asked, crossing, urgent, late: false });
        self.watch.wanted();
    }

    /// The last words of a register come at `tick`, or later.
    fn is_ready(&mut self, colour: Colour, register: PreloadRegister, tick: Tick) {
        let ready = &mut self.ready[colour as usize][register as usize];
        *ready = Some(ready.map_or(tick, |known| known.max(tick)));
    }

    /// Words that come at `tick`.
    fn send(&mut self, load: Load, register: PreloadRegister, tick: Tick, number: u32, cause: MissCause) {
        let arrival = self.instant_of(tick);
        self.pending.push(Delivery { tick, arrival, number, load, register, cause });
    }

    /// Serves what begins before `end`.
    fn run_server(&mut self, end: Option<Tick>, program: &mut SweepProgram) {
        while let Some(served) = self.server.next(end) {
            self.bring(&served, program);
        }
    }

    fn bring(&mut self, served: &Served, program: &mut SweepProgram) {
        let Job { number, colour, wanted, corner, late, crossing, .. } = served.job;
        let register = match wanted {
            Wanted::Register(register) => Some(register),
            Wanted::Diagonal => None,
        };
        let asking = Asking { crossing: Some(crossing), colour, register };
        let corner = self.stored(corner, served.begin, asking);
        let last = self.server.arrivals(served).map(|(tick, _)| tick).last().unwrap_or(served.begin);
        self.watch.loaded();
        let Some(register) = register else {
            self.diagonals[colour as usize] = Some(last);
            return;
        };
        let (target, cause) = (
            if late { Target::Hold } else { Target::Preload(register) },
            if served.waited { MissCause::Queue } else { MissCause::Access },
        );
        if late {
            self.late_set_comes(colour, register, crossing, last, program);
        } else {
            self.is_ready(colour, register, last);
        }
        let in_time = self.hold_back(colour, register, corner, crossing, last);
        for (tick, words) in self.server.arrivals(served) {
            let load = Load { colour, target, corner, words: words.and(in_time) };
            if !load.words.is_empty() {
                self.send(load, register, tick, number, cause);
            }
        }
    }

    /// A set that a fold missed while it waited is on its way: now it is known when it comes.
    fn late_set_comes(
        &mut self,
        colour: Colour,
        register: PreloadRegister,
        asked: u32,
        tick: Tick,
        program: &mut SweepProgram,
    ) {
        let arrival = self.instant_of(tick);
        let waits = |miss: &&mut Miss| {
            miss.arrival.is_none()
                && miss.colour == colour
                && miss.register == register
                && miss.crossing > asked
        };
        if let Some(miss) = program.misses.iter_mut().rev().find(waits) {
            miss.arrival = Some(arrival);
            self.watch.transfer(slack(&self.clock, miss.time, tick));
        }
    }

    /// Index of a corner in the storage buffer at `tick`, or that of no corner; `of` is who asks for it.
    fn stored(&mut self, corner: u32, tick: Tick, of: Asking) -> u32 {
        if !W::LISTENS && self.unit.missing.is_empty() {
            return corner;
        }
        let arrival = self.unit.arrival_of(corner);
        let Asking { crossing, colour, register } = of;
        let at = self.instant_of(tick);
        self.watch.corner(&AskedCorner { tick, at, crossing, colour, register, corner, arrival });
        let is_there = match arrival {
            CornerArrival::BeforeFrame => true,
            CornerArrival::At(arrival) => arrival <= tick,
            CornerArrival::NotInFrame => false,
        };
        if is_there { corner } else { NO_CORNER }
    }

    /// Home registers are filled from the same buffer.
    fn look_up_home(&mut self, program: &mut SweepProgram) {
        if !W::LISTENS && self.unit.missing.is_empty() {
            return;
        }
        let tick = self.seen(SweepTime(0.0));
        for (colour, set) in Colour::ALL.into_iter().zip(&mut program.registers) {
            let [x, y] = [PreloadRegister::XFirst, PreloadRegister::YFirst].map(Some);
            for (register, corner) in [(None, &mut set.hold), (x, &mut set.x_first), (y, &mut set.y_first)] {
                *corner = self.stored(*corner, tick, Asking { crossing: None, colour, register });
            }
        }
    }

    /// Puts what arrives until `time` into the program, in order of arrival.
    fn deliver_until(
        &mut self,
        time: SweepTime,
        range_at: &impl Fn(SweepTime) -> f64,
        program: &mut SweepProgram,
    ) {
        if self.pending.is_empty() {
            return;
        }
        self.pending.sort_by(|a, b| a.arrival.0.total_cmp(&b.arrival.0).then(a.number.cmp(&b.number)));
        let arrived = self.pending.partition_point(|delivery| delivery.arrival <= time);
        for Delivery { tick, arrival, load, .. } in self.pending.drain(..arrived) {
            program.steps.push(Step::new(arrival, range_at(arrival), StepKind::Load(load)));
            self.watch.arrival(tick, &load);
        }
    }
}

/// The axis whose stop transfers a preload register.
fn axis_of(register: PreloadRegister) -> RampAxis {
    match register {
        PreloadRegister::XFirst => RampAxis::X,
        PreloadRegister::YFirst => RampAxis::Y,
    }
}

/// Adds a miss, or its words to that of the same set.
fn note_miss(misses: &mut Vec<Miss>, miss: Miss) {
    let same = |other: &&mut Miss| {
        (other.crossing, other.colour, other.register) == (miss.crossing, miss.colour, miss.register)
    };
    match misses.iter_mut().find(same) {
        Some(known) => {
            known.words = known.words.or(miss.words);
            if miss.arrival > known.arrival {
                known.arrival = miss.arrival;
            }
        }
        None => misses.push(miss),
    }
}
