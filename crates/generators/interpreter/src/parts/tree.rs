//! A summing tree: 36 products into one voltage, a few at each amplifier (hardware 3.2).

use super::amplifier::AmplifierCircuit;
use super::figures::AmplifierFigures;

/// One tree along a sweep.
#[derive(Debug, Clone)]
pub struct TreeCircuit {
    inputs: usize,
    stages: Vec<Vec<AmplifierCircuit>>,
}

impl TreeCircuit {
    /// At rest under `terms`, for steps of `step` seconds; amplifiers that rest do not clip. The sum with it.
    pub fn at_rest(stages: &[Vec<AmplifierFigures>], inputs: usize, step: f64, terms: &[f64]) -> (Self, f64) {
        let mut values = terms.to_vec();
        let mut tree = Self { inputs, stages: Vec::new() };
        for stage in stages {
            values = meet(&values, inputs);
            let amplifiers = stage.iter().zip(&values);
            tree.stages.push(
                amplifiers
                    .map(|(figures, &input)| AmplifierCircuit::at_rest(*figures, step, input))
                    .collect(),
            );
        }
        (tree, values.iter().sum())
    }

    /// The sum a step later.
    pub fn step(&mut self, terms: &[f64]) -> f64 {
        let mut values = terms.to_vec();
        for stage in &mut self.stages {
            values = meet(&values, self.inputs);
            for (amplifier, value) in stage.iter_mut().zip(&mut values) {
                *value = amplifier.step(*value);
            }
        }
        values.iter().sum()
    }
}

impl TreeCircuit {
    /// The sum a `share` of a step later, of which `after` is the end; `terms` are what is added up where there is no amplifier.
    pub fn towards(&self, after: &Self, share: f64, terms: &[f64]) -> f64 {
        match self.stages.last().zip(after.stages.last()) {
            None => terms.iter().sum(),
            Some((last, after)) => {
                last.iter().zip(after).map(|(before, after)| before.towards(after, share)).sum()
            }
        }
    }
}

/// What meets at each amplifier.
fn meet(values: &[f64], inputs: usize) -> Vec<f64> {
    values.chunks(inputs).map(|group| group.iter().sum()).collect()
}
