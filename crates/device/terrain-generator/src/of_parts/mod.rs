//! The array of fig. 19 made of real parts: a waveform on every wire, sample by sample.
//!
//! ```text
//! accumulator ─▶ D/A ─▶ smoother ─▶ ramp, 1 - ramp ─▶ 24 function generators ─▶ ± polarity
//!                                                                                  │
//!        3 x 36 multipliers ◀──────────────────────────────────────────────────────┘
//!             └▶ 3 x 36 multiplying D/As ◀── hold registers ─▶ 3 summing trees ─▶ height, slopes
//! ```
//!
//! **Law.** That of [`crate::TerrainGenerator`], with the figures of [`hardware_model::AnalogParts`] for each part.
//! **Units.** Shares of full scale. A basis function is scaled so that its peak is full scale; a word of order
//! (p, q) then has the full scale of the level over the peaks ([`Scale`]).
//! **Timing.** The ramps run ahead of the beam by the nominal delay of the chain, so that height and range meet in
//! the projection processor; strobes and polarity are delayed to where the ramps are (our choices: a sane machine is
//! trimmed so). What is left is spread, dispersion and the offset that the model names.
//! **State.** Every wire settles in retrace. The datum is trimmed there with the accumulators at the eye's foot (our choice): an offset
//! of a thousandth of a mountain would bury the eye. Then the accumulators are preset to the first range, with the words and the
//! polarity of that place, and the array settles there (our choice: the report leaves the first part of the profile unused).
//! Without the preset the array jumps from the foot to the first range within a step. An array whose first samples
//! nobody takes starts later, at rest, by as much before the first that is taken as its parts need to forget that
//! (`warm_up`).
//! **How it is computed.** Eight lanes go through a part side by side, and a block of samples through one part after
//! the other, compiled once for each width of vectors that a processor may have and chosen as the program runs; the
//! bits are the same. What is digital is looked at when it is due, not at every sample. The plain form, part by part
//! and lane by lane, is the test's (`tests/plain.rs`).

mod basis;
mod block;
mod cell;
mod converters;
mod grid;
mod logic;
mod out;
mod parts_array;
mod ramp;
mod row_words;
mod rows;
mod run;
mod scale;
mod state;
mod strobed;
mod summer;
#[cfg(test)]
mod tests;
mod timing;
mod words;

pub use basis::broken_lines;
pub use logic::Logic;
pub use parts_array::PartsArray;
pub(crate) use parts_array::Tap;
pub use scale::Scale;
pub(crate) use scale::{PEAKS, SLOPE_PEAKS};
pub use state::ArrayState;

use std::ops::Range;

use signal::{LANES, Real};
use sweep_program::SweepProgram;

use crate::{Method, Profile, TerrainGenerator};

/// Real parts: the waveform of every wire.
#[derive(Debug)]
pub struct PartsTerrain<'a, S> {
    /// Parts of the array.
    pub array: &'a PartsArray<S>,
    /// State of these parts for the group of sweeps.
    pub state: &'a mut ArrayState<S>,
    /// Number of the first sweep of the group over all frames: noise goes by it.
    pub address: u64,
}

impl<S: Real> Method<S> for PartsTerrain<'_, S> {
    fn trace(
        &mut self,
        generator: &TerrainGenerator<'_>,
        programs: &[SweepProgram; LANES],
        span: Range<usize>,
        profile: &mut Profile<S>,
    ) {
        self.array.trace(generator, programs, span, self.address, self.state, profile, &mut ());
    }
}
