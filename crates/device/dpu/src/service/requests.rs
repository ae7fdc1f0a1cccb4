//! What a fold asks for: both preload registers of the colours that moved, and the corner beyond both stops.

use quantities::Tick;
use sweep_program::{
    Colour, Event, Load, MissCause, PreloadRegister, RampAxis, Step, SweepProgram, Target, WordMask,
};

use super::Service;
use super::stored::Asking;
use crate::server::{Job, Wanted};
use crate::unit::TimedFold;
use crate::watch::{AskedSet, Register, ServiceEvent, Watch};

/// A set whose words come to a preload register at a tick.
#[derive(Debug, Clone, Copy)]
pub(super) struct ComingSet {
    pub colour: Colour,
    pub register: PreloadRegister,
    /// Index in the level.
    pub corner: u32,
    /// The fold that asked, counted from 0 in the sweep.
    pub crossing: u32,
    pub tick: Tick,
}

impl<W: Watch> Service<'_, '_, '_, W> {
    /// Both preload registers of a colour that has moved, and its diagonal one.
    pub(super) fn renew(&mut self, colour: Colour, fold: TimedFold, seen: Tick, program: &mut SweepProgram) {
        let other = match fold.kind.axis {
            RampAxis::X => PreloadRegister::YFirst,
            RampAxis::Y => PreloadRegister::XFirst,
        };
        let loader = self.unit.loader;
        let has_diagonal = loader.diagonal_register && !loader.is_wired_through();
        // There at the fold itself, not only at the tick that sees it; tick 0 is before the sweep.
        let is_there = |ready: Tick| ready == Tick(0) || self.instant_of(ready) <= fold.time;
        let at_hand = has_diagonal && self.diagonals[colour as usize].is_some_and(is_there);
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
        let asking = Asking { crossing: Some(self.crossing), colour, register: Register::Preload(register) };
        let corner = self.unit.level.clamped_index(m, n) as u32;
        let corner = self.stored(corner, seen, asking, ServiceEvent::Diagonal);
        let load = Load { colour, target: Target::Preload(register), corner, words: WordMask::ALL };
        program.steps.push(Step::new(fold.time, fold.range, Event::Load(load)));
        // Not later than the last tick before the fold, so that another fold within the same tick finds them.
        self.ready[colour as usize][register as usize] = Some(self.due);
        Self::tell_load(&mut self.held, self.watch, seen, load);
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
        let (crossing, place) = (self.crossing, Register::Preload(register));
        self.watch.tell(seen, ServiceEvent::Wanted(AskedSet { crossing, colour, register: place }));
        let asking = Asking { crossing: Some(crossing), colour, register: place };
        let corner = self.stored(corner, seen, asking, ServiceEvent::Access);
        if W::LISTENS {
            self.is_ready(colour, register, self.due);
        }
        let words = self.hold_back(ComingSet { colour, register, corner, crossing, tick: seen });
        if !words.is_empty() {
            let load = Load { colour, target: Target::Preload(register), corner, words };
            program.steps.push(Step::new(fold.time, fold.range, Event::Load(load)));
            Self::tell_load(&mut self.held, self.watch, seen, load);
        }
    }

    /// Sends the words of a set that the model holds back, later than the others; the words that are left. Few models hold any
    /// back.
    #[inline]
    pub(super) fn hold_back(&mut self, set: ComingSet) -> WordMask {
        if self.unit.loader.delays.is_empty() { WordMask::ALL } else { self.hold_back_some(set) }
    }

    #[cold]
    fn hold_back_some(&mut self, set: ComingSet) -> WordMask {
        let ComingSet { colour, register, corner, crossing, tick } = set;
        let (unit, mut in_time) = (self.unit, WordMask::ALL);
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
        let set = AskedSet { crossing, colour, register: wanted.register() };
        self.watch.tell(asked, ServiceEvent::Wanted(set));
    }

    /// The last words of a register come at `tick`, or later.
    pub(super) fn is_ready(&mut self, colour: Colour, register: PreloadRegister, tick: Tick) {
        let ready = &mut self.ready[colour as usize][register as usize];
        *ready = Some(ready.map_or(tick, |known| known.max(tick)));
    }
}

/// The axis whose stop transfers a preload register.
fn axis_of(register: PreloadRegister) -> RampAxis {
    match register {
        PreloadRegister::XFirst => RampAxis::X,
        PreloadRegister::YFirst => RampAxis::Y,
    }
}
