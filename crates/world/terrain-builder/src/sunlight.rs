//! How a surface answers the light of the sun.

/// Sun and surface of a landscape. The sun is white and infinitely far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light {
    /// Latitude and longitude of the sub-solar point (rad).
    pub sub_solar: [f64; 2],
    /// Red, green and blue of the surface in shadow, 0 to 1.
    pub ambient: [f64; 3],
    /// Red, green and blue that full light adds, 0 to 1.
    pub diffuse: [f64; 3],
}

impl Light {
    /// Colour of a surface in the share of full light that reaches it, 0 to 1.
    pub fn colour(&self, share: f64) -> [f64; 3] {
        [0, 1, 2].map(|part| self.ambient[part] + self.diffuse[part] * share)
    }
}
