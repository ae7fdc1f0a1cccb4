//! One shape in every format, and what each format may say wrongly.

use std::fmt::Write as _;

use diagnostics::ProblemList;
use serde_json::{Value, json};
use solids::Solid;
use solids::shape_files::{self, ALBEDO, Openness, Shape};

fn read(name: &str, bytes: impl AsRef<[u8]>) -> Result<Shape, ProblemList> {
    shape_files::parse(name, bytes.as_ref(), Openness::Closed)
}

fn refused(name: &str, bytes: impl AsRef<[u8]>) -> String {
    read(name, bytes).unwrap_err().to_string()
}

/// Corners of a box: forward, port, up (m).
const CORNERS: [[f32; 3]; 8] = [
    [-0.5, -1.0, 0.0],
    [0.5, -1.0, 0.0],
    [0.5, 1.0, 0.0],
    [-0.5, 1.0, 0.0],
    [-0.5, -1.0, 0.25],
    [0.5, -1.0, 0.25],
    [0.5, 1.0, 0.25],
    [-0.5, 1.0, 0.25],
];
/// Its triangles, counter-clockwise seen from outside.
const SIDES: [[usize; 3]; 12] = [
    [0, 3, 2],
    [0, 2, 1],
    [4, 5, 6],
    [4, 6, 7],
    [0, 1, 5],
    [0, 5, 4],
    [1, 2, 6],
    [1, 6, 5],
    [2, 3, 7],
    [2, 7, 6],
    [3, 0, 4],
    [3, 4, 7],
];

fn obj() -> String {
    let mut text = String::new();
    for [x, y, z] in CORNERS {
        writeln!(text, "v {x} {y} {z}").unwrap();
    }
    for [a, b, c] in SIDES {
        writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).unwrap();
    }
    text
}

fn stl(head: &str, attributes: [u8; 2]) -> Vec<u8> {
    let mut bytes = head.as_bytes().to_vec();
    bytes.resize(80, b' ');
    bytes.extend((SIDES.len() as u32).to_le_bytes());
    for side in SIDES {
        let numbers = [f32::NAN; 3].into_iter().chain(side.into_iter().flat_map(|corner| CORNERS[corner]));
        bytes.extend(numbers.flat_map(f32::to_le_bytes).chain(attributes));
    }
    bytes
}

fn stl_text() -> String {
    let mut text = "solid a box\n".to_owned();
    for side in SIDES {
        text += "  facet normal 0 0 0\n    OUTER LOOP\n";
        side.iter().for_each(|&corner| {
            writeln!(
                text,
                "      vertex {:e} {:e} {:e}",
                CORNERS[corner][0], CORNERS[corner][1], CORNERS[corner][2]
            )
            .unwrap()
        });
        text += "    endloop\n  endfacet\n";
    }
    text + "endsolid a box\n"
}

/// Rows of a PLY file: each number with its bytes, the lowest first.
type Row = Vec<(Vec<u8>, f64)>;

const PLY_HEAD: &str = "comment a box\nobj_info made by hand\nelement vertex 8\nproperty double z\nproperty uchar flags\n\
    property float x\nproperty float32 y\nelement face 12\nproperty short id\nproperty list uchar uint vertex_index\nend_header\n";

fn rows() -> Vec<Row> {
    let long = |number: f32| (f64::from(number).to_le_bytes().to_vec(), f64::from(number));
    let short = |number: f32| (number.to_le_bytes().to_vec(), f64::from(number));
    let vertices = CORNERS.map(|[x, y, z]| vec![long(z), (vec![7], 7.0), short(x), short(y)]);
    let faces = SIDES.map(|side| {
        let corners = side.map(|corner| ((corner as u32).to_le_bytes().to_vec(), corner as f64));
        [vec![(vec![1, 0], 1.0), (vec![3], 3.0)], corners.to_vec()].concat()
    });
    vertices.into_iter().chain(faces).collect()
}

fn ply(coding: &str, rows: &[Row]) -> Vec<u8> {
    let mut bytes = format!("ply\nformat {coding} 1.0\n{PLY_HEAD}").into_bytes();
    for row in rows {
        for (word, number) in row {
            match coding {
                "ascii" => bytes.extend(format!("{number} ").bytes()),
                "binary_big_endian" => bytes.extend(word.iter().rev()),
                _ => bytes.extend(word),
            }
        }
        bytes.extend((coding == "ascii").then_some(b'\n'));
    }
    bytes
}

/// Corners by glTF's axes, x to port, y up, z forward, and sides.
fn buffer() -> Vec<u8> {
    let places = CORNERS.into_iter().flat_map(|[forward, port, up]| [port, up, forward]);
    let sides = SIDES.into_iter().flatten().map(|corner| corner as u8);
    places.flat_map(f32::to_le_bytes).chain(sides).collect()
}

/// The box as JSON, its buffer at `uri`.
fn gltf(uri: &str) -> Value {
    json!({
        "asset": {"version": "2.0", "generator": "by hand"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "a box", "mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 0, "_WEAR": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
            {"bufferView": 1, "componentType": 5121, "count": 36, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 96, "target": 34962},
            {"buffer": 0, "byteOffset": 96, "byteLength": 36},
        ],
        "buffers": [{"uri": uri, "byteLength": 132}],
    })
}

const BASE64: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// The buffer in the JSON itself.
fn data() -> String {
    data_of(&buffer())
}

/// Bytes as data in base64; their number is a multiple of three.
fn data_of(bytes: &[u8]) -> String {
    let digits = |three: &[u8]| {
        let word = three.iter().fold(0_u32, |word, &byte| word << 8 | u32::from(byte));
        [18, 12, 6, 0].map(|shift| char::from(BASE64[(word >> shift & 63) as usize]))
    };
    let digits: String = bytes.chunks(3).flat_map(digits).collect();
    format!("data:application/octet-stream;base64,{digits}")
}

fn glb(mut json: Value) -> Vec<u8> {
    json["buffers"] = json!([{"byteLength": 132}]);
    let mut json = json.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let chunk = |kind: &[u8], bytes: &[u8]| [&(bytes.len() as u32).to_le_bytes(), kind, bytes].concat();
    let chunks = [chunk(b"JSON", &json), chunk(b"BIN\0", &buffer())].concat();
    [&b"glTF\x02\0\0\0"[..], &(chunks.len() as u32 + 12).to_le_bytes(), &chunks].concat()
}

/// The same with a value at a path of the JSON.
fn changed(path: &str, value: Value) -> String {
    let mut json = gltf(&data());
    let (above, key) = path.rsplit_once('/').unwrap();
    let above = json.pointer_mut(above).unwrap();
    match key.parse::<usize>() {
        Ok(at) => above[at] = value,
        Err(_) => above[key] = value,
    }
    json.to_string()
}

fn the_box() -> Solid {
    let [solid] = &read("box.obj", obj()).unwrap().solids[..] else { panic!("one part") };
    assert_eq!((solid.vertices().len(), solid.faces().len()), (8, 12));
    solid.clone()
}

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

#[test]
fn stl_that_is_damaged_or_coloured() {
    let whole = stl("", [0; 2]);
    let short = refused("a.stl", &whole[..whole.len() - 1]);
    assert!(short.contains("binary STL with 12 facets has 600 bytes behind its head, not 599"), "{short}");
    assert!(refused("a.stl", [0; 83]).contains("83 bytes: binary STL has a head of 84 bytes"));
    let mut bad = whole;
    bad[84 + 50 + 12..][..4].copy_from_slice(&f32::INFINITY.to_le_bytes());
    let said = refused("a.stl", bad);
    assert!(said.contains("facet 2: a coordinate must be a finite number, not inf"), "{said}");
    let coloured = read("a.stl", stl("", [1, 2])).unwrap();
    assert!(coloured.notes[0].contains("12 facets have a word of attributes"), "{:?}", coloured.notes);
    assert!(
        coloured.notes[1].contains("read as metres, 1.0000 x 2.0000 x 0.2500 m large"),
        "{:?}",
        coloured.notes
    );
    let text = stl_text();
    for (wrong, said) in [
        (text.replacen("vertex", "corner", 1), "statement `corner` is not read"),
        (text.replacen("-5e-1", "nan", 1), "a coordinate must be a finite number, not nan"),
        (text.replacen("  endfacet\n", "", 1), "this facet does not end"),
        (text.replacen("    endloop", "vertex 0 0 0", 1), "a facet of 4 vertices"),
        (format!("{text}vertex 0 0 0"), "a vertex outside a facet"),
        (text.replacen(" -1e0", "", 1), "a vertex of 2 numbers"),
    ] {
        assert!(refused("a.stl", &wrong).contains(said), "{said}: {}", refused("a.stl", &wrong));
    }
    let both = format!("{text}{}", text.replace("2.5e-1", "9e0"));
    assert_eq!(read("a.stl", both).unwrap().solids.len(), 2, "two solids of one file");
}

#[test]
fn ply_with_colours_and_normals() {
    let head =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
    let face = "element face 4\nproperty list uchar int vertex_indices\n";
    let rows = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
    let coded = format!(
        "{head}property uchar red\nproperty uchar green\nproperty uchar blue\n{face}end_header\n\
         0 0 0 255 128 0\n1 0 0 255 128 0\n0 1 0 255 128 0\n0 0 1 255 128 0\n{rows}"
    );
    let solid = &read("a.ply", coded).unwrap().solids[0];
    // The curve of sRGB has 0.21586 at code 128.
    let expected = [ALBEDO, ALBEDO * 0.215_860_5, 0.0];
    assert!(
        solid.albedo(0).iter().zip(expected).all(|(found, own)| (found - own).abs() < 1e-7),
        "{:?}",
        solid.albedo(0)
    );
    let of_faces = format!(
        "{head}{face}property float red\nproperty float green\nproperty float blue\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n{}",
        rows.replace('\n', " 0.5 0 1\n")
    );
    assert_eq!(read("a.ply", of_faces).unwrap().solids[0].albedo(2), [0.5 * ALBEDO, 0.0, ALBEDO]);
    let smooth = format!(
        "{head}property float nx\nproperty float ny\nproperty float nz\n{face}end_header\n\
         0 0 0 -1 -1 -1\n1 0 0 1 -0.1 -0.1\n0 1 0 -0.1 1 -0.1\n0 0 1 -0.1 -0.1 1\n{rows}"
    );
    assert!(read("a.ply", smooth).unwrap().solids[0].is_smooth());
}

#[test]
fn ply_that_is_damaged_or_says_more() {
    let text = String::from_utf8(ply("ascii", &rows())).unwrap();
    for (from, to, said) in [
        ("end_header\n", "", "the header does not end"),
        ("format ascii 1.0", "format ascii 2.0", "this format is not read"),
        ("property uchar flags", "property uchar glow", "property `glow` of element `vertex` is not read"),
        ("property float x", "property half x", "unknown type"),
        ("property float x\n", "", "element `vertex` has no properties x, y and z"),
        ("element face 12", "element tristrips 12", "export faces instead of strips"),
        ("element face 12", "element edge 12", "delete loose edges"),
        ("element face 12", "element vertex 12", "this element stands twice"),
        ("element face 12", "element face 13", "face 13 of 13: the file ends before it"),
        ("element face 12", "element face 11", "bytes are left behind the last element"),
        ("element face 12", "element face 99999999999999999999", "this count is no whole number"),
        (
            "element vertex 8",
            "element void 18446744073709551615\nelement vertex 8",
            "element `void` has no properties",
        ),
        ("1 3 0 3 2", "1 3 0 3 8", "face 1 of 12: corner 8 names no vertex: there are 8, counted from 0"),
        ("1 3 0 3 2", "1 3 0 3 1.5", "corner 1.5 names no vertex"),
        ("1 3 0 3 2", "1 4 0 3 2", "the line is too short"),
        ("1 3 0 3 2", "1 3 0 3 2 2", "the line is too long"),
        ("1 3 0 3 2", "1 -3 0 3 2", "a list of -3 numbers"),
        ("0 7 -0.5 -1", "0 7 inf -1", "vertex 1 of 8: a coordinate is not finite"),
        ("0 7 -0.5 -1", "0 7 x -1", "`x` is no number"),
        (
            "property list uchar uint vertex_index",
            "property uint vertex_index",
            "element `face` has no list of vertices",
        ),
    ] {
        let wrong = text.replacen(from, to, 1);
        assert_ne!(wrong, text, "{from}");
        assert!(refused("a.ply", &wrong).contains(said), "{said}: {}", refused("a.ply", &wrong));
    }
    let whole = ply("binary_big_endian", &rows());
    assert!(refused("a.ply", &whole[..whole.len() - 1]).contains("face 12 of 12: the file ends before it"));
    assert!(refused("a.ply", [&whole[..], &[0]].concat()).contains("1 bytes are left"));
}

#[test]
fn nodes_of_gltf_move_turn_and_mirror() {
    let size = |solid: &Solid| {
        let fold = |ends: [f64; 2], at: f64| [ends[0].min(at), ends[1].max(at)];
        [0, 1, 2].map(|axis| {
            solid.vertices().iter().map(|at| at[axis]).fold([f64::INFINITY, f64::NEG_INFINITY], fold)
        })
    };
    let placed = |node: Value| {
        let shape = read("a.gltf", changed("/nodes/0", node)).unwrap();
        size(&shape.solids[0])
    };
    // Forward, starboard, up.
    assert_eq!(placed(json!({"mesh": 0})), [[-0.5, 0.5], [-1.0, 1.0], [0.0, 0.25]]);
    let moved = placed(json!({"mesh": 0, "translation": [1, 2, 3], "scale": [1, 4, -2]}));
    assert_eq!(moved, [[2.0, 4.0], [-2.0, 0.0], [2.0, 3.0]]);
    let half = 0.5_f64.sqrt();
    // A quarter about y, the vertical: what pointed to port points back.
    let turned = placed(json!({"mesh": 0, "rotation": [0, half, 0, half]}));
    assert!((turned[0][1] - 1.0).abs() < 1e-12 && (turned[1][1] - 0.5).abs() < 1e-12, "{turned:?}");
    let matrix = placed(json!({"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1]}));
    assert_eq!(matrix, [[2.5, 3.5], [-2.0, 0.0], [2.0, 2.25]]);
    let mut twice = gltf(&data());
    twice["nodes"] = json!([{"children": [1, 2]}, {"mesh": 0}, {"mesh": 0, "translation": [9, 0, 0]}]);
    assert_eq!(read("a.gltf", twice.to_string()).unwrap().solids.len(), 2);
}

#[test]
fn colours_strips_and_buffers_of_gltf() {
    let mut painted = gltf(&data());
    painted["materials"] = json!([{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0, 1], "baseColorTexture": {"index": 0}}}]);
    painted["meshes"][0]["primitives"][0]["material"] = json!(0);
    painted["animations"] = json!([{}]);
    let shape = read("a.gltf", painted.to_string()).unwrap();
    assert_eq!(shape.solids[0].albedo(3), [0.5 * ALBEDO, 0.25 * ALBEDO, 0.0]);
    assert!(
        shape.notes[0].contains("textures are not read")
            && shape.notes[1].contains("animations are not played")
    );
    // A tetrahedron of four corners of the box as a strip, and as a fan that leaves its base open.
    for (mode, corners) in [(5, [0, 1, 3, 4, 0, 1]), (6, [4, 0, 1, 3, 0, 0])] {
        let bytes: Vec<u8> = buffer()[..96].iter().copied().chain(corners).collect();
        let mut stripped = gltf(&data_of(&bytes));
        stripped["buffers"][0]["byteLength"] = json!(102);
        stripped["bufferViews"][1]["byteLength"] = json!(6);
        stripped["accessors"][1]["count"] = json!(6);
        stripped["meshes"][0]["primitives"][0]["mode"] = json!(mode);
        let read = read("a.gltf", stripped.to_string());
        match mode {
            5 => assert_eq!(read.unwrap().solids[0].faces().len(), 4),
            _ => assert!(read.unwrap_err().to_string().contains("not closed"), "no base"),
        }
    }
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a box.bin"), buffer()).unwrap();
    let path = folder.path().join("box.gltf");
    std::fs::write(&path, gltf("a%20box.bin").to_string()).unwrap();
    let shape = shape_files::read(&path, Openness::Closed).unwrap();
    assert_eq!((shape.solids, shape.beside), (vec![the_box()], vec![folder.path().join("a box.bin")]));
}

#[test]
fn gltf_that_is_damaged_or_says_more() {
    for (path, value, said) in [
        ("/asset/version", json!("1.0"), "asset.version: this version is not read"),
        ("/asset", json!({}), "asset: `version` is missing"),
        ("/scene", json!(3), "scene 3 does not exist"),
        ("/nodes/0", json!({"mesh": 7}), "nodes[0]: mesh 7 does not exist"),
        ("/nodes/0", json!({"children": [0]}), "nodes[0].children[0]: node 0 is reached twice"),
        ("/nodes/0", json!({"mesh": 0, "skin": 0}), "apply the armature"),
        ("/nodes/0", json!({"mesh": 0, "glow": 0}), "nodes[0]: key `glow` is not read"),
        ("/nodes/0", json!({"mesh": 0, "rotation": [0, 0, 0, 0]}), "its place is no affine transform"),
        ("/nodes/0", json!({"mesh": 0, "weights": [0.5]}), "apply shape keys"),
        ("/extensionsRequired", json!(["KHR_draco_mesh_compression"]), "export without Draco"),
        ("/extensionsUsed", json!(["EXT_mesh_gpu_instancing"]), "export instances as nodes"),
        ("/extensionsUsed", json!(["ACME_shape"]), "extensionsUsed[0]: extension ACME_shape is not read"),
        ("/meshes/0/primitives/0/mode", json!(1), "points and lines are not read"),
        ("/meshes/0/primitives/0/mode", json!(9), "mode 9 is not known"),
        ("/meshes/0/primitives/0/attributes", json!({"POSITION": 9}), "accessor 9 does not exist"),
        ("/meshes/0/primitives/0/attributes/GLOW", json!(0), "attribute GLOW is not read"),
        (
            "/meshes/0/primitives/0/attributes/NORMAL",
            json!(1),
            "accessors[1].type: wrong type for meshes[0].primitives[0].attributes.NORMAL",
        ),
        ("/accessors/0/count", json!(9), "accessors[0]: 9 elements reach beyond their view"),
        ("/accessors/0/count", json!(u64::MAX), "reach beyond their view"),
        ("/accessors/0/byteOffset", json!(u64::MAX), "reach beyond their view"),
        ("/accessors/0/componentType", json!(5124), "5124 is no type of component"),
        ("/accessors/0/sparse", json!({}), "sparse accessors are not read"),
        ("/accessors/1/count", json!(35), "triangles of 35 corners"),
        ("/bufferViews/0/byteLength", json!(133), "bufferViews[0]: reaches beyond its buffer"),
        ("/bufferViews/0/byteStride", json!(4), "a stride of 4 bytes"),
        ("/bufferViews/0/buffer", json!(1), "buffer 1 does not exist"),
        ("/buffers/0/byteLength", json!(133), "133 bytes are promised, 132 are there"),
        ("/buffers/0/uri", json!("../a.bin"), "buffers[0].uri: leads elsewhere"),
        ("/buffers/0/uri", json!("%2e%2e/a.bin"), "buffers[0].uri: leads elsewhere"),
        ("/buffers/0/uri", json!("/etc/passwd"), "leads elsewhere"),
        ("/buffers/0/uri", json!("https://example.org/a.bin"), "leads elsewhere"),
        ("/buffers/0/uri", json!("data:;base64,@"), "data that cannot be read"),
        ("/buffers/0/uri", json!("none.bin"), "none.bin: no such file"),
    ] {
        let found = refused("a.gltf", changed(path, value));
        assert!(found.contains(said) && found.contains("a.gltf"), "{said}: {found}");
    }
    let json = gltf(&data()).to_string();
    assert!(refused("a.gltf", &json[..json.len() - 1]).contains("no JSON: EOF while parsing"));
    let whole = glb(gltf(""));
    assert!(refused("a.glb", &whole[..whole.len() - 4]).contains("the head says "));
    let mut other = whole.clone();
    other[16..20].copy_from_slice(b"TEXT");
    assert!(refused("a.glb", &other).contains("other chunks than JSON and BIN"));
    other = whole;
    other[4] = 1;
    assert!(refused("a.glb", &other).contains("binary glTF of version 1 is not read"));
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
