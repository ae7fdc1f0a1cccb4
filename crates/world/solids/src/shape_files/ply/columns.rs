//! Which properties of a PLY file say what.

use diagnostics::{Problem, ProblemList};

use super::body::{Fault, Value};
use super::header::{Element, Header, Kind};
use crate::shape_files::mesh::{Corner, Face, Mesh, Vertex, WHITE, from_port, linear};

/// Properties of vertices that say nothing about shape or light.
const VERTEX_HARMLESS: [&str; 18] = [
    "alpha",
    "s",
    "t",
    "u",
    "v",
    "texture_u",
    "texture_v",
    "texture_s",
    "texture_t",
    "confidence",
    "intensity",
    "quality",
    "value",
    "flags",
    "material_index",
    "label",
    "curvature",
    "id",
];
/// The same of faces.
const FACE_HARMLESS: [&str; 13] = [
    "alpha",
    "quality",
    "flags",
    "texcoord",
    "texnumber",
    "nx",
    "ny",
    "nz",
    "material_index",
    "intensity",
    "label",
    "area",
    "id",
];
/// Elements that say nothing about shape or light.
const ELEMENT_HARMLESS: [&str; 4] = ["material", "camera", "user", "multi_texture_vertex"];
/// Elements that would be missed in the picture.
const ELEMENT_REFUSED: [(&str, &str); 3] = [
    ("edge", "delete loose edges before the export: only faces are drawn"),
    ("tristrips", "export faces instead of strips of triangles"),
    ("range_grid", "export faces instead of a grid of ranges"),
];

/// What becomes of the rows of each element.
pub(super) struct Columns {
    pub of_elements: Vec<Use>,
}

/// What becomes of the rows of an element. Numbers are those of properties.
pub(super) enum Use {
    Vertex { place: [usize; 3], normal: Option<[usize; 3]>, colour: Option<Colour> },
    Face { corners: usize, colour: Option<Colour> },
    Nothing,
}

/// Where a colour stands.
pub(super) struct Colour {
    channels: [usize; 3],
    /// The value of a colour that stands for full light.
    full: f64,
    /// Codes are on the curve of sRGB.
    is_coded: bool,
}

impl Columns {
    /// The uses of all elements.
    ///
    /// # Errors
    /// If an element or a property is not known.
    pub fn of(name: &str, header: &Header) -> Result<Self, ProblemList> {
        let mut of_elements = Vec::with_capacity(header.elements.len());
        let mut has_vertices = false;
        for element in &header.elements {
            if element.count > 0 && element.properties.is_empty() {
                let title = format!("element `{}` has no properties", element.name);
                return Err(Problem::at(&element.place, title).expected("`property` behind it").into());
            }
            of_elements.push(match element.name.as_str() {
                "vertex" => vertex(element)?,
                "face" if !has_vertices && element.count > 0 => {
                    let title = "element `face` stands before `vertex`";
                    return Err(Problem::at(&element.place, title).expected("vertices first").into());
                }
                "face" => face(element)?,
                other if element.count == 0 || ELEMENT_HARMLESS.contains(&other) => Use::Nothing,
                other => return Err(unknown_element(element, other).into()),
            });
            has_vertices |= element.name == "vertex";
        }
        match has_vertices {
            true => Ok(Self { of_elements }),
            false => Err(Problem::of_file(name, "the header has no element `vertex`")
                .expected("vertices and faces")
                .into()),
        }
    }
}

fn unknown_element(element: &Element, name: &str) -> Problem {
    let problem = Problem::at(&element.place, format!("element `{name}` is not read"));
    let known = format!("vertex, face, or of no effect: {}", ELEMENT_HARMLESS.join(", "));
    match ELEMENT_REFUSED.iter().find(|(refused, _)| *refused == name) {
        Some((_, why)) => problem.expected(known).help(*why),
        None => problem.expected(known).help("export the file without it"),
    }
}

/// The number of a property of the element that is one number, not a list.
fn one(element: &Element, name: &str) -> Option<usize> {
    element.properties.iter().position(|property| property.name == name && property.length.is_none())
}

fn all<const N: usize>(element: &Element, names: [&str; N]) -> Option<[usize; N]> {
    let found: Vec<usize> = names.iter().filter_map(|name| one(element, name)).collect();
    found.try_into().ok()
}

/// Refuses properties that are neither used nor known.
fn expect_known(element: &Element, used: &[&str], harmless: &[&str]) -> Result<(), ProblemList> {
    let is_known = |name: &str| used.contains(&name) || harmless.contains(&name);
    match element.properties.iter().find(|property| !is_known(&property.name)) {
        None => Ok(()),
        Some(property) => {
            let title = format!("property `{}` of element `{}` is not read", property.name, element.name);
            let expected = format!("{}, or of no effect: {}", used.join(", "), harmless.join(", "));
            Err(Problem::at(&property.place, title)
                .expected(expected)
                .help("export the file without it")
                .into())
        }
    }
}

const PLACE: [&str; 3] = ["x", "y", "z"];
const NORMAL: [&str; 3] = ["nx", "ny", "nz"];
/// Names of red, green and blue by different programs.
const COLOURS: [[&str; 3]; 2] = [["red", "green", "blue"], ["r", "g", "b"]];

fn vertex(element: &Element) -> Result<Use, ProblemList> {
    let used: Vec<&str> = PLACE.into_iter().chain(NORMAL).chain(COLOURS.into_iter().flatten()).collect();
    expect_known(element, &used, &VERTEX_HARMLESS)?;
    let place = all(element, PLACE).ok_or_else(|| {
        Problem::at(&element.place, "element `vertex` has no properties x, y and z")
            .expected("three coordinates")
    })?;
    let whole_triple = |names| complete(element, names);
    Ok(Use::Vertex { place, normal: whole_triple(NORMAL)?, colour: colour(element)? })
}

/// All three properties, or none.
fn complete(element: &Element, names: [&str; 3]) -> Result<Option<[usize; 3]>, ProblemList> {
    let found = all(element, names);
    if found.is_none() && names.iter().any(|name| element.properties.iter().any(|own| own.name == *name)) {
        let title = format!("element `{}` has not all of {}", element.name, names.join(", "));
        return Err(Problem::at(&element.place, title).expected("three single numbers, or none").into());
    }
    Ok(found)
}

fn colour(element: &Element) -> Result<Option<Colour>, ProblemList> {
    for names in COLOURS {
        let Some(channels) = complete(element, names)? else { continue };
        let kind = element.properties[channels[0]].kind;
        let is_same = channels.iter().all(|&channel| element.properties[channel].kind == kind);
        let Some(full) = kind.full().filter(|_| is_same) else {
            let place = &element.properties[channels[0]].place;
            let expected = "uchar, ushort, float or double, the same for all three";
            return Err(Problem::at(place, "colours of this type are not read").expected(expected).into());
        };
        return Ok(Some(Colour { channels, full, is_coded: kind.is_whole() }));
    }
    Ok(None)
}

fn face(element: &Element) -> Result<Use, ProblemList> {
    const CORNERS: [&str; 2] = ["vertex_indices", "vertex_index"];
    let used: Vec<&str> = CORNERS.into_iter().chain(COLOURS.into_iter().flatten()).collect();
    expect_known(element, &used, &FACE_HARMLESS)?;
    let is_corners = |name: &str, length: Option<Kind>| CORNERS.contains(&name) && length.is_some();
    let corners = element.properties.iter().position(|own| is_corners(&own.name, own.length));
    match corners {
        Some(corners) => Ok(Use::Face { corners, colour: colour(element)? }),
        None => Err(Problem::at(&element.place, "element `face` has no list of vertices")
            .expected("property list uchar int vertex_indices")
            .into()),
    }
}

impl Use {
    /// Adds what a row says, the row's number counted from 1.
    pub fn add(&self, mesh: &mut Mesh, row: &[Value], number: u64) -> Result<(), Fault> {
        let at = number as usize..number as usize;
        match self {
            Self::Vertex { place, normal, colour } => {
                let place = from_port(place.map(|axis| single(&row[axis])));
                if !place.is_finite() {
                    return Err(Fault::new("a coordinate is not finite", "metres"));
                }
                let colour = colour.as_ref().map_or(Ok(WHITE), |colour| colour.of(row))?;
                mesh.vertices.push(Vertex { place, colour, at });
                mesh.normals.extend(normal.map(|axes| from_port(axes.map(|axis| single(&row[axis])))));
            }
            Self::Face { corners, colour } => {
                let Value::List(indices) = &row[*corners] else { return Ok(()) };
                let corner = |&index: &f64| corner(mesh, index);
                let corners = indices.iter().map(corner).collect::<Result<_, _>>()?;
                let colour = colour.as_ref().map(|colour| colour.of(row)).transpose()?;
                mesh.last_part().faces.push(Face { corners, colour, at });
            }
            Self::Nothing => {}
        }
        Ok(())
    }
}

fn corner(mesh: &Mesh, index: f64) -> Result<Corner, Fault> {
    let vertices = mesh.vertices.len();
    let is_one = index >= 0.0 && index.fract() == 0.0 && index < vertices as f64;
    if !is_one {
        return Err(Fault::new(
            format!("corner {index} names no vertex: there are {vertices}, counted from 0"),
            "the number of a vertex, from 0",
        ));
    }
    let vertex = index as usize;
    Ok(Corner { vertex, normal: Some(vertex).filter(|&normal| normal < mesh.normals.len()) })
}

/// The number of a property that is no list.
fn single(value: &Value) -> f64 {
    match value {
        Value::One(number) => *number,
        Value::List(_) => f64::NAN,
    }
}

impl Colour {
    /// Linear red, green and blue of a row.
    fn of(&self, row: &[Value]) -> Result<[f64; 3], Fault> {
        let codes = self.channels.map(|channel| single(&row[channel]) / self.full);
        if !codes.iter().all(|code| (0.0..=1.0).contains(code)) {
            return Err(Fault::new(
                "a channel of its colour is out of range",
                "0 to 255, or linear light of 0 to 1",
            ));
        }
        Ok(if self.is_coded { codes.map(linear) } else { codes })
    }
}
