//! What a sweep is given.

use crate::frame::Frame;
use crate::parts::Drawn;
use crate::parts::gates::Edge;
use crate::shadows::ShadowLine;

/// What the interpreter does not work out and takes as the machine has it.
#[derive(Debug, Clone, Copy)]
pub struct Given<'a> {
    /// Ground range of each sample (m).
    pub ranges: &'a [f64],
    /// The digital side of the frame.
    pub frame: &'a Frame,
    /// Numbers in 0..1 that a seed draws, each by three words.
    pub draw: fn(u64, [u64; 3]) -> f64,
    /// Lines of shadow on the ground; empty where there is none.
    pub lines: &'a [ShadowLine],
    /// Gate of remote shadow at each sample, 0 or 1; empty where there is no shadow.
    pub shadow: &'a [f64],
    /// The same gate between samples: whether it is open at the eye, and where it changes, as its line generators have it.
    pub shadow_edges: (bool, &'a [Edge]),
    /// What a seed drew for the parts of the model.
    pub parts: Drawn<'a>,
    /// Steps of the scene's clock in a sample of the machine: 1, or more where it is told between samples.
    pub between: usize,
    /// Full scale of each main wire in its unit: what its slew rate is against.
    pub full_scales: &'a [(&'static str, f64)],
}

/// What drives a part with a memory: `values` at the samples of the machine, straight between them, with `between` steps in each.
/// What lies behind the last stays.
pub fn straight(mut values: Vec<f64>, between: usize) -> Vec<f64> {
    for from in (0..values.len()).step_by(between) {
        let Some(&end) = values.get(from + between) else { break };
        let begin = values[from];
        for step in 1..between {
            values[from + step] = begin + (end - begin) * (step as f64 / between as f64);
        }
    }
    values
}

/// Values at every sample of the machine as a wire of `count` steps, `between` in each sample; what is a gate stays until the next.
pub(crate) fn spread(values: &[f64], between: usize, count: usize, is_gate: bool) -> Vec<f64> {
    let of = |step: usize| values.get(step / between).copied().unwrap_or(0.0);
    let wire = (0..count).map(of).collect();
    if is_gate { wire } else { straight(wire, between) }
}
