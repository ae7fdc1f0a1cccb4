//! Tracks in existing pictures against those that `exact` draws, behind ridges and rocks too.

use std::sync::Arc;

use generator::{Label, PlaneKind};
use glam::{DMat3, DVec3};
use quantities::unit_interval;
use scenario::{Scenery, Standing, TrackPatch, Vehicle};
use solids::{Body, Kind, Solid};
use vehicle_shadow::{AugmentError, Camera, Sequence, Shape, TrueGround, USUAL_TRACKS, tracks_along};

use crate::scenes::{bumps, flat, shot, stage, sun, to_sun};
use crate::true_ground::{drawn, middle};

const SIZE: [usize; 2] = [120, 72];

/// A ride ahead of the eye, in patches half a metre long.
fn patches() -> Vec<TrackPatch> {
    let patch = |index: u32| {
        let [x, y] = [243.0 + 0.5 * f64::from(index / 2), 239.0 + 2.0 * f64::from(index % 2)];
        let bend = 0.08 * (x - 243.0);
        let corners = [[x + 0.4, y - 0.2], [x + 0.4, y + 0.2], [x, y + 0.2], [x, y - 0.2]];
        TrackPatch { laid: 0.0, corners: corners.map(|[x, y]| [x, y + bend]) }
    };
    (0..160).map(patch).collect()
}

#[test]
fn tracks_are_those_that_exact_draws() {
    let (mut dark, mut differ, mut hidden) = (0, 0, 0);
    for seed in [21, 22, 23] {
        let ground = bumps(seed, 0.9);
        let eye = ground.height(240.0, 240.0).unwrap() + 2.2;
        let shot = shot([240.0, 240.0, eye], 2.2, [6.0, -6.0, 2.0]);
        let rock =
            Arc::new(Solid::boxed(DVec3::new(-0.4, -0.4, -0.5), DVec3::new(0.4, 0.4, 0.7), 1.0).unwrap());
        let at = [246.0 + 2.0 * unit_interval(seed, &[0]), 239.2];
        let foot = DVec3::new(at[0], at[1], ground.height(at[0], at[1]).unwrap());
        let body = Body::place(1, Kind::Rock, &rock, foot, &DMat3::IDENTITY, 1.0);
        let bodies = vec![Standing { from: 0.0, until: f64::INFINITY, body }];
        let scenery = Scenery::still(sun(120.0, 60.0)).with_bodies(bodies);
        let planes = drawn(&ground, scenery.clone().with_patches(patches()), &shot);
        let labels = planes.get(PlaneKind::Label).unwrap();
        let truth = TrueGround::new(stage(&ground, scenery, SIZE.map(|count| count as u32))).unwrap();
        let nothing = Shape::new(Vec::new(), 1.6334);
        let gates = truth.gates(&nothing, &shot, &[to_sun(120.0, 60.0)], &patches(), SIZE).suns.remove(0);
        for (index, &label) in labels.iter().enumerate() {
            let x = middle(shot.field.tan_half_width, index % SIZE[0], SIZE[0]);
            let expected = label == f32::from(Label::Track.code());
            dark += usize::from(expected);
            differ += usize::from(gates.lines[index / SIZE[0]].holds(x) != expected);
        }
        // How many patches no pixel shows: the ridges do hide some.
        hidden += patches()
            .iter()
            .filter(|patch| {
                let middle: DVec3 =
                    patch.corners.iter().map(|c| DVec3::new(c[0], c[1], 0.0)).sum::<DVec3>() / 4.0;
                let top = DVec3::new(middle.x, middle.y, ground.height(middle.x, middle.y).unwrap());
                let eye = DVec3::from_array(shot.eye);
                (1..200).any(|k| {
                    let at = eye + (top - eye) * (f64::from(k) / 200.0);
                    at.z < ground.height(at.x, at.y).unwrap() - 1e-6
                })
            })
            .count();
    }
    assert!(dark > 300 && hidden > 20, "{dark} dark pixels, {hidden} hidden patches");
    assert!(differ <= dark / 60, "{differ} of {dark}: more than edges through the middles of pixels");
}

/// Three poses of a ride to the north: patches begin behind the first, under the rear wheels, and there are none where
/// the eye is too high for the vehicle to stand.
#[test]
fn tracks_follow_the_poses() {
    let folder = tempfile::tempdir().unwrap();
    let patches = |height: f64| {
        let mut poses = String::from("frame,t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg\n");
        for frame in 0..3 {
            std::fs::write(folder.path().join(format!("{frame}.png")), "not looked at").unwrap();
            poses += &format!("{frame},{frame},{},20,{height},0,0,0\n", 100 + 2 * frame);
        }
        std::fs::write(folder.path().join("poses.csv"), poses).unwrap();
        let camera = || Ok::<_, AugmentError>(Camera::of_field([50.0, 30.0]).unwrap());
        let sequence = Sequence::read(folder.path(), &folder.path().join("poses.csv"), camera).unwrap();
        tracks_along(&sequence, &USUAL_TRACKS, &Vehicle::default(), &flat()).unwrap()
    };
    let laid = patches(1.6334);
    // 4 m of way, a patch every 0.24 m from the first 0.12 m on, under two wheels.
    assert_eq!(laid.len(), 2 * 17);
    let Vehicle { wheelbase, track, .. } = Vehicle::default();
    for (patch, side) in laid.iter().zip([-1.0, 1.0]) {
        let [x, y] = [0, 1].map(|axis| patch.corners.iter().map(|corner| corner[axis]).sum::<f64>() / 4.0);
        assert!(
            (x - (100.0 - 0.5 * wheelbase + 0.06)).abs() < 1e-9
                && (y - (20.0 + 0.5 * side * track)).abs() < 1e-9
        );
        assert!(patch.laid > 0.0 && patch.laid < 0.2, "{}", patch.laid);
    }
    assert_eq!(patches(40.0), []);
}
