//! How far the ground is along the view axis, in 64 bits and by the triangles themselves.

use glam::DVec3;
use lod_tiles::{Surface, Tile};
use scene_sampler::Camera;

use crate::ground::Mesh;
use crate::prepared::Prepared;

/// Share of a triangle's area by which the axis may miss it and meet it all the same: on an edge of two, rounding may put it beside both.
const ROUNDING: f64 = 1e-12;

/// Distance (m) along the axis of `camera` to a surface; infinite where it meets none.
pub fn sounding(prepared: &Prepared, surface: &Surface<'_>, camera: &Camera) -> f64 {
    let tiles = surface.terrain.tiles().zip(&prepared.posts.heights);
    let met =
        tiles.filter(|(tile, heights)| may_meet(surface, *tile, [*heights.start(), *heights.end()], camera));
    let meshes = met.map(|(tile, _)| Mesh::of_tile(surface, tile, camera));
    meshes.map(|mesh| along(&mesh)).fold(f64::INFINITY, f64::min)
}

/// Whether the axis may meet a tile: it passes through the bounds of the corners of its box, as seen along the axis.
fn may_meet(surface: &Surface<'_>, tile: Tile, [low, high]: [f64; 2], camera: &Camera) -> bool {
    let cells = surface.terrain.cells(0);
    let on_map =
        [[0, 0], [cells, 0], [0, cells], [cells, cells]].map(|at| surface.terrain.place(tile, 0, at));
    let drop = on_map
        .map(|[east, north]| camera.drop_at(DVec3::new(north, east, 0.0)))
        .into_iter()
        .fold(0.0, f64::max);
    let corners = on_map.into_iter().flat_map(|[east, north]| {
        [low - drop, high].map(|up| camera.direction(DVec3::new(north, east, up) - camera.eye))
    });
    let (least, most) = corners.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(least, most), corner| {
        (least.min(corner), most.max(corner))
    });
    least.x <= 0.0 && most.x >= 0.0 && least.y <= 0.0 && most.y >= 0.0 && most.z > 0.0
}

/// Least depth (m) at which the axis meets a mesh.
fn along(mesh: &Mesh) -> f64 {
    let corners = |triangle: &[u32; 3]| triangle.map(|corner| mesh.places[corner as usize]);
    mesh.triangles.iter().filter_map(|triangle| along_axis(corners(triangle))).fold(f64::INFINITY, f64::min)
}

/// Depth (m) at which the axis meets a triangle in camera axes.
fn along_axis([a, b, c]: [DVec3; 3]) -> Option<f64> {
    let cross = |p: DVec3, q: DVec3| p.x * q.y - p.y * q.x;
    let parts = [cross(b, c), cross(c, a), cross(a, b)];
    let area: f64 = parts.iter().sum();
    let shares = parts.map(|part| part / area);
    let depth = shares[0] * a.z + shares[1] * b.z + shares[2] * c.z;
    let is_met = area != 0.0 && shares.iter().all(|share| *share >= -ROUNDING);
    (is_met && depth > 0.0).then_some(depth)
}
