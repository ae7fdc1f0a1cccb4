//! The faces that a generator has on the screen as a mesh before its camera, with the light that each corner sends.

use generator::{FaceScene, Look, ScreenFace};
use quantities::intensity;
use scenario::View;

use super::{EyeMesh, Sight};

/// Faces as triangles. Axes of the camera: ahead, right, down (m), the eye at the origin. In place of a normal a vertex has its light
/// (intensity), twice 0. What lets light through, and what has no distance, is left out.
pub fn screen_mesh(scene: &FaceScene, view: &View) -> EyeMesh {
    let mut mesh = EyeMesh { vertices: Vec::new(), faces: Vec::new() };
    for (number, face) in scene.faces.iter().enumerate() {
        let middle = middle(face);
        let is_seen = face.corners.iter().all(|&at| face.nearness(at).is_finite() && face.nearness(at) > 0.0);
        if !is_seen || (scene.looks)(number, middle).translucency != [0.0; 3] {
            continue;
        }
        let first = mesh.vertices.len() as u32;
        let vertex = |&at: &[f64; 2]| vertex(view, face, at, &(scene.looks)(number, at));
        mesh.vertices.extend(face.corners.iter().map(vertex));
        for second in first + 1..first + face.corners.len() as u32 - 1 {
            mesh.faces.push([first, second, second + 1, second + 1]);
        }
    }
    mesh
}

/// How the camera of `view` sees such a mesh, with `fineness` rays in place of each pixel across and upright.
pub fn camera_sight(view: &View, fineness: u32) -> Sight {
    Sight {
        size: [fineness * view.columns, fineness * view.lines],
        field: view.field,
        albedo: 1.0,
        ranges: [0.0, f64::from(f32::MAX)],
        axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    }
}

fn middle(face: &ScreenFace) -> [f64; 2] {
    let count = face.corners.len() as f64;
    std::array::from_fn(|axis| face.corners.iter().map(|corner| corner[axis]).sum::<f64>() / count)
}

fn vertex(view: &View, face: &ScreenFace, at: [f64; 2], look: &Look) -> [[f32; 3]; 2] {
    let ahead = 1.0 / face.nearness(at);
    let across = view.field.tan_half_width * (2.0 * at[0] / f64::from(view.columns) - 1.0);
    let down = view.field.tan_half_height * (2.0 * at[1] / f64::from(view.lines) - 1.0);
    let place = [ahead, ahead * across, ahead * down].map(|part| part as f32);
    [place, [intensity(look.light) as f32, 0.0, 0.0]]
}
