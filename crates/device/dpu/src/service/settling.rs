//! What a fold finds: sets used and wasted, words too late for it, words for a place that its colours have left.

use hardware_model::LatePolicy;
use quantities::Tick;
use sweep_program::{
    Colour, Event, Load, Miss, MissCause, NO_CORNER, PreloadRegister, SweepProgram, Target, WordMask,
};

use super::Service;
use super::deliveries::Delivery;
use crate::server::{Job, Wanted};
use crate::unit::TimedFold;
use crate::watch::{AskedSet, ServiceEvent, Watch};

impl<W: Watch> Service<'_, '_, '_, W> {
    /// What is still on its way for a colour that has just been transferred has come too late or moved on.
    pub(super) fn settle(&mut self, fold: TimedFold, seen: Tick, program: &mut SweepProgram) {
        if W::LISTENS {
            fold.kind.colours().into_iter().for_each(|colour| self.settle_ready(colour, fold, seen));
            if let Some(held) = &mut self.held {
                held.follow(&Event::Fold(fold.kind));
            }
        }
        self.settle_queue(fold, seen, program);
        self.settle_pending(fold, program);
    }

    /// One set of a colour is used, and the other is not.
    fn settle_ready(&mut self, colour: Colour, fold: TimedFold, seen: Tick) {
        let used = fold.kind.axis.register();
        let unused = match used {
            PreloadRegister::XFirst => PreloadRegister::YFirst,
            PreloadRegister::YFirst => PreloadRegister::XFirst,
        };
        let ready = std::mem::take(&mut self.ready[colour as usize]);
        let left_of = |register: PreloadRegister| {
            ready[register as usize].map(|ready| self.due.0 as i64 - ready.0 as i64)
        };
        let corner = |register| self.held.as_ref().map_or(NO_CORNER, |held| held.waiting(colour, register));
        let (crossing, slack, left) = (self.crossing, left_of(used), left_of(unused));
        let transfer =
            ServiceEvent::Transfer { crossing, colour, register: used, corner: corner(used), slack };
        let wasted = ServiceEvent::Wasted { colour, register: unused, corner: corner(unused) };
        self.watch.tell(seen, transfer);
        if left.is_some_and(|left| left >= 0) {
            self.watch.tell(seen, wasted);
        }
    }

    fn settle_queue(&mut self, fold: TimedFold, seen: Tick, program: &mut SweepProgram) {
        let (axis, crossing) = (fold.kind.axis, self.crossing);
        let strobe = self.unit.loader.late_policy == LatePolicy::StrobeThrough;
        let watch = &mut *self.watch;
        self.server.retain(fold.kind.colours(), |job| {
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
                let Job { crossing, colour, wanted, .. } = *job;
                let set = AskedSet { crossing, colour, register: wanted.register() };
                watch.tell(seen, ServiceEvent::Cancelled(set));
            }
            kept
        });
    }

    fn settle_pending(&mut self, fold: TimedFold, program: &mut SweepProgram) {
        let crossing = self.crossing;
        let strobe = self.unit.loader.late_policy == LatePolicy::StrobeThrough;
        self.pending.retain_mut(|delivery| {
            let load = &mut delivery.load;
            if !fold.kind.axis.takes(fold.kind.stop, load.colour) {
                return true;
            }
            let missed = delivery.register == fold.kind.axis.register() && load.target != Target::Hold;
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
