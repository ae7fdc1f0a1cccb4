//! The faces that a judge draws by area are those of the scan lines.

use faces::{Detail, Interpolation, Order, Pattern, SeaState};
use generator::{FaceScene, PlaneKind};
use glam::DVec3;
use scenario::FaceList;
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

/// Red light of the nearest face at the middle of a pixel; `None` next to a border.
fn nearest(scene: &FaceScene, pixel: usize) -> Option<f64> {
    let at = [pixel % PIXELS, pixel / PIXELS].map(|place| place as f64 + 0.5);
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
    Some(nearest.map_or(0.0, |(_, number)| (scene.looks)(number, at).light[0]))
}

#[test]
fn every_pixel_shows_the_nearest_face_of_the_judge() {
    for interpolation in [Interpolation::Screen, Interpolation::Perspective] {
        let session = session(stage(lists()), Parameters { interpolation, ..by_depth() });
        for pose in [from_above(), pose([20.0, 60.0, 15.0], 25.0, -12.0)] {
            let scene = session.faces(0, &pose).unwrap().unwrap();
            let (planes, _) = draw(&*session, 0, &pose);
            let red = planes.get(PlaneKind::Red).unwrap();
            let mut compared = 0;
            for (pixel, &drawn) in red.iter().enumerate() {
                let Some(expected) = nearest(&scene, pixel) else { continue };
                assert!((f64::from(drawn) - expected).abs() < 1e-6, "pixel {pixel}: {drawn}, not {expected}");
                compared += usize::from(expected > 0.0);
            }
            assert!(compared > PIXELS * PIXELS / 4, "{compared} pixels of faces");
        }
    }
}

/// Over a whole picture the mean of the samples is that of the areas.
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
