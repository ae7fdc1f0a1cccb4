//! Brightness along scan lines (check values 8.2, acceptance test 6).

use faces::{Cut, Interpolation, Ramp, Scan, ScreenCorner, in_space, screen_error};
use proptest::prelude::*;

use crate::near;

fn corner(x: f64, y: f64, brightness: f64) -> ScreenCorner {
    ScreenCorner { at: [x, y], depth: 1.0, brightness }
}

fn triangle() -> [ScreenCorner; 3] {
    [corner(100.0, 50.0, 0.2), corner(180.0, 210.0, 0.9), corner(40.0, 170.0, 0.5)]
}

fn ramp(corners: &[ScreenCorner], scan: Scan, line: f64) -> Ramp {
    Ramp::of(corners, scan, line, Interpolation::Screen).expect("a line that meets the face")
}

#[test]
fn a_triangle_is_the_same_in_both_directions() {
    let across = ramp(&triangle(), Scan::Horizontal, 120.0);
    for (end, (at, brightness)) in across.ends.iter().zip([(65.0, 0.375), (135.0, 0.50625)]) {
        near(end.at, at);
        near(end.brightness, brightness);
    }
    let down = ramp(&triangle(), Scan::Vertical, 100.0);
    near(down.ends[0].at, 50.0);
    near(down.ends[1].at, 1310.0 / 7.0);
    near(down.ends[1].brightness, 0.47 / 0.7);
    near(across.at(100.0), 0.440625);
    near(down.at(120.0), 0.440625);
    near(across.slope(), (0.50625 - 0.375) / 70.0);
}

/// A square on its corner with brightness 0 left and right, 1 at the top and the bottom.
fn diamond() -> [ScreenCorner; 4] {
    [corner(-1.0, 0.0, 0.0), corner(0.0, -1.0, 1.0), corner(1.0, 0.0, 0.0), corner(0.0, 1.0, 1.0)]
}

#[test]
fn an_uncut_square_depends_on_the_direction_and_a_cut_one_does_not() {
    near(ramp(&diamond(), Scan::Horizontal, 0.0).at(0.0), 0.0);
    near(ramp(&diamond(), Scan::Vertical, 0.0).at(0.0), 1.0);
    let mut compared = 0;
    for piece in Cut::Fan.pieces(4) {
        let corners: Vec<ScreenCorner> = piece.iter().map(|&k| diamond()[k]).collect();
        for (x, y) in (-9..10).flat_map(|x| (-9..10).map(move |y| (f64::from(x) / 10.0, f64::from(y) / 10.0)))
        {
            let lines = [(Scan::Horizontal, y, x), (Scan::Vertical, x, y)];
            let at = lines.map(|(scan, line, place)| {
                let ramp = Ramp::of(&corners, scan, line, Interpolation::Screen)?;
                (ramp.ends[0].at < place && place < ramp.ends[1].at).then(|| ramp.at(place))
            });
            if let [Some(across), Some(down)] = at {
                near(across, down);
                compared += 1;
            }
        }
    }
    assert!(compared > 100, "{compared} places inside");
}

#[test]
fn space_and_screen_part_with_depth() {
    near(in_space(0.5, [10.0, 30.0]), 0.25);
    let edge = [
        ScreenCorner { depth: 10.0, ..corner(0.0, 0.0, 0.0) },
        ScreenCorner { depth: 30.0, ..corner(8.0, 0.0, 1.0) },
        ScreenCorner { depth: 30.0, ..corner(8.0, 8.0, 1.0) },
    ];
    let at = |interpolation| Ramp::of(&edge, Scan::Horizontal, 0.0, interpolation).expect("an edge").at(4.0);
    near(at(Interpolation::Screen), 0.5);
    near(at(Interpolation::Perspective), 0.25);
    let inside =
        |interpolation| Ramp::of(&edge, Scan::Horizontal, 2.0, interpolation).expect("a line").at(4.0);
    near(inside(Interpolation::Perspective), 0.25);
    near(inside(Interpolation::Screen), 0.5);
}

#[test]
fn largest_error_of_the_screen_is_the_largest_there_is() {
    for (ratio, shown) in [(2.0, 0.172), (3.0, 0.268), (10.0, 0.519)] {
        let error = |k: i32| f64::from(k) / 1000.0 - in_space(f64::from(k) / 1000.0, [1.0, ratio]);
        let largest = (0..=1000).map(error).fold(0.0, f64::max);
        assert!((screen_error(ratio) - largest).abs() < 1e-5, "{ratio}: {largest}");
        assert!((screen_error(ratio) - shown).abs() < 6e-4, "{ratio}");
    }
}

#[test]
fn lines_beside_a_face_and_edges_without_length() {
    assert_eq!(Ramp::of(&triangle(), Scan::Vertical, 181.0, Interpolation::Screen), None);
    assert_eq!(Ramp::of(&[], Scan::Vertical, 0.0, Interpolation::Screen), None);
    // Only the corner at the right is met: the ramp has no length, and nothing is divided by it.
    let point = ramp(&triangle(), Scan::Vertical, 180.0);
    assert_eq!((point.at(210.0), point.slope()), (0.9, 0.0));
    let outside = ramp(&triangle(), Scan::Horizontal, 120.0);
    assert_eq!(
        (outside.at(0.0), outside.at(500.0)),
        (outside.ends[0].brightness, outside.ends[1].brightness)
    );
}

proptest! {
    /// Inside a cut face both directions give the plane through the brightness of the corners.
    #[test]
    fn any_triangle_is_a_plane(
        places in prop::array::uniform6(-100.0..100.0_f64),
        light in prop::array::uniform3(0.0..1.0_f64),
        shares in prop::array::uniform3(0.05..1.0_f64),
    ) {
        let corners = [0, 1, 2].map(|k| corner(places[2 * k], places[2 * k + 1], light[k]));
        let [a, b, c] = corners.map(|corner| corner.at);
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        prop_assume!(area.abs() > 10.0);
        let whole: f64 = shares.iter().sum();
        let mean = |of: [f64; 3]| (0..3).map(|k| of[k] * shares[k] / whole).sum::<f64>();
        let [x, y] = [mean([a[0], b[0], c[0]]), mean([a[1], b[1], c[1]])];
        let expected = mean(light);
        for (scan, line, place) in [(Scan::Vertical, x, y), (Scan::Horizontal, y, x)] {
            let found = ramp(&corners, scan, line).at(place);
            prop_assert!((found - expected).abs() < 1e-9, "{scan:?}: {found} instead of {expected}");
        }
    }
}
