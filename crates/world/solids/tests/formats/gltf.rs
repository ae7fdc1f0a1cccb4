//! Nodes, colours and buffers of glTF, and what it may say wrongly.

use serde_json::{Value, json};
use solids::Solid;
use solids::shape_files::{self, ALBEDO, Openness};

use crate::made::{buffer, changed, data, data_of, glb, gltf, read, refused, the_box};

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
        ("/asset/minVersion", json!("2.1"), "asset.minVersion: a reader of this version is asked for"),
        (
            "/nodes/0",
            json!({"mesh": 0, "rotation": [0, 0, 0, 0]}),
            "nodes[0].rotation: a quaternion of length 0",
        ),
        ("/nodes/0", json!({"mesh": 0, "rotation": [0, 0, 1, 1]}), "length 1: x y z w"),
        (
            "/nodes/0",
            json!({"mesh": 0, "scale": [1, 1, 1], "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1]}),
            "nodes[0].matrix: `scale` stands beside it",
        ),
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
    let twice = json.replacen("{\"", "{\"scene\":0,\"", 1).replacen("{\"", "{\"scene\":0,\"", 1);
    assert!(refused("a.gltf", twice).contains("two values of the key `scene`"));
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
