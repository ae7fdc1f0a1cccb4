//! Lists of faces of the scenario in a frame.

use std::borrow::Cow;

use faces::{Animate, Face, Group, ModelShading, Shading, Sides};
use generator::{Label, Stage};
use glam::DVec3;
use scenario::{FaceKind, FaceList, ListAxes, Pose};
use smallvec::SmallVec;

use crate::parameters::Parameters;
use crate::piece::Corner;
use crate::scene::{List, SceneBuilder};

/// Adds all lists of faces of a stage, the lowest priority first.
pub fn add(scene: &mut SceneBuilder<'_>, stage: &Stage, frame: u64, pose: &Pose) {
    let all = stage.scenery.face_lists();
    let mut lists: Vec<(i32, &FaceList, ListAxes)> = Vec::with_capacity(all.lists.len());
    for list in all.of_machines() {
        let Some(axes) = list.carrier.axes(frame, pose, (&stage.scenery, &stage.landscape)) else { continue };
        lists.push((list.priority(&axes, scene.camera.eye), list, axes));
    }
    lists.sort_by_key(|(priority, ..)| *priority);
    lists.into_iter().for_each(|list| add_list(scene, stage, list, frame, pose));
}

fn add_list(
    scene: &mut SceneBuilder<'_>,
    stage: &Stage,
    (priority, list, axes): (i32, &FaceList, ListAxes),
    frame: u64,
    pose: &Pose,
) {
    let group = shown_group(list, &scene.run, frame);
    let scenario_sun = DVec3::from_array(stage.scenery.sun(pose.time).direction());
    let sun = group.sun.vector(frame, scenario_sun);
    let own_sun = matches!(group.sun, faces::SunProgramme::Turning(_));
    let words = words(list, &scene.run, own_sun);
    let is_level = list.kind == FaceKind::Level || group.detail != faces::Detail::Replace;
    let number = scene.start(List {
        name: group.name.clone(),
        label: Label::of_faces(list.kind),
        priority: i64::from(priority),
        level: is_level.then_some(group.detail),
        sun: sun.to_array(),
        words,
        has_own_sun: own_sun,
    });
    // Normals stand in the axes of a pattern; those of what turns go with it.
    let to_list = axes.turn.transpose();
    let shading = scene.run.shading;
    for face in group.shown(frame, |name| list.carrier.signal(name, frame)) {
        let of_mesh = &group.mesh.faces()[face];
        let places: SmallVec<[DVec3; 4]> = of_mesh
            .corners
            .iter()
            .map(|corner| axes.place(group.mesh.vertices()[*corner as usize].place))
            .collect();
        let normal = axes.turn * group.mesh.normals()[face];
        let Some(behind) = side(of_mesh, places[0], normal, scene.camera.eye) else { continue };
        let lit = brightness(&group, face, (to_list * sun, behind), shading);
        let corners: SmallVec<[Corner; 4]> = places
            .iter()
            .zip(lit)
            .map(|(at, brightness)| Corner { place: scene.camera.place(*at), brightness })
            .collect();
        scene.add(&corners, of_mesh.colour, [number, face as u32]);
    }
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

/// The list as it shows in `frame`: under renumbered normals a sea shows the last frame that was wholly written.
fn shown_group<'a>(list: &'a FaceList, run: &Parameters, frame: u64) -> Cow<'a, Group> {
    match &list.sea {
        Some(sea) if run.animation.by == Animate::Normals => {
            let shown = run.animation.shown(frame, sea.board.vertices());
            let Group { name, priority, detail, .. } = &list.group;
            let renumbered = sea.renumbered(name, *priority, usize::MAX, shown);
            renumbered.map_or(Cow::Borrowed(&list.group), |group| Cow::Owned(group.detailed(*detail)))
        }
        _ => Cow::Borrowed(&list.group),
    }
}

/// Memory words that the real-time computer writes for a list in a frame.
fn words(list: &FaceList, run: &Parameters, has_own_sun: bool) -> u64 {
    match &list.sea {
        Some(sea) => run.animation.by.words(sea.board.vertices()),
        None if has_own_sun => Animate::Sun.words(0),
        None => 0,
    }
}
