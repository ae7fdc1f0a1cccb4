//! What a scene has beside ground and bodies at one time.

use crate::{LightPoint, Overlay, Sheet, SkyDisc};

/// Light points, sheets, overlays and discs of the sky at one time, each in the order of their numbers.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Effects {
    /// Lamps and stars that shine at this time.
    pub lights: Vec<LightPoint>,
    /// Translucent polygons of the scene.
    pub sheets: Vec<Sheet>,
    /// Polygons that are fixed to the eye.
    pub overlays: Vec<Overlay>,
    /// The sun and the Earth, the nearer first.
    pub discs: Vec<SkyDisc>,
}
