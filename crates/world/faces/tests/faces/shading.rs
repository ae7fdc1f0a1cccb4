//! Normals at corners and their brightness (check values 8.1).

use faces::{CornerNormals, Cut, Face, Mesh, Shading, Weights, brightness, lit, sun_vector};
use glam::DVec3;
use quantities::radians;

use crate::{WHITE, near, smooth, vertices};

/// A roof of two squares that meet at the edge from vertex 0 to vertex 1, with normals (1, 0, 1) and (0, 1, 1) over sqrt 2.
fn roof() -> Mesh {
    // The ridge runs along the cross product of both normals: (-1, -1, 1).
    let places = [
        [0.0, 0.0, 0.0],
        [1.0, 1.0, -1.0],
        [1.0, -1.0, -1.0],
        [2.0, 0.0, -2.0],
        [-1.0, 1.0, -1.0],
        [0.0, 2.0, -2.0],
    ];
    smooth(&places, &[&[0, 1, 3, 2], &[0, 4, 5, 1]])
}

#[test]
fn normals_of_faces_point_to_the_side_of_counter_clockwise_corners() {
    // Seen from above with north up and east to the right, these corners run east, then north: counter-clockwise.
    let up = smooth(&[[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0]], &[&[0, 1, 2, 3]]);
    assert_eq!(up.normals(), [DVec3::Z]);
    assert!(up.is_plane(0));
}

#[test]
fn average_of_two_normals_and_its_brightness() {
    let mesh = roof();
    let half = 0.5_f64.sqrt();
    for (found, expected) in mesh.normals().iter().zip([[half, 0.0, half], [0.0, half, half]]) {
        assert!(found.distance(DVec3::from_array(expected)) < 1e-15, "{found}");
    }
    let normals = CornerNormals::new(&mesh, Weights::Equal);
    let ridge = normals.of_face(0)[0];
    assert!(
        ridge.distance(DVec3::new(0.408248290463863, 0.408248290463863, 0.816496580927726)) < 1e-14,
        "{ridge}"
    );
    near(brightness(ridge, sun_vector(0.0, radians(30.0))), 0.761801681057137);
    // Off the ridge each corner has the normal of its own face.
    assert!(normals.of_face(0)[2].distance(mesh.normals()[0]) < 1e-15);
    assert_eq!(normals.knife_edges(), 0);
    let raw = (mesh.normals()[0] + mesh.normals()[1]) / 2.0;
    near(brightness(raw, sun_vector(0.0, radians(30.0))), 0.659739608441171);
}

#[test]
fn weights_by_angle_ignore_how_a_side_is_cut() {
    // A corner of a cube; one of its three sides is cut in two triangles.
    let places = [
        [0.0; 3],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [1.0, 1.0, 0.0],
        [1.0, 0.0, 1.0],
        [0.0, 1.0, 1.0],
    ];
    let whole = smooth(&places, &[&[0, 1, 4, 2], &[0, 3, 5, 1], &[0, 2, 6, 3]]);
    let cut = smooth(&places, &[&[0, 1, 4], &[0, 4, 2], &[0, 3, 5, 1], &[0, 2, 6, 3]]);
    let at_corner = |mesh: &Mesh, weights| CornerNormals::new(mesh, weights).of_face(0)[0];
    let diagonal = at_corner(&whole, Weights::Equal);
    assert!((diagonal.abs() - DVec3::splat(1.0 / 3.0_f64.sqrt())).length() < 1e-15);
    assert!(at_corner(&cut, Weights::Angle).distance(diagonal) < 1e-15);
    assert!(at_corner(&cut, Weights::Equal).distance(diagonal) > 0.1);
}

#[test]
fn a_knife_edge_falls_back_to_the_face_and_is_counted() {
    let places = [[0.0; 3], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
    let mesh = smooth(&places, &[&[0, 1, 2], &[2, 1, 0]]);
    let normals = CornerNormals::new(&mesh, Weights::Equal);
    assert_eq!(normals.knife_edges(), 3);
    assert!(normals.of_face(0).iter().all(|&normal| normal == DVec3::Z));
    assert!(normals.of_face(1).iter().all(|&normal| normal == -DVec3::Z));
}

#[test]
fn given_normals_stand_and_flat_faces_keep_their_own() {
    let mut given = vertices(&[[0.0; 3], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]);
    given[1].normal = Some(DVec3::new(0.0, 3.0, 4.0));
    let faces = |shading| vec![Face { shading, ..Face::smooth(vec![0, 1, 2], WHITE) }];
    let normal = |shading| {
        let mesh = Mesh::load("test", given.clone(), faces(shading)).expect("a face").mesh;
        CornerNormals::new(&mesh, Weights::Equal).of_face(0)[1]
    };
    assert!(normal(Shading::Smooth).distance(DVec3::new(0.0, 0.6, 0.8)) < 1e-15);
    assert_eq!(normal(Shading::Flat), DVec3::Z);
}

#[test]
fn light_from_everywhere_takes_its_part_and_the_sun_behind_gives_none() {
    assert_eq!(lit([1.0, 0.5, 0.0], 0.2, 0.25), [0.4, 0.2, 0.0]);
    assert_eq!(brightness(DVec3::Z, sun_vector(1.0, -0.5)), 0.0);
}

#[test]
fn fans_begin_at_the_first_corner() {
    assert_eq!(Cut::Fan.pieces(5), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    assert_eq!(Cut::Uncut.pieces(4), [[0, 1, 2, 3]]);
}
