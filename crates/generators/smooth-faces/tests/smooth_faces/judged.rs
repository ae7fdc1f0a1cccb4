//! The faces that a judge draws by area are those of the scan lines.

use faces::{Detail, Interpolation, Order, Pattern, Scan, SeaState};
use generator::{FaceScene, PlaneKind, Planes};
use glam::DVec3;
use scenario::FaceList;
use signal::Probe;
use smooth_faces::Parameters;

use crate::shots::{PIXELS, draw, from_above, pose, run, sea, sea_list, session, square, stage};

fn by_depth() -> Parameters {
    Parameters { order: Order::Depth, ..run() }
}

/// A sea, and a square above it that hides a part.
fn lists() -> Vec<FaceList> {
    let above = square("above", DVec3::new(150.0, 100.0, 6.0), 25.0, 2, [0.9, 0.4, 0.2]);
    vec![sea_list(&sea(SeaState::High, Pattern::Random { seed: 5 })), above]
}

/// Least distance (pixels) of a place from the border of a face to the inside; negative outside.
fn inside(corners: &[[f64; 2]], [x, y]: [f64; 2]) -> f64 {
    let edges = (0..corners.len()).map(|k| [corners[k], corners[(k + 1) % corners.len()]]);
    let side = edges.map(|[[ax, ay], [bx, by]]| {
        let [right, down] = [bx - ax, by - ay];
        (right * (y - ay) - down * (x - ax)) / (right * right + down * down).sqrt()
    });
    let sides: Vec<f64> = side.collect();
    let turned = sides.iter().map(|side| -side).fold(f64::INFINITY, f64::min);
    sides.iter().copied().fold(f64::INFINITY, f64::min).max(turned)
}

/// Red light of the nearest face at a place on the screen, and how near it is (1/m); `None` next to a border.
fn nearest(scene: &FaceScene, at: [f64; 2]) -> Option<[f64; 2]> {
    let mut nearest: Option<(f64, usize)> = None;
    for (number, face) in scene.faces.iter().enumerate() {
        let depth = inside(&face.corners, at);
        if depth.abs() < 1e-6 {
            return None;
        }
        let q = face.nearness(at);
        if depth > 0.0 && nearest.is_none_or(|(first, _)| q > first * (1.0 + scene.coincidence)) {
            nearest = Some((q, number));
        }
    }
    Some(nearest.map_or([0.0; 2], |(q, number)| [(scene.looks)(number, at).light[0], q]))
}

/// On a screen of more scan lines than are held at a time, in either direction of the scan.
#[test]
fn every_pixel_shows_the_nearest_face_of_the_judge() {
    for (interpolation, scan, [columns, lines]) in [
        (Interpolation::Screen, Scan::Vertical, [150, 60]),
        (Interpolation::Perspective, Scan::Vertical, [150, 60]),
        (Interpolation::Screen, Scan::Horizontal, [60, 150]),
    ] {
        let mut stage = stage(lists());
        (stage.view.columns, stage.view.lines) = (columns as u32, lines as u32);
        let session = session(stage, Parameters { interpolation, scan, ..by_depth() });
        for pose in [from_above(), pose([20.0, 60.0, 15.0], 25.0, -12.0)] {
            let scene = session.faces(0, &pose).unwrap().unwrap();
            let mut planes = Planes::new(columns, lines, &[PlaneKind::Red, PlaneKind::Distance]);
            session.frame(0, &pose, &mut planes, &mut Probe::off()).unwrap();
            let mut compared = 0;
            let [red, distance] = [PlaneKind::Red, PlaneKind::Distance].map(|kind| planes.get(kind).unwrap());
            for pixel in 0..columns * lines {
                let place = [pixel % columns, pixel / columns].map(|place| place as f64 + 0.5);
                let Some([light, q]) = nearest(&scene, place) else { continue };
                let drawn = f64::from(red[pixel]);
                assert!((drawn - light).abs() < 1e-6, "pixel {pixel}: {drawn}, not {light}");
                // The field has a tangent of 0.5 on either side.
                let aside = [place[0] / columns as f64 - 0.5, place[1] / lines as f64 - 0.5];
                let ray = (1.0 + aside[0] * aside[0] + aside[1] * aside[1]).sqrt();
                let near = ray / f64::from(distance[pixel]);
                assert!((near - q).abs() <= 1e-6 * near, "pixel {pixel}: {near} 1/m, not {q}");
                compared += usize::from(light > 0.0);
            }
            assert!(compared > columns * lines / 4, "{compared} pixels of faces");
        }
    }
}

/// A corner has the brightness that the faces about it have there.
#[test]
fn corners_have_the_light_beside_them() {
    let session = session(stage(lists()), by_depth());
    let scene = session.faces(0, &from_above()).unwrap().unwrap();
    for (number, face) in scene.faces.iter().enumerate() {
        let middle = [0, 1].map(|axis| {
            face.corners.iter().map(|corner| corner[axis]).sum::<f64>() / face.corners.len() as f64
        });
        for corner in &face.corners {
            let beside = [0, 1].map(|axis| corner[axis] + 1e-4 * (middle[axis] - corner[axis]));
            let [at, near] = [*corner, beside].map(|place| (scene.looks)(number, place).light[0]);
            assert!((at - near).abs() < 1e-3, "face {number}: {at} at a corner, {near} beside it");
        }
    }
}

/// Samples and areas have the same mean light over a whole picture.
#[test]
fn light_by_area_has_the_mean_of_the_samples() {
    let session = session(stage(lists()), by_depth());
    let scene = session.faces(0, &from_above()).unwrap().unwrap();
    let mean = |light: &[f32]| light.iter().map(|&light| f64::from(light)).sum::<f64>() / light.len() as f64;
    let (planes, _) = draw(&*session, 0, &from_above());
    let areas = face_areas::draw(&scene, [PIXELS; 2]);
    let by_area = areas.iter().map(|colour| colour[0]).sum::<f64>() / areas.len() as f64;
    let sampled = mean(planes.get(PlaneKind::Red).unwrap());
    assert!(by_area > 0.1 && (by_area / sampled - 1.0).abs() < 0.01, "{by_area}, samples {sampled}");
}

/// Lists that hide what is nearer are no faces, nor is a level laid upon them.
#[test]
fn lists_and_levels_are_no_faces() {
    assert!(session(stage(lists()), run()).faces(0, &from_above()).unwrap().is_none());
    let mut laid = lists();
    laid[1].group = laid[1].group.clone().detailed(Detail::Add);
    assert!(session(stage(laid), by_depth()).faces(0, &from_above()).unwrap().is_none());
}
