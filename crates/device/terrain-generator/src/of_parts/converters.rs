//! The words of the multiplying D/As of a group: strobed, on their way, and what a change does within a step.
//!
//! **Law.** A D/A is linear: a word that changes from w to v at a share p of the step adds to its output at the end what
//! the signal times `v - w` makes of a D/A at rest over the part of the step that is left, and a pulse adds what is left
//! of it. So changes add to the step that all lanes have taken, and several in one step add up.

use std::mem;

use landscape::CornerWords;
use signal::{LANES, Real};

use super::run::Run;
use super::state::{ArrayState, Coded, Due, Lane};
use super::words::Words;
use crate::terms::{TERMS, term_of};

impl<S: Real> Run<'_, S> {
    /// Puts the words on their way whose strobes are due by `sample`.
    #[inline(never)]
    pub(super) fn strobe(&self, sample: i64, state: &mut ArrayState<S>) {
        let ArrayState { lanes, words, coded, due, .. } = state;
        self.strobe_to(sample, lanes, coded, |at, lane, colour, coded| {
            self.send(at, lane, (colour, coded), words)
        });
        *due = Due::of(lanes);
    }

    /// The same by rows, where D/As are alike.
    #[inline(never)]
    pub(super) fn strobe_rows(&self, sample: i64, state: &mut ArrayState<S>) {
        let ArrayState { lanes, row_words, coded, due, .. } = state;
        self.strobe_to(sample, lanes, coded, |at, (number, _), colour, coded| {
            row_words.send(at, (colour, number), &coded.shares);
        });
        *due = Due::of(lanes);
    }

    /// Hands over the colours that get other words by strobes that are due by `sample`, lane by lane: when a nominal D/A has
    /// them.
    #[inline(always)]
    fn strobe_to(
        &self,
        sample: i64,
        lanes: &mut [Lane; LANES],
        coded: &mut [Coded; 4],
        mut send: impl FnMut(f64, (usize, &mut Lane), usize, &Coded),
    ) {
        let when = (&self.array.timing, self.generator);
        for (number, (lane, program)) in lanes.iter_mut().zip(self.programs).enumerate() {
            while let Some((at, has_new)) = lane.strobe(sample, program, when) {
                if !has_new {
                    continue;
                }
                for (colour, coded) in coded.iter_mut().enumerate() {
                    let new = *lane.registers.hold(self.generator.buffer)[colour];
                    if new != lane.held[colour] {
                        if coded.words != new {
                            *coded = self.array.coded(&new);
                        }
                        send(at, (number, lane), colour, coded);
                        lane.held[colour] = new;
                    }
                }
            }
        }
    }

    /// Puts the words of a colour on their way.
    #[inline(always)]
    fn send(
        &self,
        at: f64,
        (number, lane): (usize, &mut Lane),
        (colour, coded): (usize, &Coded),
        words: &mut Words<S>,
    ) {
        let array = self.array;
        let from = mem::replace(&mut lane.numbers[colour], coded.numbers);
        let mut pulses = [0.0; 9];
        if let Some(part) = array.words.as_ref().filter(|_| array.glitch != 0.0) {
            for word in 0..9 {
                pulses[word] = array.glitch * part.carry(from[word], coded.numbers[word]);
            }
        }
        words.send(at, (colour, number), [&coded.shares, &pulses]);
    }

    /// Registers as they are as a sweep begins.
    pub(super) fn fill_registers(&self, state: &mut ArrayState<S>) {
        let array = self.array;
        let ArrayState { lanes, coded, wires, .. } = state;
        for (number, lane) in lanes.iter_mut().enumerate() {
            lane.held = lane.registers.hold(self.generator.buffer).map(|words| *words);
            for (colour, coded) in coded.iter_mut().enumerate() {
                if coded.words != lane.held[colour] {
                    *coded = array.coded(&lane.held[colour]);
                }
                lane.numbers[colour] = coded.numbers;
                for (word, share) in coded.shares.iter().enumerate() {
                    for index in (term_of(colour, word)..).step_by(TERMS).take(3) {
                        *wires.weight(index, number) = S::from_f64(share * array.factors[index]);
                    }
                }
            }
        }
    }

    /// Gives D/As at rest the words that act by `sample`.
    pub(super) fn take_words(&self, sample: i64, state: &mut ArrayState<S>) {
        let ArrayState { words, wires, .. } = state;
        words.take(sample, &self.array.converters, |index, lane, weight| {
            *wires.weight(index, lane) = S::from_f64(weight);
        });
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
    pub(super) fn number(&self, words: &CornerWords, word: usize) -> (i32, f64) {
        let share = self.scale.share(words, word);
        self.words.as_ref().map_or((0, share), |converter| {
            let number = converter.word(share);
            (number, converter.coefficient(number))
        })
    }
}
