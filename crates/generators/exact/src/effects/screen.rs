//! The pixels of a picture over the view-plane.

use glam::DVec3;
use scenario::FieldOfView;

/// A raster over the view-plane. Places in pixels are counted from the top left corner of the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Screen {
    size: [usize; 2],
    half: [f64; 2],
}

impl Screen {
    /// A picture of `size` (columns, lines) that shows a field.
    pub fn new(size: [usize; 2], field: FieldOfView) -> Self {
        Self { size, half: [field.tan_half_width, field.tan_half_height] }
    }

    /// Columns and lines of the picture.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Place on the view-plane (right, down; at distance 1) of a place in pixels.
    pub fn on_plane(&self, at: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.half[axis] * (2.0 * at[axis] / self.size[axis] as f64 - 1.0))
    }

    /// Factors of x, y and 1 in pixels of the function `of . (x, y, 1)` of the view-plane.
    pub fn linear(&self, of: DVec3) -> [f64; 3] {
        let [across, down] = [0, 1].map(|axis| 2.0 * self.half[axis] / self.size[axis] as f64);
        [of.x * across, of.y * down, of.z - of.x * self.half[0] - of.y * self.half[1]]
    }

    /// Place in pixels of a place on the view-plane.
    pub fn in_pixels(&self, place: [f64; 2]) -> [f64; 2] {
        self.in_halves([0, 1].map(|axis| place[axis] / self.half[axis]))
    }

    /// Place in pixels of a place in half widths and half heights from the middle.
    pub fn in_halves(&self, place: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| (place[axis] + 1.0) * self.size[axis] as f64 / 2.0)
    }

    /// Focal length in pixels: the geometric mean of that across and that down. Chosen: then the area of a disc is right in
    /// pixels that are not square, and with square ones it is both.
    pub fn focal(&self) -> f64 {
        let [across, down] = self.focals();
        (across * down).sqrt()
    }

    /// A place in pixels in axes in which a pixel keeps its area of 1 and a circle of the view-plane is a circle.
    pub fn rounded(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [across, down] = self.focals();
        let stretch = (down / across).sqrt();
        [x * stretch, y / stretch]
    }

    fn focals(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.size[axis] as f64 / (2.0 * self.half[axis]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_and_view_plane_lead_to_each_other() {
        let screen = Screen::new([40, 10], FieldOfView { tan_half_width: 0.5, tan_half_height: 0.25 });
        assert_eq!(screen.on_plane([40.0, 0.0]), [0.5, -0.25]);
        assert_eq!(screen.in_pixels([0.5, -0.25]), [40.0, 0.0]);
        // 40 pixels across, 20 down: their areas are those of square pixels of the mean.
        assert!((screen.focal() - 800.0_f64.sqrt()).abs() < 1e-12);
        let [x, y] = screen.rounded([1.0, 1.0]);
        assert!((x * y - 1.0).abs() < 1e-15 && (y / x - 2.0).abs() < 1e-15);
    }
}
