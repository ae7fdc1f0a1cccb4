//! Voids: filled, counted, and known to the end.

use landscape::Sun;
use photo_camera::voids::{Border, Fill, Wishes};
use photo_check::{GroundError, Relief, Report, fill_voids};
use survey::Elevation;

use crate::{elevation, filled, from_above};

/// A sloping plane of 12 x 12 posts with a hole of 3 x 2 inside and one of 2 x 1 at the edge.
fn holes() -> Elevation {
    elevation([12, 12], |north, east| {
        let inside = (40.0..=60.0).contains(&north) && (30.0..=40.0).contains(&east);
        let edge = north == 110.0 && east < 15.0;
        if inside || edge { f64::NAN } else { 100.0 + 0.3 * north - 0.2 * east }
    })
}

#[test]
fn a_plane_comes_back_and_the_mask_stays() {
    let ground = filled(&holes(), &from_above(), Fill::Harmonic);
    assert_eq!(Report::voids_of(&ground.filling), [8, 2, 6, 2]);
    // Line 6 is north 50, column 3 is east 30.
    assert!(ground.was_void([6, 3]) && !ground.was_void([6, 5]));
    assert!((ground.height([6, 3]).expect("filled") - (100.0 + 15.0 - 6.0)).abs() < 1e-9);
    assert_eq!(ground.height([0, 0]), None);
    assert_eq!(ground.points().count(), 142);
    let mask = ground.mask().expect("a picture");
    assert_eq!((mask.code(3, 6), mask.code(5, 6), mask.code(0, 0)), (255, 0, 255));
    let sun = Sun { azimuth: 1.0, elevation: 0.8 };
    let relief = Relief::new(&ground, &sun);
    let plane = sun.reflectivity([0.3, -0.2]);
    assert!((relief.light([6, 3]).expect("filled") - plane).abs() < 1e-9);
    assert_eq!(relief.light([0, 0]), None);
}

#[test]
fn the_other_ways_differ_and_leave_leaves() {
    let height = |fill| filled(&holes(), &from_above(), fill).height([6, 3]);
    let truth = 109.0;
    assert_eq!(height(Fill::Leave), None);
    let mean = height(Fill::WrittenMean).expect("filled");
    assert!(mean.fract() == 0.0 && (mean - truth).abs() > 0.5, "{mean}");
    for fill in [Fill::Nearest, Fill::InverseDistance] {
        assert!((height(fill).expect("filled") - truth).abs() < 5.0);
    }
}

#[test]
fn a_large_hole_is_refused_unless_it_is_allowed() {
    let made = elevation([12, 12], |north, east| {
        let inside = (20.0..=90.0).contains(&north) && (20.0..=90.0).contains(&east);
        if inside { f64::NAN } else { north }
    });
    let refused = fill_voids(&made, Wishes::default()).expect_err("a large hole");
    assert!(
        matches!(refused, GroundError::Voids(_)) && refused.to_string().contains("64 of 144"),
        "{refused}"
    );
    let allowed = Wishes { allow_large_holes: true, border: Border::Filled, ..Wishes::default() };
    assert_eq!(fill_voids(&made, allowed).expect("allowed").still_void, 0);
}

/// The Moon is higher than the Earth: a grid without voids keeps heights that no fill would take.
#[test]
fn heights_without_voids_are_taken_as_they_are() {
    let high = fill_voids(&elevation([3, 3], |_, _| 10_700.0), Wishes::default()).expect("a grid");
    assert_eq!((high.heights[4], high.holes), (10_700.0, 0));
}
