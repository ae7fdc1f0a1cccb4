//! What happens between two samples: rims, and the fades of the switches.

use parts::{Fade, Jump, broken_at};
use scenario::TextureInShadow;
use signal::{Break, LANES, Real};

use crate::breaks::texture_at;
use crate::wired::mixer::{PartsMixer, SwitchScratch, limited};
use crate::{Inputs, Mixed};

/// An instant of one sweep (steps), and the height there if a rim bends it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Event<S> {
    at: f64,
    bend: Option<S>,
}

/// The unit between the samples of one lane.
pub(crate) struct Between<'a, S> {
    pub mixer: &'a PartsMixer<S>,
    pub inputs: &'a Inputs<'a, S>,
    pub scratch: &'a SwitchScratch<S>,
    pub lane: usize,
}

impl<S: Real> SwitchScratch<S> {
    /// Lists the breaks of all lanes as they come to the amplifier.
    pub(crate) fn list_breaks(&mut self, mixer: &PartsMixer<S>, inputs: &Inputs<'_, S>, out: &mut Mixed<S>) {
        for lane in 0..LANES {
            let mut events = std::mem::take(&mut self.events);
            self.collect(inputs, lane, &mut events);
            let between = Between { mixer, inputs, scratch: self, lane };
            let last = inputs.height.len().saturating_sub(1) as f64;
            for event in events.iter().filter(|event| event.at > 0.0 && event.at < last) {
                out.breaks[lane].push(between.break_at(event, out));
                out.bends[lane].push(event.bend.is_some());
            }
            self.events = events;
        }
    }

    /// All instants of a lane, ascending; one of each.
    fn collect(&self, inputs: &Inputs<'_, S>, lane: usize, events: &mut Vec<Event<S>>) {
        events.clear();
        if let Some(features) = &inputs.features {
            let instant = |sample: usize, share: S| sample as f64 - 1.0 + share.to_f64();
            events.extend(
                features.kinks[lane]
                    .iter()
                    .map(|kink| Event { at: instant(kink.sample, kink.share), bend: Some(kink.height) }),
            );
            events.extend(self.jumps[lane].iter().map(|jump| Event { at: jump.at, bend: None }));
            events.extend(knots(&self.fades[0][lane]));
        }
        if inputs.shadow.is_some() {
            events.extend(knots(&self.fades[1][lane]));
        }
        events.sort_by(|a, b| a.at.total_cmp(&b.at).then(b.bend.is_some().cmp(&a.bend.is_some())));
        events.dedup_by(|next, kept| next.at == kept.at && next.bend.is_none());
    }
}

fn knots<S>(fade: &Fade) -> impl Iterator<Item = Event<S>> + use<'_, S> {
    fade.knots().iter().map(|&[at, _]| Event { at, bend: None })
}

impl<S: Real> Between<'_, S> {
    fn break_at(&self, event: &Event<S>, out: &Mixed<S>) -> Break<S> {
        let sample = event.at.ceil() as usize;
        let share = S::from_f64(event.at - (sample - 1) as f64);
        let [before, after] = self.video(event.at, sample).map(S::from_f64);
        let straight = || {
            let from = out.height[sample - 1][self.lane];
            from + (out.height[sample][self.lane] - from) * share
        };
        Break { sample, share, height: event.bend.unwrap_or_else(straight), before, after }
    }

    /// What comes to the amplifier just before and just after `time` within the step to `sample`.
    fn video(&self, time: f64, sample: usize) -> [f64; 2] {
        let Self { mixer, inputs, scratch, lane } = *self;
        let ground = |sample: usize| inputs.reflectivity[sample][lane].to_f64();
        let mut value = broken_at(ground, inputs.reflectivity.len() - 1, &[], time);
        if inputs.features.is_some() {
            let [before, after] = self.features(time);
            let g = scratch.fades[0][lane].at(time);
            let out = |side: usize, s: f64| {
                mixer.vs1.output([g[side], value[side], s], &scratch.leaks[0], sample, lane)
            };
            value = [out(0, before), out(1, after)];
        }
        let share = S::from_f64(time - (sample - 1) as f64);
        let texture = inputs.texture.unwrap_or_default();
        let texture = texture_at(texture, lane, sample, share).to_f64();
        let [grain, behind] = match mixer.unit.texture_in_shadow {
            TextureInShadow::Off => [texture, 0.0],
            TextureInShadow::On => [0.0, texture],
        };
        value = value.map(|value| limited(value + grain));
        if inputs.shadow.is_some() {
            let g = scratch.fades[1][lane].at(time);
            value = [0, 1]
                .map(|side| mixer.vs2.output([g[side], value[side], 0.0], &scratch.leaks[1], sample, lane));
        }
        value.map(|value| limited(value + behind))
    }

    /// Input S of VS1.
    fn features(&self, time: f64) -> [f64; 2] {
        let Self { scratch, lane, .. } = *self;
        let video = |sample: usize| scratch.video[sample][lane].to_f64();
        broken_at(video, scratch.video.len() - 1, &scratch.jumps[lane], time)
    }
}

/// Where the video of the features jumps, as it leaves them: beyond what is lit it is the ground's.
pub(crate) fn jumps<S: Real>(inputs: &Inputs<'_, S>, lane: usize, jumps: &mut Vec<Jump>) {
    jumps.clear();
    let Some(features) = &inputs.features else { return };
    let ground = |sample: usize| inputs.reflectivity[sample][lane].to_f64();
    let last = inputs.reflectivity.len().saturating_sub(1);
    jumps.extend(features.kinks[lane].iter().map(|kink| {
        let at = kink.sample as f64 - 1.0 + kink.share.to_f64();
        let side = |side: usize| {
            let beside = features.lit[kink.sample - 1 + side][lane];
            if kink.present[side] || beside > S::ZERO {
                kink.feature[side].to_f64()
            } else {
                broken_at(ground, last, &[], at)[side]
            }
        };
        Jump { at, before: side(0), after: side(1) }
    }));
}
