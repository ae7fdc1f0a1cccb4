//! The video switch: standard television hardware (section 14).

use fearless_simd::prelude::{Select, SimdBase, SimdFrom};
use fearless_simd::{Level, Simd, dispatch};
use hardware_model::{Gate, MixingParts};
use signal::{Lanes, Real};

/// Voltage of a presence line above which it says that something is there: half way between 0 and 1.
const PRESENT: f64 = 0.5;

/// A switch with inputs C (normally closed) and S (normally open), and a threshold detector on its gate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VideoSwitch {
    /// What drives the gate.
    pub gate: Gate,
    /// Level that the gate must exceed, in its own unit: presence 0 or 1, reflectivity 0..=1.
    pub threshold: f64,
}

impl VideoSwitch {
    /// The switch that the parts make.
    pub fn new(parts: &MixingParts) -> Self {
        let threshold = match parts.gate {
            Gate::Presence => PRESENT,
            Gate::SelfKeyed => parts.threshold,
        };
        Self { gate: parts.gate, threshold }
    }

    /// Whether S is through, given the presence line and the video at S.
    pub fn is_open<S: Real>(&self, present: S, video: S) -> bool {
        let gate = match self.gate {
            Gate::Presence => present,
            Gate::SelfKeyed => video.at_least(S::ZERO),
        };
        gate > S::from_f64(self.threshold)
    }

    /// One value: S while the gate is above the threshold, otherwise C.
    pub fn output<S: Real>(&self, closed: S, open: S, present: S) -> S {
        if self.is_open(present, open) { open } else { closed }
    }

    /// Whole signals, `out` holding C before and the output after.
    pub fn run<S: Real>(&self, open: &[Lanes<S>], present: &[Lanes<S>], out: &mut [Lanes<S>]) {
        // The kind of gate is asked once, not once a sample.
        match self.gate {
            Gate::Presence => self.select(open, present, out),
            Gate::SelfKeyed => self.select(open, open, out),
        }
    }

    fn select<S: Real>(&self, open: &[Lanes<S>], gate: &[Lanes<S>], out: &mut [Lanes<S>]) {
        dispatch!(Level::new(), simd => self.select_by(simd, open, gate, out));
    }

    #[inline(always)]
    fn select_by<L: Simd, S: Real>(
        &self,
        simd: L,
        open: &[Lanes<S>],
        gate: &[Lanes<S>],
        out: &mut [Lanes<S>],
    ) {
        let [level, zero] =
            [S::from_f64(self.threshold), S::ZERO].map(|value| S::Vector::<L>::simd_from(simd, value));
        for ((out, open), gate) in out.iter_mut().zip(open).zip(gate) {
            let [closed, open, gate] =
                [&*out, open, gate].map(|lanes| S::Vector::<L>::from_slice(simd, &lanes.0));
            let gate = gate.simd_gt(zero).select(gate, zero);
            gate.simd_gt(level).select(open, closed).store_slice(&mut out.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::VideoSwitch;
    use hardware_model::{Gate, MixingParts};

    fn switch(gate: Gate, threshold: f64) -> VideoSwitch {
        VideoSwitch::new(&MixingParts { gate, threshold })
    }

    #[test]
    fn a_presence_line_keeps_a_dark_wall_dark() {
        let presence = switch(Gate::Presence, 0.0);
        assert_eq!(presence.output(0.8, -0.2, 1.0), -0.2);
        assert_eq!(presence.output(0.8, 0.3, 0.0), 0.8);
    }

    #[test]
    fn a_self_keyed_gate_lets_terrain_shine_through_dark_video() {
        let keyed = switch(Gate::SelfKeyed, 0.1);
        for (video, expected) in [(-0.2, 0.8), (0.0, 0.8), (0.1, 0.8), (0.11, 0.11), (0.9, 0.9)] {
            assert_eq!(keyed.output(0.8, video, 1.0), expected, "{video}");
        }
    }
}
