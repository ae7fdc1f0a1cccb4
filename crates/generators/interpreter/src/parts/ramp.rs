//! A ramp: converter, settling lag and smoother behind the accumulator (hardware 3.1).

use super::figures::RampFigures;
use super::series::{LagMap, TwoPoleMap};

/// Damping of the smoother.
const DAMPING: f64 = 0.8;

/// One ramp along a sweep.
#[derive(Debug, Clone)]
pub struct RampCircuit {
    figures: RampFigures,
    step: f64,
    settle: LagMap,
    smoother: Option<TwoPoleMap>,
    /// What the major carry adds at once to the converter's output; nothing without a lag, as it is over at once.
    kick: f64,
    word: u32,
    level: f64,
    converted: f64,
    smooth: [f64; 2],
}

impl RampCircuit {
    /// At rest with the accumulator at `value`, for steps of `step` seconds.
    pub fn at_rest(figures: RampFigures, step: f64, value: f64) -> Self {
        let word = figures.bits.map_or(0, |bits| word_for(value, bits));
        let level = figures.bits.map_or(value, |bits| level_of(word, bits, figures.nonlinearity));
        let has_smoother = figures.smoother > 0.0;
        Self {
            settle: LagMap::of(step, figures.settle),
            smoother: has_smoother.then(|| smoother(&figures, step)),
            kick: if figures.settle > 0.0 { figures.glitch / figures.settle } else { 0.0 },
            figures,
            step,
            word,
            level,
            converted: level,
            smooth: [level, 0.0],
        }
    }

    /// Output of the ramp now.
    pub fn output(&self) -> f64 {
        if self.smoother.is_some() { self.smooth[0] } else { self.converted }
    }

    /// The ramp a step later. The accumulator had `begins` as the step began, and has `ends` at its end: a converter takes the first, a
    /// smoother without a converter follows the straight line. Behind a converter it follows what that puts out.
    pub fn step(&mut self, begins: f64, ends: f64) -> f64 {
        let Some(bits) = self.figures.bits else {
            let before = std::mem::replace(&mut self.converted, ends);
            return self.smoothed([before, ends]);
        };
        let word = word_for(begins, bits);
        let kicked = self.kicked(word, bits);
        (self.word, self.level) = (word, level_of(word, bits, self.figures.nonlinearity));
        self.converted = self.settle.step(kicked, [self.level; 2]);
        self.smoothed([kicked, self.level])
    }

    /// What the converter puts out as it takes `word`, with the pulse of the carry.
    fn kicked(&self, word: u32, bits: u32) -> f64 {
        let kick = self.kick * carry(self.word, word, bits);
        self.converted + if word < self.word { -kick } else { kick }
    }

    /// The ramp a `share` of a step later, of which `after` is the end: an accumulator without a converter goes straight there.
    pub fn towards(&self, after: &Self, share: f64) -> f64 {
        let time = share * self.step;
        let input = match self.figures.bits {
            None => [self.converted, self.converted + (after.converted - self.converted) * share],
            Some(bits) => [self.kicked(after.word, bits), after.level],
        };
        if self.smoother.is_some() {
            let [y, rate] = self.smooth;
            return smoother(&self.figures, time).step([y, rate * share], input)[0];
        }
        match self.figures.bits {
            None => input[1],
            Some(_) => LagMap::of(time, self.figures.settle).step(input[0], [after.level; 2]),
        }
    }

    /// How far an accumulator is from where the converter takes another word (full scales); infinite without a converter.
    pub fn to_the_next_word(&self, accumulator: f64) -> f64 {
        let Some(bits) = self.figures.bits else { return f64::INFINITY };
        let words = f64::from(1_u32 << bits);
        let place = accumulator * words - 0.5;
        (place - place.round()).abs() / words
    }

    fn smoothed(&mut self, input: [f64; 2]) -> f64 {
        let Some(smoother) = &self.smoother else { return self.converted };
        self.smooth = smoother.step(self.smooth, input);
        self.smooth[0]
    }
}

/// The smoother over `time` (s), as what is before it drives it.
fn smoother(figures: &RampFigures, time: f64) -> TwoPoleMap {
    match figures.bits {
        None => TwoPoleMap::of(time, figures.smoother, DAMPING),
        Some(_) => TwoPoleMap::settling(time, figures.smoother, DAMPING, figures.settle),
    }
}

/// The nearest word of a converter without sign.
pub fn word_for(value: f64, bits: u32) -> u32 {
    let words = f64::from(1_u32 << bits);
    (value * words + 0.5).floor().clamp(0.0, words - 1.0) as u32
}

/// The level of a word: off by at most `nonlinearity`, right at both ends and in the middle.
pub fn level_of(word: u32, bits: u32, nonlinearity: f64) -> f64 {
    let q = f64::from(word) / f64::from(1_u32 << bits);
    // The cubic q (1 - q) (1 - 2 q) is sqrt(3) / 18 where it is largest.
    q + nonlinearity * 18.0 / 3.0_f64.sqrt() * q * (1.0 - q) * (1.0 - 2.0 * q)
}

/// What a change of a word makes of the pulse at the major carry: half of it for each bit below.
pub fn carry(from: u32, to: u32, bits: u32) -> f64 {
    if from == to {
        return 0.0;
    }
    let highest = 32 - (from ^ to).leading_zeros();
    libm::exp2(f64::from(highest) - f64::from(bits))
}
