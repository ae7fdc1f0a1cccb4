//! What makes a list of faces a convex solid.

use std::collections::BTreeSet;

use glam::DVec3;

use crate::{Face, Solid, SolidError};

/// Vertices farther from the foot point than this are a mistake (m).
const FARTHEST: f64 = 1e5;

pub(crate) fn check_counts(vertices: usize, faces: usize) -> Result<(), SolidError> {
    check_most(vertices, faces, [4, 4])
}

/// At least so many vertices and faces, at most [`Solid::MOST`].
pub(crate) fn check_most(vertices: usize, faces: usize, least: [usize; 2]) -> Result<(), SolidError> {
    if vertices < least[0] || faces < least[1] {
        return Err(SolidError::TooSmall { vertices, faces });
    }
    for (what, found) in [("vertices", vertices), ("faces", faces)] {
        if found > Solid::MOST {
            return Err(SolidError::TooLarge { what, found, most: Solid::MOST });
        }
    }
    Ok(())
}

pub(crate) fn check_vertices(vertices: &[DVec3]) -> Result<(), SolidError> {
    // A NaN is not within the bounds either.
    let is_place = |vertex: &DVec3| vertex.to_array().iter().all(|length| length.abs() <= FARTHEST);
    match vertices.iter().position(|vertex| !is_place(vertex)) {
        Some(vertex) => Err(SolidError::BadVertex { vertex }),
        None => Ok(()),
    }
}

/// Unit normal of a face by the cross product of its edges, and the mean of its corners.
pub(crate) fn plane_of(
    vertices: &[DVec3],
    face: usize,
    corners: &[u32],
    size: f64,
) -> Result<(DVec3, DVec3), SolidError> {
    check_corners(vertices, face, corners)?;
    let bad = |what| Err(SolidError::BadFace { face, what });
    let places: Vec<DVec3> = corners.iter().map(|&corner| vertices[corner as usize]).collect();
    let middle = places.iter().sum::<DVec3>() / places.len() as f64;
    let area = edges(&places).map(|(from, to)| (from - middle).cross(to - middle)).sum::<DVec3>();
    // Twice the area over the longest extent is the width of a sliver.
    if area.length() <= f64::EPSILON.sqrt() * size * size {
        return bad("no area");
    }
    let normal = area.normalize();
    if places.iter().any(|place| normal.dot(*place - middle).abs() > Solid::TOLERANCE * size) {
        return bad("corners not in one plane");
    }
    let after = edges(&places).skip(1).chain(edges(&places).take(1));
    let mut turns =
        edges(&places).zip(after).map(|((from, at), (_, to))| normal.dot((at - from).cross(to - at)));
    if turns.any(|turn| turn < -Solid::TOLERANCE * size * size) {
        return bad("the outline turns back on itself");
    }
    Ok((normal, middle))
}

fn check_corners(vertices: &[DVec3], face: usize, corners: &[u32]) -> Result<(), SolidError> {
    let bad = |what| Err(SolidError::BadFace { face, what });
    if let Some(&vertex) = corners.iter().find(|&&corner| corner as usize >= vertices.len()) {
        return Err(SolidError::NoVertex { face, vertex, last: vertices.len() - 1 });
    }
    if corners.len() < 3 {
        return bad("fewer than 3 corners");
    }
    if corners.iter().collect::<BTreeSet<_>>().len() < corners.len() {
        return bad("one corner stands twice");
    }
    Ok(())
}

fn edges(places: &[DVec3]) -> impl Iterator<Item = (DVec3, DVec3)> {
    places.iter().zip(places.iter().cycle().skip(1)).map(|(&from, &to)| (from, to))
}

/// Every vertex lies behind every face.
pub(crate) fn check_convex(vertices: &[DVec3], faces: &[Face], tolerance: f64) -> Result<(), SolidError> {
    for (index, face) in faces.iter().enumerate() {
        let on_face = vertices[face.corners[0] as usize];
        for (vertex, &place) in vertices.iter().enumerate() {
            let outside = face.normal.dot(place - on_face);
            if outside > tolerance {
                return Err(SolidError::NotConvex { vertex, face: index, outside });
            }
        }
    }
    Ok(())
}

/// Every edge is run through once each way, every vertex lies on an edge.
pub(crate) fn check_closed(faces: &[Face], vertices: usize) -> Result<(), SolidError> {
    let mut seen = BTreeSet::new();
    for face in faces {
        let after = face.corners.iter().cycle().skip(1);
        for (&from, &to) in face.corners.iter().zip(after) {
            if !seen.insert((from, to)) {
                return Err(SolidError::Open(from, to));
            }
        }
    }
    if let Some(&(from, to)) = seen.iter().find(|&&(from, to)| !seen.contains(&(to, from))) {
        return Err(SolidError::Open(from, to));
    }
    let used: BTreeSet<u32> = seen.into_iter().map(|(from, _)| from).collect();
    match (0..vertices).find(|&vertex| !used.contains(&(vertex as u32))) {
        Some(vertex) => Err(SolidError::Unused { vertex }),
        None => Ok(()),
    }
}
