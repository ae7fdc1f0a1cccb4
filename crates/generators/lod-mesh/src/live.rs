//! Slopes of the ground as it is drawn, so that light moves with the vertices.

use glam::DVec3;
use lod_tiles::{Side, Surface, Tile};
use rayon::prelude::*;

use crate::ground::Mesh;

/// Slopes of all vertices to the north and to the east (m/m), by the heights of the surface a cell away on both sides. The cell is that of the
/// coarsest tile that has the vertex, so both sides of an edge agree.
pub fn slopes(surface: &Surface<'_>, mesh: &Mesh) -> Vec<[f64; 2]> {
    let tiles: Vec<_> = mesh.tiles().collect();
    let parts =
        tiles.into_par_iter().map(|(tile, vertices)| of_tile(surface, tile, &mesh.vertices[vertices]));
    let parts: Vec<Vec<[f64; 2]>> = parts.collect();
    parts.into_iter().flatten().collect()
}

/// Slopes of the vertices of a tile: its own row by row, then those of finer neighbours.
fn of_tile(surface: &Surface<'_>, tile: Tile, vertices: &[DVec3]) -> Vec<[f64; 2]> {
    let cells = surface.terrain.cells(surface.tile_state(tile).level);
    let number = |[i, j]: [usize; 2]| j * (cells + 1) + i;
    let slope = |at: [usize; 2]| {
        let is_inside = at.iter().all(|index| (1..cells).contains(index));
        if !is_inside {
            return across(surface, vertices[number(at)], step(surface, tile, at));
        }
        let [i, j] = at;
        let [west, east, south, north] =
            [[i - 1, j], [i + 1, j], [i, j - 1], [i, j + 1]].map(|at| vertices[number(at)]);
        [(north.z - south.z) / (north.x - south.x), (east.z - west.z) / (east.y - west.y)]
    };
    let own = (0..=cells).flat_map(|j| (0..=cells).map(move |i| [i, j]));
    let inserted = vertices[(cells + 1) * (cells + 1)..].iter();
    own.map(slope).chain(inserted.map(|vertex| across(surface, *vertex, surface.cell(tile)))).collect()
}

/// Slopes between the surface a `step` (east, north; m) before and behind a vertex. Where the ground ends they are one-sided.
fn across(surface: &Surface<'_>, vertex: DVec3, step: [f64; 2]) -> [f64; 2] {
    let [low, high] = surface.terrain.extent();
    let along = |axis: usize| {
        let place = [vertex.y, vertex.x];
        let ends = [-1.0, 1.0].map(|sign| {
            let mut end = place;
            end[axis] = (place[axis] + sign * step[axis]).clamp(low[axis], high[axis]);
            end
        });
        let [before, behind] = ends.map(|end| surface.under(end));
        (behind - before) / (ends[1][axis] - ends[0][axis])
    };
    [along(1), along(0)]
}

/// Cells (east, north; m) of the coarsest tile that has a vertex.
fn step(surface: &Surface<'_>, tile: Tile, at: [usize; 2]) -> [f64; 2] {
    let cells = surface.terrain.cells(surface.tile_state(tile).level);
    let beyond = |side: Side, tile: Tile| side.beyond(surface.terrain, tile);
    let sides: Vec<Side> = Side::ALL.into_iter().filter(|side| side.holds(at, cells)).collect();
    let mut tiles = vec![tile];
    tiles.extend(sides.iter().filter_map(|side| beyond(*side, tile)));
    // At a corner the tile across it has the vertex too.
    if let [first, second] = sides[..] {
        tiles.extend(beyond(first, tile).and_then(|next| beyond(second, next)));
    }
    let cell = |tile: &Tile| surface.cell(*tile);
    tiles.iter().map(cell).fold([0.0; 2], |most, cell| [most[0].max(cell[0]), most[1].max(cell[1])])
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use lod_tiles::{Edges, State, Stitch, Terrain, TileState};
    use quantities::unit_interval;

    use super::*;

    /// 3 x 3 tiles of random levels over random heights: a vertex has one slope, whichever tile it is asked of.
    #[test]
    fn both_sides_of_an_edge_have_the_same_slopes() {
        for seed in 0..40 {
            let random = |word: u64| unit_interval(seed, &[word]);
            let places: Vec<f64> = (0..25).map(f64::from).collect();
            let heights = (0..625).map(|post| 10.0 * random(post)).collect();
            let terrain = Terrain::new(3, [places.clone(), places], heights).unwrap();
            let tile =
                |number: u64| TileState { level: (3.0 * random(1000 + number)) as usize, fraction: 0.0 };
            let state = State::of(&terrain, (0..9).map(tile).collect());
            let surface = Surface {
                terrain: &terrain,
                state: &state,
                levels: 4,
                edges: Edges::Shared,
                stitch: Stitch::CoarseSide,
            };
            let mut known = BTreeMap::new();
            for tile in terrain.tiles() {
                let vertices: Vec<DVec3> =
                    surface.mesh(tile).vertices.iter().map(|[x, y, z]| DVec3::new(*y, *x, *z)).collect();
                for (vertex, slopes) in vertices.iter().zip(of_tile(&surface, tile, &vertices)) {
                    let first = *known.entry([vertex.x, vertex.y].map(f64::to_bits)).or_insert(slopes);
                    assert!((0..2).all(|axis| (first[axis] - slopes[axis]).abs() < 1e-9), "{seed}: {vertex}");
                }
            }
        }
    }
}
