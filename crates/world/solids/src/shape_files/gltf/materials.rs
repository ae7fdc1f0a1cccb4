//! Colours of materials.

use diagnostics::ProblemList;

use super::json::Json;
use crate::shape_files::mesh::WHITE;

/// Keys of a material beside its colour: they change the light of a surface in ways that are not drawn.
const HARMLESS: [&str; 7] = [
    "normalTexture",
    "occlusionTexture",
    "emissiveTexture",
    "emissiveFactor",
    "alphaMode",
    "alphaCutoff",
    "doubleSided",
];
/// The same of the model of metal and roughness.
const MODEL_HARMLESS: [&str; 3] = ["metallicFactor", "roughnessFactor", "metallicRoughnessTexture"];

/// What is read of all materials.
pub(super) struct Materials {
    /// Linear red, green and blue of each.
    colours: Vec<[f64; 3]>,
    has_textures: bool,
}

impl Materials {
    /// Those of a file.
    ///
    /// # Errors
    /// If a material cannot be read.
    pub fn new(root: &Json) -> Result<Self, ProblemList> {
        let mut materials = Self { colours: Vec::new(), has_textures: false };
        for material in root.list("materials")? {
            material.expect_known(&["pbrMetallicRoughness"], &HARMLESS)?;
            let colour =
                material.get("pbrMetallicRoughness").map(|model| materials.colour(&model)).transpose()?;
            materials.colours.push(colour.unwrap_or(WHITE));
        }
        Ok(materials)
    }

    fn colour(&mut self, model: &Json) -> Result<[f64; 3], ProblemList> {
        model.expect_known(&["baseColorFactor", "baseColorTexture"], &MODEL_HARMLESS)?;
        self.has_textures |= model.get("baseColorTexture").is_some();
        let Some(factor) = model.get("baseColorFactor") else { return Ok(WHITE) };
        let [red, green, blue, _] = factor.numbers()?;
        match [red, green, blue].iter().all(|light| (0.0..=1.0).contains(light)) {
            true => Ok([red, green, blue]),
            false => {
                Err(factor.problem("a channel is not 0 to 1", "linear red, green, blue and opacity").into())
            }
        }
    }

    /// Whether a texture gives colours that are not seen.
    pub fn has_textures(&self) -> bool {
        self.has_textures
    }

    /// The colour of the material that a primitive names; white if it names none.
    ///
    /// # Errors
    /// If there is none of that number.
    pub fn of(&self, primitive: &Json) -> Result<[f64; 3], ProblemList> {
        let Some(named) = primitive.get("material") else { return Ok(WHITE) };
        let number = named.whole()?;
        let colour = self.colours.get(number).copied();
        colour.ok_or_else(|| {
            named.problem(format!("material {number} does not exist"), "the number of a material").into()
        })
    }
}
