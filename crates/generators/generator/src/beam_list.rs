//! The list of light points that a generator hands to a beam of its own.

use serde::Serialize;

/// A calligraphic light point of a frame: a beam draws it over the raster (EP-0611021, claims 7, 8, 11 to 16).
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BeamEntry {
    /// Number of the light among those of the mission at that time.
    pub light: u32,
    /// Place on the screen (pixels, x to the right, y down, from the top left corner).
    pub place_px: [f64; 2],
    /// Colour (linear red, green, blue).
    pub colour: [f64; 3],
    /// Diameter of its disc (pixels).
    pub diameter_px: f64,
    /// Intensity with nothing in front of it, above 0.
    pub intensity: f64,
    /// Aperture: sampling points under the disc.
    pub aperture: u32,
    /// Attenuation factor: sum over them of the share of its light that reaches the eye.
    pub attenuation: f64,
    /// Intensity to display: intensity times attenuation over aperture.
    pub display_intensity: f64,
    /// Whether the beam has time for it; the faintest are left out first.
    pub is_drawn: bool,
}
