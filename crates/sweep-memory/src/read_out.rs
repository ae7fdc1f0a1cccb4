//! The read beam: from sweep space to the picture.

use quantities::sin_cos;
use scenario::{FieldOfView, Projection};
use sweep_program::Fan;

/// What decides where a pixel lies between the sweeps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Azimuths of the sweeps.
    pub fan: Fan,
    /// Law by which the sweeps were written.
    pub projection: Projection,
    /// Pitch of the eye (rad).
    pub pitch: f64,
    /// Field of view.
    pub field: FieldOfView,
}

impl View {
    /// `tan beta` over X on display line `line` of `lines` (section 15.3, inverted): oblique sweeps cross a line
    /// at equal distances, which depend on the line.
    fn tangent_over_x(&self, line: usize, lines: usize) -> f64 {
        if self.projection != Projection::Exact {
            return 1.0;
        }
        let (sin, cos) = sin_cos(self.pitch);
        let y = self.field.tan_half_height * ((2 * line + 1) as f64 / lines as f64 - 1.0);
        1.0 / (cos + sin * y)
    }
}

/// Reads `store`, which holds `lines` values a sweep, into `picture` (row by row, `columns` wide).
pub fn scan_converter(store: &[f32], lines: usize, columns: usize, view: &View, picture: &mut [f32]) {
    let last = view.fan.sweeps as usize - 1;
    for (line, row) in picture.chunks_exact_mut(columns).enumerate() {
        let scale = view.field.tan_half_width * view.tangent_over_x(line, lines) / columns as f64;
        for (column, pixel) in row.iter_mut().enumerate() {
            let offset = (2 * column + 1) as f64 - columns as f64;
            let position = view.fan.position(offset * scale).clamp(0.0, last as f64);
            let left = (position as usize).min(last);
            let right = (left + 1).min(last);
            let share = (position - left as f64) as f32;
            let (left, right) = (store[left * lines + line], store[right * lines + line]);
            *pixel = left + share * (right - left);
        }
    }
}

/// Reads the raster as it was written: column n is sweep n.
pub fn digital_memory(store: &[f32], lines: usize, columns: usize, picture: &mut [f32]) {
    for (line, row) in picture.chunks_exact_mut(columns).enumerate() {
        for (sweep, pixel) in row.iter_mut().enumerate() {
            *pixel = store[sweep * lines + line];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{View, digital_memory, scan_converter};
    use quantities::{radians, sin_cos};
    use scenario::{FieldOfView, Projection};
    use sweep_program::Fan;

    const FIELD: FieldOfView =
        FieldOfView { tan_half_width: 0.466307658154998, tan_half_height: 0.26794919243112 };

    fn view(pitch: f64, sweeps: u32) -> View {
        let fan = Fan::covering(Projection::Exact, pitch, &FIELD, sweeps).unwrap();
        View { fan, projection: Projection::Exact, pitch, field: FIELD }
    }

    #[test]
    fn level_sweeps_read_as_written_by_both_memories() {
        let store: Vec<f32> = (0..12).map(|k| k as f32).collect();
        let (mut tube, mut digital) = (vec![0.0; 12], vec![0.0; 12]);
        scan_converter(&store, 3, 4, &view(0.0, 4), &mut tube);
        digital_memory(&store, 3, 4, &mut digital);
        assert_eq!(digital[..4], [0.0, 3.0, 6.0, 9.0]);
        for (tube, digital) in tube.iter().zip(&digital) {
            assert!((tube - digital).abs() < 1e-5);
        }
    }

    #[test]
    fn a_pixel_takes_the_azimuth_of_its_ray() {
        // Each sweep stores its own tan beta; the picture must show that of every pixel's ray.
        let (pitch, sweeps, lines, columns) = (radians(-17.0), 101, 9, 13);
        let view = view(pitch, sweeps);
        let mut store = Vec::new();
        for sweep in 0..sweeps {
            store.extend(std::iter::repeat_n(view.fan.tangent(sweep) as f32, lines));
        }
        let mut picture = vec![0.0; lines * columns];
        scan_converter(&store, lines, columns, &view, &mut picture);
        for (index, &found) in picture.iter().enumerate() {
            let (line, column) = ((index / columns) as f64, (index % columns) as f64);
            let x = FIELD.tan_half_width * ((2.0 * column + 1.0) / columns as f64 - 1.0);
            let y = FIELD.tan_half_height * ((2.0 * line + 1.0) / lines as f64 - 1.0);
            let (sin, cos) = sin_cos(pitch);
            let expected = x / (cos + y * sin);
            let error = (f64::from(found) - expected).abs();
            assert!(error < 0.006 * view.fan.edge, "pixel {index}: {found} against {expected}");
        }
    }
}
