//! Faces that are refused, left out, or accepted at the limit (section 9).

use faces::{Face, FaceError, Mesh, Shading, Vertex};
use glam::DVec3;

use crate::{WHITE, vertices};

const SQUARE: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0]];

fn refusal(vertices: Vec<Vertex>, face: Face) -> FaceError {
    Mesh::load("hull", vertices, vec![face]).expect_err("a face that is refused")
}

fn refused(places: &[[f64; 3]], corners: &[u32]) -> FaceError {
    refusal(vertices(places), Face::smooth(corners.to_vec(), WHITE))
}

#[test]
fn numbers_that_are_none() {
    let mut places = vertices(&SQUARE);
    places[2].place.y = f64::NAN;
    let message = refusal(places, Face::smooth(vec![0, 1, 2], WHITE)).to_string();
    assert_eq!(
        message,
        "list `hull`, vertex 2: a coordinate is not finite: expected three finite numbers (m)"
    );
    for none in [DVec3::ZERO, DVec3::NAN, DVec3::INFINITY] {
        let mut places = vertices(&SQUARE);
        places[1].normal = Some(none);
        let found = refusal(places, Face::smooth(vec![0, 1, 2], WHITE));
        assert_eq!(found, FaceError::Normal { list: "hull".into(), vertex: 1 });
    }
    for colour in [[1.5, 0.0, 0.0], [0.0, -0.1, 0.0], [0.0, 0.0, f64::NAN]] {
        let found = refusal(vertices(&SQUARE), Face::smooth(vec![0, 1, 2], colour));
        assert!(found.to_string().contains("a colour is "), "{found}");
    }
}

#[test]
fn corners_that_are_too_few_or_missing() {
    assert_eq!(refused(&SQUARE, &[0, 1]), FaceError::Corners { list: "hull".into(), face: 0, found: 2 });
    let missing = FaceError::NoVertex { list: "hull".into(), face: 0, vertex: 4, vertices: 4 };
    assert_eq!(refused(&SQUARE, &[0, 1, 4]), missing);
}

#[test]
fn an_uneven_face_is_refused_flat_and_cut_smooth() {
    let raised = |up: f64| {
        let mut places = SQUARE;
        places[2][2] = up;
        places
    };
    let load = |up: f64, shading| {
        let face = Face { shading, ..Face::smooth(vec![0, 1, 2, 3], WHITE) };
        Mesh::load("hull", vertices(&raised(up)), vec![face])
    };
    assert!(matches!(load(0.1, Shading::Flat), Err(FaceError::NotPlane { face: 0, .. })));
    assert!(!load(0.1, Shading::Smooth).expect("a smooth face").mesh.is_plane(0));
    // A quarter of the height of one corner is the distance of all four from the plane of best fit.
    let bound = 4.0 * Mesh::PLANE * 2.0_f64.sqrt();
    assert!(load(0.9 * bound, Shading::Flat).expect("a plane face").mesh.is_plane(0));
    assert!(load(1.1 * bound, Shading::Flat).is_err());
}

#[test]
fn a_face_that_turns_back_names_the_corner() {
    let arrow = [[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.5, 0.5, 0.0], [2.0, 0.0, 0.0]];
    assert_eq!(
        refused(&arrow, &[0, 1, 2, 3]),
        FaceError::NotConvex { list: "hull".into(), face: 0, vertex: 2 }
    );
    // A star of five corners turns to the left everywhere, but twice around.
    let star: Vec<[f64; 3]> = (0..5)
        .map(|k| {
            let (sin, cos) = libm::sincos(f64::from(k) * 0.8 * std::f64::consts::PI);
            [sin, cos, 0.0]
        })
        .collect();
    assert!(matches!(refused(&star, &[0, 1, 2, 3, 4]), FaceError::NotConvex { .. }));
    // Three corners on one line are convex.
    let straight = [[0.0; 3], [0.0, 1.0, 0.0], [0.0, 2.0, 0.0], [1.0, 0.0, 0.0]];
    let face = Face::flat(vec![0, 1, 2, 3], WHITE);
    assert!(Mesh::load("hull", vertices(&straight), vec![face]).is_ok());
}

#[test]
fn faces_without_area_are_left_out_by_name() {
    let places = [[0.0; 3], [0.0, 1.0, 0.0], [0.0, 2.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let corners = [vec![0, 1, 2], vec![0, 1, 3], vec![0, 1, 4, 3], vec![0, 1, 1, 3]];
    let faces = corners.map(|corners| Face::smooth(corners, WHITE)).into();
    let loaded = Mesh::load("hull", vertices(&places), faces).expect("faces of which some are left out");
    assert_eq!(loaded.kept, [None, Some(0), None, None]);
    let told: Vec<String> = loaded.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        told,
        [
            "list `hull`, face 0: no area; the face is left out",
            "list `hull`, face 2: two corners at one place; the face is left out",
            "list `hull`, face 3: two corners at one place; the face is left out",
        ]
    );
}

#[test]
fn a_million_faces_are_refused_before_they_are_looked_at() {
    let faces = vec![Face::smooth(Vec::new(), WHITE); Mesh::MOST_FACES + 1];
    let found = Mesh::load("hull", Vec::new(), faces).expect_err("too many faces").to_string();
    assert_eq!(
        found,
        "list `hull` has 200001 faces: expected 200000 or fewer; raise `faces.limit`, or use a coarser model"
    );
    let two = vec![Face::smooth(vec![0, 1, 2], WHITE); 2];
    assert!(Mesh::limited("hull", vertices(&SQUARE), two.clone(), 1).is_err());
    assert!(Mesh::limited("hull", vertices(&SQUARE), two, 2).is_ok());
}
