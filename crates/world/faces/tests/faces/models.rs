//! Face models of files and of bodies.

use std::path::PathBuf;
use std::sync::Arc;

use faces::{Loaded, Model, ModelShading, Shading, Sides, of_body};
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

#[test]
fn a_body_is_faceted_or_rounded() {
    let cube = || Solid::boxed(-DVec3::ONE, DVec3::ONE, 0.5).expect("a cube");
    let placed = body(cube());
    let flat = of_body("cube", &placed, ModelShading::AsWritten).expect("faces").mesh;
    assert_eq!((flat.faces().len(), flat.vertices().len()), (12, 24));
    let middle = DVec3::new(10.0, 20.0, 0.0);
    for (face, normal) in flat.faces().iter().zip(flat.normals()) {
        assert_eq!((face.shading, face.sides, face.colour), (Shading::Flat, Sides::One, [0.5; 3]));
        assert!((flat.places(face)[0] - middle).dot(*normal) > 0.0);
    }
    let round = of_body("cube", &placed, ModelShading::Smooth).expect("faces").mesh;
    for vertex in round.vertices() {
        let expected = (vertex.place - middle).normalize();
        assert!(vertex.normal.expect("an average").distance(expected) < 1e-14);
    }
    let given =
        body(cube().with_normals(|face, _| Some(cube().faces()[face].normal + DVec3::new(0.0, 0.1, 0.2))));
    let smooth = of_body("cube", &given, ModelShading::AsWritten).expect("faces").mesh;
    assert!(smooth.faces().iter().all(|face| face.shading == Shading::Smooth));
}

#[test]
fn an_open_surface_is_seen_from_both_sides() {
    let places = vec![DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::new(1.0, 1.0, 0.0)];
    let sail = Solid::open(places, vec![(vec![0, 1, 3, 2], 0.7)]).expect("a sail");
    let mesh = of_body("sail", &body(sail), ModelShading::AsWritten).expect("faces").mesh;
    assert!(mesh.faces().len() == 2 && mesh.faces().iter().all(|face| face.sides == Sides::Both));
    assert!(mesh.normals().iter().all(|normal| normal.distance(DVec3::Z) < 1e-15));
}
