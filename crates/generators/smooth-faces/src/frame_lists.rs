//! Lists of faces of the scenario in a frame.

use std::borrow::Cow;

use faces::{Animate, Detail, Face, Group, ModelShading, Shading, Sides};
use generator::{Label, Stage};
use glam::DVec3;
use scenario::{Carrier, FaceKind, FaceList, ListAxes, Pose};
use smallvec::SmallVec;

use crate::drawn_lists::{drawn, shown_faces};
use crate::list::List;
use crate::parameters::{Hull, Parameters};
use crate::piece::Corner;
use crate::scene::SceneBuilder;
use crate::shown::{Geometry, in_runs};

/// Adds all lists of faces of a stage, the lowest priority first.
pub fn add(scene: &mut SceneBuilder<'_>, stage: &Stage, pose: &Pose) {
    let mut lists = Vec::new();
    for (number, list) in drawn(stage, &scene.run).into_iter().enumerate() {
        let shown = scene.schedule.of_list(number, scene.frame);
        let [_, _, body, _] = shown;
        let at = Pose { time: scene.time(body, stage, pose), ..*pose };
        let Some(axes) = list.carrier.axes(body, &at, (&stage.scenery, &stage.landscape)) else { continue };
        let priority = list.priority(&axes, scene.camera.eye);
        lists.push((rank(list, priority, scene.run.hull), (list, axes, shown)));
    }
    lists.sort_by_key(|(rank, _)| *rank);
    lists.into_iter().for_each(|((_, priority), list)| add_list(scene, stage, priority, list, pose));
}

/// Place of a list in the order: the sea and its levels are before all others where it comes first.
fn rank(list: &FaceList, priority: i32, hull: Hull) -> (u8, i32) {
    let class = match (hull, list.kind, &list.carrier) {
        (Hull::SeaFirst, FaceKind::Level, _) => 0,
        (Hull::SeaFirst, FaceKind::Sea, Carrier::Map(_)) => 1,
        (Hull::SeaFirst, ..) => 2,
        _ => 0,
    };
    (class, priority)
}

fn add_list(
    scene: &mut SceneBuilder<'_>,
    stage: &Stage,
    priority: i32,
    (list, axes, shown): (&FaceList, ListAxes, [u64; 4]),
    pose: &Pose,
) {
    let [of_sequence, of_sun, _, of_normals] = shown;
    let group = shown_group(list, &scene.run, of_normals);
    let scenario_sun = DVec3::from_array(stage.scenery.sun(pose.time).direction());
    let sun = group.sun.vector(of_sun, scenario_sun);
    let detail = if scene.hardware.adds_levels { group.detail } else { Detail::Replace };
    let is_level = list.kind == FaceKind::Level || group.detail != Detail::Replace;
    let number = scene.start(List {
        name: group.name.clone(),
        label: Label::of_faces(list.kind),
        priority: i64::from(priority),
        level: is_level.then_some(detail),
        sun: sun.to_array(),
        has_own_sun: matches!(group.sun, faces::SunProgramme::Turning(_)),
        shown,
        has_fallen: false,
    });
    scene.shown.work.add(Geometry::of_mesh(&group.mesh));
    // Normals stand in the axes of a pattern; those of what turns go with it.
    let to_list = axes.turn.transpose();
    let (screen, shading) = (scene.screen(), scene.run.shading);
    let faces = shown_faces(list, &group, of_sequence, &scene.hardware);
    let runs = in_runs(faces.len(), |shown, place| {
        let face = faces[place];
        let of_mesh = &group.mesh.faces()[face];
        let places: SmallVec<[DVec3; 4]> = of_mesh
            .corners
            .iter()
            .map(|corner| axes.place(group.mesh.vertices()[*corner as usize].place))
            .collect();
        let normal = axes.turn * group.mesh.normals()[face];
        let Some(behind) = side(of_mesh, places[0], normal, screen.camera.eye) else { return };
        let lit = brightness(&group, face, (to_list * sun, behind), shading);
        let corners: SmallVec<[Corner; 4]> = places
            .iter()
            .zip(lit)
            .map(|(at, brightness)| Corner { place: screen.camera.place(*at), brightness })
            .collect();
        shown.add(screen, &corners, of_mesh.colour, [number, face as u32]);
    });
    scene.shown.append(runs);
}

/// Whether a face is seen from behind; `None` if it is not seen.
fn side(face: &Face, corner: DVec3, normal: DVec3, eye: DVec3) -> Option<bool> {
    let is_behind = normal.dot(eye - corner) < 0.0;
    (face.sides == Sides::Both || !is_behind).then_some(is_behind)
}

/// Brightness of the corners of a face under a sun in the axes of its list.
fn brightness(group: &Group, face: usize, (sun, behind): (DVec3, bool), shading: ModelShading) -> Vec<f64> {
    let lit = group.brightness(face, sun, behind);
    match shading == ModelShading::Flat && group.mesh.faces()[face].shading == Shading::Smooth {
        false => lit,
        // A face of false normals is flat with their mean: its own normal would show nothing of them.
        true => vec![lit.iter().sum::<f64>() / lit.len() as f64; lit.len()],
    }
}

/// The list as it is drawn: under renumbered normals a sea has those of frame `written`.
fn shown_group<'a>(list: &'a FaceList, run: &Parameters, written: u64) -> Cow<'a, Group> {
    match &list.sea {
        Some(sea) if run.animate == Animate::Normals => {
            let Group { name, priority, detail, .. } = &list.group;
            let renumbered = sea.renumbered(name, *priority, usize::MAX, written);
            renumbered.map_or(Cow::Borrowed(&list.group), |group| Cow::Owned(group.detailed(*detail)))
        }
        _ => Cow::Borrowed(&list.group),
    }
}
