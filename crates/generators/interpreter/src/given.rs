//! What a sweep is given.

use crate::frame::Frame;
use crate::parts::Drawn;
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
    /// What a seed drew for the parts of the model.
    pub parts: Drawn<'a>,
    /// Full scale of each main wire in its unit: what its slew rate is against.
    pub full_scales: &'a [(&'static str, f64)],
}
