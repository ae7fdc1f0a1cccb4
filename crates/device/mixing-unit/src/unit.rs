//! Switches and adder in the order of fig. 28.

use hardware_model::MixingParts;
use scenario::TextureInShadow;
use signal::{Breaks, LANES, Lanes, Real};

use crate::breaks::{Profile, texture_at};
use crate::switch::VideoSwitch;
use crate::{Composite, Inputs, ToggleList};

/// The composite landscape of a group: one [`Lanes`] a sample.
#[derive(Debug, Clone, Default)]
pub struct Mixed<S> {
    /// Height above the eye (m).
    pub height: Vec<Lanes<S>>,
    /// Reflectivity with its sign, at most 1: below 0 is local shadow, drawn as 0.
    pub reflectivity: Vec<Lanes<S>>,
    /// Kinks and edges of remote shadow.
    pub breaks: Breaks<S>,
    /// Which of the breaks bend the profile: kinks do, edges of shadow do not.
    pub bends: [Vec<bool>; LANES],
}

impl<S> Mixed<S> {
    /// The signals at the samples.
    pub fn composite(&self) -> Composite<'_, S> {
        Composite { height: &self.height, reflectivity: &self.reflectivity }
    }

    /// Whether anything lies between samples.
    pub fn has_breaks(&self) -> bool {
        self.breaks.iter().any(|breaks| !breaks.is_empty())
    }
}

/// What the unit is set to for a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MixingUnit {
    /// The switch that lays features on terrain.
    pub vs1: VideoSwitch,
    /// Whether the adder stands behind VS2 or before it.
    pub texture_in_shadow: TextureInShadow,
}

impl MixingUnit {
    /// The unit that the parts make, under a law.
    pub fn new(parts: &MixingParts, texture_in_shadow: TextureInShadow) -> Self {
        Self { vs1: VideoSwitch::new(parts), texture_in_shadow }
    }

    /// Mixes a group. All signals are as long as the terrain's, texture at most.
    pub fn run<S: Real>(&self, inputs: &Inputs<'_, S>, out: &mut Mixed<S>) {
        self.lay_features(inputs, out);
        let texture = inputs.texture.unwrap_or_default();
        let (before, behind) = match self.texture_in_shadow {
            TextureInShadow::Off => (texture, [].as_slice()),
            TextureInShadow::On => ([].as_slice(), texture),
        };
        for (value, &texture) in out.reflectivity.iter_mut().zip(before) {
            *value = *value + texture;
        }
        self.list_breaks(inputs, before, out);
        lay_shadow(inputs.shadow, &mut out.reflectivity);
        add_behind(behind, out);
        clip(out);
    }

    /// VS1 and the height summer.
    fn lay_features<S: Real>(&self, inputs: &Inputs<'_, S>, out: &mut Mixed<S>) {
        out.reflectivity.clear();
        out.reflectivity.extend_from_slice(inputs.reflectivity);
        out.height.clear();
        let Some(features) = inputs.features else {
            return out.height.extend_from_slice(inputs.height);
        };
        let heights = inputs.height.iter().zip(features.height);
        out.height.extend(heights.map(|(&terrain, &feature)| terrain + feature));
        self.vs1.run(features.reflectivity, features.present, &mut out.reflectivity);
    }

    fn list_breaks<S: Real>(&self, inputs: &Inputs<'_, S>, texture: &[Lanes<S>], out: &mut Mixed<S>) {
        let Mixed { height, reflectivity, breaks, bends } = out;
        for (lane, (breaks, bends)) in breaks.iter_mut().zip(bends).enumerate() {
            breaks.clear();
            bends.clear();
            let kinks = inputs.features.map_or([].as_slice(), |features| &features.kinks[lane]);
            let profile = Profile { lane, height, reflectivity, kinks, vs1: &self.vs1, texture };
            let lit = ToggleList { open_at_start: false, toggles: &[] };
            profile.merge(inputs.shadow.map_or(lit, |shadow| shadow[lane]), breaks, bends);
        }
    }
}

/// VS2 at the samples.
fn lay_shadow<S: Real>(shadow: Option<&[ToggleList<'_, S>; LANES]>, reflectivity: &mut [Lanes<S>]) {
    for (lane, toggles) in shadow.into_iter().flatten().enumerate() {
        toggles.for_each_open(reflectivity.len(), |sample| reflectivity[sample][lane] = S::ZERO);
    }
}

/// The adder behind VS2: texture comes upon what would be drawn.
fn add_behind<S: Real>(texture: &[Lanes<S>], out: &mut Mixed<S>) {
    let drawn = |value: S| value.at_least(S::ZERO);
    for (value, &texture) in out.reflectivity.iter_mut().zip(texture) {
        *value = value.map(drawn) + texture;
    }
    for (lane, breaks) in out.breaks.iter_mut().enumerate() {
        for place in breaks.iter_mut().take_while(|place| place.sample < texture.len()) {
            let grain = texture_at(texture, lane, place.sample, place.share);
            (place.before, place.after) = (drawn(place.before) + grain, drawn(place.after) + grain);
        }
    }
}

fn clip<S: Real>(out: &mut Mixed<S>) {
    let at_most_one = |value: S| if value > S::ONE { S::ONE } else { value };
    for value in &mut out.reflectivity {
        *value = value.map(at_most_one);
    }
    for place in out.breaks.iter_mut().flatten() {
        (place.before, place.after) = (at_most_one(place.before), at_most_one(place.after));
    }
}

#[cfg(test)]
mod tests;
