//! Height profiles of mountains beyond the stored area (section 8).

/// The outline of far mountains: elevation against azimuth, of one reflectivity.
#[derive(Debug, Clone, PartialEq)]
pub struct Silhouette {
    /// Azimuth (rad, ascending, clockwise from north) and tangent of the elevation, joined by straight lines;
    /// nothing outside.
    pub outline: Vec<[f64; 2]>,
    /// What it returns, 0..=1.
    pub reflectivity: f64,
}
