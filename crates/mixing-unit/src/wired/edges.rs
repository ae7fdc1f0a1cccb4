//! When the gate of a switch changes.

use parts::Comparator;
use signal::Real;

use crate::{FeatureInput, ToggleList, VideoSwitch};

/// A gate behind its comparator over one sweep: how it begins, and the instants at which it changes.
#[derive(Debug, Clone, Default)]
pub(crate) struct GateEdges {
    pub open_at_start: bool,
    /// Ascending.
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

    /// A gate that follows presence or video at the samples of a lane: exact at a rim, otherwise half way between the samples
    /// that differ. Each change is a jump.
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
            let step = sample as f64 - 1.0;
            while let Some(kink) = kinks.next_if(|kink| kink.sample == sample) {
                let present = if kink.present[1] { S::ONE } else { S::ZERO };
                self.change(&mut open, vs1.is_open(present, kink.feature[1]), step + kink.share.to_f64());
            }
            self.change(&mut open, is_open(sample), step + 0.5);
        }
        let late = comparator.on_ramp(f64::INFINITY);
        self.edges.iter_mut().for_each(|edge| *edge += late);
    }

    fn change(&mut self, open: &mut bool, now: bool, at: f64) {
        if now != *open {
            self.edges.push(at);
            *open = now;
        }
    }
}
