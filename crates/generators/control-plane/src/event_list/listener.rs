//! What the service of one sweep over one level tells, as a list.

use dpu::{AskedCorner, AskedSet, Register, ServiceEvent, Watch};
use hardware_model::CrossingServer;
use quantities::Tick;
use sweep_program::{Colour, Fold, Load, Miss, NO_CORNER, PreloadRegister, Target, WordMask};

use crate::digital_event::{DigitalEvent, DigitalUnit, EventWord};
use crate::frame_sweeps::FrameSweeps;

/// The listener. What it hears it writes down: it works out nothing.
pub struct Listener<'a> {
    /// Events in the order in which they were told.
    pub events: Vec<DigitalEvent>,
    sweeps: &'a FrameSweeps<'a>,
    sweep: u32,
    level: usize,
    /// Corners of the level to the east.
    columns: usize,
}

impl<'a> Listener<'a> {
    /// Nothing heard yet of sweep `sweep` over level `level`.
    pub fn new(sweeps: &'a FrameSweeps<'a>, sweep: u32, level: usize) -> Self {
        let columns = sweeps.crossings().stage.landscape.bank().levels()[level].corners()[1];
        Self { events: Vec::new(), sweeps, sweep, level, columns }
    }

    fn event(&self, tick: Tick, event: EventWord, unit: DigitalUnit) -> DigitalEvent {
        let (sweep, level) = (Some(self.sweep), Some(self.level));
        DigitalEvent { sweep, level, ..DigitalEvent::new(tick, event, unit) }
    }

    /// An event of `words` of a register.
    fn of_words(
        &self,
        event: DigitalEvent,
        colour: Colour,
        register: Register,
        words: WordMask,
    ) -> DigitalEvent {
        let (colour, register) = (Some(colour), Some(register));
        DigitalEvent { colour, register, mask: words, words: words.0.count_ones(), ..event }
    }

    /// The unit that serves a colour: the same words as in the timing record.
    fn server(&self, colour: Colour) -> DigitalUnit {
        match self.sweeps.loader().served_by {
            CrossingServer::WiredPointers => DigitalUnit::Loader(colour),
            CrossingServer::IoProcessor => DigitalUnit::IoProcessor,
            CrossingServer::CpuInterrupt => DigitalUnit::Cpu,
        }
    }

    fn place(&self, corner: u32) -> Option<[i64; 2]> {
        let corner = (corner != NO_CORNER).then_some(corner as usize)?;
        Some([(corner / self.columns) as i64, (corner % self.columns) as i64])
    }

    fn stop(&self, tick: Tick, crossing: u32, fold: Fold) -> DigitalEvent {
        let stop = self.event(tick, EventWord::Stop, DigitalUnit::Dpu);
        DigitalEvent { crossing: Some(crossing), fold: Some(fold), ..stop }
    }

    fn of_preload(
        &self,
        tick: Tick,
        word: EventWord,
        colour: Colour,
        register: PreloadRegister,
        corner: u32,
    ) -> DigitalEvent {
        let event = self.event(tick, word, DigitalUnit::Registers);
        let event = DigitalEvent { corner: self.place(corner), ..event };
        self.of_words(event, colour, Register::Preload(register), WordMask::ALL)
    }

    fn of_set(&self, tick: Tick, word: EventWord, set: AskedSet) -> DigitalEvent {
        let event = self.event(tick, word, self.server(set.colour));
        let event = DigitalEvent { crossing: Some(set.crossing), ..event };
        self.of_words(event, set.colour, set.register, WordMask::ALL)
    }

    fn of_corner(&self, tick: Tick, word: EventWord, unit: DigitalUnit, asked: &AskedCorner) -> DigitalEvent {
        let event = self.event(tick, word, unit);
        let event = DigitalEvent { crossing: asked.crossing, corner: self.place(asked.corner), ..event };
        self.of_words(event, asked.colour, asked.register, WordMask::ALL)
    }

    /// Who looked for the corner of the event before did not find it.
    fn absent(&self, tick: Tick, asked: &AskedCorner) -> DigitalEvent {
        let unit = self.events.last().map_or(DigitalUnit::Registers, |event| event.unit);
        self.of_corner(tick, EventWord::Absent, unit, asked)
    }

    fn load(&self, tick: Tick, load: Load) -> DigitalEvent {
        let register = match load.target {
            Target::Hold => Register::Hold,
            Target::Preload(register) => Register::Preload(register),
        };
        let event = self.event(tick, EventWord::Load, DigitalUnit::Registers);
        let event = DigitalEvent { corner: self.place(load.corner), ..event };
        self.of_words(event, load.colour, register, load.words)
    }

    fn late(&self, seen: Tick, miss: Miss) -> DigitalEvent {
        let due = seen.0 as i64 - i64::from(self.sweeps.clock(self.sweep).instant_of(seen) > miss.time);
        let came = |arrival| self.sweeps.tick_of(self.sweep, arrival).0 as i64;
        let event = DigitalEvent {
            crossing: Some(miss.crossing),
            corner: self.place(miss.corner),
            slack: miss.arrival.map(|arrival| due - came(arrival)),
            cause: Some(miss.cause),
            comes: miss.arrival,
            ..self.event(seen, EventWord::Late, DigitalUnit::Registers)
        };
        self.of_words(event, miss.colour, Register::Preload(miss.register), miss.words)
    }

    /// The row of an event; none for what a list of events does not have.
    fn row(&self, tick: Tick, event: ServiceEvent) -> Option<DigitalEvent> {
        let registers = DigitalUnit::Registers;
        Some(match event {
            ServiceEvent::Home(asked) => self.of_corner(tick, EventWord::Home, registers, &asked),
            ServiceEvent::Stop { crossing, fold } => self.stop(tick, crossing, fold),
            ServiceEvent::Transfer { crossing, colour, register, corner, .. } => {
                let event = self.of_preload(tick, EventWord::Transfer, colour, register, corner);
                DigitalEvent { crossing: Some(crossing), ..event }
            }
            ServiceEvent::Wasted { colour, register, corner } => {
                self.of_preload(tick, EventWord::Wasted, colour, register, corner)
            }
            ServiceEvent::Wanted(set) => self.of_set(tick, EventWord::Wanted, set),
            ServiceEvent::Cancelled(set) => self.of_set(tick, EventWord::Cancelled, set),
            ServiceEvent::Diagonal(asked) => self.of_corner(tick, EventWord::Diagonal, registers, &asked),
            ServiceEvent::Access(asked) => {
                self.of_corner(tick, EventWord::Access, self.server(asked.colour), &asked)
            }
            ServiceEvent::Absent(asked) => self.absent(tick, &asked),
            ServiceEvent::Load(load) => self.load(tick, load),
            ServiceEvent::Late { miss, .. } => self.late(tick, miss),
            ServiceEvent::LateSet { .. } => return None,
        })
    }
}

impl Watch for Listener<'_> {
    fn tell(&mut self, tick: Tick, event: ServiceEvent) {
        let row = self.row(tick, event);
        self.events.extend(row);
    }
}
