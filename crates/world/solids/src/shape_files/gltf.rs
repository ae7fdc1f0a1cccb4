//! glTF 2.0: meshes placed by a tree of nodes, in JSON or in one binary file.
//!
//! The first fault ends the reading. Its place is the path of the value in the JSON, as `meshes[0].primitives[1].mode`.

mod accessors;
mod binary;
mod buffers;
mod extensions;
mod json;
mod materials;
mod nodes;
mod primitives;

use std::path::Path;

use diagnostics::{Problem, ProblemList};

use super::Read;
use super::faults::Faults;
use super::mesh::Mesh;
use accessors::Accessors;
use buffers::Buffers;
use extensions::expect_extensions;
use json::Json;
use materials::Materials;
use nodes::placed_meshes;
use primitives::Primitives;

/// Reads the JSON of a glTF file; buffers may stand beside it.
///
/// # Errors
/// The first fault.
pub(super) fn read(path: &Path, bytes: &[u8]) -> Result<Read, ProblemList> {
    read_json(path, bytes, None)
}

/// Reads a binary glTF file.
///
/// # Errors
/// The first fault.
pub(super) fn read_binary(path: &Path, bytes: &[u8]) -> Result<Read, ProblemList> {
    let (json, buffer) = binary::chunks(&path.display().to_string(), bytes)?;
    read_json(path, json, buffer)
}

/// Keys of the root that say nothing about shape or light here.
const HARMLESS: [&str; 4] = ["textures", "images", "samplers", "cameras"];
const USED: [&str; 12] = [
    "asset",
    "scene",
    "scenes",
    "nodes",
    "meshes",
    "accessors",
    "bufferViews",
    "buffers",
    "materials",
    "skins",
    "animations",
    "extensionsUsed",
];

fn read_json(path: &Path, bytes: &[u8], chunk: Option<&[u8]>) -> Result<Read, ProblemList> {
    let name = path.display().to_string();
    let value = text::read_json(bytes)
        .map_err(|error| Problem::of_file(&name, format!("no JSON: {error}")).expected("glTF 2.0"))?;
    let root = Json::root(&name, &value);
    expect_extensions(&root)?;
    root.expect_known(&[&USED[..], &["extensionsRequired"]].concat(), &HARMLESS)?;
    expect_version(&root)?;
    let mut mesh = Mesh::default();
    let mut buffers = Buffers::new(path, &root, chunk)?;
    let accessors = Accessors::new(&root)?;
    let materials = Materials::new(&root)?;
    let mut primitives = Primitives {
        accessors: &accessors,
        materials: &materials,
        buffers: &mut buffers,
        counted: 0,
        is_morphed: false,
    };
    let meshes = root.list("meshes")?;
    for placed in placed_meshes(&root)? {
        let Some(own) = meshes.get(placed.mesh) else {
            return Err(placed
                .node
                .problem(format!("mesh {} does not exist", placed.mesh), "the number of a mesh")
                .into());
        };
        primitives.add(&mut mesh, own, &placed)?;
    }
    let is_morphed = primitives.is_morphed;
    mesh.notes.extend(notes(&root, &materials, is_morphed)?);
    Ok(Read { mesh, faults: Faults::of_numbers(&name, "triangle"), beside: buffers.into_files() })
}

fn expect_version(root: &Json) -> Result<(), ProblemList> {
    let asset = root.required("asset")?;
    asset.expect_known(&["version", "minVersion"], &["generator", "copyright", "name"])?;
    let version = asset.required("version")?;
    if !version.text()?.starts_with("2.") {
        return Err(version.problem("this version is not read", "2.0").into());
    }
    // A reader of 2.0 does for every 2.x that does not ask for more.
    match asset.get("minVersion") {
        Some(least) if least.text()? != "2.0" => {
            Err(least.problem("a reader of this version is asked for", "2.0").into())
        }
        _ => Ok(()),
    }
}

/// What is not seen, although the file has it.
fn notes(root: &Json, materials: &Materials, is_morphed: bool) -> Result<Vec<String>, ProblemList> {
    let mut notes = Vec::new();
    let mut note = |is_so: bool, note: &str| notes.extend(is_so.then(|| note.to_owned()));
    note(materials.has_textures(), "textures are not read: faces have the plain colours of their materials");
    note(!root.list("animations")?.is_empty(), "animations are not played: the shape is drawn at rest");
    note(is_morphed, "morph targets are not read: the shape is drawn at rest");
    let scenes = root.list("scenes")?.len();
    note(scenes > 1, "several scenes: the one that the file names is read, or the first");
    Ok(notes)
}
