//! Bad input: one clear error each.

use sight::{Curvature, Point, Posts, SightError};

use crate::posts;

fn message(error: SightError) -> String {
    error.to_string()
}

#[test]
fn meshes_that_are_none_are_refused() {
    let refused = |size, corner, spacing, heights: Vec<f64>| {
        message(Posts::new(size, corner, spacing, heights).unwrap_err())
    };
    let origin = [0.0, 0.0];
    assert!(refused([2, 2], origin, 1.0, vec![0.0; 5]).contains("5 heights for 2 rows of 2 posts"));
    assert!(refused([1, 5], origin, 1.0, vec![0.0; 5]).contains("2 rows and columns or more"));
    assert!(refused([usize::MAX, 2], origin, 1.0, vec![]).contains("0 heights"));
    assert!(
        refused([2, 2], origin, 1.0, vec![0.0, 0.0, f64::INFINITY, 0.0])
            .contains("(row 1, column 0) is inf m")
    );
    for spacing in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(refused([2, 2], origin, spacing, vec![0.0; 4]).contains("spacing of the posts (m) is"));
    }
    assert!(refused([2, 2], [f64::NAN, 0.0], 1.0, vec![0.0; 4]).contains("north-western post (m) is NaN"));
}

#[test]
fn levels_that_leave_posts_out_are_refused() {
    let ground = posts([9, 13], 1.0, |_, _| 0.0);
    assert!(ground.level(2).is_ok());
    assert!(message(ground.level(3).unwrap_err()).contains("level 3 takes every 8th of 9 x 13 posts"));
    assert!(ground.level(200).is_err());
}

#[test]
fn points_without_ground_or_below_it_are_refused() {
    let ground = posts([4, 4], 1.0, |row, _| if row == 3 { f64::NAN } else { 5.0 });
    let sight = |point: Point| {
        let other = Point::above_datum([0.0, 0.0], 50.0);
        message(ground.line_of_sight(&point, &other, Curvature::FLAT).unwrap_err())
    };
    assert!(sight(Point::above_ground([7.0, 1.0], 2.0)).contains("no ground at (7, 1) m"));
    assert!(sight(Point::above_ground([-2.5, 1.5], 2.0)).contains("no ground"));
    assert!(sight(Point::above_datum([-1.0, 1.0], 4.0)).contains("lies 1 m below the ground"));
    for height in [-0.1, f64::NAN, f64::INFINITY, 1e8] {
        assert!(sight(Point::above_ground([-1.0, 1.0], height)).contains("height above the ground (m) is"));
    }
    assert!(sight(Point::above_datum([-1.0, 1.0], f64::NAN)).contains("height above the datum (m) is NaN"));
    assert!(sight(Point::above_datum([f64::NAN, 1.0], 9.0)).contains("place of a point (m) is NaN"));
}

#[test]
fn bodies_and_targets_out_of_range_are_refused() {
    for (radius, refraction) in [(0.0, 0.0), (f64::NAN, 0.0), (1e6, 1.0), (1e6, -0.1), (1e6, f64::NAN)] {
        assert!(Curvature::parabolic(radius, refraction).is_err());
    }
    let ground = posts([4, 4], 1.0, |_, _| 0.0);
    let eye = Point::above_ground([-1.0, 1.0], 1.0);
    for height in [-1.0, f64::NAN, f64::INFINITY] {
        let error = ground.viewshed(&eye, height, Curvature::FLAT).unwrap_err();
        assert!(message(error).contains("height of the targets (m) is"));
    }
}

#[test]
fn a_target_at_the_observer_is_seen() {
    let ground = posts([4, 4], 1.0, |_, _| 3.0);
    let eye = Point::above_ground([-1.0, 1.0], 1.0);
    let line = ground.line_of_sight(&eye, &eye, Curvature::FLAT).unwrap();
    assert_eq!((line.sight, line.distance, line.clearance), (sight::Sight::Visible, 0.0, 1.0));
}
