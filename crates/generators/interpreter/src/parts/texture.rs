//! Converter and filter of the texture generator (sheet of the texture generator).
//!
//! The sum of all layers is a word of a converter whose reference fades with the range; a lag follows.

use landscape::Texture;

use super::kit::Kit;
use super::series::LagMap;

/// Time constants that the filter remembers.
const MEMORY: f64 = 30.0;

/// Margins are told in shares of the reference times this: 1e-9 of a margin is 1e-11 of the reference.
const MARGIN: f64 = 100.0;

/// Texture behind its parts.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Grain {
    /// What is added, from the first sample on; none beyond the reach.
    pub values: Vec<f64>,
    /// How near each sample is to another word, as a hundredth of the reference: the least that the filter remembers.
    pub margins: Vec<f64>,
}

/// `pattern` behind the parts, at `ranges` (m), with what craters add to its gain.
pub fn grained(
    kit: &Kit<'_>,
    texture: &Texture,
    pattern: &[f64],
    added: Option<&[f64]>,
    ranges: &[f64],
) -> Grain {
    let mut grain = Grain { values: pattern.to_vec(), margins: vec![f64::INFINITY; pattern.len()] };
    if let Some(bits) = kit.analog.texture.bits {
        let half = f64::from(1_u32 << (bits - 1));
        for (value, (margin, range)) in grain.values.iter_mut().zip(grain.margins.iter_mut().zip(ranges)) {
            (*value, *margin) = word(*value, reference(texture, *range), half);
        }
    }
    grain.values = enlarged(grain.values, added);
    let tau = kit.lag("txg.filter", 0, kit.analog.texture.bandwidth);
    if tau > 0.0 {
        filter(tau, &mut grain);
    }
    grain
}

/// `values` times the gain of 1 and what craters add, which is never negative.
pub fn enlarged(values: Vec<f64>, added: Option<&[f64]>) -> Vec<f64> {
    let Some(added) = added else { return values };
    values.iter().zip(added).map(|(value, added)| value * (1.0 + added).max(0.0)).collect()
}

/// Amplitude of all layers at a range (m).
fn reference(texture: &Texture, range: f64) -> f64 {
    let layers = texture.grains().iter().map(|grain| grain.layer());
    layers
        .filter(|layer| range < layer.range)
        .map(|layer| layer.amplitude * (1.0 - range / layer.range))
        .sum()
}

/// What a word makes of a value against its reference, and how far the value is from another word.
fn word(value: f64, reference: f64, half: f64) -> (f64, f64) {
    if reference <= 0.0 {
        return (value, f64::INFINITY);
    }
    let place = value / reference * half + 0.5;
    let word = place.floor().clamp(-half, half - 1.0);
    (word / half * reference, (place - place.round()).abs() / half * MARGIN)
}

fn filter(tau: f64, grain: &mut Grain) {
    let lag = LagMap::of(1.0, tau);
    let Some(&first) = grain.values.first() else { return };
    let (mut before, mut output) = (first, first);
    for value in &mut grain.values {
        output = lag.step(output, [before, *value]);
        before = std::mem::replace(value, output);
    }
    let memory = (MEMORY * tau).ceil() as usize + 1;
    let near = grain.margins.clone();
    for (sample, margin) in grain.margins.iter_mut().enumerate() {
        *margin = near[sample.saturating_sub(memory)..=sample].iter().copied().fold(f64::INFINITY, f64::min);
    }
}
