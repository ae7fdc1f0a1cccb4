//! Texture, video switches, adder and clip (sections 13, 14).

use hardware_model::Gate;
use landscape::Texture;
use scenario::TextureInShadow;

use crate::scene::SceneData;

/// What comes into the unit at one sample; reflectivities with their sign.
#[derive(Debug, Clone, Copy)]
pub struct Inputs {
    /// Reflectivity of the terrain, with its sign.
    pub terrain: f64,
    /// Of the surface that features make.
    pub features: f64,
    /// Whether the sample lies within the footprint of a feature.
    pub present: bool,
    /// Whether the sample lies in remote shadow.
    pub shadow: bool,
    /// What texture adds; `None` beyond its reach.
    pub texture: Option<f64>,
}

/// Signals that leave the mixing unit at one sample.
#[derive(Debug, Clone, Copy)]
pub struct Mixed {
    /// Reflectivity as a probe sees it, 0 to 1.
    pub reflectivity: f64,
    /// The same with its sign, as it leaves the unit.
    pub signed: f64,
    /// Whether the gate of video switch VS1 is open.
    pub vs1: bool,
}

/// The unit at one sample.
pub fn mix(scene: &SceneData<'_>, inputs: &Inputs) -> Mixed {
    let parts = scene.settings.mixing_unit;
    let vs1 = inputs.present
        && match parts.gate {
            Gate::Presence => true,
            Gate::SelfKeyed => inputs.features > parts.threshold,
        };
    let lit = if vs1 { inputs.features } else { inputs.terrain };
    let blanked = |video: f64| if inputs.shadow { 0.0 } else { video };
    let mixed = match (inputs.texture, scene.settings.laws.texture_in_shadow) {
        (None, _) => blanked(lit),
        // The adder stands behind VS2: what is dark is recorded as 0 and grained.
        (Some(grain), TextureInShadow::On) => blanked(lit).max(0.0) + grain,
        (Some(grain), TextureInShadow::Off) => blanked(lit + grain),
    };
    Mixed { reflectivity: mixed.clamp(0.0, 1.0), signed: mixed.min(1.0), vs1 }
}

/// What texture adds at (x, y) seen from `range` (m); `None` beyond its reach.
pub fn texture(texture: &Texture, [x, y]: [f64; 2], range: f64) -> Option<f64> {
    let origin = texture.origin();
    let [x, y] = [x - origin[0], y - origin[1]];
    let mut sum = None;
    for grain in texture.grains() {
        let layer = grain.layer();
        if range < layer.range {
            let fading = layer.amplitude * (1.0 - range / layer.range);
            sum = Some(sum.unwrap_or(0.0) + fading * grain.pattern(x, y));
        }
    }
    sum
}
