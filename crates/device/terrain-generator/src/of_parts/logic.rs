//! The digital wires of an array of parts: the instants of a sweep's steps as each of them has these.

use signal::Real;
use sweep_program::{RampAxis, SweepProgram};

use super::PartsArray;
use crate::TerrainGenerator;

/// Digital wires of an array, by where they are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Logic {
    /// What tells a fold: the accumulator, or a comparator on the ramp.
    Stops,
    /// Flip-flops of the polarity.
    Polarity,
    /// Registers in front of the multiplying D/As.
    Registers,
}

impl<S: Real> PartsArray<S> {
    /// `program` with the instants at which its steps are on these wires, in samples of the beam, ahead of which the ramps run. What lies
    /// before the first range keeps its instants where the accumulators are preset. A strobe of the words in hold does not overtake the
    /// one before it, nor a fold of an axis that axis's fold before it. Of other steps each has its own instant: they need not ascend.
    pub fn on_wires(
        &self,
        logic: Logic,
        generator: &TerrainGenerator<'_>,
        program: &SweepProgram,
    ) -> SweepProgram {
        let timing = &self.timing;
        let mut told = program.clone();
        let (mut strobed_at, mut found_at) = (f64::NEG_INFINITY, [f64::NEG_INFINITY; 2]);
        for (step, told) in program.steps.iter().zip(&mut told.steps) {
            if timing.preset && step.time.0 <= 0.0 {
                continue;
            }
            let own = match logic {
                Logic::Stops => timing.of_stop(step, generator, program),
                Logic::Polarity => timing.of_polarity(step, generator, program),
                Logic::Registers => timing.of_strobe(step, generator, program),
            };
            let before = match (logic, step.kind.fold()) {
                (Logic::Registers, _) => step.kind.changes_hold().then_some(&mut strobed_at),
                (_, fold) => fold.map(|fold| &mut found_at[usize::from(fold.axis == RampAxis::Y)]),
            };
            told.time.0 = before.map_or(own, |before| {
                *before = own.max(*before);
                *before
            });
        }
        told
    }
}
