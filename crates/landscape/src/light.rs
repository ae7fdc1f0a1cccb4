//! Direction of light and Lambert's law (section 7).

use quantities::sin_cos;

/// The sun as a direction; a point source, the same over the problem area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sun {
    /// Clockwise from north (rad).
    pub azimuth: f64,
    /// Above the horizontal (rad).
    pub elevation: f64,
}

impl Sun {
    /// Unit vector to the sun: north, east, up.
    pub fn direction(&self) -> [f64; 3] {
        let (sin_e, cos_e) = sin_cos(self.elevation);
        let (sin_a, cos_a) = sin_cos(self.azimuth);
        [cos_e * cos_a, cos_e * sin_a, sin_e]
    }

    /// Lambert's factor `max(n.s, 0)` for ground of slopes `[hx, hy]`; 0 is local shadow.
    pub fn reflectivity(&self, [hx, hy]: [f64; 2]) -> f64 {
        let [north, east, up] = self.direction();
        ((up - hx * north - hy * east) / (1.0 + hx * hx + hy * hy).sqrt()).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::Sun;
    use quantities::radians;

    #[test]
    fn check_table_23_3() {
        let rows = [
            ([0.0, 0.0], 30.0, 77.0, 0.5),
            ([0.1, -0.2], 30.0, 40.0, 0.5318584010756228),
            ([0.5, 0.25], 5.0, 0.0, 0.0),
            ([-0.03, 0.04], 2.0, 290.0, 0.08261545308301832),
        ];
        for (slopes, elevation, azimuth, expected) in rows {
            let sun = Sun { azimuth: radians(azimuth), elevation: radians(elevation) };
            assert!((sun.reflectivity(slopes) - expected).abs() < 1e-14, "{slopes:?}");
        }
    }
}
