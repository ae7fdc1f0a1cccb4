//! The Earth, whose elevation files are read too.

/// Equatorial radius of the ellipsoid WGS 84 (m); those of other systems of the Earth differ by less than 0.03 %.
pub const RADIUS: f64 = 6_378_137.0;

/// Note of a format that lies on the ellipsoid by its definition.
pub fn note() -> String {
    format!("the body is flattened by 0.335 %: a sphere of {RADIUS} m stands for it")
}
