//! When the gate of a switch changes.

use parts::Comparator;
use signal::Real;

use crate::switch::VideoSwitch;
use crate::{FeatureInput, ToggleList};

/// A gate behind its comparator over one sweep: how it begins, and the instants at which it changes.
#[derive(Debug, Clone, Default)]
pub(crate) struct GateEdges {
    pub open_at_start: bool,
    /// Instants of the changes, ascending (steps).
    pub edges: Vec<f64>,
}

impl GateEdges {
    /// A gate whose edges are told. Two of them may change their order: they are the same two changes.
    pub fn follow<S: Real>(&mut self, list: &ToggleList<'_, S>, comparator: &Comparator<S>) {
        self.edges.clear();
        self.open_at_start = list.open_at_start;
        self.edges.extend(list.toggles.iter().map(|toggle| {
            toggle.sample as f64 - 1.0 + toggle.share.to_f64() + comparator.on_ramp(toggle.slope)
        }));
        self.edges.sort_by(f64::total_cmp);
    }

    /// A gate that follows presence or video at the samples of a lane: exact at a rim, otherwise half way from the sample before,
    /// or from the last rim behind it, to the sample that differs. Each change is a jump.
    pub fn follow_samples<S: Real>(
        &mut self,
        vs1: &VideoSwitch,
        features: &FeatureInput<'_, S>,
        lane: usize,
        comparator: &Comparator<S>,
    ) {
        self.edges.clear();
        let is_open =
            |sample: usize| vs1.is_open(features.present[sample][lane], features.reflectivity[sample][lane]);
        let samples = features.present.len();
        self.open_at_start = samples > 0 && is_open(0);
        let (mut open, mut kinks) = (self.open_at_start, features.kinks[lane].iter().peekable());
        for sample in 1..samples {
            let (step, mut share) = (sample as f64 - 1.0, 0.0);
            while let Some(kink) = kinks.next_if(|kink| kink.sample == sample) {
                let present = if kink.present[1] { S::ONE } else { S::ZERO };
                share = kink.share.to_f64();
                self.change(&mut open, vs1.is_open(present, kink.feature[1]), step + share);
            }
            self.change(&mut open, is_open(sample), step + 0.5 * (share + 1.0));
        }
        let late = comparator.on_ramp(f64::INFINITY);
        self.edges.iter_mut().for_each(|edge| *edge += late);
    }

    /// The gate at each sample, 0 or 1.
    pub fn at_samples(&self, samples: usize) -> Vec<f64> {
        let (mut edges, mut open) = (self.edges.iter().peekable(), self.open_at_start);
        let at = |sample: usize| {
            while edges.next_if(|edge| **edge <= sample as f64).is_some() {
                open = !open;
            }
            f64::from(u8::from(open))
        };
        (0..samples).map(at).collect()
    }

    fn change(&mut self, open: &mut bool, now: bool, at: f64) {
        if now != *open {
            self.edges.push(at);
            *open = now;
        }
    }
}

#[cfg(test)]
mod tests {
    use std::array;

    use hardware_model::{AnalogParts, Gate, MixingParts};
    use parts::{Comparator, NoiseSource, Spread};
    use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};
    use signal::{LANES, Lanes};

    use super::GateEdges;
    use crate::switch::VideoSwitch;
    use crate::{FeatureInput, Kink};

    proptest! {
        /// Rims lie anywhere in a step, and the sample behind them may differ once more: a late crater, a dark wall.
        #[test]
        fn edges_ascend_and_lead_from_sample_to_sample(
            samples in proptest::collection::vec(any::<bool>(), 2..30),
            mut rims in proptest::collection::vec((1..30usize, 0.0..=1.0f64, any::<bool>()), 0..40),
            gate in proptest::sample::select(vec![Gate::Presence, Gate::SelfKeyed]),
        ) {
            rims.retain(|rim| rim.0 < samples.len());
            rims.sort_by(|a, b| (a.0, a.1).partial_cmp(&(b.0, b.1)).expect("numbers"));
            let kink = |&(sample, share, on): &(usize, f64, bool)| {
                let feature = [0.0, f64::from(u8::from(on))];
                Kink { sample, share, height: 0.0, feature, terrain: 0.0, present: [false, on] }
            };
            let kinks: [Vec<_>; LANES] = array::from_fn(|_| rims.iter().map(kink).collect());
            let signal: Vec<_> = samples.iter().map(|&on| Lanes::splat(f64::from(u8::from(on)))).collect();
            let features = FeatureInput {
                height: &signal, present: &signal, reflectivity: &signal, lit: &signal, kinks: &kinks, gates: None,
            };
            let law = AnalogParts::ideal().comparator_law(&Spread::new(1), "fg.comparator", 0);
            let comparator = Comparator::new(1e-8, &law, NoiseSource::new(1, "fg.comparator", 0));
            let mut edges = GateEdges::default();
            edges.follow_samples(&VideoSwitch::new(&MixingParts { gate, threshold: 0.0 }), &features, 3, &comparator);
            prop_assert!(edges.edges.is_sorted(), "{:?}", edges.edges);
            for (sample, &on) in samples.iter().enumerate() {
                let at_rim = edges.edges.contains(&(sample as f64));
                let before = edges.edges.iter().filter(|&&edge| edge <= sample as f64).count();
                prop_assert!(at_rim || on == edges.open_at_start ^ (before % 2 == 1), "{sample}: {edges:?}");
            }
            prop_assert_eq!(edges.open_at_start, samples[0]);
        }
    }
}
