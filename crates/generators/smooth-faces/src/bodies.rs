//! Bodies of the stage in a frame: each a list of its own, the nearest first.

use faces::{Face, Mesh, of_body};
use generator::{Label, Stage};
use glam::DVec3;
use scenario::Pose;
use smallvec::SmallVec;
use solids::{Body, Kind};

use crate::piece::Corner;
use crate::scene::{List, SceneBuilder};

/// Priority of the nearest body: behind all lists of a scenario.
pub const FIRST: i64 = 1 << 40;

/// Adds rocks and man-made things at the time of a pose.
///
/// # Errors
/// If a body's numbers are not finite.
pub fn add(scene: &mut SceneBuilder<'_>, stage: &Stage, pose: &Pose) -> Result<(), faces::FaceError> {
    let standing = stage.scenery.bodies(pose.time).cloned();
    let mut bodies: Vec<Body> = standing.chain(stage.scenery.guests(pose.time)).collect();
    let eye = scene.camera.eye;
    bodies.sort_by(|a, b| (a.foot - eye).length_squared().total_cmp(&(b.foot - eye).length_squared()));
    for (rank, body) in bodies.iter().enumerate() {
        add_body(scene, stage, body, (rank, pose.time))?;
    }
    Ok(())
}

fn add_body(
    scene: &mut SceneBuilder<'_>,
    stage: &Stage,
    body: &Body,
    (rank, time): (usize, f64),
) -> Result<(), faces::FaceError> {
    let mesh = of_body("body", body, scene.run.shading)?.mesh;
    let normals = faces::CornerNormals::new(&mesh, faces::Weights::Equal);
    let own = stage.scenery.sun_of_group(body.group, time);
    let sun = DVec3::from_array(own.unwrap_or_else(|| stage.scenery.sun(time)).direction());
    let number = scene.start(List {
        name: format!("body at {:.1} m north, {:.1} m east", body.foot.x, body.foot.y),
        label: match body.kind {
            Kind::Rock => Label::Rock,
            Kind::Culture => Label::Culture,
        },
        priority: FIRST + rank as i64,
        level: None,
        sun: sun.to_array(),
        words: 0,
        has_own_sun: own.is_some(),
    });
    let drop = DVec3::Z * scene.camera.drop_at(body.foot);
    for (k, face) in mesh.faces().iter().enumerate() {
        let Some(turned) = seen_side(face, &mesh, k, scene.camera.eye) else { continue };
        let place = |corner: u32| mesh.vertices()[corner as usize].place;
        let corners: SmallVec<[Corner; 4]> = face
            .corners
            .iter()
            .zip(normals.of_face(k))
            .map(|(corner, normal)| Corner {
                place: scene.camera.direction(place(*corner) - drop - scene.camera.eye),
                brightness: faces::brightness(*normal * turned, sun),
            })
            .collect();
        scene.add(&corners, face.colour, [number, k as u32]);
    }
    Ok(())
}

/// 1 where a face is seen from before, -1 from behind; `None` if it is not seen.
fn seen_side(face: &Face, mesh: &Mesh, number: usize, eye: DVec3) -> Option<f64> {
    let corner = mesh.vertices()[face.corners[0] as usize].place;
    let is_behind = mesh.normals()[number].dot(eye - corner) < 0.0;
    match (is_behind, face.sides) {
        (false, _) => Some(1.0),
        (true, faces::Sides::Both) => Some(-1.0),
        (true, faces::Sides::One) => None,
    }
}
