//! What a fold finds: sets used and wasted, words too late for it, words for a place that its colours have left.

use hardware_model::LatePolicy;
use quantities::SweepTime;
use sweep_program::{Colour, Load, Miss, MissCause, PreloadRegister, SweepProgram, Target, WordMask, slack};

use super::Service;
use super::deliveries::Delivery;
use crate::server::Wanted;
use crate::unit::TimedFold;
use crate::watch::Watch;

impl<W: Watch> Service<'_, '_, '_, W> {
    /// What is still on its way for a colour that has just been transferred has come too late or moved on.
    pub(super) fn settle(&mut self, fold: TimedFold, program: &mut SweepProgram) {
        for colour in fold.kind.colours().into_iter().filter(|_| W::LISTENS) {
            self.settle_ready(colour, fold.kind.axis.register(), fold.time);
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
