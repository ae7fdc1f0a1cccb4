//! Bodies of the stage in a frame: each a list of its own, the nearest first.

use std::borrow::Cow;

use faces::{BodyFaces, BodyTriangle, FaceError, Sides};
use generator::{Label, Stage};
use glam::DVec3;
use rayon::prelude::*;
use scenario::{Guest, Pose};
use solids::{Body, Kind};

use crate::list::List;
use crate::piece::Corner;
use crate::scene::SceneBuilder;
use crate::schedule::{Target, group_target};
use crate::shown::{Geometry, Shown};

/// Priority of the nearest body: behind all lists of a scenario.
pub const FIRST: i64 = 1 << 40;

/// A body and the frame whose place and turn it has.
type Placed<'a> = (Cow<'a, Body>, u64);

/// Adds rocks and man-made things at the time of a pose.
///
/// # Errors
/// If a body's numbers are not finite.
pub fn add(scene: &mut SceneBuilder<'_>, stage: &Stage, pose: &Pose) -> Result<(), FaceError> {
    let standing = stage.scenery.bodies(pose.time).map(|body| (Cow::Borrowed(body), scene.frame));
    let guest = |guest: &Guest| {
        let shown = scene.schedule.shown(Target::Object(guest.object), scene.frame);
        Some((Cow::Owned(guest.body(scene.time(shown, stage, pose))?), shown))
    };
    let guests = stage.scenery.all_guests().iter().filter_map(guest);
    let mut bodies: Vec<Placed<'_>> = standing.chain(guests).collect();
    let eye = scene.camera.eye;
    let nearness = |(body, _): &Placed<'_>| (body.foot - eye).length_squared();
    bodies.sort_by(|a, b| nearness(a).total_cmp(&nearness(b)));
    let lists: Vec<(u32, DVec3)> = bodies
        .iter()
        .enumerate()
        .map(|(rank, (body, body_frame))| {
            let list = list(scene, stage, body, (rank, *body_frame, pose));
            let sun = DVec3::from_array(list.sun);
            (scene.start(list), sun)
        })
        .collect();
    let shown = |((body, _), (number, sun)): (&Placed<'_>, &(u32, DVec3))| shown(scene, body, *number, *sun);
    let all: Vec<_> = bodies.par_iter().zip(&lists).map(shown).collect();
    scene.shown.append(all.into_iter().collect::<Result<_, _>>()?);
    Ok(())
}

/// The list of a body, which is number `rank` from the eye on.
fn list(
    scene: &SceneBuilder<'_>,
    stage: &Stage,
    body: &Body,
    (rank, body_frame, pose): (usize, u64, &Pose),
) -> List {
    let sun_frame =
        group_target(body.group).map_or(scene.frame, |group| scene.schedule.shown(group, scene.frame));
    let own = stage.scenery.sun_of_group(body.group, scene.time(sun_frame, stage, pose));
    List {
        name: format!("body at {:.1} m north, {:.1} m east", body.foot.x, body.foot.y),
        label: match body.kind {
            Kind::Rock => Label::Rock,
            Kind::Culture => Label::Culture,
        },
        priority: FIRST + rank as i64,
        level: None,
        sun: own.unwrap_or_else(|| stage.scenery.sun(pose.time)).direction(),
        has_own_sun: own.is_some(),
        shown: [scene.frame, sun_frame, body_frame, scene.frame],
        has_fallen: false,
    }
}

/// The faces of a body that are seen, under a sun. Those of a body beside the picture are counted alone.
fn shown(scene: &SceneBuilder<'_>, body: &Body, number: u32, sun: DVec3) -> Result<Shown, FaceError> {
    let (screen, camera) = (scene.screen(), scene.camera);
    let faces = BodyFaces::new("body", body)?;
    let drop = DVec3::Z * camera.drop_at(body.foot);
    let is_beside = camera.misses(body.centre - drop - camera.eye, body.radius);
    let normals = (!is_beside).then(|| faces.normals(scene.run.shading));
    let mut shown =
        Shown { work: Geometry { vertices: faces.vertices(), ..Geometry::default() }, ..Shown::default() };
    for (face, triangle) in faces.triangles().enumerate() {
        shown.work.faces += 1;
        let Some(turned) = seen_side(&triangle, faces.sides(), camera.eye) else { continue };
        let Some(normals) = &normals else {
            shown.faces += 1;
            continue;
        };
        let normals = normals.of(&triangle);
        let corners = [0, 1, 2].map(|corner| Corner {
            place: camera.direction(triangle.places[corner] - drop - camera.eye),
            brightness: faces::brightness(normals[corner] * turned, sun),
        });
        shown.add(screen, &corners, faces.colour(&triangle), [number, face as u32]);
    }
    Ok(shown)
}

/// 1 where a triangle is seen from before, -1 from behind; `None` if it is not seen.
fn seen_side(triangle: &BodyTriangle, sides: Sides, eye: DVec3) -> Option<f64> {
    let is_behind = triangle.normal.dot(eye - triangle.places[0]) < 0.0;
    match (is_behind, sides) {
        (false, _) => Some(1.0),
        (true, Sides::Both) => Some(-1.0),
        (true, Sides::One) => None,
    }
}
