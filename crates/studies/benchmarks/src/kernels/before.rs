//! What is brought for a frame before its sweeps run, and what is found before a mission.

use std::hint::black_box;
use std::path::Path;

use control_plane::ControlPlane;
use glam::DVec3;
use hardware_model::ShadowCache;
use polyhedron_generator::{Drawn, FaceLight, Field, LeftOut, PolyhedronGenerator, Sight, ViewPlane};
use quantities::sin_cos;
use remote_shadow::Outlines;
use scenario::BodyShading;
use shadow_controller::ShadowController;
use solids::Body;

use super::frames::PART;
use super::group::Group;
use super::{Work, alone};
use crate::around::RoughPlain;
use crate::{Choice, TimedScene};

/// How far around the eye shadows are found (m).
const NEAR: f64 = 1.0;

/// Directions of all sweeps of a group's frame.
fn directions(group: &Group) -> Vec<[f64; 2]> {
    let (sin, cos) = sin_cos(group.scene.pose.attitude.heading);
    (0..group.fan.sweeps).map(|sweep| group.fan.direction(sweep, [cos, sin])).collect()
}

pub(super) fn gates(shadows: Option<&Path>) -> Work {
    let group = Group::of("long-shadows");
    let (stage, foot, directions) = (&group.scene.stage, group.foot(), directions(&group));
    let (reach, parts) = (stage.settings.range.end, stage.settings.shadow_controller);
    let mut bank = group.scene.shadow_bank();
    if let Some(ShadowCache { folder, most_bytes }) = shadows.map(ShadowCache::shared) {
        bank = bank.with_cache(folder, most_bytes);
    }
    let tiles = alone(|| bank.around(&stage.scenery.sun(0.0), foot, NEAR, None));
    let controller = ShadowController { parts, map_centre: [0.0; 2], map_side: 1.0, tells_lines: false };
    let mut gates = Vec::new();
    Work::new(directions.len() as u64, move || {
        let shadows: Vec<&Outlines> = tiles.iter().map(|tile| &tile.outlines).collect();
        alone(|| controller.gates(foot, &directions, reach, black_box(&shadows), &mut gates));
    })
}

pub(super) fn polyhedra() -> Work {
    let group = Group::of("full-drive");
    let tangents: Vec<f64> = (0..group.fan.sweeps).map(|sweep| group.fan.tangent(sweep)).collect();
    let (stage, pose) = (&group.scene.stage, group.scene.pose);
    let (settings, field) = (&stage.settings, stage.settings.raster.field);
    let lines = f64::from(settings.raster.lines);
    let view = ViewPlane {
        eye: pose.eye,
        heading: pose.attitude.heading,
        pitch: pose.attitude.pitch,
        projection: settings.laws.projection,
        curvature: settings.laws.curvature,
        tan_half_height: field.tan_half_height,
        lines,
    };
    let sight = Sight::new(lines, 2.0 * libm::atan(field.tan_half_height));
    let (eye, mut out) = (DVec3::from_array(pose.eye), LeftOut::default());
    let light =
        FaceLight { sun: DVec3::from_array(stage.scenery.sun(0.0).direction()), shading: BodyShading::Flat };
    let resolved = |body: &&Body| sight.resolves(eye, body, &mut out);
    let seen: Vec<Body> = stage.scenery.bodies(0.0).filter(resolved).cloned().collect();
    let mut generator = PolyhedronGenerator::default();
    Work::new(u64::from(group.fan.sweeps), move || {
        let seen: Vec<&Body> = seen.iter().collect();
        let field = Field::new(black_box(&view), &tangents);
        alone(|| {
            generator
                .run(&field, &light, &seen, |&body| Some(Drawn { aspect: field.aspect(body)?, dark: false }))
        });
    })
}

pub(super) fn control_plane(model: &'static str) -> Work {
    let choice = Choice { model: Some(model), raster: Some(PART), ..Choice::default() };
    let scene = TimedScene::shipped("nominal-drive", &choice);
    let (pose, sweeps) = (scene.pose, scene.stage.settings.raster.sweeps);
    let plane = ControlPlane::new(scene.stage);
    let mut programs = Vec::new();
    Work::new(u64::from(sweeps), move || {
        let frame = plane.sweeps(0, &pose).expect("drawn by the tests");
        for sweep in 0..sweeps {
            frame.write_programs(sweep, &mut programs);
            black_box(&programs);
        }
    })
}

pub(super) fn shadow_boundaries() -> Work {
    let scene = TimedScene::shipped("long-shadows", &Choice::default());
    let (sun, foot) = (scene.stage.scenery.sun(0.0), [scene.pose.eye[0], scene.pose.eye[1]]);
    Work::new(1, move || {
        let bank = scene.shadow_bank();
        black_box(alone(|| bank.around(&sun, foot, NEAR, None)));
    })
}

/// Of `side` x `side` samples.
pub(super) fn survey(side: usize) -> Work {
    let plain = RoughPlain::new(side);
    Work::new((side * side) as u64, move || {
        black_box(alone(|| plain.survey()).expect("the samples are finite"));
    })
}
