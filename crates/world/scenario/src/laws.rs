//! Law switches: what the report leaves open or has wrong, decided in the scenario or the model and listed in
//! the record of a run. `exact` follows the same laws.

use landscape::{parabolic_drop, spherical_drop};

/// How elevation becomes a place on the view-plane (section 15.3).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Projection {
    /// `X = D tan beta`, `Y = D tan(theta - eta)`: right on the centre sweep only.
    AsReported,
    /// `Y = (D / cos beta) tan(-eta)`: right for all sweeps at zero pitch; pitch is left out.
    Corrected,
    /// Both deflections driven with constants per sweep: always right.
    Exact,
}

/// The lunoid's drop below its tangent plane (section 15.4).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Curvature {
    /// A flat Moon: no drop at any range.
    None,
    /// `h - s^2 / 2R`.
    Parabolic,
    /// `h - R + sqrt(R^2 - s^2)`: the sphere. Ground range s is measured along the tangent plane.
    Exact,
}

impl Curvature {
    /// How far the lunoid has dropped below the tangent plane at ground range `range` (m, at least 0): m, at least 0.
    #[inline]
    pub fn drop(self, range: f64) -> f64 {
        match self {
            Self::None => 0.0,
            Self::Parabolic => parabolic_drop(range),
            Self::Exact => spherical_drop(range),
        }
    }
}

/// How the display projection processor finds what is hidden (section 15.2).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Occlusion {
    /// As reported: blank when elevation falls, unblank when it returns to the held value.
    Derivative,
    /// Compare with the highest elevation so far.
    PeakHold,
}

/// What a pixel shows of the line that it covers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PixelRule {
    /// The mean over the line's height.
    LineMean,
    /// The value at the line's centre.
    Centre,
}

/// What the light of a feature is worked out from (section 10).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FeatureLight {
    /// As reported: from the slopes of the features alone, as if on level ground.
    AsReported,
    /// From the slopes of terrain and features together.
    Combined,
}

/// When a rock or a man-made thing is seen (section 12).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BodyVisibility {
    /// As reported: whole or not at all, by its foot point; it lies over whatever is there.
    AsReported,
    /// By true depth against the ground and against each other.
    Depth,
}

/// What happens to a body whose foot point is in remote shadow (section 12).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShadowedBodies {
    /// As reported: it is not drawn.
    Vanish,
    /// It is drawn black.
    Dark,
}

/// How the light of a rock or a man-made thing runs over its faces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BodyShading {
    /// As reported: one reflectivity a face.
    Flat,
    /// A ramp along each sweep between the edges of a face, whose corners have normals (a study of Link for NASA Ames).
    Smooth,
}

/// Whether texture lies in remote shadow too (section 14).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TextureInShadow {
    /// As reported: the adder comes after the shadow switch, and shadow is grained.
    On,
    /// The shadow gate blanks texture as well.
    Off,
}

/// The laws of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Laws {
    /// Law from elevation to the view-plane.
    pub projection: Projection,
    /// Shape of the lunoid.
    pub curvature: Curvature,
    /// Finding of hidden ground.
    pub occlusion: Occlusion,
    /// From a line to a pixel.
    pub pixel_rule: PixelRule,
    /// Law for the light of features.
    pub feature_light: FeatureLight,
    /// When bodies are seen.
    pub body_visibility: BodyVisibility,
    /// Bodies in remote shadow.
    pub shadowed_bodies: ShadowedBodies,
    /// Light over the faces of bodies.
    pub body_shading: BodyShading,
    /// Texture in remote shadow.
    pub texture_in_shadow: TextureInShadow,
}

impl Default for Laws {
    /// Those nearest to what an eye would see.
    fn default() -> Self {
        Self {
            projection: Projection::Exact,
            curvature: Curvature::Parabolic,
            occlusion: Occlusion::PeakHold,
            pixel_rule: PixelRule::LineMean,
            feature_light: FeatureLight::Combined,
            body_visibility: BodyVisibility::Depth,
            shadowed_bodies: ShadowedBodies::Dark,
            body_shading: BodyShading::Flat,
            texture_in_shadow: TextureInShadow::Off,
        }
    }
}

/// The laws that a scenario asks for; what it leaves open is the model's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LawWishes {
    /// Law from elevation to the view-plane.
    pub projection: Option<Projection>,
    /// Shape of the lunoid.
    pub curvature: Option<Curvature>,
    /// Finding of hidden ground.
    pub occlusion: Option<Occlusion>,
    /// From a line to a pixel.
    pub pixel_rule: Option<PixelRule>,
    /// Law for the light of features.
    pub feature_light: Option<FeatureLight>,
    /// When bodies are seen.
    pub body_visibility: Option<BodyVisibility>,
    /// Bodies in remote shadow.
    pub shadowed_bodies: Option<ShadowedBodies>,
    /// Light over the faces of bodies.
    pub body_shading: Option<BodyShading>,
    /// Texture in remote shadow.
    pub texture_in_shadow: Option<TextureInShadow>,
}

impl From<Laws> for LawWishes {
    /// Wishes for exactly these laws.
    fn from(laws: Laws) -> Self {
        Self {
            projection: Some(laws.projection),
            curvature: Some(laws.curvature),
            occlusion: Some(laws.occlusion),
            pixel_rule: Some(laws.pixel_rule),
            feature_light: Some(laws.feature_light),
            body_visibility: Some(laws.body_visibility),
            shadowed_bodies: Some(laws.shadowed_bodies),
            body_shading: Some(laws.body_shading),
            texture_in_shadow: Some(laws.texture_in_shadow),
        }
    }
}

impl LawWishes {
    /// These wishes, and `model` where nothing is wished.
    pub fn or(self, model: Laws) -> Laws {
        Laws {
            projection: self.projection.unwrap_or(model.projection),
            curvature: self.curvature.unwrap_or(model.curvature),
            occlusion: self.occlusion.unwrap_or(model.occlusion),
            pixel_rule: self.pixel_rule.unwrap_or(model.pixel_rule),
            feature_light: self.feature_light.unwrap_or(model.feature_light),
            body_visibility: self.body_visibility.unwrap_or(model.body_visibility),
            shadowed_bodies: self.shadowed_bodies.unwrap_or(model.shadowed_bodies),
            body_shading: self.body_shading.unwrap_or(model.body_shading),
            texture_in_shadow: self.texture_in_shadow.unwrap_or(model.texture_in_shadow),
        }
    }
}
