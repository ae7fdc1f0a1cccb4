//! Posts without a height.

use sight::{Curvature, Point, Sight};

use crate::posts;

#[test]
fn a_line_across_a_void_is_unknown_and_one_beside_it_is_seen() {
    let holed = posts([7, 21], 1.0, |row, column| if (row, column) == (3, 10) { f64::NAN } else { 0.0 });
    let eye = Point::above_ground([-3.0, 0.0], 1.0);
    let seen = holed.viewshed(&eye, 0.0, Curvature::FLAT).unwrap();
    let of = |row: usize, column: usize| seen[row * 21 + column];
    assert_eq!(
        (of(3, 10), of(3, 9), of(3, 11), of(3, 20)),
        (Sight::Unknown, Sight::Visible, Sight::Unknown, Sight::Unknown)
    );
    assert_eq!((of(0, 20), of(6, 20), of(4, 20)), (Sight::Visible, Sight::Visible, Sight::Unknown));
    let least = holed.least_heights(&eye, Curvature::FLAT).unwrap();
    assert!(least.iter().zip(&seen).all(|(least, &sight)| least.is_nan() == (sight == Sight::Unknown)));
}

#[test]
fn a_line_along_the_side_of_a_void_is_known() {
    let holed = posts([7, 21], 1.0, |row, column| if (row, column) == (3, 10) { f64::NAN } else { 0.0 });
    for row in [2.0, 4.0] {
        let [eye, target] = [0.0, 20.0].map(|east| Point::above_ground([-row, east], 1.0));
        let line = holed.line_of_sight(&eye, &target, Curvature::FLAT).unwrap();
        assert_eq!((line.sight, line.least_height), (Sight::Visible, Some(0.0)));
    }
}

#[test]
fn ground_before_or_behind_a_void_hides_all_the_same() {
    let height = |_, column| match column {
        5 => 4.0,
        10 => f64::NAN,
        _ => 0.0,
    };
    let holed = posts([3, 21], 1.0, height);
    for [from, to] in [[0.0, 20.0], [20.0, 0.0]] {
        let [eye, target] = [from, to].map(|east| Point::above_ground([-1.0, east], 1.0));
        let line = holed.line_of_sight(&eye, &target, Curvature::FLAT).unwrap();
        assert_eq!((line.sight, line.least_height), (Sight::Hidden, None));
    }
}

#[test]
fn a_line_far_above_a_void_is_unknown() {
    let holed = posts([65, 65], 1.0, |row, column| if (row, column) == (30, 40) { f64::NAN } else { 0.0 });
    let [eye, target] = [0.0, 64.0].map(|east| Point::above_datum([-30.2, east], 1e5));
    let line = holed.line_of_sight(&eye, &target, Curvature::FLAT).unwrap();
    assert_eq!(line.sight, Sight::Unknown);
}
