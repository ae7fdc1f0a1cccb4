//! What one ray sees: all that the planes of a pixel hold.

use generator::{Label, PlaneKind, Shade};

/// What is seen through one place of the screen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seen {
    /// Reflectivity with shadow and texture, 0..=1.
    pub intensity: f64,
    /// Ground range (m), infinite where there is no place.
    pub range: f64,
    /// Height above the tangent plane (m).
    pub height: f64,
    /// Outward unit normal: north, east, up.
    pub normal: [f64; 3],
    /// Reflectivity before remote shadow and texture.
    pub reflectivity: f64,
    /// How it is lit.
    pub shade: Shade,
    /// What it is.
    pub label: Label,
}

impl Seen {
    /// Black sky.
    pub const SKY: Self = Self {
        intensity: 0.0,
        range: f64::INFINITY,
        height: 0.0,
        normal: [0.0; 3],
        reflectivity: 0.0,
        shade: Shade::Lit,
        label: Label::Sky,
    };

    /// A mountain beyond the stored area.
    pub fn silhouette(reflectivity: f64) -> Self {
        Self { intensity: reflectivity, reflectivity, label: Label::Silhouette, ..Self::SKY }
    }

    /// Its value in a plane.
    pub fn value(&self, kind: PlaneKind) -> f64 {
        match kind {
            // It draws no colour: all three would be alike, and their luminance the intensity.
            PlaneKind::Intensity | PlaneKind::Red | PlaneKind::Green | PlaneKind::Blue => self.intensity,
            // Of the distance the part along the ground; the session, which knows the eye, has the rest.
            PlaneKind::Range | PlaneKind::Distance => self.range,
            PlaneKind::Height => self.height,
            PlaneKind::NormalNorth => self.normal[0],
            PlaneKind::NormalEast => self.normal[1],
            PlaneKind::NormalUp => self.normal[2],
            PlaneKind::Reflectivity => self.reflectivity,
            PlaneKind::Shadow => f64::from(self.shade.code()),
            PlaneKind::Label => f64::from(self.label.code()),
        }
    }
}
