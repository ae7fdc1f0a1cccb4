//! Faces of a file as they stand, without solids.

use glam::DVec3;
use solids::shape_files::{Surface, parse_surface, read_surface};

const OPEN: &str = "\
v 0 0 0 1 0 0
v 2 0 0 1 0 0
v 2 1 0 1 0 0
v 0 1 0.5 1 0 0
vn 0 0 1
vn 0 1 0
g one
f 1//1 2//1 3//2
g two
f 1 3 4
";

fn surface(text: &str) -> Result<Surface, String> {
    parse_surface("sail.obj", text.as_bytes()).map_err(|error| error.to_string())
}

#[test]
fn faces_of_all_parts_with_normals_colours_and_lines() {
    let found = surface(OPEN).expect("a surface");
    assert_eq!(found.places[3], DVec3::new(0.0, -1.0, 0.5));
    assert_eq!(found.normals, [DVec3::Z, DVec3::NEG_Y]);
    let [one, two] = &found.faces[..] else { panic!("two faces") };
    assert_eq!(one.corners, [(0, Some(0)), (1, Some(0)), (2, Some(1))]);
    assert_eq!(two.corners, [(0, None), (2, None), (3, None)]);
    assert_eq!((one.colour, two.place.as_ref().expect("a place").line()), ([1.0, 0.0, 0.0], 10));
}

#[test]
fn faults_of_a_surface_have_their_line() {
    let none = surface(&OPEN.replace("v 2 1 0", "v inf 1 0")).expect_err("no length");
    assert!(none.contains("sail.obj:3:3") && none.contains("finite"), "{none}");
    let missing = surface(&OPEN.replace("f 1 3 4", "f 1 3 9")).expect_err("no vertex");
    assert!(missing.contains("sail.obj:10") && missing.contains("names no vertex"), "{missing}");
    assert!(surface("v 0 0 0\n").expect_err("no faces").contains("no faces"));
    let gone = read_surface("no-such-sail.obj").expect_err("no file").to_string();
    assert!(gone.contains("no-such-sail.obj"), "{gone}");
}
