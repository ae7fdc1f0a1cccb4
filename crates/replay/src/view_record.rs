//! The view as the record of a run has it: units in the keys, clocks as exact fractions.

use quantities::degrees;
use scenario::{
    BodyVisibility, Curvature, FeatureLight, Laws, Occlusion, PixelRule, Projection, ShadowedBodies,
    TextureInShadow, View,
};
use serde::Serialize;
use serde_json::{Value, json};

/// What was asked of every picture.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ViewRecord {
    columns: u32,
    lines: u32,
    field_of_view_deg: [f64; 2],
    update: String,
    refresh: String,
    display: Value,
    laws: Value,
    ranges_m: [f64; 2],
    yoke: Value,
    levels: Value,
    shadows: Value,
}

impl ViewRecord {
    /// The record of `view`.
    pub fn new(view: &View) -> Self {
        let angle = |tangent: f64| degrees(2.0 * libm::atan(tangent));
        Self {
            columns: view.columns,
            lines: view.lines,
            field_of_view_deg: [angle(view.field.tan_half_width), angle(view.field.tan_half_height)],
            // Rates as whole numbers or fractions of hertz, in words: a float would round them.
            update: view.update.to_string(),
            refresh: view.refresh.to_string(),
            display: json!({ "white": view.display.white, "gamma": view.display.gamma }),
            laws: laws(&view.laws),
            ranges_m: view.ranges,
            yoke: view.yoke.map_or(Value::Null, |yoke| {
                let [step, rate, travel] = [yoke.step, yoke.rate, yoke.travel].map(degrees);
                json!({ "step_deg": step, "rate_deg_s": rate, "travel_deg": travel,
                        "natural_hz": yoke.natural, "damping": yoke.damping })
            }),
            levels: view
                .levels
                .map_or(Value::Null, |switch| json!({ "switch_m": switch.range, "blend_m": switch.blend })),
            shadows: view.shadows.map_or(Value::Null, |fineness| {
                json!({ "finest_m": fineness.finest, "angle_mrad": 1e3 * fineness.angle, "reach_m": fineness.reach })
            }),
        }
    }
}

fn laws(laws: &Laws) -> Value {
    json!({
        "projection": match laws.projection {
            Projection::AsReported => "as-reported",
            Projection::Corrected => "corrected",
            Projection::Exact => "exact",
        },
        "curvature": match laws.curvature {
            Curvature::None => "none",
            Curvature::Parabolic => "parabolic",
            Curvature::Exact => "exact",
        },
        "occlusion": match laws.occlusion {
            Occlusion::Derivative => "derivative",
            Occlusion::PeakHold => "peak-hold",
        },
        "pixel_rule": match laws.pixel_rule {
            PixelRule::LineMean => "line-mean",
            PixelRule::Centre => "centre",
        },
        "feature_light": match laws.feature_light {
            FeatureLight::AsReported => "as-reported",
            FeatureLight::Combined => "combined",
        },
        "body_visibility": match laws.body_visibility {
            BodyVisibility::AsReported => "as-reported",
            BodyVisibility::Depth => "depth",
        },
        "shadowed_bodies": match laws.shadowed_bodies {
            ShadowedBodies::Vanish => "vanish",
            ShadowedBodies::Dark => "dark",
        },
        "texture_in_shadow": match laws.texture_in_shadow {
            TextureInShadow::On => "on",
            TextureInShadow::Off => "off",
        },
    })
}
