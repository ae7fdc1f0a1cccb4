//! What happens between two samples: rims, the fades of the switches, and the begin and end of local shadow.

use fearless_simd::prelude::{SimdBase, SimdFrom, SimdMask};
use fearless_simd::{Level, Simd, dispatch};
use parts::{Fade, Jump, NearFade, NearJumps, straight_at};
use scenario::TextureInShadow;
use signal::{Break, LANES, Lanes, Real};

use crate::breaks::texture_at;
use crate::of_parts::mixer::{PartsMixer, SwitchScratch, limited};
use crate::{Inputs, Mixed};

/// An instant of one sweep (steps), and the height there if a rim bends it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Event<S> {
    at: f64,
    bend: Option<S>,
    /// What comes to the limiter before VS2 just before and just after it, once that has been looked up.
    signed: Option<[f64; 2]>,
}

impl<S> Event<S> {
    fn new(at: f64, bend: Option<S>) -> Self {
        Self { at, bend, signed: None }
    }
}

/// Jumps of the features and fades of the switches of a lane, as time goes on.
struct Near<'a> {
    jumps: NearJumps<'a>,
    fades: [NearFade<'a>; 2],
}

impl<'a> Near<'a> {
    fn new<S>(scratch: &'a SwitchScratch<S>, lane: usize) -> Self {
        let fades = [0, 1].map(|switch| NearFade::new(&scratch.fades[switch][lane]));
        Self { jumps: NearJumps::new(&scratch.jumps[lane]), fades }
    }
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
        self.list_turns();
        let (mut events, mut terminators) =
            (std::mem::take(&mut self.events), std::mem::take(&mut self.terminators));
        for lane in 0..LANES {
            self.collect(inputs, lane, &mut events);
            let between = Between { mixer, inputs, scratch: self, lane };
            between.find_terminators(&mut events, &mut terminators);
            events.append(&mut terminators);
            sort(&mut events);
            let mut near = Near::new(self, lane);
            for event in &events {
                out.breaks[lane].push(between.break_at(event, &mut near, out));
                out.bends[lane].push(event.bend.is_some());
            }
        }
        (self.events, self.terminators) = (events, terminators);
    }

    /// Lists the steps over which what comes to the limiter before VS2 changes its sign, all lanes at once.
    fn list_turns(&mut self) {
        let Self { signed, turns, .. } = self;
        turns.iter_mut().for_each(Vec::clear);
        dispatch!(Level::new(), simd => turn_wide(simd, signed, turns));
    }

    /// All instants of a lane but those of local shadow, ascending; one of each.
    fn collect(&self, inputs: &Inputs<'_, S>, lane: usize, events: &mut Vec<Event<S>>) {
        events.clear();
        if let Some(features) = &inputs.features {
            let instant = |sample: usize, share: S| sample as f64 - 1.0 + share.to_f64();
            events.extend(
                features.kinks[lane]
                    .iter()
                    .map(|kink| Event::new(instant(kink.sample, kink.share), Some(kink.height))),
            );
            events.extend(self.jumps[lane].iter().map(|jump| Event::new(jump.at, None)));
            events.extend(knots(&self.fades[0][lane]));
        }
        if inputs.shadow.is_some() {
            events.extend(knots(&self.fades[1][lane]));
        }
        let last = inputs.height.len().saturating_sub(1) as f64;
        events.retain(|event| event.at > 0.0 && event.at < last);
        sort(events);
    }
}

#[inline(always)]
fn turn_wide<L: Simd, S: Real>(simd: L, signed: &[Lanes<S>], turns: &mut [Vec<usize>; LANES]) {
    let zero = S::Vector::<L>::simd_from(simd, S::ZERO);
    let mut before = zero;
    for (sample, now) in signed.iter().enumerate() {
        let now = S::Vector::<L>::from_slice(simd, &now.0);
        let turned = (before.simd_lt(zero) & now.simd_gt(zero)) | (before.simd_gt(zero) & now.simd_lt(zero));
        if turned.any_true() {
            let lanes = turned.to_bitmask();
            (0..LANES).filter(|lane| lanes >> lane & 1 == 1).for_each(|lane| turns[lane].push(sample));
        }
        before = now;
    }
}

fn knots<S>(fade: &Fade) -> impl Iterator<Item = Event<S>> + use<'_, S> {
    fade.knots().iter().map(|&[at, _]| Event::new(at, None))
}

/// Ascending, and one at each instant: a rim rather than what coincides with it.
fn sort<S: Real>(events: &mut Vec<Event<S>>) {
    events.sort_by(|a, b| a.at.total_cmp(&b.at).then(b.bend.is_some().cmp(&a.bend.is_some())));
    events.dedup_by(|next, kept| next.at == kept.at && next.bend.is_none());
}

impl<S: Real> Between<'_, S> {
    /// Where what comes to the limiter before VS2 passes 0, straight between samples and `events`: there local shadow
    /// begins and ends.
    fn find_terminators(&self, events: &mut [Event<S>], found: &mut Vec<Event<S>>) {
        found.clear();
        let signed = |sample: usize| self.scratch.signed[sample][self.lane].to_f64();
        let mut events = events.iter_mut().peekable();
        let mut turns = self.scratch.turns[self.lane].iter().copied().peekable();
        let mut near = Near::new(self.scratch, self.lane);
        // Other steps do not pass 0.
        while let Some(sample) = next_step(events.peek().map(|event| event.at), turns.peek()) {
            turns.next_if_eq(&sample);
            let end = sample as f64;
            let (mut at, mut value) = (end - 1.0, signed(sample - 1));
            while let Some(event) = events.next_if(|event| event.at < end) {
                // At a sample, the break is of the step before: what leaks is that of the sample.
                let signed = self.signed(event.at, event.at.ceil() as usize, &mut near);
                event.signed = Some(signed);
                let [before, after] = signed;
                found.extend(terminator([at, event.at], [value, before]));
                (at, value) = (event.at, after);
            }
            found.extend(terminator([at, end], [value, signed(sample)]));
        }
    }

    fn break_at(&self, event: &Event<S>, near: &mut Near<'_>, out: &Mixed<S>) -> Break<S> {
        let sample = event.at.ceil() as usize;
        let share = S::from_f64(event.at - (sample - 1) as f64);
        let [before, after] = self.video(event, sample, near).map(S::from_f64);
        let straight = || {
            let from = out.height[sample - 1][self.lane];
            from + (out.height[sample][self.lane] - from) * share
        };
        Break { sample, share, height: event.bend.unwrap_or_else(straight), before, after }
    }

    /// What comes to the amplifier just before and just after an event within the step to `sample`.
    fn video(&self, event: &Event<S>, sample: usize, near: &mut Near<'_>) -> [f64; 2] {
        let Self { mixer, inputs, scratch, lane } = *self;
        let time = event.at;
        let mut value = event.signed.unwrap_or_else(|| self.signed(time, sample, near)).map(limited);
        if inputs.shadow.is_some() {
            let g = near.fades[1].at(time);
            value = [0, 1]
                .map(|side| mixer.vs2.output([g[side], value[side], 0.0], &scratch.leaks[1], sample, lane));
        }
        let behind = match mixer.unit.texture_in_shadow {
            TextureInShadow::Off => 0.0,
            TextureInShadow::On => self.texture(time, sample),
        };
        value.map(|value| limited(value + behind))
    }

    /// What comes to the limiter before VS2.
    fn signed(&self, time: f64, sample: usize, near: &mut Near<'_>) -> [f64; 2] {
        let Self { mixer, inputs, scratch, lane } = *self;
        let ground = |sample: usize| inputs.reflectivity[sample][lane].to_f64();
        let mut value = [straight_at(ground, inputs.reflectivity.len() - 1, time); 2];
        if inputs.features.is_some() {
            // Input S of VS1.
            let video = |sample: usize| scratch.video[sample][lane].to_f64();
            let [before, after] = near.jumps.at(video, scratch.video.len() - 1, time);
            let g = near.fades[0].at(time);
            let out = |side: usize, s: f64| {
                mixer.vs1.output([g[side], value[side], s], &scratch.leaks[0], sample, lane)
            };
            value = [out(0, before), out(1, after)];
        }
        match mixer.unit.texture_in_shadow {
            TextureInShadow::Off => value.map(|value| value + self.texture(time, sample)),
            TextureInShadow::On => value,
        }
    }

    fn texture(&self, time: f64, sample: usize) -> f64 {
        let share = S::from_f64(time - (sample - 1) as f64);
        texture_at(self.inputs.texture.unwrap_or_default(), self.lane, sample, share).to_f64()
    }
}

/// The step in which the next event lies, one at a sample in the step that begins there, or the next turn if that is sooner.
fn next_step(event: Option<f64>, turn: Option<&usize>) -> Option<usize> {
    event.map(|at| at as usize + 1).into_iter().chain(turn.copied()).min()
}

/// Where a straight piece passes 0, if within it.
fn terminator<S>([from, to]: [f64; 2], [value, target]: [f64; 2]) -> Option<Event<S>> {
    if value * target >= 0.0 {
        return None;
    }
    let at = from + (to - from) * (value / (value - target));
    (at > from && at < to).then_some(Event::new(at, None))
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
                straight_at(ground, last, at)
            }
        };
        Jump { at, before: side(0), after: side(1) }
    }));
}

#[cfg(test)]
mod tests {
    use signal::{LANES, Lanes};

    use super::terminator;
    use crate::of_parts::mixer::SwitchScratch;

    /// Signals about 0, at it, and what is no number: steps that are listed are those that pass 0.
    #[test]
    fn turns_are_the_steps_that_pass_0() {
        let drawn = |sample: u64, lane: u64| match quantities::unit_interval(3, &[sample, lane]) {
            share if share < 0.2 => 0.0,
            share if share < 0.22 => f64::NAN,
            share => share - 0.6,
        };
        let mut scratch = SwitchScratch::<f64>::default();
        scratch.signed = (0..500).map(|k| Lanes::from_fn(|lane| drawn(k, lane as u64))).collect();
        scratch.list_turns();
        for lane in 0..LANES {
            let passes = |&sample: &usize| {
                let ends = [sample - 1, sample].map(|sample| scratch.signed[sample][lane]);
                terminator::<f64>([sample as f64 - 1.0, sample as f64], ends).is_some()
            };
            assert_eq!(scratch.turns[lane], (1..500).filter(passes).collect::<Vec<_>>());
            assert!(scratch.turns[lane].len() > 100);
        }
    }
}
