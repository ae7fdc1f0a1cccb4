//! D/A converter of the sweep generator.
//!
//! ```text
//! u, 0..=1 ─▶ word of b bits ─▶ level with its nonlinearity ─▶ delay ─▶ settling lag ─▶ y
//!                      └─ carry ─▶ glitch ──────────────────────────────┘
//! ```
//!
//! **Law** (sections 3.1 and 6). `word = round(2^b u)`, held in `0..2^b`; `level = q + 6 sqrt 3 e q (1 - q)(1 - 2 q)`,
//! `q = word / 2^b`: a cubic that keeps both ends and the middle and is off by e at most. The output follows by a
//! lag from the delay on. A change whose highest changed bit has the weight k (1: the lowest, b: the major carry)
//! adds a pulse of area `A_g 2^(k - b)` with the sign of the change.
//! **Parameters.** [`ConverterLaw`].
//! **State and timing.** [`ConverterState`]. A delay longer than a step: feed the word of [`Converter::whole_steps`]
//! samples ago.
//! **Our choices.** Nearest word (the top half step is short of it by up to a whole one: there is no word 2^b). The
//! pulse is an impulse at the instant of the change; without a settling lag it is over by the next sample.

use signal::{LANES, Lanes, Real};

use crate::delay::Delay;
use crate::lag::{LagStep, impulse};
use crate::whole::{WHOLE, whole};

/// What a converter is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConverterLaw {
    /// Bits b, 1..=24 (held within).
    pub bits: u32,
    /// Largest deviation e of the level (share of full scale), either sign.
    pub nonlinearity: f64,
    /// Area `A_g` of the pulse at the major carry (full scale times seconds).
    pub glitch_area: f64,
    /// From the word to the change of the output (s).
    pub delay: f64,
    /// Settling lag (s): [`crate::settling_time_constant`].
    pub tau: f64,
}

/// The part, for one step length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Converter<S> {
    bits: u32,
    words: f64,
    cubic: f64,
    delay: Delay,
    settle: LagStep<S>,
    /// What the pulse of the major carry leaves at the end of a step, and what it begins with.
    pulse: S,
    kick: S,
}

/// Word, its level, and the output.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ConverterState<S> {
    /// Word at the input.
    pub word: u32,
    /// Level it stands for.
    pub level: S,
    /// Output of the converter.
    pub y: S,
}

impl<S: Real> Converter<S> {
    /// For steps of `h` seconds.
    pub fn new(h: f64, law: &ConverterLaw) -> Self {
        let bits = law.bits.clamp(1, 24);
        let delay = Delay::new(h, law.delay);
        Self {
            bits,
            words: f64::from(1_u32 << bits),
            cubic: 6.0 * 3.0_f64.sqrt() * law.nonlinearity,
            delay,
            settle: LagStep::jump(h, law.tau, delay.share),
            pulse: S::from_f64(law.glitch_area * impulse(h, law.tau, delay.share)),
            kick: S::from_f64(law.glitch_area * impulse(0.0, law.tau, 0.0)),
        }
    }

    /// Whole steps of the delay; what is left of it is in the part.
    pub fn whole_steps(&self) -> usize {
        self.delay.whole
    }

    /// The word for `u` (share of full scale).
    #[inline]
    pub fn word(&self, u: S) -> u32 {
        // `as` holds what is below 0 at 0.
        ((u.to_f64() * self.words + 0.5) as u32).min((1 << self.bits) - 1)
    }

    /// The level `word` stands for (share of full scale).
    #[inline]
    pub fn level(&self, word: u32) -> S {
        let q = f64::from(word) / self.words;
        S::from_f64(q + self.cubic * q * (1.0 - q) * (1.0 - 2.0 * q))
    }

    /// The converter at rest at `u`.
    pub fn at_rest(&self, u: S) -> ConverterState<S> {
        let word = self.word(u);
        let level = self.level(word);
        ConverterState { word, level, y: level }
    }

    /// Gives it `word` at the start of a step; returns the output at its end.
    #[inline]
    pub fn step(&self, state: &mut ConverterState<S>, word: u32) -> S {
        let (before, from) = (state.level, state.word);
        state.word = word;
        state.level = self.level(word);
        let carry = S::from_f64(carry_weight(from, word, self.bits));
        let pulse = if word < from { -(self.pulse * carry) } else { self.pulse * carry };
        state.y = self.settle.step(state.y, before, state.level) + pulse;
        state.y
    }
}

/// Words, levels and outputs of a group.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConverterLanes<S> {
    word: [f64; LANES],
    level: Lanes<S>,
    /// Outputs of the group, lane by lane.
    pub y: Lanes<S>,
}

impl<S: Real> Default for ConverterLanes<S> {
    fn default() -> Self {
        Self { word: [0.0; LANES], level: Lanes::default(), y: Lanes::default() }
    }
}

/// The bits of an f64 without its mantissa: the power of two at or below it.
const POWER: u64 = 0xfff0_0000_0000_0000;

impl<S: Real> Converter<S> {
    /// A group of converters at rest at `u`.
    pub fn lanes_at_rest(&self, u: Lanes<S>) -> ConverterLanes<S> {
        let states = u.0.map(|u| self.at_rest(u));
        let y = Lanes(states.map(|state| state.y));
        ConverterLanes { word: states.map(|state| f64::from(state.word)), level: y, y }
    }

    /// [`Converter::step`] for the words of `u` (shares of full scale); each lane has the bits it has alone. Words are held
    /// as numbers, so that a group needs no conversions and no branches.
    #[inline(always)]
    pub fn step_lanes(&self, state: &mut ConverterLanes<S>, u: Lanes<S>) -> Lanes<S> {
        let before = *state;
        let carries = self.take(state, u);
        for lane in 0..LANES {
            let settled = self.settle.step(before.y.0[lane], before.level.0[lane], state.level.0[lane]);
            state.y.0[lane] = settled + self.pulse * carries.0[lane];
        }
        state.y
    }

    /// The same of converters without a delay, for a part behind them that follows their outputs within the step: these go by the
    /// settling lag from the first to the second of what is returned.
    #[inline(always)]
    pub fn settling_lanes(&self, state: &mut ConverterLanes<S>, u: Lanes<S>) -> [Lanes<S>; 2] {
        let before = *state;
        let carries = self.take(state, u);
        let mut begin = Lanes::default();
        for lane in 0..LANES {
            let (y, carry) = (before.y.0[lane], carries.0[lane]);
            begin.0[lane] = y + self.kick * carry;
            let settled = self.settle.step(y, before.level.0[lane], state.level.0[lane]);
            state.y.0[lane] = settled + self.pulse * carry;
        }
        [begin, state.level]
    }

    /// Converts `u` to words, lane by lane. Returns the pulse of each carry, with its sign, in units of the major carry's pulse.
    #[inline(always)]
    fn take(&self, state: &mut ConverterLanes<S>, u: Lanes<S>) -> Lanes<S> {
        let (top, lsb, major) = (self.words - 1.0, 1.0 / self.words, 2.0 / self.words);
        let mut carries = Lanes::default();
        for lane in 0..LANES {
            let word = whole(u.0[lane].to_f64() * self.words + 0.5);
            let word = if word > 0.0 { word } else { 0.0 };
            let word = if word < top { word } else { top };
            let from = state.word[lane];
            let changed = ((word + WHOLE).to_bits() ^ (from + WHOLE).to_bits()) | WHOLE.to_bits();
            let highest = f64::from_bits((f64::from_bits(changed) - WHOLE).to_bits() & POWER);
            let q = word * lsb;
            let sign = if word < from { -1.0 } else { 1.0 };
            carries.0[lane] = S::from_f64(highest * major * sign);
            state.level.0[lane] = S::from_f64(q + self.cubic * q * (1.0 - q) * (1.0 - 2.0 * q));
            state.word[lane] = word;
        }
        carries
    }
}

/// `2^(k - bits)`, k the weight of the highest bit (1..=`bits`) in which the words differ; 0 if they do not.
#[inline]
pub fn carry_weight(from: u32, to: u32, bits: u32) -> f64 {
    let k = u32::BITS - (from ^ to).leading_zeros();
    if k == 0 { 0.0 } else { (1_u64 << k) as f64 / (1_u64 << bits) as f64 }
}

#[cfg(test)]
mod tests {
    use signal::{LANES, Lanes};

    use super::{Converter, ConverterLaw, carry_weight};

    const BARE: ConverterLaw =
        ConverterLaw { bits: 10, nonlinearity: 0.0, glitch_area: 0.0, delay: 0.0, tau: 0.0 };

    #[test]
    fn the_level_is_within_half_a_step_below_the_top() {
        for bits in 1..=24 {
            let converter = Converter::<f64>::new(1e-8, &ConverterLaw { bits, ..BARE });
            let lsb = 1.0 / f64::from(1 << bits);
            for i in 0..=1000 {
                let u = f64::from(i) / 1000.0;
                let off = converter.level(converter.word(u)) - u;
                assert!(
                    off.abs() <= lsb / 2.0 || (u > 1.0 - lsb && off.abs() <= lsb),
                    "{bits} bits, {u}: {off}"
                );
            }
            assert_eq!(converter.word(-0.3), 0);
            assert_eq!(converter.word(7.0), (1 << bits) - 1);
        }
    }

    #[test]
    fn nonlinearity_keeps_the_ends_and_has_its_size() {
        let converter = Converter::<f64>::new(1e-8, &ConverterLaw { nonlinearity: 5e-4, ..BARE });
        let off: Vec<f64> = (0..1024).map(|w| converter.level(w) - f64::from(w) / 1024.0).collect();
        assert_eq!((off[0], off[512]), (0.0, 0.0));
        let most = off.iter().fold(0.0_f64, |most, off| most.max(off.abs()));
        assert!((most - 5e-4).abs() < 1e-8, "{most}");
        assert!(off[200] > 0.0 && off[800] < 0.0);
    }

    /// `1 - e^(-(t - t_d)/tau)` from the delay on, two whole steps and a quarter.
    #[test]
    fn a_delay_longer_than_a_step_is_the_word_of_samples_ago() {
        let (h, tau) = (50e-9, 20e-9);
        let converter = Converter::<f64>::new(h, &ConverterLaw { delay: 2.25 * h, tau, ..BARE });
        assert_eq!(converter.whole_steps(), 2);
        let mut state = converter.at_rest(0.0);
        for sample in 1..12_usize {
            // The word changes at sample 0; a step that begins at `sample - 1` is fed with the word of two samples ago.
            let word = if sample > converter.whole_steps() { 512 } else { 0 };
            let since = (sample as f64 - 2.25).max(0.0) * h;
            let expected = -0.5 * libm::expm1(-since / tau);
            let found = converter.step(&mut state, word);
            assert!((found - expected).abs() < 1e-14, "{found} at {sample}, expected {expected}");
        }
    }

    #[test]
    fn a_pulse_has_the_area_of_its_carry() {
        let (h, tau) = (50e-9, 20e-9);
        let law = ConverterLaw { glitch_area: 10e-9, delay: 8e-9, tau, ..BARE };
        let converter = Converter::<f64>::new(h, &law);
        let clean = Converter::<f64>::new(h, &ConverterLaw { glitch_area: 0.0, ..law });
        for (from, to, weight) in
            [(511_u32, 512_u32, 1.0), (512, 511, -1.0), (256, 257, 1.0 / 512.0), (9, 9, 0.0)]
        {
            let rest = f64::from(from) / 1024.0;
            let (mut a, mut b) = (converter.at_rest(rest), clean.at_rest(rest));
            let pulse = converter.step(&mut a, to) - clean.step(&mut b, to);
            // An impulse of area A into a lag is A / tau, and has decayed since.
            let expected = weight * 10e-9 / tau * libm::exp(-(h - 8e-9) / tau);
            assert!((pulse - expected).abs() < 1e-15, "{from} to {to}: {pulse}, {expected}");
        }
        assert_eq!(carry_weight(0, 1, 24), 2.0 / f64::from(1 << 24));
    }

    #[test]
    fn a_group_has_the_bits_of_its_converters() {
        for bits in [1, 6, 10, 24] {
            let law = ConverterLaw { bits, nonlinearity: 5e-4, glitch_area: 2e-9, delay: 0.0, tau: 22e-9 };
            let part = Converter::<f32>::new(50e-9, &law);
            let u = |step: usize, lane: usize| {
                1.3 * quantities::unit_interval(8, &[step as u64, lane as u64]) as f32 - 0.15
            };
            let mut group = part.lanes_at_rest(Lanes::from_fn(|lane| u(0, lane)));
            let mut alone: [_; LANES] = std::array::from_fn(|lane| part.at_rest(u(0, lane)));
            for step in 1..500 {
                let y = part.step_lanes(&mut group, Lanes::from_fn(|lane| u(step, lane)));
                for (lane, alone) in alone.iter_mut().enumerate() {
                    let word = part.word(u(step, lane));
                    assert_eq!(y[lane], part.step(alone, word), "{bits} bits, {step}, {lane}");
                }
            }
        }
    }

    #[test]
    fn one_bit_and_no_lag() {
        let converter = Converter::<f32>::new(1e-8, &ConverterLaw { bits: 0, glitch_area: 1.0, ..BARE });
        let mut state = converter.at_rest(0.1);
        assert_eq!(state.y, 0.0);
        let word = converter.word(0.9);
        // The delay is 0, so the word is there at once.
        assert_eq!(converter.step(&mut state, word), 0.5);
    }
}
