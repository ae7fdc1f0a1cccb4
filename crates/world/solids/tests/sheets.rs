//! Open shapes: seen from both sides, from files too.

use std::sync::Arc;

use glam::{DMat3, DVec3};
use solids::shape_files::{self, Openness};
use solids::{Body, Kind, Solid, SolidError};

/// 2 m x 4 m, upright across the way forward, foot in the middle of its lower edge.
fn sheet() -> Solid {
    let places = [[0.0, -1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 1.0, 4.0], [0.0, -1.0, 4.0]];
    Solid::open(places.map(DVec3::from_array).to_vec(), vec![(vec![0, 1, 2, 3], 0.5)]).unwrap()
}

#[test]
fn a_sheet_is_met_from_both_sides_and_not_beside_it() {
    assert!(sheet().is_open() && sheet().edge_words().is_empty());
    let quarter = DMat3::from_cols(DVec3::Y, -DVec3::X, DVec3::Z);
    let foot = DVec3::new(10.0, 20.0, 1.0);
    let body = Body::place(0, Kind::Culture, &Arc::new(sheet()), foot, &quarter, 2.0);
    for side in [-1.0, 1.0] {
        let from = |north: f64, up: f64| DVec3::new(10.0 + north, 20.0 + 5.0 * side, 1.0 + up);
        let hit = |north, up| body.first_hit(from(north, up), -side * DVec3::Y, 0.0);
        assert_eq!(hit(1.9, 7.9).map(|hit| (hit.distance, hit.face)), Some((5.0, 0)));
        for (north, up) in [(2.1, 4.0), (-2.1, 4.0), (0.0, -0.1), (0.0, 8.1)] {
            assert!(hit(north, up).is_none(), "{north} {up}");
        }
        // Away from it, and along it.
        assert!(body.first_hit(from(0.0, 1.0), side * DVec3::Y, 0.0).is_none());
        assert!(body.first_hit(foot - 9.0 * DVec3::X + DVec3::Z, DVec3::X, 0.0).is_none());
    }
}

#[test]
fn a_sheet_needs_a_face_and_an_area() {
    let line = Solid::open(vec![DVec3::ZERO, DVec3::X, 2.0 * DVec3::X], vec![(vec![0, 1, 2], 0.5)]);
    assert!(matches!(line, Err(SolidError::BadFace { face: 0, .. })));
    assert!(matches!(Solid::open(vec![DVec3::ZERO; 3], vec![]), Err(SolidError::TooSmall { .. })));
}

fn parse(text: &str, openness: Openness) -> Result<Vec<Solid>, diagnostics::ProblemList> {
    shape_files::parse("a.obj", text.as_bytes(), openness).map(|shape| shape.solids)
}

const SHEET: &str = "v 0 1 0 1 0.5 0\nv 0 -1 0 1 0.5 0\nv 0 -1 4 1 0.5 0\nv 0 1 4 1 0.5 0\nf 1 2 3 4\n";

#[test]
fn an_open_file_is_a_sheet_only_where_that_is_asked() {
    let refused = parse(SHEET, Openness::Closed).unwrap_err().to_string();
    assert!(refused.contains("no solid"), "{refused}");
    let [found] = &parse(SHEET, Openness::Any).unwrap()[..] else { panic!("one part") };
    assert!(found.is_open());
    assert_eq!(found.albedo(0), [0.8, 0.4, 0.0]);
    // A part that closes is a solid all the same.
    let cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 1 3 4\n";
    assert!(!parse(cube, Openness::Any).unwrap()[0].is_open());
}

#[test]
fn normals_of_a_file_make_light_smooth() {
    let vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    let normals = "vn -1 -1 -1\nvn 1 -0.1 -0.1\nvn -0.1 1 -0.1\nvn -0.1 -0.1 1\n";
    let faces = "f 1//1 2//2 3//3\nf 1//1 2//2 4//4\nf 2//2 3//3 4//4\nf 1//1 3//3 4//4\n";
    let [found] = &parse(&format!("{vertices}{normals}{faces}"), Openness::Closed).unwrap()[..] else {
        panic!("one part")
    };
    assert!(found.is_smooth());
    let corner = found.normal_at(0, DVec3::ZERO);
    // Starboard is -y of the file.
    assert!(corner.distance(DVec3::new(-1.0, 1.0, -1.0).normalize()) < 1e-15, "{corner}");
    let wrong = format!("{vertices}{normals}{}", faces.replace("3//3", "3//9"));
    let wrong = parse(&wrong, Openness::Closed).unwrap_err().to_string();
    assert!(wrong.contains("3//9 names no normal: 4 stand above"), "{wrong}");
    let colour =
        parse(&format!("{}f 1 2 3\n", vertices.replace("0 0 1\n", "0 0 1 9 0 0\n")), Openness::Closed);
    assert!(colour.unwrap_err().to_string().contains("a channel of a colour must be 0 to 1, not 9"));
}

/// What exporters write: no length of 1, normals of no direction, corners without one, and one on the wrong side.
#[test]
fn odd_normals_of_a_file_leave_the_light_of_its_faces() {
    let vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    let faces = "f 1//1 2//1 3//1\nf 1//1 2 4//1\nf 2/ 3// 4\nf 1 3 4\n";
    for normal in ["0 0 0", "nan nan nan", "0 0 1", "1 0 0", "0 0 -9"] {
        let text = format!("{vertices}vn {normal}\n{faces}");
        let [found] = &parse(&text, Openness::Closed).unwrap()[..] else { panic!("{normal}: one part") };
        for (number, face) in found.faces().iter().enumerate() {
            for &corner in &face.corners {
                let place = found.vertices()[corner as usize];
                let own = found.normal_at(number, place);
                assert!(own.is_normalized() && own.dot(face.normal) > 0.0, "{normal}: {own}");
            }
        }
    }
    let rounded = "vn -0.0002 0 -0.9999\nvn 0 0 -7\n";
    let flat = format!("{vertices}{rounded}f 1//1 2//2 3//1\nf 1 2 4\nf 2 3 4\nf 1 3 4\n");
    assert!(!parse(&flat, Openness::Closed).unwrap()[0].is_smooth());
}
