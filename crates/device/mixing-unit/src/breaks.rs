//! Kinks and shadow edges of a lane in one ascending list.

use signal::{Break, Lanes, Real};

use crate::stretch::Stretch;
use crate::switch::VideoSwitch;
use crate::{Kink, Toggle, ToggleList};

/// The profile of one lane as it comes to VS2.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Profile<'a, S> {
    pub lane: usize,
    pub height: &'a [Lanes<S>],
    pub reflectivity: &'a [Lanes<S>],
    pub kinks: &'a [Kink<S>],
    pub vs1: &'a VideoSwitch,
    /// Texture that is in `reflectivity`, where the adder stands before VS2.
    pub texture: &'a [Lanes<S>],
}

impl<S: Real> Profile<'_, S> {
    /// Adds kinks and toggles to `breaks` in order, blanked as VS2 does. `bends` says which of them are kinks.
    pub fn merge(&self, shadow: ToggleList<'_, S>, breaks: &mut Vec<Break<S>>, bends: &mut Vec<bool>) {
        let (mut kink, mut toggle, mut dark) = (0, 0, shadow.open_at_start);
        loop {
            let bend = match (self.kinks.get(kink), shadow.toggles.get(toggle)) {
                (None, None) => break,
                (Some(kink), Some(toggle)) => (kink.sample, kink.share) <= (toggle.sample, toggle.share),
                (next, _) => next.is_some(),
            };
            let mut place =
                if bend { self.at_kink(kink) } else { self.at_toggle(&shadow.toggles[toggle], kink) };
            place.before = if dark { S::ZERO } else { place.before };
            dark ^= !bend;
            place.after = if dark { S::ZERO } else { place.after };
            breaks.push(place);
            bends.push(bend);
            kink += usize::from(bend);
            toggle += usize::from(!bend);
        }
    }

    fn at_kink(&self, index: usize) -> Break<S> {
        let kink = &self.kinks[index];
        let texture = texture_at(self.texture, self.lane, kink.sample, kink.share);
        let [before, after] = sides(kink, self.vs1).map(|value| value + texture);
        Break { sample: kink.sample, share: kink.share, height: kink.height, before, after }
    }

    /// `next` is the first kink beyond the toggle.
    fn at_toggle(&self, toggle: &Toggle<S>, next: usize) -> Break<S> {
        let (height, light) = self.stretches(toggle.sample, next);
        let value = light.at(toggle.share);
        let Toggle { sample, share, .. } = *toggle;
        Break { sample, share, height: height.at(share), before: value, after: value }
    }

    /// Height and reflectivity around a place in step `sample` before kink `next`.
    fn stretches(&self, sample: usize, next: usize) -> (Stretch<S>, Stretch<S>) {
        let (passed, ahead) = self.kinks.split_at(next);
        let begins = passed.last().filter(|kink| kink.sample == sample).map(|_| next - 1);
        let ends = ahead.first().filter(|kink| kink.sample == sample).map(|_| next);
        let before = passed.iter().rev().find(|kink| kink.sample < sample);
        let beyond = ahead.iter().find(|kink| kink.sample > sample);
        // A kink in the step before or after cuts the sample behind it off from this piece.
        let near = sample >= 2 && begins.is_none() && before.is_none_or(|kink| kink.sample + 1 < sample);
        let far = sample + 1 < self.height.len()
            && ends.is_none()
            && beyond.is_none_or(|kink| kink.sample > sample + 1);
        let (begins, ends) = (begins.map(|kink| self.at_kink(kink)), ends.map(|kink| self.at_kink(kink)));
        let stretch = |signal: &[Lanes<S>], start: fn(&Break<S>) -> S, end: fn(&Break<S>) -> S| Stretch {
            start: begins.map_or((S::ZERO, signal[sample - 1][self.lane]), |kink| (kink.share, start(&kink))),
            end: ends.map_or((S::ONE, signal[sample][self.lane]), |kink| (kink.share, end(&kink))),
            near: near.then(|| signal[sample - 2][self.lane]),
            far: far.then(|| signal[sample + 1][self.lane]),
        };
        (
            stretch(self.height, |kink| kink.height, |kink| kink.height),
            stretch(self.reflectivity, |kink| kink.after, |kink| kink.before),
        )
    }
}

/// What VS1 lets through on either side of a kink.
fn sides<S: Real>(kink: &Kink<S>, vs1: &VideoSwitch) -> [S; 2] {
    std::array::from_fn(|side| {
        let present = if kink.present[side] { S::ONE } else { S::ZERO };
        vs1.output(kink.terrain, kink.feature[side], present)
    })
}

/// Texture between two samples; 0 where it has ended.
pub(crate) fn texture_at<S: Real>(texture: &[Lanes<S>], lane: usize, sample: usize, share: S) -> S {
    match texture.get(sample) {
        Some(next) => {
            let before = texture[sample - 1][lane];
            before + share * (next[lane] - before)
        }
        None => S::ZERO,
    }
}
