//! Words on their way: from the server, or held back, into the program in order of arrival.

use quantities::{SweepTime, Tick};
use sweep_program::{
    Colour, Event, Load, Miss, MissCause, PreloadRegister, Step, SweepProgram, Target, slack,
};

use super::Service;
use super::requests::ComingSet;
use super::stored::Asking;
use crate::server::{Job, Served, Wanted};
use crate::watch::{ServiceEvent, Watch};

/// Words on their way.
#[derive(Debug, Clone, Copy)]
pub(super) struct Delivery {
    pub tick: Tick,
    pub arrival: SweepTime,
    /// Number of the request: what arrives in one instant keeps the order in which it was asked for.
    pub number: u32,
    pub load: Load,
    /// The preload register that asked.
    pub register: PreloadRegister,
    pub cause: MissCause,
}

impl<W: Watch> Service<'_, '_, '_, W> {
    /// Words that come at `tick`.
    pub(super) fn send(
        &mut self,
        load: Load,
        register: PreloadRegister,
        tick: Tick,
        number: u32,
        cause: MissCause,
    ) {
        let arrival = self.instant_of(tick);
        let later = |delivery: &Delivery| (delivery.tick, delivery.number) > (tick, number);
        let place = self.pending.iter().rposition(|delivery| !later(delivery)).map_or(0, |before| before + 1);
        self.pending.insert(place, Delivery { tick, arrival, number, load, register, cause });
    }

    /// Serves what begins before `end`.
    pub(super) fn run_server(&mut self, end: Option<Tick>, program: &mut SweepProgram) {
        for line in self.server.lines() {
            while let Some(served) = self.server.next(line, end) {
                self.bring(&served, program);
            }
        }
    }

    fn bring(&mut self, served: &Served, program: &mut SweepProgram) {
        let Job { number, colour, wanted, corner, late, crossing, .. } = served.job;
        let register = match wanted {
            Wanted::Register(register) => Some(register),
            Wanted::Diagonal => None,
        };
        let asking = Asking { crossing: Some(crossing), colour, register: wanted.register() };
        let corner = self.stored(corner, served.begin, asking, ServiceEvent::Access);
        let last = self.server.last(served);
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
        let in_time = self.hold_back(ComingSet { colour, register, corner, crossing, tick: last });
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
            let slack = slack(&self.clock, miss.time, tick);
            self.watch.tell(tick, ServiceEvent::LateSet { slack });
        }
    }

    /// Puts what arrives until `time` into the program, in order of arrival.
    pub(super) fn deliver_until(
        &mut self,
        time: SweepTime,
        range_at: &impl Fn(SweepTime) -> f64,
        program: &mut SweepProgram,
    ) {
        let arrived = self.pending.iter().take_while(|delivery| delivery.arrival <= time).count();
        if arrived == 0 {
            return;
        }
        for Delivery { tick, arrival, load, .. } in self.pending.drain(..arrived) {
            program.steps.push(Step::new(arrival, range_at(arrival), Event::Load(load)));
            Self::tell_load(&mut self.held, self.watch, tick, load);
        }
    }
}
