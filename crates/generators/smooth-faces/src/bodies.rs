//! Bodies of the stage in a frame: each a list of its own, the nearest first.

use faces::{Face, Mesh, of_body};
use generator::{Label, Stage};
use glam::DVec3;
use scenario::{Guest, Pose};
use smallvec::SmallVec;
use solids::{Body, Kind};

use crate::list::List;
use crate::piece::Corner;
use crate::scene::SceneBuilder;
use crate::schedule::{Target, group_target};

/// Priority of the nearest body: behind all lists of a scenario.
pub const FIRST: i64 = 1 << 40;

/// Adds rocks and man-made things at the time of a pose.
///
/// # Errors
/// If a body's numbers are not finite.
pub fn add(scene: &mut SceneBuilder<'_>, stage: &Stage, pose: &Pose) -> Result<(), faces::FaceError> {
    let standing = stage.scenery.bodies(pose.time).cloned().map(|body| (body, scene.frame));
    let guest = |guest: &Guest| {
        let shown = scene.schedule.shown(Target::Object(guest.object), scene.frame);
        Some((guest.body(scene.time(shown, stage, pose))?, shown))
    };
    let guests = stage.scenery.all_guests().iter().filter_map(guest);
    let mut bodies: Vec<(Body, u64)> = standing.chain(guests).collect();
    let eye = scene.camera.eye;
    let nearness = |(body, _): &(Body, u64)| (body.foot - eye).length_squared();
    bodies.sort_by(|a, b| nearness(a).total_cmp(&nearness(b)));
    for (rank, body) in bodies.iter().enumerate() {
        add_body(scene, stage, body, (rank, pose))?;
    }
    Ok(())
}

fn add_body(
    scene: &mut SceneBuilder<'_>,
    stage: &Stage,
    (body, body_frame): &(Body, u64),
    (rank, pose): (usize, &Pose),
) -> Result<(), faces::FaceError> {
    let mesh = of_body("body", body, scene.run.shading)?.mesh;
    let normals = faces::CornerNormals::new(&mesh, faces::Weights::Equal);
    let sun_frame =
        group_target(body.group).map_or(scene.frame, |group| scene.schedule.shown(group, scene.frame));
    let own = stage.scenery.sun_of_group(body.group, scene.time(sun_frame, stage, pose));
    let sun = DVec3::from_array(own.unwrap_or_else(|| stage.scenery.sun(pose.time)).direction());
    let number = scene.start(List {
        name: format!("body at {:.1} m north, {:.1} m east", body.foot.x, body.foot.y),
        label: match body.kind {
            Kind::Rock => Label::Rock,
            Kind::Culture => Label::Culture,
        },
        priority: FIRST + rank as i64,
        level: None,
        sun: sun.to_array(),
        has_own_sun: own.is_some(),
        shown: [scene.frame, sun_frame, *body_frame, scene.frame],
        has_fallen: false,
    });
    scene.work.add_mesh(&mesh);
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
