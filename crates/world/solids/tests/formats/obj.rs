//! OBJ as programs write it.

use std::fmt::Write as _;

use crate::made::{CORNERS, SIDES, obj, read, refused, the_box};

#[test]
fn obj_as_programs_write_it() {
    let text = obj();
    let joined = text.replacen("f 1 4 3", "f 1 \\\n4 3", 1);
    let old = text.replace('\n', "\r");
    let marked = format!("\u{feff}{text}");
    let harmless = format!("lod 3\nvp 0 1\nshadow_obj a.obj\ns 1\n# C:\\\n{text}# no line behind\\");
    for text in [joined, old, marked, harmless] {
        assert_eq!(read("a.obj", text).unwrap().solids, [the_box()]);
    }
    let latin1 = [b"# bo\xeete\ng cr\xe9\xe9\n", text.as_bytes()].concat();
    assert_eq!(read("a.obj", latin1).unwrap().solids, [the_box()]);
    let wide: Vec<u8> = "\u{feff}v 0".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert!(refused("a.obj", wide).contains("the text is UTF-16"));
    let materials = read("a.obj", format!("mtllib a.mtl\n{text}")).unwrap();
    assert_eq!(
        materials.notes,
        [
            "a.obj: materials are not read, their colours are lost (mtllib): give `colour`, or colours of vertices"
        ]
    );
    for face in ["f", "f 1", "f 1 2"] {
        let said = refused(
            "a.obj",
            format!("{text}v 9 9 9\nv 8 8 8\n{}\n", face.replace('1', "-1").replace('2', "-2")),
        );
        assert!(said.contains("a.obj:23:1") && said.contains("no solid"), "{said}");
    }
    for (statement, why) in [
        ("l 1 2", "delete loose edges"),
        ("curv 0 1 1 2", "curves and free surfaces are not drawn"),
        ("csh rm", "other files and commands are never followed"),
        ("bzp 1", "patches of old files"),
    ] {
        let said = refused("a.obj", format!("{text}{statement}\n"));
        assert!(said.contains("is not read") && said.contains(why), "{said}");
    }
}

/// Groups that are open singly and closed together are one shape; those that close are shapes by themselves.
#[test]
fn groups_for_each_face_are_one_shape() {
    let mut grouped = String::new();
    for (number, line) in obj().lines().enumerate() {
        let group = if line.starts_with('f') {
            format!("g side-{number}\nusemtl m{number}\n")
        } else {
            String::new()
        };
        writeln!(grouped, "{group}{line}").unwrap();
    }
    assert_eq!(read("a.obj", &grouped).unwrap().solids, [the_box()]);
    let second: String = CORNERS.iter().map(|[x, y, z]| format!("v {x} {y} {}\n", z + 0.25)).collect();
    let faces: String = SIDES.iter().map(|[a, b, c]| format!("f {} {} {}\n", a + 9, b + 9, c + 9)).collect();
    // The second box stands on the first: they share corners, and stay two.
    assert_eq!(read("a.obj", format!("o one\n{}o two\n{second}{faces}", obj())).unwrap().solids.len(), 2);
    let without = grouped.replace("f 1 4 3\n", "");
    assert!(refused("a.obj", without).contains("not closed"), "a hole");
}
