//! The words of the multiplying D/As of a group: strobed, on their way, and what a change does within a step.
//!
//! **Law.** A D/A is linear: a word that changes from w to v at a share p of the step adds to its output at the end what
//! the signal times `v - w` makes of a D/A at rest over the part of the step that is left, and a pulse adds what is left
//! of it. So changes add to the step that all lanes have taken, and several in one step add up.

use std::mem;

use landscape::CornerWords;
use signal::Real;

use super::run::Run;
use super::state::{ArrayState, Coded, Due, Lane};
use super::terms::{ALL, TERMS, term_of, word_of};
use super::words::{Change, Words};

impl<S: Real> Run<'_, S> {
    /// Puts the words on their way whose strobes are due by `sample`.
    #[inline(never)]
    pub(super) fn strobe(&self, sample: i64, state: &mut ArrayState<S>) {
        let when = (&self.array.timing, self.generator);
        let ArrayState { lanes, words, coded, due, .. } = state;
        for (number, (lane, program)) in lanes.iter_mut().zip(self.programs).enumerate() {
            while let Some((at, has_new)) = lane.strobe(sample, program, when) {
                if has_new {
                    self.send(at, (number, lane), coded, words);
                }
            }
        }
        *due = Due::of(lanes);
    }

    /// Puts the words of the hold registers of a lane on their way that are others than before; a nominal D/A has them
    /// `at`.
    fn send(&self, at: f64, (number, lane): (usize, &mut Lane), coded: &mut [Coded; 4], words: &mut Words) {
        let array = self.array;
        let hold = lane.registers.hold(self.generator.buffer);
        let glitching = array.words.as_ref().filter(|_| array.glitch != 0.0);
        for (colour, new) in hold.into_iter().enumerate() {
            if *new == lane.held[colour] {
                continue;
            }
            let coded = &mut coded[colour];
            if coded.words != *new {
                *coded = array.coded(new);
            }
            for word in 0..9 {
                if new[word] == lane.held[colour][word] {
                    continue;
                }
                let (now, share) = (coded.numbers[word], coded.shares[word]);
                let from = mem::replace(&mut lane.numbers[colour][word], now);
                let carry = glitching.map_or(0.0, |part| part.carry(from, now));
                for index in (term_of(colour, word)..).step_by(TERMS).take(3) {
                    let change = Change {
                        at: at + array.timing.later(index),
                        index,
                        lane: number,
                        weight: share * array.factors[index],
                        pulse: array.glitch * carry,
                    };
                    words.send(change, array.grid.cells[index].tau);
                }
            }
            lane.held[colour] = *new;
        }
    }

    /// Registers as they are as a sweep begins.
    pub(super) fn fill_registers(&self, state: &mut ArrayState<S>) {
        let array = self.array;
        for (number, lane) in state.lanes.iter_mut().enumerate() {
            lane.held = lane.registers.hold(self.generator.buffer).map(|words| *words);
            lane.numbers = lane.held.each_ref().map(|words| array.coded(words).numbers);
            for index in 0..ALL {
                let [colour, _] = word_of(index % TERMS);
                *state.wires.weight(index, number) = S::from_f64(array.weight(&lane.held[colour], index));
            }
        }
    }

    /// Gives D/As at rest the words that act by `sample`.
    pub(super) fn take_words(&self, sample: i64, state: &mut ArrayState<S>) {
        let ArrayState { words, wires, .. } = state;
        words.take(sample, |change| *wires.weight(change.index, change.lane) = S::from_f64(change.weight));
    }
}

impl<S: Real> super::PartsArray<S> {
    /// The words of a corner as D/As have them.
    fn coded(&self, words: &CornerWords) -> Coded {
        let mut coded = Coded { words: *words, ..Coded::NONE };
        for word in 0..9 {
            (coded.numbers[word], coded.shares[word]) = self.number(words, word);
        }
        coded
    }

    /// The number of a word in its D/A, 0 where they take any, and its share of full scale there.
    fn number(&self, words: &CornerWords, word: usize) -> (i32, f64) {
        let share = self.scale.share(words, word);
        self.words.as_ref().map_or((0, share), |converter| {
            let number = converter.word(share);
            (number, converter.coefficient(number))
        })
    }

    /// What D/A `index` multiplies by for these words.
    pub(super) fn weight(&self, words: &CornerWords, index: usize) -> f64 {
        self.number(words, word_of(index % TERMS)[1]).1 * self.factors[index]
    }
}
