//! Reflectivity of the ground: slopes, photometry, texture and shadow, in the order of the mixing unit (7, 14).

use features::Rise;
use generator::{Label, Shade};
use landscape::{Landscape, Sun};
use quantities::{is_grey, luminance};
use scenario::{FeatureLight, Laws, TextureInShadow};

use crate::Spot;
use crate::seen::Seen;
use crate::shadow::Dark;
use crate::view::STEEPEST;

/// The light on the ground, as an eye sees it.
#[derive(Debug, Clone, Copy)]
pub struct Light<'a> {
    landscape: &'a Landscape,
    sun: [f64; 3],
    laws: Laws,
    eye_height: f64,
}

impl<'a> Light<'a> {
    /// Light of `sun` on `landscape`, seen from `eye_height` (m).
    pub fn new(landscape: &'a Landscape, sun: &Sun, laws: Laws, eye_height: f64) -> Self {
        Self { landscape, sun: sun.direction(), laws, eye_height }
    }

    /// What is seen of a spot along `direction` (north, east), with what craters add there. `dark` tells whether
    /// remote shadow lies on it, if that matters (its argument).
    pub fn ground(
        &self,
        spot: &Spot,
        direction: [f64; 2],
        rise: &Rise,
        dark: impl FnOnce(bool) -> Option<Dark>,
    ) -> Seen {
        let height = spot.height + rise.height;
        let slopes = std::array::from_fn(|axis| spot.slopes[axis] + rise.slopes[axis]);
        let lit_slopes = match self.laws.feature_light {
            FeatureLight::AsReported if rise.present => rise.slopes,
            _ => slopes,
        };
        // Straight below an eye that all but touches the ground the range is 0.
        let range = spot.range.max(f64::MIN_POSITIVE);
        let sight = ((height - self.eye_height) / range).clamp(-STEEPEST, STEEPEST);
        let shaded = self.shaded(lit_slopes, direction, sight);
        let albedo = self.albedo(spot.place);
        let signed = albedo.map(|albedo| albedo * shaded);
        let texture = self.landscape.texture_at(spot.place[0], spot.place[1], spot.range);
        let [open, shadowed] = self.with_texture(signed, tint(albedo).map(|share| share * texture));
        let dark = dark(open.iter().any(|channel| *channel > 0.0));
        Seen {
            light: if dark.is_some() { shadowed } else { open },
            range: spot.range,
            height,
            normal: normal(slopes),
            reflectivity: signed.map(|channel| channel.clamp(0.0, 1.0)),
            shade: shade(shaded, dark),
            label: self.label(spot.place, rise.present, dark),
        }
    }

    fn label(&self, [x, y]: [f64; 2], crater: bool, dark: Option<Dark>) -> Label {
        match dark {
            Some(Dark::Track) => Label::Track,
            _ if crater => Label::Feature,
            _ if self.landscape.is_void(x, y) => Label::Void,
            _ => Label::Terrain,
        }
    }

    /// Albedo of the ground at a place (north, east; m) for red, green and blue.
    pub fn albedo(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        self.landscape.albedo_at(x, y)
    }

    /// `n.s` times the photometric factor, below 0 in local shadow, for ground of albedo 1 that the eye sees at a
    /// tangent of elevation `sight`.
    pub fn shaded(&self, [hx, hy]: [f64; 2], direction: [f64; 2], sight: f64) -> f64 {
        let ([north, east, up], photometry) = (self.sun, self.landscape.photometry());
        let length = (1.0 + hx * hx + hy * hy).sqrt();
        let lambert = (up - hx * north - hy * east) / length;
        let slant = (1.0 + sight * sight).sqrt();
        let [to_north, to_east] = direction;
        let mu = (hx * to_north + hy * to_east - sight) / (length * slant);
        let cos_g = -(north * to_north + east * to_east + up * sight) / slant;
        lambert * photometry.factor(lambert, mu, cos_g)
    }

    /// Reflectivity outside and inside remote shadow. Texture that shadow gates is added to the signed value, so that
    /// it fades out where the ground turns from the sun.
    fn with_texture(&self, signed: [f64; 3], texture: [f64; 3]) -> [[f64; 3]; 2] {
        let sum = |light: [f64; 3]| -> [f64; 3] {
            std::array::from_fn(|channel| light[channel] + texture[channel])
        };
        let both = match self.laws.texture_in_shadow {
            TextureInShadow::On => [sum(signed.map(|channel| channel.max(0.0))), texture],
            TextureInShadow::Off => [sum(signed), [0.0; 3]],
        };
        both.map(|light| light.map(|channel| channel.clamp(0.0, 1.0)))
    }
}

/// Share of texture that a channel gets: texture has the colour of the ground under it, and the luminance that it has on grey
/// ground.
fn tint(albedo: [f64; 3]) -> [f64; 3] {
    if is_grey(albedo) { [1.0; 3] } else { albedo.map(|channel| channel / luminance(albedo)) }
}

/// Unit normal of ground of slopes `[hx, hy]`: north, east, up.
fn normal([hx, hy]: [f64; 2]) -> [f64; 3] {
    let length = (1.0 + hx * hx + hy * hy).sqrt();
    [-hx / length, -hy / length, 1.0 / length]
}

fn shade(shaded: f64, dark: Option<Dark>) -> Shade {
    match dark {
        _ if shaded <= 0.0 => Shade::Local,
        Some(_) => Shade::Remote,
        None => Shade::Lit,
    }
}
