//! A scene as `peers/embree.cpp` reads it.

use scenario::FieldOfView;

use super::EyeMesh;

/// First word of a scene.
const MAGIC: u32 = 0x4853_4d4c;

/// What a ray tracer sees of a mesh around its eye.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sight {
    /// Columns and lines of the picture.
    pub size: [u32; 2],
    /// Field of view of the picture.
    pub field: FieldOfView,
    /// Share of the light that the ground returns, 0..=1.
    pub albedo: f64,
    /// Ground ranges between which the ground is seen (m).
    pub ranges: [f64; 2],
    /// Unit vectors ahead, to starboard and down (north, east, up).
    pub axes: [[f64; 3]; 3],
}

/// Bytes of a scene, little-endian: header, vertices, faces.
pub fn scene_file(mesh: &EyeMesh, sight: &Sight) -> Vec<u8> {
    let counts = [mesh.vertices.len() as u32, mesh.faces.len() as u32];
    let header = [MAGIC].into_iter().chain(counts).chain(sight.size);
    let numbers = [sight.field.tan_half_width, sight.field.tan_half_height, sight.albedo];
    let numbers = numbers.iter().chain(&sight.ranges).chain(sight.axes.iter().flatten());
    let places = mesh.vertices.iter().flatten().flatten();
    let mut bytes: Vec<u8> = header.flat_map(u32::to_le_bytes).collect();
    bytes.extend(numbers.flat_map(|&number| (number as f32).to_le_bytes()));
    bytes.extend(places.flat_map(|part| part.to_le_bytes()));
    bytes.extend(mesh.faces.iter().flatten().flat_map(|corner| corner.to_le_bytes()));
    bytes
}

#[cfg(test)]
mod tests {
    use scenario::FieldOfView;

    use super::{MAGIC, Sight, scene_file};
    use crate::peers::embree::EyeMesh;

    #[test]
    fn a_scene_is_its_header_its_vertices_and_its_faces() {
        let vertices = vec![[[1.0, 2.0, 3.0], [0.0, 0.0, 1.0]]; 3];
        let mesh = EyeMesh { vertices, faces: vec![[0, 1, 2, 2]] };
        let field = FieldOfView { tan_half_width: 0.5, tan_half_height: 0.25 };
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]];
        let sight = Sight { size: [7, 5], field, albedo: 0.75, ranges: [2.0, 900.0], axes };
        let bytes = scene_file(&mesh, &sight);
        let word = |at: usize| u32::from_le_bytes(bytes[4 * at..4 * at + 4].try_into().unwrap());
        let number = |at: usize| f32::from_bits(word(at));
        assert_eq!([0, 1, 2, 3, 4].map(word), [MAGIC, 3, 1, 7, 5]);
        assert_eq!([5, 6, 7, 8, 9].map(number), [0.5, 0.25, 0.75, 2.0, 900.0]);
        assert_eq!([10, 14, 18].map(number), [1.0, 1.0, -1.0]);
        assert_eq!([19, 20, 21, 22, 23, 24].map(number), [1.0, 2.0, 3.0, 0.0, 0.0, 1.0]);
        assert_eq!([37, 38, 39, 40].map(word), [0, 1, 2, 2]);
        assert_eq!(bytes.len(), 4 * 41);
    }
}
