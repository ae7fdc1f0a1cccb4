//! All parts of an array along one sweep, one after the other, sample by sample.

use std::collections::{BTreeSet, VecDeque};

use super::array::Sweep;
use super::figures::{CellFigures, Figures, PEAKS, TERMS};
use super::functions::FunctionCircuits;
use super::ramp::RampCircuit;
use super::series::LagMap;
use super::tree::TreeCircuit;
use super::words::{Taken, Words};
use crate::terrain::{Sums, sums};
use crate::walk::Sample;

/// A multiplier with its D/A.
#[derive(Debug, Clone)]
struct CellCircuit<'a> {
    figures: &'a CellFigures,
    step: f64,
    lag: LagMap,
    converter: LagMap,
    /// Words of the D/A, and how many of them it has taken.
    words: &'a [Taken],
    next: usize,
    weight: f64,
    raw: f64,
    product: f64,
    term: f64,
}

impl<'a> CellCircuit<'a> {
    fn at_rest(figures: &'a CellFigures, step: f64, words: &'a [Taken], by: f64, input: [f64; 2]) -> Self {
        let next = words.iter().take_while(|word| word.at <= by).count().max(1);
        let (weight, raw) = (words[next - 1].weight, figures.multiply(input));
        Self {
            lag: LagMap::of(step, figures.tau),
            converter: LagMap::of(step, figures.converter_tau),
            figures,
            step,
            words,
            next,
            weight,
            raw,
            product: raw,
            term: raw * weight,
        }
    }

    /// Product and what the D/A puts out a `share` of the step to `sample` later, of which `after` is the end; `input` is what the
    /// multiplier has then. What stands before a lag goes straight to its end; a part without a lag follows its input.
    fn towards(&self, after: &Self, input: [f64; 2], sample: i64, share: f64) -> [f64; 2] {
        let straight = |from: f64, to: f64| from + (to - from) * share;
        let (figures, mut part) = (self.figures, self.clone());
        let product = if figures.tau == 0.0 && figures.leak == 0.0 {
            figures.multiply(input)
        } else {
            let lag = LagMap::of(share * self.step, figures.tau);
            lag.step(self.product, [self.raw, straight(self.raw, after.raw)])
        };
        part.divided([sample as f64 - 1.0, share], [self.product, after.product]);
        let term = if figures.converter_tau == 0.0 { product * part.weight } else { part.term };
        [product, term]
    }

    /// What the D/A sends to its sum a step later, at `sample`; `moved` is the change of the first input.
    fn step(&mut self, sample: i64, input: [f64; 2], moved: f64) -> f64 {
        let raw = self.figures.multiply(input) + self.figures.leak / self.step * moved;
        let before = self.product;
        self.product = self.lag.step(before, [self.raw, raw]);
        self.raw = raw;
        if self.words.get(self.next).is_none_or(|word| word.at > sample as f64) {
            let input = [before * self.weight, self.product * self.weight];
            self.term = self.converter.step(self.term, input);
        } else {
            self.divided([sample as f64 - 1.0, 1.0], [before, self.product]);
        }
        self.term + self.figures.past / self.step * (self.product - before)
    }

    /// What the D/A makes of a product that goes straight from one value to another in a step that begins at `begins`, divided by
    /// the words that come in it, up to a share of it.
    fn divided(&mut self, [begins, share]: [f64; 2], [before, after]: [f64; 2]) {
        let tau = self.figures.converter_tau;
        let product = |at: f64| before + (after - before) * at;
        let mut from = 0.0;
        while let Some(word) = self.words.get(self.next).filter(|word| word.at <= begins + share) {
            let to = (word.at - begins).clamp(from, share);
            let input = [product(from), product(to)].map(|product| product * self.weight);
            self.term = LagMap::of((to - from) * self.step, tau).step(self.term, input);
            if tau > 0.0 {
                self.term += word.pulse * product(to) / tau;
            }
            (from, self.weight) = (to, word.weight);
            self.next += 1;
        }
        let input = [product(from), product(share)].map(|product| product * self.weight);
        self.term = LagMap::of((share - from) * self.step, tau).step(self.term, input);
    }
}

impl CellFigures {
    /// The product with its static errors.
    fn multiply(&self, [a, b]: [f64; 2]) -> f64 {
        let [of_a, of_b] = self.feed;
        (1.0 + self.gain) * a * b + of_a * a + of_b * b + self.offset + self.bend * a * (1.0 - a * a)
    }
}

/// The parts of an array at one instant.
#[derive(Debug, Clone)]
pub struct Chain<'a> {
    sweep: &'a Sweep<'a>,
    figures: &'a Figures,
    turns: &'a [(f64, usize)],
    ties: &'a BTreeSet<i64>,
    polarity: [f64; 2],
    ramps: [RampCircuit; 2],
    ramp: [f64; 2],
    functions: [FunctionCircuits<'a>; 2],
    /// Function generators with their signs.
    signed: [[f64; 12]; 2],
    cells: [Vec<CellCircuit<'a>>; 3],
    trees: [TreeCircuit; 3],
    sums: [f64; 3],
    /// How near the accumulators were to another word of their converters, in the steps that the parts remember.
    stairs: VecDeque<f64>,
}

impl<'a> Chain<'a> {
    /// Everything at rest under accumulators that stand, with all that acts by sample `by`.
    pub fn at_rest(
        sweep: &'a Sweep<'a>,
        figures: &'a Figures,
        words: &'a Words,
        (by, accumulators): (f64, [f64; 2]),
    ) -> Self {
        let Figures { step, inputs, .. } = *figures;
        let (polarity, turned) = polarity_by(sweep, words, by);
        let ramps = [0, 1].map(|axis| RampCircuit::at_rest(figures.ramps[axis], step, accumulators[axis]));
        let ramp = [0, 1].map(|axis| ramps[axis].output());
        let functions = [0, 1]
            .map(|axis| FunctionCircuits::at_rest(figures.functions[axis], step, ramp[axis], sweep.drawn));
        let signed = [0, 1].map(|axis| with_signs(&functions[axis].outputs, polarity[axis]));
        let cells = [0, 1, 2].map(|sum| {
            let cells = figures.cells[sum].iter().zip(&words.taken[sum]).enumerate();
            let at_rest = |(term, (figures, words)): (usize, (&'a CellFigures, &'a Vec<Taken>))| {
                CellCircuit::at_rest(figures, step, words, by, factors(&signed, sum, term))
            };
            cells.map(at_rest).collect::<Vec<_>>()
        });
        let mut sums = [0.0; 3];
        let trees = [0, 1, 2].map(|sum| {
            let terms: Vec<f64> = cells[sum].iter().map(|cell| cell.term).collect();
            let (tree, total) = TreeCircuit::at_rest(&figures.trees[sum], inputs, step, &terms);
            sums[sum] = total;
            tree
        });
        let turns = &words.turns[turned..];
        let stairs = VecDeque::from(vec![f64::INFINITY; figures.memory()]);
        let ties = &words.ties;
        Self {
            sweep,
            figures,
            turns,
            ties,
            polarity,
            ramps,
            ramp,
            functions,
            signed,
            cells,
            trees,
            sums,
            stairs,
        }
    }

    /// Height on the wire (m).
    pub fn height(&self) -> f64 {
        self.sums[0] * self.figures.scales.height + self.figures.scales.datum
    }

    /// The right height at ramps that stand, with all that acts by sample `by` (m).
    pub fn right(&self, words: &Words, (by, ramps): (f64, [f64; 2])) -> f64 {
        let held = words.held.iter().take_while(|(at, _)| *at <= by).last();
        sums(held.map_or(&self.sweep.hold, |(_, hold)| hold), ramps, self.polarity).ground[0]
    }

    /// A step to `sample`, over which the accumulators went from `before` to `now`.
    pub fn step(&mut self, sample: i64, before: [f64; 2], now: [f64; 2]) {
        while let Some(&(_, axis)) = self.turns.first().filter(|(at, _)| *at <= sample as f64) {
            self.polarity[axis] = -self.polarity[axis];
            self.turns = &self.turns[1..];
        }
        let was = self.signed;
        let to_the_next = |axis: usize| self.ramps[axis].to_the_next_word(before[axis]);
        let stairs = if self.ties.contains(&sample) { 0.0 } else { to_the_next(0).min(to_the_next(1)) };
        self.stairs.pop_front();
        self.stairs.push_back(stairs);
        for axis in 0..2 {
            self.ramp[axis] = self.ramps[axis].step(before[axis], now[axis]);
            self.functions[axis].step(self.ramp[axis]);
            self.signed[axis] = with_signs(&self.functions[axis].outputs, self.polarity[axis]);
        }
        for sum in 0..3 {
            let signed = &self.signed;
            let cells = self.cells[sum].iter_mut().enumerate();
            let terms: Vec<f64> = cells
                .map(|(term, cell)| {
                    let [now, was] = [signed, &was].map(|signed| factors(signed, sum, term));
                    cell.step(sample, now, now[0] - was[0])
                })
                .collect();
            self.sums[sum] = self.trees[sum].step(&terms);
        }
    }

    /// The wires a `share` of the step to `sample` later, of which `after` is the end: every part is driven straight from what it has
    /// now to what it has there. No chain goes on from them.
    pub fn towards(&self, after: &Self, sample: i64, share: f64) -> Self {
        let mut wires = self.clone();
        for axis in 0..2 {
            wires.ramp[axis] = self.ramps[axis].towards(&after.ramps[axis], share);
            let ramp = wires.ramp[axis];
            wires.functions[axis].outputs = self.functions[axis].towards(&after.functions[axis], share, ramp);
            let polarity = self.polarity_at(axis, sample as f64 - 1.0 + share);
            wires.signed[axis] = with_signs(&wires.functions[axis].outputs, polarity);
        }
        for sum in 0..3 {
            let ends = self.cells[sum].iter().zip(&after.cells[sum]);
            let signed = &wires.signed;
            for (term, (cell, (before, after))) in wires.cells[sum].iter_mut().zip(ends).enumerate() {
                let input = factors(signed, sum, term);
                [cell.product, cell.term] = before.towards(after, input, sample, share);
            }
            let terms: Vec<f64> = wires.cells[sum].iter().map(|cell| cell.term).collect();
            wires.sums[sum] = self.trees[sum].towards(&after.trees[sum], share, &terms);
        }
        wires
    }

    /// Polarity of an axis with the turns up to an instant (steps).
    fn polarity_at(&self, axis: usize, at: f64) -> f64 {
        let turned =
            self.turns.iter().take_while(|(turn, _)| *turn <= at).filter(|(_, of)| *of == axis).count();
        if turned % 2 == 1 { -self.polarity[axis] } else { self.polarity[axis] }
    }

    /// Writes the wires at an instant into a sample (steps from the first sample); the datum is trimmed by `trim` (m).
    pub fn put(&self, at: f64, trim: f64, accumulators: [f64; 2], sample: &mut Sample) {
        let level = self.sweep.level;
        let scales = &self.figures.scales;
        let [height, u, v] = [0, 1, 2].map(|sum| self.sums[sum] + self.noise(sum, at));
        let d = level.region_size();
        *sample = Sample {
            accumulators,
            ramps: self.ramp,
            sums: self.wires(),
            height: height * scales.height + scales.datum + trim,
            slopes: [u * scales.slope / d, v * scales.slope / d],
            stairs: self.stairs.iter().copied().fold(f64::INFINITY, f64::min),
        };
    }

    /// Noise of a sum at an instant: straight between samples.
    fn noise(&self, sum: usize, at: f64) -> f64 {
        if self.figures.noise == 0.0 {
            return 0.0;
        }
        let Sweep { name, drawn, number, .. } = *self.sweep;
        let source = format!("{name}.noise");
        let deviate = |sample: f64| (drawn.noise)(drawn.seed, (&source, sum as u64), [number, sample as u64]);
        let share = at - at.floor();
        let later = if share > 0.0 { share * (deviate(at.ceil()) - deviate(at.floor())) } else { 0.0 };
        self.figures.noise * (deviate(at.floor()) + later)
    }

    /// Wires between the ramps and the sums, in their units.
    fn wires(&self) -> Sums {
        let scales = &self.figures.scales;
        let mut sums = Sums::default();
        for fed in 0..4 {
            for order in 0..3 {
                let output = |slope: usize| {
                    self.functions[fed / 2].outputs[6 * slope + 3 * (fed % 2) + order]
                        * PEAKS[3 * slope + order]
                };
                (sums.functions[fed][order], sums.derivatives[fed][order]) = (output(0), output(1));
            }
        }
        for sum in 0..3 {
            let full_scale = if sum == 0 { scales.height } else { scales.slope };
            for term in 0..TERMS {
                let cell = &self.cells[sum][term];
                let [p, q] = [term / 6, term % 6];
                let (colour, word) = (p / 3 + 2 * (q / 3), 3 * (p % 3) + q % 3);
                let [of_x, of_y] = peaks(sum, term);
                sums.products[sum][colour][word] = cell.product * of_x * of_y;
                sums.sent[sum][colour][word] = cell.term * full_scale;
            }
        }
        sums.colours = std::array::from_fn(|colour| sums.sent[0][colour].iter().sum());
        sums
    }
}

/// Polarity of both axes with all turns by sample `by`, and how many these are.
fn polarity_by(sweep: &Sweep<'_>, words: &Words, by: f64) -> ([f64; 2], usize) {
    let mut polarity = sweep.ramps.each_ref().map(|ramp| ramp.polarity);
    let turned = words.turns.iter().take_while(|(at, _)| *at <= by).count();
    for (_, axis) in &words.turns[..turned] {
        polarity[*axis] = -polarity[*axis];
    }
    (polarity, turned)
}

/// Outputs of function generators behind their polarity switches: odd values and even slopes turn with it, the other way round at
/// the far end (6.4).
fn with_signs(outputs: &[f64; 12], polarity: f64) -> [f64; 12] {
    std::array::from_fn(|unit| {
        let sign = if unit / 3 % 2 == 0 { polarity } else { -polarity };
        if is_turned(unit) { sign * outputs[unit] } else { outputs[unit] }
    })
}

/// Whether the polarity turns the output of a function generator.
pub fn is_turned(unit: usize) -> bool {
    (unit % 3 + unit / 6) % 2 == 1
}

/// Units of X and of Y that a term of a sum multiplies.
pub fn units(sum: usize, term: usize) -> [usize; 2] {
    let [p, q] = [term / 6, term % 6];
    [if sum == 1 { 6 + p } else { p }, if sum == 2 { 6 + q } else { q }]
}

fn factors(signed: &[[f64; 12]; 2], sum: usize, term: usize) -> [f64; 2] {
    let [x, y] = units(sum, term);
    [signed[0][x], signed[1][y]]
}

/// Largest values of both factors of a term.
fn peaks(sum: usize, term: usize) -> [f64; 2] {
    units(sum, term).map(|unit| PEAKS[3 * (unit / 6) + unit % 3])
}
