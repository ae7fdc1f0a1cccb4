//! Sub-generators one by one: what each puts out, and what its comparator answers.

use std::collections::BTreeMap;

use crate::composite::{Samples, Wires, gates};
use crate::loads::DrawnCrater;
use crate::parts::kit::Kit;
use crate::parts::mixer::MixerFigures;
use crate::sweep::Walker;

/// Wires of each crater type, of which there are three.
const TOLD: u32 = 16;

impl Walker<'_> {
    /// `fg.height.<n>` and `fg.comparator.<n>`: the craters of each sub-generator by themselves.
    pub(crate) fn put_sub_generators(
        &mut self,
        wires: Wires,
        samples: &Samples<'_>,
        craters: &[DrawnCrater],
    ) {
        let mut own: BTreeMap<u32, Vec<DrawnCrater>> = BTreeMap::new();
        for crater in craters.iter().filter(|crater| crater.sub_generator < TOLD) {
            let kind = self.scene.landscape.features().crater(crater.crater).type_number();
            own.entry((kind - 1) * TOLD + crater.sub_generator).or_default().push(*crater);
        }
        let nothing = vec![0.0; samples.ground.len()];
        for number in 0..3 * TOLD {
            let [height, comparator] = ["height", "comparator"].map(|wire| format!("fg.{wire}.{number}"));
            let Some(craters) = own.get(&number) else {
                [height, comparator].iter().for_each(|name| self.put_gate(wires, name, &nothing));
                continue;
            };
            let features = self.relief(samples, craters);
            let answers = if self.scene.settings.analog.switching_is_ideal() {
                gates(&features.present)
            } else {
                let unit = MixerFigures::of(&Kit::of(self.scene, self.given));
                let gate = self.presence(samples, &features, &unit);
                self.record.margins.insert(comparator.clone(), gate.margins(nothing.len()));
                gates(&gate.at_samples(nothing.len()))
            };
            self.put_wire(wires, &height, &features.height);
            self.put_gate(wires, &comparator, &answers);
            self.record.margins.entry(comparator).or_insert(features.clear);
        }
    }
}
