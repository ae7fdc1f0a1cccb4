//! Tables of control points: read, and refused by line and column.

use std::fs;

use photo_check::{Control, Ground, read_points};
use quantities::radians;
use survey::{Affine, Elevation, Frame};

use crate::{elevation, from_above, ground, over_the_moon};

fn read(text: &str, ground: &Ground) -> Result<Vec<Control>, String> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("points.csv");
    fs::write(&path, text).expect("written");
    read_points(&path, ground).map_err(|problems| problems.render(false))
}

fn plane() -> Ground {
    ground(&elevation([11, 11], |north, east| 5.0 + 0.1 * north + 0.2 * east), &from_above())
}

fn moon() -> Ground {
    let affine = Affine { first: [radians(0.01), radians(-0.01)], step: [radians(-0.001), radians(0.001)] };
    let frame = Frame::Geographic { radius: 1_737_400.0 };
    ground(&Elevation::new(21, 21, vec![40.0; 441], affine, frame), &over_the_moon())
}

#[test]
fn places_in_metres_take_the_height_of_the_grid_where_they_have_none() {
    let text = "name,east_m,north_m,height_m,i_px,j_px\nrim,30,40,7.5,10.5,20.25\n,35,45,,1,2\n";
    let found = read(text, &plane()).expect("points");
    assert_eq!((found[0].name.as_str(), found[1].name.as_str()), ("rim", "2"));
    assert_eq!(found[0].point.ground.to_array(), [30.0, 40.0, 7.5]);
    assert_eq!(found[0].point.pixel, [10.5, 20.25]);
    assert!((found[1].point.ground.z - (5.0 + 4.5 + 7.0)).abs() < 1e-12);
}

#[test]
fn places_in_degrees_are_read_by_the_one_grammar() {
    let text = "latitude;longitude;i_px;j_px\n0:00:18 N;0:00:18 W;50;50\n0,005;-0,005;50;50\n";
    let found = read(text, &moon()).expect("points");
    let [first, second] = [0, 1].map(|at| found[at].point.ground);
    assert!((first - second).length() < 1e-6 && (first.length() - 1_737_440.0).abs() < 1e-6, "{first}");
}

#[test]
fn what_is_no_table_of_points_is_refused_by_line() {
    let (plane, moon) = (plane(), moon());
    for (ground, text, told) in [
        (&plane, "east_m,north_m,i_px\n1,2,3\n", "`j_px`"),
        (&plane, "east_m,i_px,j_px\n1,2,3\n", "`north_m`"),
        (&plane, "latitude,longitude,i_px,j_px\n1,2,3,4\n", "`east_m`"),
        (&plane, "east_m,north_m,i_px,j_px\n1,2,3,x\n", "points.csv:2"),
        (&plane, "east_m,north_m,i_px,j_px\n1,200,3,4\n", "where the elevation grid has none"),
        (&plane, "east_m,north_m,i_px,j_px,z\n1,2,3,4,5\n", "`z`"),
        (&plane, "east_m,north_m,i_px,j_px\n", "without rows"),
        (&moon, "east_m,north_m,i_px,j_px\n1,2,3,4\n", "`latitude`"),
        (&moon, "latitude,longitude,i_px,j_px\n-0:00:18 N,0,3,4\n", "a sign stands in degrees"),
        (&moon, "latitude,longitude,i_px,j_px\n91,0,3,4\n", "`latitude` must be a number from -90 to 90"),
        (&moon, "latitude,longitude,i_px,j_px\n91:00:00 N,0,3,4\n", "out of range"),
    ] {
        let said = read(text, ground).expect_err(told);
        assert!(said.contains(told), "{told}: {said}");
    }
}
