//! Paths between their waypoints.

use proptest::prelude::*;
use quantities::{degrees, radians};
use scenario::{Path, PathError, Waypoint};

fn waypoint(time: f64, x: f64, y: f64, heading_deg: Option<f64>) -> Waypoint {
    let heading = heading_deg.map(radians);
    Waypoint { time, at: [x, y], heading, eye_height: None, pitch: None, roll: None }
}

fn heading_deg(path: &Path, time: f64) -> f64 {
    degrees(path.at(time).heading)
}

#[test]
fn two_waypoints_are_a_straight_drive() {
    let path = Path::new(vec![waypoint(0.0, 0.0, 0.0, None), waypoint(2.0, 6.0, 8.0, None)]).unwrap();
    let half = path.at(1.0);
    assert_eq!((half.at, half.velocity), ([3.0, 4.0], [3.0, 4.0]));
    assert!((half.heading - libm::atan2(4.0, 3.0)).abs() < 1e-15);
    let after = path.at(9.0);
    assert_eq!((after.at, after.velocity, after.heading), ([6.0, 8.0], [0.0, 0.0], half.heading));
    assert_eq!(path.at(-1.0).at, [0.0, 0.0]);
}

#[test]
fn headings_take_the_shortest_way_around() {
    let path =
        Path::new(vec![waypoint(0.0, 0.0, 0.0, Some(350.0)), waypoint(2.0, 1.0, 0.0, Some(20.0))]).unwrap();
    assert!((heading_deg(&path, 1.0) - 5.0).abs() < 1e-9);
    let back =
        Path::new(vec![waypoint(0.0, 0.0, 0.0, Some(10.0)), waypoint(2.0, 1.0, 0.0, Some(-20.0))]).unwrap();
    assert!((heading_deg(&back, 1.0) - 355.0).abs() < 1e-9);
}

#[test]
fn a_heading_left_open_joins_the_direction_of_travel() {
    let path = Path::new(vec![
        waypoint(0.0, 0.0, 0.0, None),
        waypoint(1.0, 10.0, 0.0, None),
        waypoint(2.0, 20.0, 0.0, Some(90.0)),
    ])
    .unwrap();
    assert!(heading_deg(&path, 0.5).abs() < 1e-9);
    let turning = heading_deg(&path, 1.5);
    assert!((1.0..89.0).contains(&turning), "{turning}");
    assert!((heading_deg(&path, 2.0) - 90.0).abs() < 1e-9);
}

#[test]
fn a_halt_keeps_the_heading() {
    let path = Path::new(vec![
        waypoint(0.0, 0.0, 0.0, None),
        waypoint(1.0, 0.0, 5.0, None),
        waypoint(2.0, 0.0, 5.0, None),
        waypoint(3.0, -5.0, 5.0, None),
    ])
    .unwrap();
    assert!((heading_deg(&path, 0.9) - 90.0).abs() < 1e-6);
    assert!((heading_deg(&path, 1.5) - 90.0).abs() < 1e-6);
    assert!((heading_deg(&path, 2.5) - 180.0).abs() < 1e-6);
    assert_eq!(path.at(1.5).velocity, [0.0, 0.0]);
}

#[test]
fn a_vehicle_that_never_moves_looks_north() {
    let path = Path::new(vec![waypoint(0.0, 5.0, 5.0, None)]).unwrap();
    assert_eq!((path.at(3.0).at, path.at(3.0).heading), ([5.0, 5.0], 0.0));
    let still = Path::new(vec![waypoint(0.0, 5.0, 5.0, None), waypoint(1.0, 5.0, 5.0, None)]).unwrap();
    assert_eq!(still.at(0.5).heading, 0.0);
}

#[test]
fn what_is_no_path_is_refused() {
    assert_eq!(Path::new(vec![]), Err(PathError::Empty));
    let nan = Path::new(vec![waypoint(0.0, f64::NAN, 0.0, None)]);
    assert_eq!(nan, Err(PathError::NotFinite { index: 0 }));
    let infinite = Path::new(vec![waypoint(0.0, 0.0, 0.0, Some(f64::INFINITY))]);
    assert_eq!(infinite, Err(PathError::NotFinite { index: 0 }));
    let twice = Path::new(vec![waypoint(1.0, 0.0, 0.0, None), waypoint(1.0, 1.0, 0.0, None)]);
    assert_eq!(twice, Err(PathError::Time { index: 1, time: 1.0, before: 1.0 }));
    let high = Waypoint { eye_height: Some(3.0), ..waypoint(0.0, 0.0, 0.0, None) };
    let partly = Path::new(vec![high, waypoint(1.0, 0.0, 0.0, None)]);
    assert_eq!(partly, Err(PathError::Partly { what: "z_m" }));
}

proptest! {
    #[test]
    fn position_is_smooth_and_passes_all_waypoints(
        steps in prop::collection::vec((0.5..5.0f64, -20.0..20.0f64, -20.0..20.0f64), 1..8),
    ) {
        let mut time = 0.0;
        let list: Vec<Waypoint> = steps
            .iter()
            .map(|&(step, x, y)| { time += step; waypoint(time, x, y, None) })
            .collect();
        let path = Path::new(list.clone()).unwrap();
        for w in &list {
            let station = path.at(w.time);
            prop_assert!((0..2).all(|axis| (station.at[axis] - w.at[axis]).abs() < 1e-12));
            prop_assert!((0.0..7.0).contains(&station.heading));
        }
        for pair in list.windows(3) {
            let (before, after) = (path.at(pair[1].time - 1e-9), path.at(pair[1].time));
            prop_assert!((0..2).all(|axis| (before.velocity[axis] - after.velocity[axis]).abs() < 1e-5));
        }
    }
}
