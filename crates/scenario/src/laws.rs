//! Law switches: what the report leaves open or has wrong, decided in the scenario or the model and listed in
//! the record of a run. `exact` follows the same laws.

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
    /// A flat Moon.
    None,
    /// `h - s^2 / 2R`.
    Parabolic,
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

/// The laws of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Laws {
    /// Elevation to view-plane.
    pub projection: Projection,
    /// Shape of the lunoid.
    pub curvature: Curvature,
    /// Finding of hidden ground.
    pub occlusion: Occlusion,
    /// From a line to a pixel.
    pub pixel_rule: PixelRule,
}

/// The laws that a scenario asks for; what it leaves open is the model's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LawWishes {
    /// Elevation to view-plane.
    pub projection: Option<Projection>,
    /// Shape of the lunoid.
    pub curvature: Option<Curvature>,
    /// Finding of hidden ground.
    pub occlusion: Option<Occlusion>,
    /// From a line to a pixel.
    pub pixel_rule: Option<PixelRule>,
}

impl LawWishes {
    /// These wishes, and `model` where nothing is wished.
    pub fn or(self, model: Laws) -> Laws {
        Laws {
            projection: self.projection.unwrap_or(model.projection),
            curvature: self.curvature.unwrap_or(model.curvature),
            occlusion: self.occlusion.unwrap_or(model.occlusion),
            pixel_rule: self.pixel_rule.unwrap_or(model.pixel_rule),
        }
    }
}
