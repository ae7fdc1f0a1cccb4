//! Bodies as triangles.

use glam::DVec3;
use solids::Body;

/// A triangle of a face of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyTriangle {
    /// Corners: north, east, up (m), counter-clockwise seen from outside.
    pub corners: [DVec3; 3],
    /// Unit normals at the corners, outwards.
    pub normals: [DVec3; 3],
    /// Share of red, green and blue light that is returned, 0..=1.
    pub albedo: [f64; 3],
    /// Number of the face.
    pub face: usize,
}

/// The faces of a body as fans from their first corner. They are convex, so each fan covers its face once.
pub fn body_triangles(body: &Body) -> impl Iterator<Item = BodyTriangle> {
    let (turn, scale) = body.to_ground();
    let place = move |corner: u32| body.foot + turn * (body.solid.vertices()[corner as usize] * scale);
    let fan = move |face: usize| {
        let own = &body.solid.faces()[face].corners;
        own[1..].windows(2).map(move |pair| {
            let corners = [own[0], pair[0], pair[1]].map(place);
            let normals = corners.map(|corner| body.normal_at(face, corner));
            BodyTriangle { corners, normals, albedo: body.solid.albedo(face), face }
        })
    };
    (0..body.solid.faces().len()).flat_map(fan)
}
