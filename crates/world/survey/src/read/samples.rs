//! Stored numbers into heights: no-data, scale, offset.

use std::path::Path;

use landscape::LUNOID_RADIUS;

use super::ReadOptions;
use crate::error::SurveyError;

/// How a stored number becomes a height.
#[derive(Debug, Clone, PartialEq)]
pub struct Conversion {
    /// Stored numbers that mark a void, rounded to the stored type.
    pub voids: Vec<f64>,
    /// Height of one stored unit (m); not 0.
    pub scale: f64,
    /// Height of the stored number 0 above the lunoid (m).
    pub offset: f64,
}

impl Conversion {
    /// From what the file says, where the user does not say otherwise. An offset near the lunar radius makes radii;
    /// heights are above the lunoid, so the radius is taken off again.
    pub fn new(
        path: &Path,
        options: &ReadOptions,
        voids: Vec<f64>,
        scale: Option<f64>,
        offset: Option<f64>,
    ) -> Result<Self, SurveyError> {
        let scale = options.scale.or(scale).unwrap_or(1.0);
        let offset = options.offset.or(offset).unwrap_or(0.0);
        if !(scale.is_finite() && scale != 0.0 && offset.is_finite()) {
            return Err(super::field(
                path,
                "scale and offset",
                format!("{scale} and {offset}"),
                "finite numbers, the scale other than 0",
                "give --scale and --offset",
            ));
        }
        let is_radius = (offset / LUNOID_RADIUS - 1.0).abs() < 0.02;
        let offset = if is_radius { offset - LUNOID_RADIUS } else { offset };
        Ok(Self { voids: options.no_data.map_or(voids, |value| vec![value]), scale, offset })
    }

    /// Rounds the marks of voids to f32, as a file of that type holds them.
    pub fn rounded_to_f32(mut self) -> Self {
        self.voids.iter_mut().for_each(|value| *value = f64::from(*value as f32));
        self
    }

    /// Height (m), NaN for a void; `None` for what nothing declares and is no height: infinity, or beyond the lunar
    /// radius, as the -3.4e38 of a file that forgot to declare its no-data value.
    ///
    /// Minus infinity is a void: exports write it where they mean "none".
    pub fn height(&self, stored: f64) -> Option<f64> {
        if stored.is_nan() || stored == f64::NEG_INFINITY || self.voids.contains(&stored) {
            return Some(f64::NAN);
        }
        let height = stored * self.scale + self.offset;
        (height.abs() <= LUNOID_RADIUS).then_some(height)
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{Conversion, ReadOptions};

    fn conversion(void: f64, offset: f64) -> Conversion {
        Conversion::new(Path::new("x"), &ReadOptions::default(), vec![void], Some(0.5), Some(offset)).unwrap()
    }

    #[test]
    fn no_data_is_compared_in_the_stored_type() {
        // The decimal text of an f32 no-data value is not the f64 that the sample converts to.
        let as_text = -3.4028226550889045e38;
        let stored = f64::from(as_text as f32);
        assert_ne!(stored, -3.40282265508890e38);
        assert!(conversion(-3.40282265508890e38, 0.0).rounded_to_f32().height(stored).unwrap().is_nan());
    }

    #[test]
    fn radii_become_heights() {
        assert_eq!(conversion(-1.0, 1_737_400.0).height(21_008.0), Some(10_504.0));
        assert_eq!(conversion(-1.0, 100.0).height(10.0), Some(105.0));
    }

    #[test]
    fn infinities() {
        assert!(conversion(-1.0, 0.0).height(f64::NEG_INFINITY).unwrap().is_nan());
        assert_eq!(conversion(-1.0, 0.0).height(f64::INFINITY), None);
        assert!(conversion(f64::INFINITY, 0.0).height(f64::INFINITY).unwrap().is_nan());
    }

    #[test]
    fn a_void_that_nothing_declares_is_no_height() {
        assert_eq!(conversion(-1.0, 0.0).height(-3.4028234663852886e38), None);
        assert_eq!(conversion(-1.0, 0.0).height(2.0 * 1_737_400.0), Some(1_737_400.0));
    }
}
