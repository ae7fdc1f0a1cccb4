//! Triangles of meshes.

use diagnostics::ProblemList;
use glam::{DMat3, DVec3};

use super::accessors::{Accessors, Elements};
use super::buffers::Buffers;
use super::json::Json;
use super::materials::Materials;
use super::nodes::PlacedMesh;
use crate::shape_files::MAX_PARTS;
use crate::shape_files::mesh::{Corner, Face, Mesh, Part, Vertex, WHITE};

/// Most vertices, and corners of triangles, of all nodes together: one mesh may stand in many places.
const MOST_COUNTED: usize = 3 << 20;

/// Attributes of vertices that are used.
const USED: [&str; 3] = ["POSITION", "NORMAL", "COLOR_0"];
/// Beginnings of attributes that say nothing about shape or light here; those with a `_` are a program's own.
const HARMLESS: [&str; 6] = ["TANGENT", "TEXCOORD_", "JOINTS_", "WEIGHTS_", "COLOR_", "_"];

/// What triangles are made of.
pub(super) struct Primitives<'p, 'a> {
    pub accessors: &'p Accessors<'a>,
    pub materials: &'p Materials,
    pub buffers: &'p mut Buffers<'a>,
    /// Vertices, and corners of triangles, so far.
    pub counted: usize,
    /// Whether a mesh has morph targets.
    pub is_morphed: bool,
}

impl Primitives<'_, '_> {
    /// Adds the triangles of a mesh in its place, each primitive a part.
    ///
    /// # Errors
    /// At the first fault.
    pub fn add(&mut self, into: &mut Mesh, own: &Json, placed: &PlacedMesh) -> Result<(), ProblemList> {
        own.expect_known(&["primitives", "weights"], &[])?;
        for weights in [own, &placed.node].into_iter().filter_map(|holder| holder.get("weights")) {
            if weights.has_weight() {
                let help = "apply shape keys before the export";
                return Err(weights.problem("morph targets are not read", "weights of 0").help(help).into());
            }
        }
        let name = [&placed.node, own].into_iter().find_map(|named| named.get("name"));
        let name = name.and_then(|name| name.text().ok()).unwrap_or_default();
        for primitive in own.required("primitives")?.items()? {
            primitive.expect_known(&["attributes", "indices", "material", "mode", "targets"], &[])?;
            self.is_morphed |= primitive.get("targets").is_some();
            if into.parts.len() == MAX_PARTS {
                return Err(primitive
                    .problem(format!("more than {MAX_PARTS} parts"), "fewer; use several files")
                    .into());
            }
            into.parts.push(Part { name: name.into(), ..Part::default() });
            self.add_primitive(into, &primitive, placed)?;
        }
        Ok(())
    }

    fn add_primitive(
        &mut self,
        into: &mut Mesh,
        primitive: &Json,
        placed: &PlacedMesh,
    ) -> Result<(), ProblemList> {
        let attributes = primitive.required("attributes")?;
        for key in attributes.keys()? {
            if !USED.contains(&key) && !HARMLESS.iter().any(|known| key.starts_with(known)) {
                return Err(attributes
                    .problem(format!("attribute {key} is not read"), USED.join(", "))
                    .into());
            }
        }
        let position = attributes.required("POSITION")?;
        let places = self.accessors.elements(&position, &["VEC3"], self.buffers)?;
        self.count(places.len(), primitive)?;
        let normals = self.attribute(&attributes, "NORMAL", &["VEC3"], places.len())?;
        let colours = self.attribute(&attributes, "COLOR_0", &["VEC3", "VEC4"], places.len())?;
        let first = [into.vertices.len(), into.normals.len()];
        let material = self.materials.of(primitive)?;
        for number in 0..places.len() {
            let place = placed.to_scene.transform_point3(DVec3::from_array(places.triple(number)));
            if !place.is_finite() {
                return Err(position
                    .problem(format!("vertex {number} has no finite place"), "metres")
                    .into());
            }
            let own = colours.as_ref().map_or(WHITE, |colours| colours.triple(number));
            if !own.iter().all(|light| (0.0..=1.0).contains(light)) {
                return Err(attributes
                    .problem(format!("the colour of vertex {number} is not 0 to 1"), "linear light")
                    .into());
            }
            let colour = std::array::from_fn(|channel| own[channel] * material[channel]);
            into.vertices.push(Vertex { place: in_body_axes(place), colour, at: number..number });
        }
        // Normals turn with the faces that they stand on: the inverse transposed, but for its size.
        let to_scene = DMat3::from_mat4(placed.to_scene);
        let DMat3 { x_axis: x, y_axis: y, z_axis: z } = to_scene;
        let is_mirrored = to_scene.determinant() < 0.0;
        let turn =
            DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y)) * if is_mirrored { -1.0 } else { 1.0 };
        for number in 0..normals.as_ref().map_or(0, Elements::len) {
            let normal = normals.as_ref().map_or([0.0; 3], |normals| normals.triple(number));
            into.normals.push(in_body_axes(turn * DVec3::from_array(normal)));
        }
        let corner = |number: usize| Corner {
            vertex: first[0] + number,
            normal: normals.is_some().then_some(first[1] + number),
        };
        for (number, mut triangle) in (1..).zip(self.triangles(primitive, places.len())?) {
            if is_mirrored {
                triangle.swap(1, 2);
            }
            let corners = triangle.map(corner).to_vec();
            into.last_part().faces.push(Face { corners, colour: None, at: number..number });
        }
        Ok(())
    }

    /// An attribute with as many elements as there are vertices.
    fn attribute(
        &mut self,
        attributes: &Json,
        key: &str,
        types: &[&str],
        vertices: usize,
    ) -> Result<Option<Elements>, ProblemList> {
        let Some(asked) = attributes.get(key) else { return Ok(None) };
        let elements = self.accessors.elements(&asked, types, self.buffers)?;
        match elements.len() == vertices {
            true => Ok(Some(elements)),
            false => Err(asked
                .problem(format!("{} elements", elements.len()), format!("{vertices}, as POSITION has"))
                .into()),
        }
    }

    /// The triangles of a primitive, by vertices: a list, a strip or a fan.
    fn triangles(&mut self, primitive: &Json, vertices: usize) -> Result<Vec<[usize; 3]>, ProblemList> {
        let corners = match primitive.get("indices") {
            None => (0..vertices).collect(),
            Some(asked) => self.indices(&asked, vertices)?,
        };
        self.count(corners.len(), primitive)?;
        let threes = || corners.windows(3).map(|three| [three[0], three[1], three[2]]);
        match primitive.whole_or("mode", 4)? {
            4 if corners.len().is_multiple_of(3) => Ok(threes().step_by(3).collect()),
            4 => Err(primitive
                .problem(format!("triangles of {} corners", corners.len()), "three corners each")
                .into()),
            // Every second triangle of a strip runs the other way round.
            5 => Ok(threes()
                .enumerate()
                .map(|(at, [a, b, c])| if at % 2 == 0 { [a, b, c] } else { [b, a, c] })
                .collect()),
            6 => Ok(corners.windows(2).skip(1).map(|two| [corners[0], two[0], two[1]]).collect()),
            0..=3 => Err(primitive
                .problem("points and lines are not read", "triangles: mode 4, 5 or 6")
                .help("delete loose edges and points before the export")
                .into()),
            mode => Err(primitive.problem(format!("mode {mode} is not known"), "mode 4, 5 or 6").into()),
        }
    }

    /// Counts vertices and corners of triangles.
    fn count(&mut self, more: usize, primitive: &Json) -> Result<(), ProblemList> {
        self.counted += more;
        if self.counted <= MOST_COUNTED {
            return Ok(());
        }
        let title = format!("the nodes draw more than {MOST_COUNTED} vertices and corners together");
        Err(primitive.problem(title, "a simpler shape").into())
    }

    fn indices(&mut self, asked: &Json, vertices: usize) -> Result<Vec<usize>, ProblemList> {
        let indices = self.accessors.elements(asked, &["SCALAR"], self.buffers)?.numbers;
        let is_one = |index: &f64| index.fract() == 0.0 && (0.0..vertices as f64).contains(index);
        match indices.iter().find(|index| !is_one(index)) {
            None => Ok(indices.into_iter().map(|index| index as usize).collect()),
            Some(index) => {
                let title = format!("index {index} names no vertex: there are {vertices}, counted from 0");
                Err(asked.problem(title, "the number of a vertex, from 0").into())
            }
        }
    }
}

/// From y up, front along z and x to port, to forward, starboard, up.
fn in_body_axes(place: DVec3) -> DVec3 {
    DVec3::new(place.z, -place.x, place.y)
}
