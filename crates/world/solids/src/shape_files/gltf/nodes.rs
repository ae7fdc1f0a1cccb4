//! The tree of nodes: where each mesh stands.

use diagnostics::ProblemList;
use glam::{DMat3, DMat4, DQuat, DVec3};

use super::json::Json;

/// A mesh in its place.
pub(super) struct PlacedMesh<'a> {
    /// Number of the mesh.
    pub mesh: usize,
    /// From the mesh to the scene.
    pub to_scene: DMat4,
    /// The node that places it.
    pub node: Json<'a>,
}

const USED: [&str; 8] = ["mesh", "children", "matrix", "translation", "rotation", "scale", "skin", "weights"];

/// The meshes of the scene that the file names, or of its first; without scenes, of all nodes.
///
/// # Errors
/// If a node cannot be read, does not exist, or is reached twice.
pub(super) fn placed_meshes<'a>(root: &Json<'a>) -> Result<Vec<PlacedMesh<'a>>, ProblemList> {
    let nodes = root.list("nodes")?;
    let mut open: Vec<(Json, DMat4)> = Vec::new();
    for top in tops(root, nodes.is_empty())? {
        open.push((top, DMat4::IDENTITY));
    }
    open.reverse();
    let mut is_met = vec![false; nodes.len()];
    let mut placed = Vec::new();
    while let Some((asked, above)) = open.pop() {
        let number = asked.whole()?;
        let Some(node) = nodes.get(number) else {
            return Err(asked
                .problem(format!("node {number} does not exist"), "the number of a node")
                .into());
        };
        if std::mem::replace(&mut is_met[number], true) {
            return Err(asked.problem(format!("node {number} is reached twice"), "a tree of nodes").into());
        }
        node.expect_known(&USED, &["camera"])?;
        let to_scene = above * transform(node)?;
        if let Some(mesh) = node.get("mesh") {
            if let Some(skin) = node.get("skin") {
                let help = "apply the armature before the export";
                return Err(skin
                    .problem("a skin that bends the mesh is not read", "a rigid mesh")
                    .help(help)
                    .into());
            }
            placed.push(PlacedMesh { mesh: mesh.whole()?, to_scene, node: node.clone() });
        }
        let mut children = node.list("children")?;
        children.reverse();
        open.extend(children.into_iter().map(|child| (child, to_scene)));
    }
    Ok(placed)
}

/// Numbers of the nodes that a scene begins with.
fn tops<'a>(root: &Json<'a>, has_no_nodes: bool) -> Result<Vec<Json<'a>>, ProblemList> {
    let scenes = root.list("scenes")?;
    if !scenes.is_empty() {
        let number = root.whole_or("scene", 0)?;
        let Some(scene) = scenes.get(number) else {
            return Err(root
                .problem(format!("scene {number} does not exist"), "the number of a scene")
                .into());
        };
        scene.expect_known(&["nodes"], &[])?;
        return scene.list("nodes");
    }
    match has_no_nodes {
        true => Ok(Vec::new()),
        false => {
            Err(root.problem("no scene", "`scenes` with the nodes to draw").help("export a scene").into())
        }
    }
}

/// From a node to the one above it: a matrix, or a scale, a rotation and a translation.
fn transform(node: &Json) -> Result<DMat4, ProblemList> {
    let triple = |key: &str, usual: [f64; 3]| node.get(key).map_or(Ok(usual), |value| value.numbers());
    let made = match node.get("matrix") {
        Some(matrix) => {
            expect_matrix_alone(node, &matrix)?;
            DMat4::from_cols_array(&matrix.numbers()?)
        }
        None => {
            let rotation = DMat3::from_quat(node.get("rotation").map_or(Ok(DQuat::IDENTITY), rotation)?);
            let scale = DMat3::from_diagonal(DVec3::from_array(triple("scale", [1.0; 3])?));
            DMat4::from_mat3_translation(
                rotation * scale,
                DVec3::from_array(triple("translation", [0.0; 3])?),
            )
        }
    };
    let is_affine = made.row(3).to_array() == [0.0, 0.0, 0.0, 1.0];
    match made.is_finite() && is_affine {
        true => Ok(made),
        false => Err(node
            .problem("its place is no affine transform", "finite numbers, and a rotation that is not 0")
            .into()),
    }
}

/// The place of a node is said in one way (glTF 2.0, 3.5.2).
fn expect_matrix_alone(node: &Json, matrix: &Json) -> Result<(), ProblemList> {
    match ["translation", "rotation", "scale"].iter().find(|key| node.get(key).is_some()) {
        Some(key) => Err(matrix
            .problem(format!("`{key}` stands beside it"), "a matrix, or translation, rotation and scale")
            .into()),
        None => Ok(()),
    }
}

/// A rotation: a quaternion `x y z w` of length 1. Files round it; what is farther off is none.
fn rotation(written: Json) -> Result<DQuat, ProblemList> {
    const ROUNDED: f64 = 0.01;
    let quaternion = DQuat::from_array(written.numbers()?);
    match (quaternion.length() - 1.0).abs() <= ROUNDED {
        true => Ok(quaternion.normalize()),
        false => {
            let title = format!("a quaternion of length {}", quaternion.length());
            Err(written.problem(title, "length 1: x y z w, scalar last").into())
        }
    }
}
