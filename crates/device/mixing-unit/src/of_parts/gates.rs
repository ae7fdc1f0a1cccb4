//! Gates of real switches at the samples of a lane: for a probe.

use hardware_model::{Gate, MixingParts};
use parts::Fade;
use signal::Real;

use crate::of_parts::edges::GateEdges;
use crate::of_parts::mixer::PartsMixer;
use crate::switch::VideoSwitch;
use crate::{FeatureInput, Inputs, ToggleList};

/// Gates of one sweep, one value a sample; 0 throughout where a generator is not there.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SwitchGates {
    /// Presence line behind its comparator: 0 or 1.
    pub present: Vec<f64>,
    /// Gates of VS1 and VS2 behind their comparators: 0 or 1.
    pub gates: [Vec<f64>; 2],
    /// How far both switches are open, 0..=1.
    pub fades: [Vec<f64>; 2],
}

impl<S: Real> PartsMixer<S> {
    /// The gates of a lane as the comparators put them out.
    pub fn gates(&self, inputs: &Inputs<'_, S>, lane: usize) -> SwitchGates {
        let samples = inputs.height.len();
        let nothing = || vec![0.0; samples];
        let mut gates =
            SwitchGates { present: nothing(), gates: [nothing(), nothing()], fades: [nothing(), nothing()] };
        let mut edges = GateEdges::default();
        if let Some(features) = &inputs.features {
            gates.present = self.presence(features, lane);
            self.follow_presence(&self.unit.vs1, features, lane, &mut edges);
            gates.gates[0] = edges.at_samples(samples);
            gates.fades[0] = faded(&edges, self.vs1.transition, samples);
        }
        if let Some(shadow) = inputs.shadow {
            edges.follow(&shadow[lane], self.shadow_comparator());
            gates.gates[1] = edges.at_samples(samples);
            gates.fades[1] = faded(&edges, self.vs2.transition, samples);
        }
        gates
    }

    /// The presence line of a lane behind its comparator, at the samples: 0 or 1.
    pub fn presence(&self, features: &FeatureInput<'_, S>, lane: usize) -> Vec<f64> {
        let lines = VideoSwitch::new(&MixingParts { gate: Gate::Presence, threshold: 0.0 });
        let mut edges = GateEdges::default();
        self.follow_presence(&lines, features, lane, &mut edges);
        edges.at_samples(features.present.len())
    }

    /// When the comparator of a gate of shadow answers at each of its changes (samples, ascending).
    pub fn shadow_answers(&self, gate: &ToggleList<'_, S>) -> Vec<f64> {
        let mut edges = GateEdges::default();
        edges.follow(gate, self.shadow_comparator());
        edges.edges
    }

    /// The gate of `switch`, VS1 or one like it, behind the comparator of the presence line.
    pub(crate) fn follow_presence(
        &self,
        switch: &VideoSwitch,
        features: &FeatureInput<'_, S>,
        lane: usize,
        edges: &mut GateEdges,
    ) {
        let comparator = self.presence_comparator();
        match features.gates.filter(|_| switch.gate == Gate::Presence) {
            Some(gates) => edges.follow(&gates[lane], comparator),
            None => edges.follow_samples(switch, features, lane, comparator),
        }
    }
}

/// How far a switch of this transition (steps) is open.
fn faded(edges: &GateEdges, transition: f64, samples: usize) -> Vec<f64> {
    let (mut fade, mut open) = (Fade::default(), vec![0.0; samples]);
    fade.follow(edges.open_at_start, edges.edges.iter().copied(), transition);
    fade.sample(samples, |sample, g| open[sample] = g);
    open
}
