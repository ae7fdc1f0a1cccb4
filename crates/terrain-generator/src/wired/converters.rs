//! The words of the multiplying D/As of a group: strobed, on their way, and what a change does within a step.
//!
//! **Law.** A D/A is linear: a word that changes from w to v at a share p of the step adds to its output at the end what
//! the signal times `v - w` makes of a D/A at rest over the part of the step that is left, and a pulse adds what is left
//! of it. So changes add to the step that all lanes have taken, and several in one step add up.

use landscape::CornerWords;
use parts::LagSteps;
use signal::{LANES, Real};

use super::run::Run;
use super::state::{ArrayState, Change, Due, Lane};
use super::terms::{ALL, TERMS, word_of};

/// Changes of one lane whose lags are worked out side by side.
const AT_ONCE: usize = 8;

impl<S: Real> Run<'_, S> {
    /// Puts the words on their way whose strobes are due by `sample`.
    #[inline(never)]
    pub(super) fn strobe(&self, sample: i64, state: &mut ArrayState<S>) {
        let when = (&self.array.timing, self.generator);
        for (lane, program) in state.lanes.iter_mut().zip(self.programs) {
            while let Some((at, has_new)) = lane.strobe(sample, program, when) {
                if has_new {
                    self.send(at, lane);
                }
            }
        }
        state.due = Due::of(&state.lanes);
    }

    /// Puts the words of the hold registers on their way that are others than before; a nominal D/A has them `at`.
    fn send(&self, at: f64, lane: &mut Lane) {
        let array = self.array;
        let mut changed = [[None; 9]; 4];
        for colour in 0..4 {
            let new = lane.registers.hold(self.generator.buffer)[colour];
            for word in 0..9 {
                if new[word] != lane.held[colour][word] {
                    let (number, share) = array.number(new, word);
                    let from = std::mem::replace(&mut lane.numbers[colour][word], number);
                    let carry = array.words.as_ref().map_or(0.0, |part| part.carry(from, number));
                    changed[colour][word] = Some((share, array.glitch * carry));
                }
            }
            lane.held[colour] = *new;
        }
        lane.pending.drain(..lane.acted);
        lane.acted = 0;
        let behind = lane.pending.last().map_or(f64::NEG_INFINITY, |last| last.at);
        let first = lane.pending.len();
        for &index in &array.by_lateness {
            let [colour, word] = word_of(index % TERMS);
            if let Some((share, pulse)) = changed[colour][word] {
                let (at, weight) = (at + array.timing.later(index), share * array.factors[index]);
                lane.pending.push(Change { at, index, weight, pulse });
            }
        }
        if lane.pending.get(first).is_some_and(|next| next.at < behind) {
            // Stable: what acts at one instant acts in the order of the program.
            lane.pending.sort_by(|a, b| a.at.total_cmp(&b.at));
        }
        lane.due.change = lane.next_change();
    }

    /// Registers as they are as a sweep begins.
    pub(super) fn fill_registers(&self, state: &mut ArrayState<S>) {
        let array = self.array;
        for (number, lane) in state.lanes.iter_mut().enumerate() {
            lane.held = lane.registers.hold(self.generator.buffer).map(|words| *words);
            lane.numbers =
                lane.held.each_ref().map(|words| std::array::from_fn(|word| array.number(words, word).0));
            for (index, wires) in state.wires.iter_mut().enumerate() {
                let [colour, _] = word_of(index % TERMS);
                wires.weight[number] = S::from_f64(array.weight(&lane.held[colour], index));
            }
        }
    }

    /// Gives D/As at rest the words that act by `sample`.
    pub(super) fn take_words(&self, sample: i64, state: &mut ArrayState<S>) {
        for lane in 0..LANES {
            while let Some(change) = state.lanes[lane].next_word(sample) {
                state.wires[change.index].weight[lane] = S::from_f64(change.weight);
            }
        }
        state.due = Due::of(&state.lanes);
    }

    /// Gives D/As the words that act in the step to `sample`, which they have taken with those before.
    #[inline(always)]
    pub(super) fn change_words(&self, sample: i64, state: &mut ArrayState<S>) {
        let mut touched = [false; ALL];
        for lane in 0..LANES {
            while state.lanes[lane].due.change <= sample as f64 {
                let mut acting = [Change::default(); AT_ONCE];
                let mut count = 0;
                while let Some(change) =
                    (count < AT_ONCE).then(|| state.lanes[lane].next_word(sample)).flatten()
                {
                    touched[self.array.grid.group_of(change.index)] = true;
                    acting[count] = change;
                    count += 1;
                }
                self.change_some(lane, sample, &acting, count, state);
            }
        }
        for (group, sum) in state.partial.iter_mut().enumerate().filter(|(group, _)| touched[*group]) {
            *sum = self.array.grid.sum(group, &state.wires);
        }
        state.due = Due::of(&state.lanes);
    }

    /// The first `count` of these changes, of one lane.
    #[inline(always)]
    fn change_some(
        &self,
        lane: usize,
        sample: i64,
        acting: &[Change; AT_ONCE],
        count: usize,
        state: &mut ArrayState<S>,
    ) {
        let array = self.array;
        let shares = acting.map(|change| (change.at - (sample - 1) as f64).clamp(0.0, 1.0));
        let taus = acting.map(|change| array.converter_taus[change.index]);
        let rest = LagSteps::new(shares.map(|share| array.timing.step * (1.0 - share)), taus);
        for (n, change) in acting.iter().enumerate().take(count) {
            let (wires, cell) = (&mut state.wires[change.index], &array.grid.cells[change.index]);
            let [before, end] = [wires.before, wires.product].map(|product| product[lane].to_f64());
            let start = before + shares[n] * (end - before);
            let step = change.weight - wires.weight[lane].to_f64();
            let kick = if taus[n] > 0.0 { change.pulse * start * (rest.keep[n] / taus[n]) } else { 0.0 };
            let more = (start * rest.from[n] + end * rest.to[n]) * step + kick;
            let term = S::from_f64(wires.term[lane].to_f64() + more);
            wires.weight[lane] = S::from_f64(change.weight);
            wires.term[lane] = term;
            wires.term_left[lane] = cell.converter.leave(term, wires.product[lane] * wires.weight[lane]);
        }
    }
}

impl Lane {
    /// The next word, if it acts by `sample`.
    fn next_word(&mut self, sample: i64) -> Option<Change> {
        let next = *self.pending.get(self.acted).filter(|change| change.at <= sample as f64)?;
        self.acted += 1;
        self.due.change = self.next_change();
        Some(next)
    }
}

impl<S: Real> super::PartsArray<S> {
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
