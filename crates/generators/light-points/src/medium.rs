//! Light that dust lets through.

/// Share of light (0 to 1) that a `path` (m, at least 0) through a medium of extinction `kappa` (1/m, at least 0) lets through.
pub fn transmittance(kappa: f64, path: f64) -> f64 {
    libm::exp(-kappa * path)
}

/// Path (m) inside a sheet of a `thickness` (m) that a ray crosses at an angle of this `cosine` to the sheet's normal: as long as the
/// sheet is wide (`diameter`, m) where the ray runs along it.
pub fn path_in_sheet(thickness: f64, cosine: f64, diameter: f64) -> f64 {
    (thickness / cosine.abs()).min(diameter)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dust_of_the_check_values() {
        assert!((transmittance(0.05, 10.0) - 0.606530659712633).abs() < 1e-15);
        assert!((transmittance(0.05, 40.0) - 0.135335283236613).abs() < 1e-15);
    }

    #[test]
    fn a_slanted_path_is_longer_and_ends_at_the_sheet() {
        assert_eq!(path_in_sheet(2.0, 1.0, 30.0), 2.0);
        assert_eq!(path_in_sheet(2.0, -0.5, 30.0), 4.0);
        assert_eq!(path_in_sheet(2.0, 0.0, 30.0), 30.0);
    }
}
