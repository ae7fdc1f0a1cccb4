//! The faces that a judge draws by area are those that sampling points see.

use crate::shots::{Shot, level_ground};
use generator::PlaneKind;
use raster::Pattern;

/// Red light of all pixels by area.
fn by_area(shot: &Shot) -> Vec<f64> {
    let faces = shot.session().faces(0, &shot.pose).unwrap().unwrap();
    let size = [shot.view.columns, shot.view.lines].map(|pixels| pixels as usize);
    face_areas::draw(&faces, size).into_iter().map(|colour| colour[0]).collect()
}

/// The polygon that stands for a disc has the disc's area.
#[test]
fn a_lamp_has_its_own_light_by_area() {
    let mut shot = Shot::new(24, 24, 400.0);
    let at = [12.3, 9.6];
    shot.effects.lights = vec![shot.lamp(0, at, 100.0 / shot.eye().ray(at).length(), 1.0)];
    let sum: f64 = by_area(&shot).into_iter().sum();
    let expected = std::f64::consts::PI * 4.0;
    assert!((sum / expected - 1.0).abs() < 1e-9, "{sum}, not {expected}");
}

/// Ground, a pane and a wall: thirty-two sampling points are near the areas, and one is less near.
#[test]
fn more_sampling_points_come_nearer_to_the_areas() {
    let mut shot = Shot::new(40, 32, 60.0);
    shot.ground = level_ground(crate::shots::HOME, 0.5);
    let pane = shot.sheet(0, &[[3.2, 2.1], [30.7, 5.4], [12.6, 28.9]], 5.0, [0.9; 3], 0.4);
    let wall = shot.sheet(1, &[[18.3, 9.8], [37.1, 14.2], [25.5, 30.6]], 3.0, [0.2; 3], 0.0);
    shot.effects.sheets = vec![pane, wall];
    let areas = by_area(&shot);
    let off = |pattern: Pattern| {
        let mut shot = shot.clone();
        shot.run.sampling.pattern = pattern;
        let drawn = shot.draw();
        let pairs = drawn.plane(PlaneKind::Red).iter().zip(&areas);
        pairs.map(|(drawn, area)| (f64::from(*drawn) - area).abs()).sum::<f64>() / areas.len() as f64
    };
    let [one, many] = [Pattern::One, Pattern::Lattice32].map(off);
    assert!(many < 1e-3 && many < 0.2 * one, "{one} {many}");
}
