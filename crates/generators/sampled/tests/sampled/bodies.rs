//! Bodies on the screen.

use std::sync::Arc;

use crate::shots::Shot;
use generator::{Label, PlaneKind};
use glam::{DMat3, DVec3};
use landscape::Photometry;
use quantities::radians;
use scenario::Standing;
use solids::{Body, Kind, Solid};

/// A box of 2 m that is seen at a place on the screen (pixels) in a depth (m).
fn boxed(shot: &Shot, at: [f64; 2], depth: f64) -> Standing {
    let solid = Arc::new(Solid::boxed(DVec3::splat(-1.0), DVec3::splat(1.0), 1.0).unwrap());
    let turn = DMat3::from_rotation_z(0.6);
    let body = Body::place(0, Kind::Culture, &solid, shot.eye().place(at, depth), &turn, 1.0);
    Standing { from: 0.0, until: f64::INFINITY, body }
}

/// Pixels of the box: first and last column, first and last line.
fn found(shot: &Shot) -> Option<[[f64; 2]; 2]> {
    let pixels = shot.draw().labelled(Label::Culture);
    let columns = shot.view.columns as usize;
    let range = |along: &dyn Fn(usize) -> usize| {
        let along = pixels.iter().map(|index| along(*index));
        Some([along.clone().min()? as f64, along.max()? as f64 + 1.0])
    };
    Some([range(&|index| index % columns)?, range(&|index| index / columns)?])
}

/// The same by projecting the corners, cut at the borders of the screen.
fn expected(shot: &Shot) -> [[f64; 2]; 2] {
    let eye = shot.eye();
    let corners: Vec<[f64; 2]> = shot.standing[0].body.vertices().map(|at| eye.project(at)).collect();
    let size = [shot.view.columns, shot.view.lines].map(f64::from);
    [0, 1].map(|axis| {
        let along = corners.iter().map(|corner| corner[axis].clamp(0.0, size[axis]));
        [along.clone().fold(f64::INFINITY, f64::min), along.fold(0.0, f64::max)]
    })
}

fn check(shot: &Shot) {
    let (found, expected) = (found(shot), expected(shot));
    let found = found.unwrap_or_else(|| panic!("nothing is seen: {expected:?}"));
    for (found, expected) in found.as_flattened().iter().zip(expected.as_flattened()) {
        assert!((found - expected).abs() < 1.0, "{found}, not {expected}");
    }
}

#[test]
fn corners_are_where_the_camera_projects_them() {
    let mut shot = Shot::new(60, 40, 80.0);
    (shot.pose.attitude.pitch, shot.pose.attitude.heading) = (radians(-6.0), radians(200.0));
    shot.pose.yoke = radians(-14.0);
    shot.pose.eye[2] = 30.0;
    for at in [[30.0, 20.0], [5.0, 8.0], [58.0, 38.0], [-2.0, 20.0], [61.0, 41.0]] {
        shot.standing = vec![boxed(&shot, at, 20.0)];
        check(&shot);
    }
}

/// Where pixels are not square, lengths along one axis of the camera are not those of the scene.
#[test]
fn a_body_at_the_border_is_seen_when_pixels_are_not_square() {
    for stretch in [0.2, 1.0, 6.0] {
        let mut shot = Shot::new(60, 60, 60.0);
        shot.pose.eye[2] = 100.0;
        shot.view.field.tan_half_height = 0.5 / stretch;
        for at in [[30.0, 60.0 + 2.5 * stretch], [30.0, -2.5 * stretch], [62.5, 30.0]] {
            shot.standing = vec![boxed(&shot, at, 20.0)];
            check(&shot);
        }
    }
}

/// A box far away, so that all of it mirrors the sun alike.
#[test]
fn a_box_returns_light_by_a_law_of_its_own() {
    let mut shot = Shot::new(60, 40, 400.0);
    shot.pose.attitude.heading = radians(320.0);
    shot.pose.eye[2] = 30.0;
    // A side that looks to 124.4 degrees mirrors this sun to the eye, which is at 140.
    shot.sun.azimuth = radians(108.8);
    let gloss = Photometry::Specular { strength: 2.0, exponent: 3 };
    let to_sun = DVec3::from_array(shot.sun.direction());
    let mut light = |law| {
        let mut standing = boxed(&shot, [30.0, 20.0], 60.0);
        let solid = Solid::boxed(DVec3::splat(-1.0), DVec3::splat(1.0), 0.2).unwrap().reflecting(law);
        standing.body = standing.body.shaped(&Arc::new(solid));
        shot.standing = vec![standing];
        let (frame, body) = (shot.draw(), &shot.standing[0].body);
        let (planes, pixels) = (&frame.planes, frame.labelled(Label::Culture));
        let picture = planes.get(PlaneKind::Intensity).unwrap();
        let most = pixels.iter().map(|pixel| picture[*pixel]).fold(0.0, f32::max);
        let to_eye = (DVec3::from_array(shot.pose.eye) - body.centre).normalize();
        let of_face = |normal: DVec3| {
            let lambert = normal.dot(to_sun).max(0.0);
            let mirrored = (2.0 * normal.dot(to_sun) * normal - to_sun).dot(to_eye).max(0.0);
            let shine = if law == gloss { 2.0 * mirrored * mirrored * mirrored } else { 0.0 };
            if normal.dot(to_eye) > 0.0 { 0.2 * lambert * (1.0 + shine) } else { 0.0 }
        };
        (f64::from(most), body.normals().map(of_face).fold(0.0, f64::max))
    };
    let [plain, shining] = [light(Photometry::Lambert), light(gloss)];
    assert!(plain.0 > 0.1 && (plain.0 - plain.1).abs() < 1e-6, "{plain:?}");
    assert!((shining.0 / shining.1 - 1.0).abs() < 0.1 && shining.0 > 1.2 * plain.0, "{plain:?} {shining:?}");
}
