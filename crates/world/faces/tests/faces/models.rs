//! Face models of files and of bodies.

use std::path::PathBuf;
use std::sync::Arc;

use faces::{BodyFaces, BodyTriangle, Face, Loaded, Mesh, Model, ModelShading, Shading, Sides, Vertex};
use glam::{DMat3, DVec3};
use solids::{Body, Kind, Solid};

use crate::near;

const TENT: &str = "\
v 1 0 0 1 0.5 0
v -1 0 0 1 0.5 0
v -1 2 0 1 0.5 0
v 1 2 0 1 0.5 0
v 1 1 1 1 0.5 0
vn 0 0 1
vn 0 0 0
f 1//1 4//1 5//1
f 4 3 5
f 3//2 2//2 5//2
";

struct File {
    _folder: tempfile::TempDir,
    path: PathBuf,
}

fn file(text: &str) -> File {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("tent.obj");
    std::fs::write(&path, text).expect("a file");
    File { _folder: folder, path }
}

fn read(text: &str, shading: ModelShading) -> Result<Model, String> {
    Model::read(&file(text).path, "tent", shading, 1000).map_err(|error| error.to_string())
}

#[test]
fn an_obj_with_normals_and_colours() {
    let Loaded { mesh, kept, .. } = read(TENT, ModelShading::AsWritten).expect("a model").loaded;
    assert_eq!(kept, [Some(0), Some(1), Some(2)]);
    // Vertices 1, 4 and 5 stand once with and once without the normal.
    assert_eq!(mesh.vertices().len(), 3 + 3 + 1);
    let shading: Vec<Shading> = mesh.faces().iter().map(|face| face.shading).collect();
    assert_eq!(shading, [Shading::Smooth, Shading::Flat, Shading::Flat]);
    near(mesh.faces()[0].colour[1], 0.4);
    // x forward, y to port: the second corner of the file is aft, 2 m to port is -2 to starboard.
    assert_eq!(mesh.places(&mesh.faces()[1])[1], DVec3::new(-1.0, -2.0, 0.0));
    // Counter-clockwise from outside: the port side looks to port and up.
    assert!(mesh.normals()[1].y < 0.0 && mesh.normals()[1].z > 0.0, "{}", mesh.normals()[1]);
}

#[test]
fn shading_can_be_chosen() {
    for (shading, expected) in [(ModelShading::Smooth, Shading::Smooth), (ModelShading::Flat, Shading::Flat)]
    {
        let mesh = read(TENT, shading).expect("a model").loaded.mesh;
        assert!(mesh.faces().iter().all(|face| face.shading == expected));
    }
}

#[test]
fn faults_of_a_file_have_their_line() {
    let none = read(&TENT.replace("v -1 2 0", "v -1 nan 0"), ModelShading::AsWritten).expect_err("no number");
    assert!(none.contains("tent.obj:3:6"), "{none}");
    let uneven = TENT.replace("f 4 3 5\n", "f 1 4 5 2\n");
    let found = read(&uneven, ModelShading::Flat).expect_err("not plane");
    assert!(found.contains("face 1: vertex") && found.contains("tent.obj:9:1"), "{found}");
    assert!(read("v 0 0 0\n", ModelShading::Flat).expect_err("no faces").contains("no faces"));
    let few = Model::read(&file(TENT).path, "tent", ModelShading::Flat, 2).expect_err("too many").to_string();
    assert!(
        few.contains("list `tent` has 3 faces: expected 2 or fewer") && few.contains("tent.obj"),
        "{few}"
    );
    let missing =
        Model::read(&PathBuf::from("none.obj"), "tent", ModelShading::Flat, 9).expect_err("no file");
    assert!(missing.to_string().contains("none.obj"), "{missing}");
}

fn body(solid: Solid) -> Body {
    let turn = DMat3::from_cols(DVec3::Y, -DVec3::X, DVec3::Z);
    Body::place(1, Kind::Rock, &Arc::new(solid), DVec3::new(10.0, 20.0, 0.0), &turn, 2.0)
}

/// Triangles of a body with the normals at their corners.
fn triangles(body: &Body, shading: ModelShading) -> Vec<(BodyTriangle, [DVec3; 3])> {
    let faces = BodyFaces::new("body", body).expect("finite places");
    let normals = faces.normals(shading);
    faces.triangles().map(|triangle| (triangle, normals.of(&triangle))).collect()
}

fn cube() -> Solid {
    Solid::boxed(-DVec3::ONE, DVec3::ONE, 0.5).expect("a cube")
}

#[test]
fn a_body_is_faceted_or_rounded() {
    let placed = body(cube());
    let faces = BodyFaces::new("cube", &placed).expect("finite places");
    assert_eq!((faces.triangles().count(), faces.vertices(), faces.sides()), (12, 24, Sides::One));
    let middle = DVec3::new(10.0, 20.0, 0.0);
    for (triangle, normals) in triangles(&placed, ModelShading::AsWritten) {
        assert_eq!((normals, faces.colour(&triangle)), ([triangle.normal; 3], [0.5; 3]));
        assert!((triangle.places[0] - middle).dot(triangle.normal) > 0.0);
    }
    for (triangle, normals) in triangles(&placed, ModelShading::Smooth) {
        for (place, normal) in triangle.places.into_iter().zip(normals) {
            assert!(normal.distance((place - middle).normalize()) < 1e-14);
        }
    }
    let leaning = |face: usize| cube().faces()[face].normal + DVec3::new(0.0, 0.1, 0.2);
    let given = body(cube().with_normals(|face, _| Some(leaning(face))));
    for (triangle, normals) in triangles(&given, ModelShading::AsWritten) {
        let (turn, _) = given.to_ground();
        assert!(normals[1].distance(turn * leaning(triangle.face).normalize()) < 1e-14);
    }
    assert!(
        triangles(&given, ModelShading::Flat).iter().all(|(triangle, normals)| normals[0] == triangle.normal)
    );
}

/// The list of faces that a file of the same shape would give has the same normals, to the bit.
#[test]
fn triangles_of_a_body_are_those_of_a_list_of_faces() {
    let rock = |seed: f64| {
        let corners = (0..14).map(|k| {
            let turn = f64::from(k) * (2.4 + 0.01 * seed);
            let up = f64::from(k) / 6.5 - 1.0;
            DVec3::new(libm::cos(turn), libm::sin(turn), up).normalize()
        });
        Solid::hull(&corners.collect::<Vec<_>>(), 0.3).expect("a rock")
    };
    for seed in 0..40 {
        let placed = body(rock(f64::from(seed)));
        let places: Vec<DVec3> = placed.vertices().collect();
        let corners = placed.solid.faces().iter().flat_map(|face| {
            (2..face.corners.len())
                .map(|last| vec![face.corners[0], face.corners[last - 1], face.corners[last]])
        });
        let faces: Vec<Face> = corners.map(|corners| Face::flat(corners, [0.3; 3])).collect();
        let vertices = places.into_iter().map(Vertex::at).collect();
        let Loaded { mesh, .. } = Mesh::load("rock", vertices, faces).expect("a list");
        let found = triangles(&placed, ModelShading::Flat);
        assert!(found.len() > 12 && found.len() == mesh.faces().len());
        for ((triangle, _), (face, normal)) in found.iter().zip(mesh.faces().iter().zip(mesh.normals())) {
            assert_eq!((&triangle.places[..], triangle.normal), (&mesh.places(face)[..], *normal));
        }
    }
}

#[test]
fn an_open_surface_is_seen_from_both_sides() {
    let places = vec![DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::new(1.0, 1.0, 0.0)];
    let sail = body(Solid::open(places, vec![(vec![0, 1, 3, 2], 0.7)]).expect("a sail"));
    assert_eq!(BodyFaces::new("sail", &sail).expect("finite places").sides(), Sides::Both);
    let found = triangles(&sail, ModelShading::AsWritten);
    assert_eq!(found.len(), 2);
    assert!(found.iter().all(|(triangle, _)| triangle.normal.distance(DVec3::Z) < 1e-15));
}

#[test]
fn a_body_without_a_place_is_refused() {
    let turn = DMat3::IDENTITY;
    let lost = Body::place(1, Kind::Rock, &Arc::new(cube()), DVec3::new(0.0, f64::NAN, 0.0), &turn, 1.0);
    let error = BodyFaces::new("lost", &lost).expect_err("no number").to_string();
    assert!(error.contains("lost"), "{error}");
}
