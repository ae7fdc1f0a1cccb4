//! Extensions of glTF, by name.

use diagnostics::{Problem, ProblemList};

use super::json::Json;

/// Extensions that say nothing about shape, or that the readers of numbers know anyway. Those of materials change the light of
/// surfaces in ways that are not drawn.
const HARMLESS: [&str; 27] = [
    "KHR_mesh_quantization",
    "KHR_lights_punctual",
    "KHR_texture_basisu",
    "KHR_texture_transform",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    "KHR_xmp_json_ld",
    "KHR_xmp",
    "EXT_lights_image_based",
    "EXT_texture_webp",
    "EXT_texture_avif",
    "MSFT_texture_dds",
    "MSFT_packing_normalRoughnessMetallic",
    "MSFT_packing_occlusionRoughnessMetallic",
    "AGI_articulations",
    "AGI_stk_metadata",
    "CESIUM_primitive_outline",
    "GODOT_single_root",
];
/// Extensions that would be missed in the picture, and what to do about them.
const REFUSED: [(&str, &str); 7] = [
    ("KHR_draco_mesh_compression", "export without Draco compression"),
    ("EXT_meshopt_compression", "export without meshopt compression"),
    ("KHR_meshopt_compression", "export without meshopt compression"),
    ("EXT_mesh_gpu_instancing", "export instances as nodes"),
    (
        "KHR_materials_pbrSpecularGlossiness",
        "export materials as metallic and roughness: colours would be lost",
    ),
    ("KHR_materials_variants", "export one variant of the materials"),
    ("MSFT_lod", "export one level of detail"),
];

/// Refuses extensions that are not known to be harmless, wherever the file declares them.
///
/// # Errors
/// At the first.
pub(super) fn expect_extensions(root: &Json) -> Result<(), ProblemList> {
    for list in ["extensionsRequired", "extensionsUsed"] {
        for extension in root.list(list)? {
            let name = extension.text()?;
            if !HARMLESS.contains(&name) {
                return Err(refused(&extension, name).into());
            }
        }
    }
    Ok(())
}

fn refused(extension: &Json, name: &str) -> Problem {
    let problem = extension.problem(format!("extension {name} is not read"), "plain glTF 2.0");
    match REFUSED.iter().find(|(refused, _)| *refused == name) {
        Some((_, why)) => problem.help(*why),
        None => problem.help("export without it"),
    }
}
