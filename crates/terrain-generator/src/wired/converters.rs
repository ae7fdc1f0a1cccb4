//! The multiplying D/As of a group: words as they come to act, and what they make of the products.

use landscape::CornerWords;
use parts::{LagStep, impulse};
use signal::{LANES, Real};

use super::run::Run;
use super::state::{ArrayState, Change, Divided};
use super::terms::{ALL, TERMS, word_of};

impl<S: Real> Run<'_, S> {
    /// Registers up to `sample`, and the outputs of the multiplying D/As then.
    pub(super) fn convert(&self, sample: i64, state: &mut ArrayState<S>) {
        let array = self.array;
        state.divided.clear();
        for lane in 0..LANES {
            self.strobe(sample, lane, state);
        }
        let [now, before] = &state.products;
        if array.converter_lags.is_empty() {
            for (index, term) in state.terms.iter_mut().enumerate() {
                *term = now[index] * state.weights[index];
            }
            return;
        }
        for (index, lag) in array.converter_lags.iter().enumerate() {
            let weight = state.weights[index];
            state.terms[index] = lag.step(state.terms[index], before[index] * weight, now[index] * weight);
        }
        for &Divided { lane, index, share, output } in &state.divided {
            let weight = state.weights[index][lane].to_f64();
            let [start, end] = [share, 1.0].map(|share| self.product_at(state, lane, index, share) * weight);
            let lag = LagStep::<f64>::new(array.timing.step * (1.0 - share), array.converter_taus[index]);
            state.terms[index][lane] = S::from_f64(lag.step(output, start, end));
        }
    }

    /// Words of a lane that act up to `sample`.
    fn strobe(&self, sample: i64, lane: usize, state: &mut ArrayState<S>) {
        let (timing, program) = (&self.array.timing, &self.programs[lane]);
        let digital = &mut state.lanes[lane];
        while let Some((old, at)) = digital.strobe(sample, program, (timing, self.generator)) {
            for index in 0..ALL {
                let [colour, word] = word_of(index % TERMS);
                let [old, new] = [&old[colour], digital.registers.hold(self.generator.buffer)[colour]];
                if new[word] != old[word] {
                    let (at, weight) = (at + timing.later(index), self.array.weight(new, index));
                    let pulse = self.pulse(index, [old, new]);
                    digital.pending.push(Change { at, index, weight, pulse });
                }
            }
        }
        if digital.pending.is_empty() {
            return;
        }
        let mut pending = std::mem::take(&mut digital.pending);
        // Stable: what acts at one instant acts in the order of the program.
        pending.sort_by(|a, b| a.at.total_cmp(&b.at));
        let due = pending.partition_point(|change| change.at <= sample as f64);
        for change in pending.drain(..due) {
            self.change_word(lane, (change.at - (sample - 1) as f64).clamp(0.0, 1.0), &change, state);
        }
        state.lanes[lane].pending = pending;
    }

    /// Gives a D/A its new word at `share` of the step.
    fn change_word(&self, lane: usize, share: f64, change: &Change, state: &mut ArrayState<S>) {
        let Change { index, weight, pulse, .. } = *change;
        let step = self.array.timing.step;
        if let Some(&tau) = self.array.converter_taus.get(index) {
            let known =
                state.divided.iter().position(|divided| (divided.lane, divided.index) == (lane, index));
            let (from, output) = known.map_or((0.0, state.terms[index][lane].to_f64()), |known| {
                let divided = state.divided[known];
                (divided.share, divided.output)
            });
            let weight = state.weights[index][lane].to_f64();
            let [start, end] = [from, share].map(|share| self.product_at(state, lane, index, share));
            let lag = LagStep::<f64>::new(step * (share - from), tau);
            let pulse = pulse * end * impulse(step, tau, 1.0);
            let output = lag.step(output, start * weight, end * weight) + pulse;
            let divided = Divided { lane, index, share, output };
            match known {
                Some(known) => state.divided[known] = divided,
                None => state.divided.push(divided),
            }
        }
        state.weights[index][lane] = S::from_f64(weight);
    }

    fn product_at(&self, state: &ArrayState<S>, lane: usize, index: usize, share: f64) -> f64 {
        let [now, before] = state.products.each_ref().map(|products| products[index][lane].to_f64());
        before + share * (now - before)
    }

    /// Area of what the bits that switch apart add to the output of a D/A, for a product of full scale.
    fn pulse(&self, index: usize, [old, new]: [&CornerWords; 2]) -> f64 {
        let Some(converter) = self.array.words.as_ref().filter(|_| self.array.glitch > 0.0) else {
            return 0.0;
        };
        let [_, word] = word_of(index % TERMS);
        let [old, new] = [old, new].map(|words| converter.word(self.array.scale.share(words, word)));
        self.array.glitch * converter.carry(old, new)
    }
}
