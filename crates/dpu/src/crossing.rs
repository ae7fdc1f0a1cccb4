//! Service of the crossings: from folds to a sweep program.

use hardware_model::{LatePolicy, LoadDelay, Loader};
use landscape::Level;
use quantities::{SweepTime, Tick, Timebase};
use sweep_program::{
    Colour, Fold, Load, Miss, PreloadRegister, Step, StepKind, SweepProgram, SweepStart, Target, WordMask,
};

use crate::Pointers;

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

/// The unit that answers folds with coefficient words.
#[derive(Debug, Clone, Copy)]
pub struct CrossingService<'a> {
    /// Terrain whose corners are delivered.
    pub level: &'a Level,
    /// How fast, and what happens to late words.
    pub loader: &'a Loader,
    /// Clocks of the run.
    pub timebase: &'a Timebase,
}

/// Words on their way.
#[derive(Debug, Clone, Copy)]
struct Request {
    arrival: SweepTime,
    load: Load,
    /// The preload register that asked.
    register: PreloadRegister,
}

/// The program being written.
struct Service<'a, 's> {
    unit: &'s CrossingService<'a>,
    frame: u64,
    sweep: u32,
    pointers: Pointers,
    pending: Vec<Request>,
    crossing: u32,
}

impl CrossingService<'_> {
    /// Writes the program of sweep `sweep` of frame `frame` into `program`, whose buffers are reused. `folds`
    /// ends where the profile ends, at `end_range` (m); `range_at` gives the range of an instant.
    pub fn write_program(
        &self,
        (frame, sweep): (u64, u32),
        start: SweepStart,
        folds: impl Iterator<Item = TimedFold>,
        end_range: f64,
        range_at: impl Fn(SweepTime) -> f64,
        program: &mut SweepProgram,
    ) {
        let pointers = Pointers::at_start(&start);
        program.start = start;
        program.registers = pointers.home_registers(self.level);
        program.end_range = end_range;
        program.steps.clear();
        program.misses.clear();
        let mut service = Service { unit: self, frame, sweep, pointers, pending: Vec::new(), crossing: 0 };
        for fold in folds {
            service.deliver_until(fold.time, &range_at, program);
            service.serve(fold, program);
        }
        service.deliver_until(SweepTime(f64::INFINITY), &range_at, program);
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
}

impl Service<'_, '_> {
    /// One fold: transfer, pointers, requests.
    fn serve(&mut self, fold: TimedFold, program: &mut SweepProgram) {
        program.steps.push(Step::new(fold.time, fold.range, StepKind::Fold(fold.fold)));
        self.settle_late(fold, program);
        self.pointers.follow(fold.fold);
        for colour in Colour::ALL {
            if fold.fold.axis.takes(fold.fold.stop, colour) {
                self.request(colour, PreloadRegister::XFirst, fold, program);
                self.request(colour, PreloadRegister::YFirst, fold, program);
            }
        }
        self.crossing += 1;
    }

    /// What is still on its way for a colour that has just been transferred has come too late or moved on.
    fn settle_late(&mut self, fold: TimedFold, program: &mut SweepProgram) {
        let crossing = self.crossing;
        let strobe = self.unit.loader.late_policy == LatePolicy::StrobeThrough;
        self.pending.retain_mut(|request| {
            let load = &mut request.load;
            if !fold.fold.axis.takes(fold.fold.stop, load.colour) {
                return true;
            }
            let missed = request.register == fold.fold.axis.register() && load.target != Target::Hold;
            if missed {
                let Request { arrival, register, .. } = *request;
                let (colour, words) = (load.colour, load.words);
                program.misses.push(Miss { crossing, time: fold.time, arrival, colour, register, words });
                load.target = Target::Hold;
            }
            missed && strobe
        });
    }

    fn request(
        &mut self,
        colour: Colour,
        register: PreloadRegister,
        fold: TimedFold,
        program: &mut SweepProgram,
    ) {
        let unit = self.unit;
        let [m, n] = self.pointers.ahead(colour, register);
        let corner = unit.level.clamped_index(m, n) as u32;
        let mut in_time = WordMask::ALL;
        for delay in unit.delays(self.frame, self.sweep, self.crossing) {
            if delay.colour == colour && delay.register == register {
                let words = WordMask::only(delay.word);
                in_time = in_time.without(words);
                self.send(colour, register, corner, words, delay.ticks, fold, program);
            }
        }
        if !in_time.is_empty() {
            self.send(colour, register, corner, in_time, 0, fold, program);
        }
    }

    fn send(
        &mut self,
        colour: Colour,
        register: PreloadRegister,
        corner: u32,
        words: WordMask,
        delay: u64,
        fold: TimedFold,
        program: &mut SweepProgram,
    ) {
        let load = Load { colour, target: Target::Preload(register), corner, words };
        let latency = self.unit.loader.access + delay;
        if latency == 0 {
            program.steps.push(Step::new(fold.time, fold.range, StepKind::Load(load)));
            return;
        }
        let seen = self.unit.timebase.tick_at_or_after(self.frame, self.sweep, fold.time);
        let arrival = self.unit.timebase.instant_of(Tick(seen.0 + latency), self.frame, self.sweep);
        self.pending.push(Request { arrival, load, register });
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
        self.pending.sort_by(|a, b| a.arrival.0.total_cmp(&b.arrival.0));
        let arrived = self.pending.partition_point(|request| request.arrival <= time);
        for Request { arrival, load, .. } in self.pending.drain(..arrived) {
            program.steps.push(Step::new(arrival, range_at(arrival), StepKind::Load(load)));
        }
    }
}
