//! What was asked of every picture.

use std::collections::BTreeMap;

use quantities::degrees;
use scenario::{
    BodyVisibility, Curvature, FeatureLight, Laws, LevelSwitch, Occlusion, PixelRule, Projection,
    ShadowFineness, ShadowedBodies, TextureInShadow, View, Yoke,
};
use serde::{Deserialize, Serialize};

/// What was asked of every picture, whatever drew it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ViewRecord {
    /// Columns of the picture.
    pub columns: u32,
    /// Lines of the picture.
    pub lines: u32,
    /// Width and height of the field (deg).
    pub field_of_view_deg: [f64; 2],
    /// Pictures computed a second, as `30000/1001 Hz`.
    pub update: String,
    /// Pictures shown a second.
    pub refresh: String,
    /// From reflectivity to grey.
    pub display: DisplayRecord,
    /// Law switches by name.
    pub laws: BTreeMap<String, String>,
    /// Ground ranges at which ground begins and ends to be seen (m).
    pub ranges_m: [f64; 2],
    /// Deflection yoke, where the display turns the picture with the vehicle's roll.
    pub yoke: Option<YokeRecord>,
    /// Switch from the fine level of the ground to the coarse one.
    pub levels: Option<LevelsRecord>,
    /// How finely remote shadow is worked out, where it is drawn.
    pub shadows: Option<ShadowsRecord>,
}

/// From reflectivity to grey.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct DisplayRecord {
    /// Reflectivity that is shown white.
    pub white: f64,
    /// Exponent of the display.
    pub gamma: f64,
}

/// Steps, limits and dynamics of a deflection yoke.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct YokeRecord {
    /// Smallest step of the yoke (deg).
    pub step_deg: f64,
    /// Largest rate of turn (deg/s).
    pub rate_deg_s: f64,
    /// Largest angle to either side (deg).
    pub travel_deg: f64,
    /// Natural frequency (Hz); none of a yoke that follows at once.
    pub natural_hz: Option<f64>,
    /// Damping ratio of the yoke, without unit.
    pub damping: f64,
}

/// A switch between two levels of the ground.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LevelsRecord {
    /// Ground range of the switch (m).
    pub switch_m: f64,
    /// Length over which both are blended (m).
    pub blend_m: f64,
}

/// How finely remote shadow is worked out.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ShadowsRecord {
    /// Smallest distance of profiles (m).
    pub finest_m: f64,
    /// Distance of profiles for each metre from the eye (mrad).
    pub angle_mrad: f64,
    /// Ground range beyond which no shadow is drawn (m).
    pub reach_m: Option<f64>,
}

impl From<&View> for ViewRecord {
    fn from(view: &View) -> Self {
        let angle = |tangent: f64| degrees(2.0 * libm::atan(tangent));
        Self {
            columns: view.columns,
            lines: view.lines,
            field_of_view_deg: [angle(view.field.tan_half_width), angle(view.field.tan_half_height)],
            update: view.update.to_string(),
            refresh: view.refresh.to_string(),
            display: DisplayRecord { white: view.display.white, gamma: view.display.gamma },
            laws: laws(&view.laws),
            ranges_m: view.ranges,
            yoke: view.yoke.as_ref().map(YokeRecord::from),
            levels: view.levels.as_ref().map(LevelsRecord::from),
            shadows: view.shadows.as_ref().map(ShadowsRecord::from),
        }
    }
}

impl From<&Yoke> for YokeRecord {
    fn from(yoke: &Yoke) -> Self {
        let [step_deg, rate_deg_s, travel_deg] = [yoke.step, yoke.rate, yoke.travel].map(degrees);
        Self { step_deg, rate_deg_s, travel_deg, natural_hz: yoke.natural, damping: yoke.damping }
    }
}

impl From<&LevelSwitch> for LevelsRecord {
    fn from(switch: &LevelSwitch) -> Self {
        Self { switch_m: switch.range, blend_m: switch.blend }
    }
}

impl From<&ShadowFineness> for ShadowsRecord {
    fn from(fineness: &ShadowFineness) -> Self {
        Self { finest_m: fineness.finest, angle_mrad: 1e3 * fineness.angle, reach_m: fineness.reach }
    }
}

/// Each law with the word that scenario files have for it.
fn laws(laws: &Laws) -> BTreeMap<String, String> {
    let words = [
        ("projection", projection(laws.projection)),
        ("curvature", curvature(laws.curvature)),
        ("occlusion", occlusion(laws.occlusion)),
        ("pixel_rule", pixel_rule(laws.pixel_rule)),
        ("feature_light", feature_light(laws.feature_light)),
        ("body_visibility", body_visibility(laws.body_visibility)),
        ("shadowed_bodies", shadowed_bodies(laws.shadowed_bodies)),
        ("texture_in_shadow", texture_in_shadow(laws.texture_in_shadow)),
    ];
    words.into_iter().map(|(law, word)| (law.to_owned(), word.to_owned())).collect()
}

fn projection(law: Projection) -> &'static str {
    match law {
        Projection::AsReported => "as-reported",
        Projection::Corrected => "corrected",
        Projection::Exact => "exact",
    }
}

fn curvature(law: Curvature) -> &'static str {
    match law {
        Curvature::None => "none",
        Curvature::Parabolic => "parabolic",
        Curvature::Exact => "exact",
    }
}

fn occlusion(law: Occlusion) -> &'static str {
    match law {
        Occlusion::Derivative => "derivative",
        Occlusion::PeakHold => "peak-hold",
    }
}

fn pixel_rule(law: PixelRule) -> &'static str {
    match law {
        PixelRule::LineMean => "line-mean",
        PixelRule::Centre => "centre",
    }
}

fn feature_light(law: FeatureLight) -> &'static str {
    match law {
        FeatureLight::AsReported => "as-reported",
        FeatureLight::Combined => "combined",
    }
}

fn body_visibility(law: BodyVisibility) -> &'static str {
    match law {
        BodyVisibility::AsReported => "as-reported",
        BodyVisibility::Depth => "depth",
    }
}

fn shadowed_bodies(law: ShadowedBodies) -> &'static str {
    match law {
        ShadowedBodies::Vanish => "vanish",
        ShadowedBodies::Dark => "dark",
    }
}

fn texture_in_shadow(law: TextureInShadow) -> &'static str {
    match law {
        TextureInShadow::On => "on",
        TextureInShadow::Off => "off",
    }
}
