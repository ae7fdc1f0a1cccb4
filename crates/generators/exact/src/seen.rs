//! What one ray sees: all that the planes of a pixel hold.

use generator::{Label, PlaneKind, Shade};
use quantities::intensity;

/// What is seen through one place of the screen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seen {
    /// Red, green and blue with shadow and texture, 0..=1 each; equal where there is no colour.
    pub light: [f64; 3],
    /// Ground range (m), infinite where there is no place.
    pub range: f64,
    /// Height above the tangent plane (m).
    pub height: f64,
    /// Outward unit normal: north, east, up.
    pub normal: [f64; 3],
    /// Red, green and blue before remote shadow and texture.
    pub reflectivity: [f64; 3],
    /// How it is lit.
    pub shade: Shade,
    /// Kind of thing that is seen.
    pub label: Label,
}

impl Seen {
    /// What a ray sees in the sky: black, at no range.
    pub const SKY: Self = Self {
        light: [0.0; 3],
        range: f64::INFINITY,
        height: 0.0,
        normal: [0.0; 3],
        reflectivity: [0.0; 3],
        shade: Shade::Lit,
        label: Label::Sky,
    };

    /// A mountain beyond the stored area.
    pub fn silhouette(reflectivity: f64) -> Self {
        let grey = [reflectivity; 3];
        Self { light: grey, reflectivity: grey, label: Label::Silhouette, ..Self::SKY }
    }

    /// Its value in a plane.
    pub fn value(&self, kind: PlaneKind) -> f64 {
        match kind {
            PlaneKind::Intensity => intensity(self.light),
            PlaneKind::Red => self.light[0],
            PlaneKind::Green => self.light[1],
            PlaneKind::Blue => self.light[2],
            // Of the distance the part along the ground; the session, which knows the eye, has the rest.
            PlaneKind::Range | PlaneKind::Distance => self.range,
            PlaneKind::Height => self.height,
            PlaneKind::NormalNorth => self.normal[0],
            PlaneKind::NormalEast => self.normal[1],
            PlaneKind::NormalUp => self.normal[2],
            PlaneKind::Reflectivity => intensity(self.reflectivity),
            PlaneKind::Shadow => f64::from(self.shade.code()),
            PlaneKind::Label => f64::from(self.label.code()),
            // It has no limits.
            PlaneKind::Overload => 0.0,
        }
    }
}
