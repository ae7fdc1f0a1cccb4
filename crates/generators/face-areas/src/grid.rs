//! Which faces reach which lines of the screen.

use generator::ScreenFace;

/// Numbers of faces by line of the screen, ascending.
pub struct Rows {
    lines: Vec<Vec<u32>>,
}

impl Rows {
    /// Lists each face in every line that its box reaches.
    pub fn of(faces: &[ScreenFace], lines: usize) -> Self {
        let mut listed = vec![Vec::new(); lines];
        for (number, face) in (0..).zip(faces) {
            let [low, high] = extent(face, 1);
            // Conversion saturates: what lies beside the screen reaches no line.
            let range = low.floor().max(0.0) as usize..(high.ceil().max(0.0) as usize).min(lines);
            listed[range.start.min(lines)..range.end.max(range.start.min(lines))]
                .iter_mut()
                .for_each(|line: &mut Vec<u32>| line.push(number));
        }
        Self { lines: listed }
    }

    /// Faces that reach a line.
    pub fn of_line(&self, line: usize) -> &[u32] {
        &self.lines[line]
    }
}

/// Least and greatest x (axis 0) or y (axis 1) of a face.
pub fn extent(face: &ScreenFace, axis: usize) -> [f64; 2] {
    let values = face.corners.iter().map(|corner| corner[axis]);
    [values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max)]
}
