//! Vertices and faces of a list, as given.

use diagnostics::Reader;
use glam::DVec3;

use super::list::{report, report_at};
use crate::face::{Face, Shading, Sides, Vertex};
use crate::mesh::{Loaded, Mesh};

/// The faces of a list.
pub(super) fn given(table: &Reader, list: &str, most: usize) -> Option<Loaded> {
    let vertices = table.f64_triples("vertices").required();
    let normals = table.f64_triples("normals").optional();
    let tables = table.tables("face");
    if tables.is_empty() && !table.has("face") {
        let problem = table.problem("face", "a list without faces");
        table.report(problem.expected("a table [[group.face]] or more, or a table [group.pattern]"));
    }
    let faces: Vec<Option<Face>> = tables.iter().map(face).collect();
    let vertices = with_normals(table, vertices?, normals)?;
    let faces = faces.into_iter().collect::<Option<Vec<Face>>>()?;
    let loaded = Mesh::limited(list, vertices, faces, most);
    let refused = loaded.map_err(|error| match error.face() {
        Some(face) => report_at(&tables[face], &error),
        None => report(table, "vertices", &error),
    });
    refused.ok()
}

/// One normal for each vertex, or none at all.
fn with_normals(
    table: &Reader,
    places: Vec<[f64; 3]>,
    normals: Option<Vec<[f64; 3]>>,
) -> Option<Vec<Vertex>> {
    let places = places.into_iter().map(DVec3::from_array);
    let Some(normals) = normals else {
        return (!table.has("normals")).then(|| places.map(Vertex::at).collect());
    };
    if normals.len() != places.len() {
        let title = format!("{} normals for {} vertices", normals.len(), places.len());
        table.report(table.problem("normals", title).expected("as many as vertices, or no key `normals`"));
        return None;
    }
    let normals = normals.into_iter().map(DVec3::from_array);
    Some(places.zip(normals).map(|(place, normal)| Vertex { place, normal: Some(normal) }).collect())
}

fn face(table: &Reader) -> Option<Face> {
    let corners = table.u64_list("corners").at_most(u64::from(u32::MAX)).required();
    let colour = table.f64_array("colour").between(0.0, 1.0).required();
    let shading = [("flat", Shading::Flat), ("smooth", Shading::Smooth), ("glow", Shading::Glow)];
    let shading = table.one_of("shading", &shading).default(Shading::Smooth);
    let sides = table.one_of("sides", &[("one", Sides::One), ("both", Sides::Both)]).default(Sides::One);
    let corners = corners?.into_iter().map(|corner| corner as u32).collect();
    Some(Face { corners, colour: colour?, shading: shading?, sides: sides? })
}
