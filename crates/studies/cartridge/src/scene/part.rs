//! One analog part on the bench, with the figures that a hardware model gives it.

use hardware_model::{HardwareModel, SMOOTHER_DAMPING};
use parts::{
    Amplifier, AmplifierLaw, AmplifierState, Comparator, ComparatorState, Converter, ConverterLaw, LagStep,
    NoiseSource, SecondOrder, SecondOrderState, Spread, settling_time_constant, summing_time_constant,
    time_constant,
};
use serde::Deserialize;

use super::within;
use crate::hardware::Hardware;

/// A part and what it is fed with, from rest at 0. Signals are shares of full scale.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PartScene {
    /// Kind of the part.
    pub part: Part,
    /// Length of a step.
    pub step_ns: f64,
    /// Number of steps that are run.
    pub steps: usize,
    /// What it is fed with.
    pub input: Input,
    /// The figures of the part.
    pub hardware: Hardware,
}

/// A part, by the keys of the hardware model that say how good it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Part {
    /// A lag of one pole: `multiplier.bandwidth_mhz`.
    Lag,
    /// A smoother of two poles: `sweep.smoother_ns`.
    Smoother,
    /// An amplifier of one input: `amplifier.*`.
    Amplifier,
    /// A comparator by itself: `comparator.*`.
    Comparator,
    /// The converter of a ramp: `sweep.dac_bits` and its other keys.
    Converter,
}

/// An input over time.
#[derive(Debug, Clone, Copy, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Input {
    /// 0 before the start, `to` from then on.
    Step {
        /// Share of full scale.
        to: f64,
    },
    /// From `from` at the start, `per_us` a microsecond.
    Ramp {
        /// Share of full scale.
        from: f64,
        /// Share of full scale a microsecond.
        per_us: f64,
    },
    /// From 0 at the start, `per_us` a microsecond up to the fold, and as fast down from it.
    Fold {
        /// Share of full scale a microsecond.
        per_us: f64,
        /// Time of the fold, from the start (µs).
        fold_us: f64,
    },
}

/// A part under one hardware model.
#[derive(Debug, Clone)]
pub struct PartCase {
    pub scene: PartScene,
    pub model: HardwareModel,
}

/// Instants (s), input and output at each step's end, and the trips of a comparator (s).
#[derive(Debug, Clone, Default)]
pub struct Output {
    pub times: Vec<f64>,
    pub input: Vec<f64>,
    pub output: Vec<f64>,
    pub trips: Vec<f64>,
}

impl PartScene {
    pub(super) fn cases(&self) -> Result<Vec<PartCase>, String> {
        within("step_ns", self.step_ns, 1e-6, 1e9)?;
        within("steps", self.steps as f64, 1.0, 1e7)?;
        let case = |model| PartCase { scene: self.clone(), model };
        Ok(self.hardware.load()?.into_iter().map(case).collect())
    }
}

impl Input {
    /// Its value at a time from the start (s).
    pub fn at(&self, time: f64) -> f64 {
        match *self {
            Self::Step { to } => to,
            Self::Ramp { from, per_us } => from + per_us * 1e6 * time,
            Self::Fold { per_us, fold_us } => per_us * (fold_us - (1e6 * time - fold_us).abs()),
        }
    }
}

impl PartCase {
    /// Time constant of the lag, and of the amplifier (s).
    pub fn tau(&self) -> f64 {
        let analog = &self.model.analog;
        match self.scene.part {
            Part::Amplifier => {
                analog.amplifier.gain_bandwidth.map_or(0.0, |gbw| summing_time_constant(1, gbw))
            }
            _ => analog.multiplier.bandwidth.map_or(0.0, time_constant),
        }
    }

    /// Slew rate of the amplifier (full scales a second).
    pub fn slew(&self) -> f64 {
        let analog = &self.model.analog;
        analog.amplifier.slew.map_or(f64::INFINITY, |slew| slew / analog.full_scale)
    }

    /// Returns the law of the smoother, a system of second order.
    pub fn smoother(&self) -> SecondOrder {
        SecondOrder { natural: 1.0 / self.model.analog.sweep.smoother, damping: SMOOTHER_DAMPING }
    }

    fn amplifier_law(&self) -> AmplifierLaw {
        let analog = &self.model.analog;
        AmplifierLaw {
            tau: self.tau(),
            slew: self.slew(),
            saturation: analog.amplifier.saturation.map_or(f64::INFINITY, |volts| volts / analog.full_scale),
            recovery: analog.amplifier.recovery,
        }
    }

    fn converter_law(&self) -> ConverterLaw {
        let (sweep, full_scale) = (&self.model.analog.sweep, self.model.analog.full_scale);
        ConverterLaw {
            bits: sweep.dac_bits.unwrap_or(24),
            nonlinearity: sweep.nonlinearity,
            glitch_area: sweep.glitch / full_scale,
            delay: 0.0,
            tau: settling_time_constant(sweep.settle, 0.001),
        }
    }

    pub(super) fn run(&self) -> Output {
        let h = 1e-9 * self.scene.step_ns;
        match self.scene.part {
            Part::Lag => {
                let (step, mut y) = (LagStep::<f64>::new(h, self.tau()), 0.0);
                self.walk(|_, [u0, u1]| {
                    y = step.step(y, u0, u1);
                    y
                })
            }
            Part::Smoother => {
                let (step, mut state) = (self.smoother().step::<f64>(h), SecondOrderState::default());
                self.walk(|_, [u0, u1]| {
                    state = step.step(state, u0, u1);
                    state.y
                })
            }
            Part::Amplifier => {
                let part = Amplifier::<f64>::new(h, &self.amplifier_law());
                let mut state = AmplifierState::default();
                self.walk(|_, [u0, u1]| part.step(&mut state, u0, u1))
            }
            Part::Converter => {
                let part = Converter::<f64>::new(h, &self.converter_law());
                let mut state = part.at_rest(self.scene.input.at(0.0));
                self.walk(|_, [_, u1]| part.step(&mut state, part.word(u1)))
            }
            Part::Comparator => self.compare(h),
        }
    }

    fn compare(&self, h: f64) -> Output {
        let law = self.model.analog.comparator_law(&Spread::new(self.model.seed), "bench", 0);
        let part = Comparator::<f64>::new(h, &law, NoiseSource::new(self.model.seed, "bench", 0));
        let (mut state, mut trips) = (ComparatorState::default(), Vec::new());
        let walked = self.walk(|step, [u0, u1]| {
            part.step(&mut state, (0, step), u0, u1, &mut trips);
            f64::from(u8::from(state.high))
        });
        Output { trips: trips.iter().map(|trip| trip.at.0 * h).collect(), ..walked }
    }

    /// Every step's end, with the input at its start and end.
    fn walk(&self, mut step: impl FnMut(usize, [f64; 2]) -> f64) -> Output {
        let (h, input) = (1e-9 * self.scene.step_ns, &self.scene.input);
        let mut seen = Output::default();
        for k in 1..=self.scene.steps {
            let [before, time] = [(k - 1) as f64 * h, k as f64 * h];
            let ends = [input.at(before), input.at(time)];
            seen.times.push(time);
            seen.input.push(ends[1]);
            seen.output.push(step(k, ends));
        }
        seen
    }
}
