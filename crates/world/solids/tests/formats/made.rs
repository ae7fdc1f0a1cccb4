//! A box in every format, and readers of it.

use std::fmt::Write as _;

use diagnostics::ProblemList;
use serde_json::{Value, json};
use solids::Solid;
use solids::shape_files::{self, Openness, Shape};

pub fn read(name: &str, bytes: impl AsRef<[u8]>) -> Result<Shape, ProblemList> {
    shape_files::parse(name, bytes.as_ref(), Openness::Closed)
}

pub fn refused(name: &str, bytes: impl AsRef<[u8]>) -> String {
    read(name, bytes).unwrap_err().to_string()
}

/// Corners of a box: forward, port, up (m).
pub const CORNERS: [[f32; 3]; 8] = [
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
pub const SIDES: [[usize; 3]; 12] = [
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

pub fn obj() -> String {
    let mut text = String::new();
    for [x, y, z] in CORNERS {
        writeln!(text, "v {x} {y} {z}").unwrap();
    }
    for [a, b, c] in SIDES {
        writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).unwrap();
    }
    text
}

pub fn stl(head: &str, attributes: [u8; 2]) -> Vec<u8> {
    let mut bytes = head.as_bytes().to_vec();
    bytes.resize(80, b' ');
    bytes.extend((SIDES.len() as u32).to_le_bytes());
    for side in SIDES {
        let numbers = [f32::NAN; 3].into_iter().chain(side.into_iter().flat_map(|corner| CORNERS[corner]));
        bytes.extend(numbers.flat_map(f32::to_le_bytes).chain(attributes));
    }
    bytes
}

pub fn stl_text() -> String {
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
pub type Row = Vec<(Vec<u8>, f64)>;

pub const PLY_HEAD: &str = "comment a box\nobj_info made by hand\nelement vertex 8\nproperty double z\nproperty uchar flags\n\
    property float x\nproperty float32 y\nelement face 12\nproperty short id\nproperty list uchar uint vertex_index\nend_header\n";

pub fn rows() -> Vec<Row> {
    let long = |number: f32| (f64::from(number).to_le_bytes().to_vec(), f64::from(number));
    let short = |number: f32| (number.to_le_bytes().to_vec(), f64::from(number));
    let vertices = CORNERS.map(|[x, y, z]| vec![long(z), (vec![7], 7.0), short(x), short(y)]);
    let faces = SIDES.map(|side| {
        let corners = side.map(|corner| ((corner as u32).to_le_bytes().to_vec(), corner as f64));
        [vec![(vec![1, 0], 1.0), (vec![3], 3.0)], corners.to_vec()].concat()
    });
    vertices.into_iter().chain(faces).collect()
}

pub fn ply(coding: &str, rows: &[Row]) -> Vec<u8> {
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
pub fn buffer() -> Vec<u8> {
    let places = CORNERS.into_iter().flat_map(|[forward, port, up]| [port, up, forward]);
    let sides = SIDES.into_iter().flatten().map(|corner| corner as u8);
    places.flat_map(f32::to_le_bytes).chain(sides).collect()
}

/// The box as JSON, its buffer at `uri`.
pub fn gltf(uri: &str) -> Value {
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

pub const BASE64: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// The buffer in the JSON itself.
pub fn data() -> String {
    data_of(&buffer())
}

/// Bytes as data in base64; their number is a multiple of three.
pub fn data_of(bytes: &[u8]) -> String {
    let digits = |three: &[u8]| {
        let word = three.iter().fold(0_u32, |word, &byte| word << 8 | u32::from(byte));
        [18, 12, 6, 0].map(|shift| char::from(BASE64[(word >> shift & 63) as usize]))
    };
    let digits: String = bytes.chunks(3).flat_map(digits).collect();
    format!("data:application/octet-stream;base64,{digits}")
}

pub fn glb(mut json: Value) -> Vec<u8> {
    json["buffers"] = json!([{"byteLength": 132}]);
    let mut json = json.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let chunk = |kind: &[u8], bytes: &[u8]| [&(bytes.len() as u32).to_le_bytes(), kind, bytes].concat();
    let chunks = [chunk(b"JSON", &json), chunk(b"BIN\0", &buffer())].concat();
    [&b"glTF\x02\0\0\0"[..], &(chunks.len() as u32 + 12).to_le_bytes(), &chunks].concat()
}

/// The same with a value at a path of the JSON.
pub fn changed(path: &str, value: Value) -> String {
    let mut json = gltf(&data());
    let (above, key) = path.rsplit_once('/').unwrap();
    let above = json.pointer_mut(above).unwrap();
    match key.parse::<usize>() {
        Ok(at) => above[at] = value,
        Err(_) => above[key] = value,
    }
    json.to_string()
}

pub fn the_box() -> Solid {
    let [solid] = &read("box.obj", obj()).unwrap().solids[..] else { panic!("one part") };
    assert_eq!((solid.vertices().len(), solid.faces().len()), (8, 12));
    solid.clone()
}
