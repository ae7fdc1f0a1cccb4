//! One shape in every format, and what each format may say wrongly.

mod gltf;
mod made;
mod obj;
mod ply;
mod stl;

use made::{data, glb, gltf, ply, read, refused, rows, stl, stl_text, the_box};

#[test]
fn a_box_is_the_same_solid_in_every_format() {
    let codings = ["ascii", "binary_little_endian", "binary_big_endian"];
    let plys = codings.map(|coding| ("box.ply", ply(coding, &rows())));
    let others = [
        ("box.stl", stl("made by hand", [0; 2])),
        ("box.stl", stl("solid by its first word", [0; 2])),
        ("box.STL", stl_text().into_bytes()),
        ("box.stl", stl_text().to_uppercase().replace('\n', "\r\n").into_bytes()),
        ("box.gltf", gltf(&data()).to_string().into_bytes()),
        ("box.glb", glb(gltf(""))),
    ];
    for (name, bytes) in plys.into_iter().chain(others) {
        let shape = read(name, &bytes).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(shape.solids, [the_box()], "{name}: {}", String::from_utf8_lossy(&bytes[..60]));
        assert_eq!(shape.notes.len(), usize::from(name.ends_with(['l', 'L'])), "{:?}", shape.notes);
    }
}

#[test]
fn endings_and_contents_must_agree() {
    for (name, bytes, said) in [
        ("a.obj", ply("ascii", &rows()), "named as Wavefront OBJ, but its first bytes are those of PLY"),
        ("a.stl", glb(gltf("")), "rename it to end in .glb"),
        ("a.gltf", glb(gltf("")), "named as glTF, but its first bytes are those of binary glTF"),
        ("a.ply", stl_text().into_bytes(), "those of STL"),
        ("a.fbx", vec![], "the ending `fbx` is no format of shapes"),
        ("box", vec![], "the ending `` is no format of shapes"),
        ("a.glb", vec![], "binary glTF of 0 bytes"),
        ("a.stl", vec![], "0 bytes: binary STL"),
        ("a.ply", vec![], "the header does not end"),
        ("a.obj", vec![], "no faces, so no solid"),
    ] {
        let found = refused(name, bytes);
        assert!(found.contains(said), "{said}: {found}");
    }
}
