//! Who hears the service of one sweep over one level, and writes it down.

use std::collections::VecDeque;

use dpu::{AskedCorner, CornerArrival, Watch};
use hardware_model::{CrossingServer, LatePolicy, Loader};
use landscape::Level;
use quantities::{SweepClock, Tick};
use sweep_program::{Colour, Fold, Load, Miss, NO_CORNER, PreloadRegister, SweepProgram, Target, WordMask};

use super::tick_of;
use crate::digital_event::{DigitalEvent, DigitalUnit, EventWord, Register};
use crate::frame_sweeps::FrameSweeps;

const PRELOADS: [PreloadRegister; 2] = [PreloadRegister::XFirst, PreloadRegister::YFirst];

/// A set that was asked for and that nobody has fetched.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Asked {
    colour: Colour,
    register: Register,
    crossing: u32,
    /// Whether a fold has found it missing.
    late: bool,
}

/// The listener.
pub struct Listener<'a> {
    events: Vec<DigitalEvent>,
    sweeps: &'a FrameSweeps<'a>,
    sweep: u32,
    number: usize,
    level: &'a Level,
    loader: &'a Loader,
    clock: SweepClock,
    /// When the last fold was seen, and folds so far.
    seen: Tick,
    folds: u32,
    /// Sets that the fold asks for, in the order in which it does.
    next: VecDeque<(Colour, Register)>,
    queue: Vec<Asked>,
    /// Corner in each register, by colour: hold, x-first, y-first.
    held: [[u32; 3]; 4],
    /// Words of each preload register that have come since its colour moved.
    come: [[WordMask; 2]; 4],
    /// Sets wasted and cancelled so far, as they were told and as they are listed.
    told: [usize; 2],
    listed: [usize; 2],
}

impl<'a> Listener<'a> {
    pub fn new(
        sweeps: &'a FrameSweeps<'a>,
        sweep: u32,
        number: usize,
        level: &'a Level,
        loader: &'a Loader,
    ) -> Self {
        Self {
            events: Vec::new(),
            sweeps,
            sweep,
            number,
            level,
            loader,
            clock: sweeps.clock(sweep),
            seen: Tick(0),
            folds: 0,
            next: VecDeque::new(),
            queue: Vec::new(),
            held: [[NO_CORNER; 3]; 4],
            come: [[WordMask(0); 2]; 4],
            told: [0; 2],
            listed: [0; 2],
        }
    }

    /// The events in the order in which they were told, then what the program says of late words.
    pub fn finish(mut self, program: &SweepProgram) -> Vec<DigitalEvent> {
        self.compare();
        for miss in &program.misses {
            let event = self.late(miss);
            self.events.push(event);
        }
        self.events
    }

    /// What follows from the wiring is what the service does, fold by fold.
    fn compare(&self) {
        debug_assert_eq!(self.told, self.listed, "sweep {}, fold {}", self.sweep, self.folds);
    }

    fn event(&self, tick: Tick, event: EventWord, unit: DigitalUnit) -> DigitalEvent {
        let (sweep, level) = (Some(self.sweep), Some(self.number));
        DigitalEvent { sweep, level, ..DigitalEvent::new(tick, event, unit) }
    }

    /// The unit that serves a colour: the same words as in the timing record.
    fn server(&self, colour: Colour) -> DigitalUnit {
        match self.loader.served_by {
            CrossingServer::WiredPointers => DigitalUnit::Loader(colour),
            CrossingServer::IoProcessor => DigitalUnit::IoProcessor,
            CrossingServer::CpuInterrupt => DigitalUnit::Cpu,
        }
    }

    fn place(&self, corner: u32) -> Option<[i64; 2]> {
        let (corner, columns) = ((corner != NO_CORNER).then_some(corner as usize)?, self.level.corners()[1]);
        Some([(corner / columns) as i64, (corner % columns) as i64])
    }

    /// Two colours take a preload register each (fig. 22); their other one is overwritten, full or not.
    fn transfer(&mut self, tick: Tick, fold: Fold, crossing: u32) {
        let used = fold.axis.register();
        for colour in fold.colours() {
            let corner = self.held[colour as usize][1 + used as usize];
            self.held[colour as usize][0] = corner;
            let transfer = self.event(tick, EventWord::Transfer, DigitalUnit::Registers);
            self.events.push(DigitalEvent {
                crossing: Some(crossing),
                colour: Some(colour),
                register: Some(Register::Preload(used)),
                corner: self.place(corner),
                mask: WordMask::ALL,
                words: WordMask::ALL.0.count_ones(),
                ..transfer
            });
            self.overwrite(tick, colour, used);
        }
    }

    fn overwrite(&mut self, tick: Tick, colour: Colour, used: PreloadRegister) {
        for register in PRELOADS {
            let come = std::mem::replace(&mut self.come[colour as usize][register as usize], WordMask(0));
            if register != used && come == WordMask::ALL {
                self.listed[0] += 1;
                let wasted = self.event(tick, EventWord::Wasted, DigitalUnit::Registers);
                let corner = self.place(self.held[colour as usize][1 + register as usize]);
                self.events.push(DigitalEvent {
                    colour: Some(colour),
                    register: Some(Register::Preload(register)),
                    corner,
                    mask: come,
                    words: come.0.count_ones(),
                    ..wasted
                });
            }
        }
    }

    /// What waits for a colour that moves is dropped, but what the fold itself needs, where it may come late.
    fn cancel(&mut self, tick: Tick, fold: Fold) {
        let strobe = self.loader.late_policy == LatePolicy::StrobeThrough;
        let mut dropped = Vec::new();
        self.queue.retain_mut(|asked| {
            if !fold.axis.takes(fold.stop, asked.colour) {
                return true;
            }
            let needed = asked.register == Register::Preload(fold.axis.register()) && !asked.late;
            asked.late |= needed;
            if !(needed && strobe) {
                dropped.push(*asked);
            }
            needed && strobe
        });
        self.listed[1] += dropped.len();
        for asked in dropped {
            let event = self.of_set(tick, EventWord::Cancelled, asked);
            self.events.push(event);
        }
    }

    fn of_set(&self, tick: Tick, event: EventWord, asked: Asked) -> DigitalEvent {
        DigitalEvent {
            crossing: Some(asked.crossing),
            colour: Some(asked.colour),
            register: Some(asked.register),
            mask: WordMask::ALL,
            words: WordMask::ALL.0.count_ones(),
            ..self.event(tick, event, self.server(asked.colour))
        }
    }

    /// Sets that a fold asks for: both preload registers of either colour, then its diagonal one.
    fn expect(&mut self, fold: Fold) {
        self.next.clear();
        for colour in fold.colours() {
            self.next.extend(PRELOADS.map(|register| (colour, Register::Preload(register))));
            if self.loader.diagonal_register && !self.loader.is_wired_through() {
                self.next.push_back((colour, Register::Diagonal));
            }
        }
    }

    fn late(&self, miss: &Miss) -> DigitalEvent {
        let seen = self.clock.tick_at_or_after(miss.time);
        let due = seen.0 as i64 - i64::from(self.clock.instant_of(seen) > miss.time);
        DigitalEvent {
            crossing: Some(miss.crossing),
            colour: Some(miss.colour),
            register: Some(Register::Preload(miss.register)),
            corner: self.place(miss.corner),
            mask: miss.words,
            words: miss.words.0.count_ones(),
            slack: miss.arrival.map(|arrival| due - tick_of(self.sweeps, self.sweep, arrival).0 as i64),
            cause: Some(miss.cause),
            comes: miss.arrival,
            ..self.event(seen, EventWord::Late, DigitalUnit::Registers)
        }
    }
}

impl Watch for Listener<'_> {
    fn fold(&mut self, tick: Tick, fold: Fold) {
        self.compare();
        let crossing = self.folds;
        self.seen = tick;
        self.folds += 1;
        let stop = self.event(tick, EventWord::Stop, DigitalUnit::Dpu);
        self.events.push(DigitalEvent { crossing: Some(crossing), fold: Some(fold), ..stop });
        if self.loader.stop_after_crossings.is_none_or(|last| crossing < last) {
            self.transfer(tick, fold, crossing);
            self.cancel(tick, fold);
            self.expect(fold);
        }
    }

    fn wanted(&mut self) {
        let Some((colour, register)) = self.next.pop_front() else { return };
        let asked = Asked { colour, register, crossing: self.folds - 1, late: false };
        self.queue.push(asked);
        let event = self.of_set(self.seen, EventWord::Wanted, asked);
        self.events.push(event);
    }

    fn wasted(&mut self) {
        self.told[0] += 1;
    }

    fn cancelled(&mut self) {
        self.told[1] += 1;
    }

    fn corner(&mut self, asked: &AskedCorner) {
        let &AskedCorner { tick, crossing, colour, corner, .. } = asked;
        let register = match (crossing, asked.register) {
            (_, Some(register)) => Register::Preload(register),
            (None, None) => Register::Hold,
            (Some(_), None) => Register::Diagonal,
        };
        let is_next = crossing.is_some() && self.next.front() == Some(&(colour, register));
        let (word, unit) = match crossing {
            None => (EventWord::Home, DigitalUnit::Registers),
            // The service comes to a register that has not been asked for: its words have moved over.
            Some(_) if is_next => (EventWord::Diagonal, DigitalUnit::Registers),
            Some(_) => (EventWord::Access, self.server(colour)),
        };
        if is_next {
            self.next.pop_front();
        }
        self.queue
            .retain(|set| (set.colour, set.register, Some(set.crossing)) != (colour, register, crossing));
        let event = DigitalEvent {
            crossing,
            colour: Some(colour),
            register: Some(register),
            corner: self.place(corner),
            mask: WordMask::ALL,
            words: WordMask::ALL.0.count_ones(),
            ..self.event(tick, word, unit)
        };
        self.events.push(event);
        let is_there = match asked.arrival {
            CornerArrival::BeforeFrame => true,
            CornerArrival::At(arrival) => arrival <= tick,
            CornerArrival::NotInFrame => false,
        };
        if crossing.is_none() {
            let register = asked.register.map_or(0, |register| 1 + register as usize);
            self.held[colour as usize][register] = if is_there { corner } else { NO_CORNER };
        }
        if !is_there {
            self.events.push(DigitalEvent { event: EventWord::Absent, ..event });
        }
    }

    fn arrival(&mut self, tick: Tick, load: &Load) {
        let &Load { colour, target, corner, words } = load;
        let (register, number) = match target {
            Target::Hold => (Register::Hold, 0),
            Target::Preload(register) => (Register::Preload(register), 1 + register as usize),
        };
        if words.has(0) {
            self.held[colour as usize][number] = corner;
        }
        if let Target::Preload(register) = target {
            let come = &mut self.come[colour as usize][register as usize];
            *come = come.or(words);
        }
        let event = DigitalEvent {
            colour: Some(colour),
            register: Some(register),
            corner: self.place(corner),
            mask: words,
            words: words.0.count_ones(),
            ..self.event(tick, EventWord::Load, DigitalUnit::Registers)
        };
        self.events.push(event);
    }
}
