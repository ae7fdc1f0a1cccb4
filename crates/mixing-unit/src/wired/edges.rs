//! When the gate of a switch changes, and the fade that follows.

use parts::Switch;
use quantities::SweepTime;
use signal::{Lanes, Real};

use crate::{FeatureInput, ToggleList, VideoSwitch};

/// A gate over one sweep: how it begins, and the instants at which it changes.
#[derive(Debug, Clone, Default)]
pub(crate) struct GateEdges {
    pub open_at_start: bool,
    /// Ascending.
    pub edges: Vec<f64>,
}

impl GateEdges {
    /// The gate of VS2: the toggles of the shadow controller.
    pub fn follow_shadow<S: Real>(&mut self, list: &ToggleList<'_, S>) {
        self.edges.clear();
        self.open_at_start = list.dark_at_start;
        self.edges
            .extend(list.toggles.iter().map(|toggle| toggle.sample as f64 - 1.0 + toggle.share.to_f64()));
    }

    /// The gate of VS1 on a lane: exact at a rim, otherwise half way between the samples that differ.
    pub fn follow_features<S: Real>(
        &mut self,
        vs1: &VideoSwitch,
        features: &FeatureInput<'_, S>,
        lane: usize,
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
    }

    fn change(&mut self, open: &mut bool, now: bool, at: f64) {
        if now != *open {
            self.edges.push(at);
            *open = now;
        }
    }

    /// The fade of a switch whose gate is this, `late` steps behind, into one lane of `fades`.
    pub fn fade<S: Real>(&self, switch: &FadingSwitch<S>, late: f64, lane: usize, fades: &mut [Lanes<S>]) {
        let acts = self.edges.iter().map(|&edge| switch.part.acts_at(SweepTime(edge + late)).0);
        let mut acts = acts.peekable();
        let mut fade = Fade { g: share(self.open_at_start), target: share(self.open_at_start), now: -0.5 };
        for (sample, out) in fades.iter_mut().enumerate() {
            let end = sample as f64 + 0.5;
            let mut area = 0.0;
            while let Some(at) = acts.next_if(|&at| at <= end) {
                area += fade.advance(switch, at);
                fade.target = 1.0 - fade.target;
            }
            out[lane] = S::from_f64(area + fade.advance(switch, end));
        }
    }
}

/// A video switch and how long it fades (steps).
#[derive(Debug, Clone, Copy)]
pub(crate) struct FadingSwitch<S> {
    pub part: Switch<S>,
    pub transition: f64,
}

/// The fade of one sweep.
struct Fade {
    g: f64,
    target: f64,
    now: f64,
}

impl Fade {
    /// Goes on to `to`; returns the area of g on the way (steps). The fade is a straight line up to where it ends.
    fn advance<S: Real>(&mut self, switch: &FadingSwitch<S>, to: f64) -> f64 {
        let (start, length) = (self.g, (to - self.now).max(0.0));
        self.now = self.now.max(to);
        if start == self.target {
            return length * start;
        }
        self.g = switch.part.fade(S::from_f64(start), self.target > start, S::from_f64(length)).to_f64();
        let way = ((self.target - start).abs() * switch.transition).min(length);
        way * (start + self.g) / 2.0 + (length - way) * self.g
    }
}

fn share(open: bool) -> f64 {
    f64::from(u8::from(open))
}
