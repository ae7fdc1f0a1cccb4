//! Both sides of an edge draw the same line, whatever the levels and fractions.

use crate::flight::{levels, moving, terrain};
use lod_tiles::{Edges, State, Stitch, Surface, Terrain, Tile, TileState};

/// Heights along a side of a tile as it is drawn: the broken line through the corners of its triangles there, at every post of the finest level.
pub fn line(surface: &Surface<'_>, tile: Tile, (axis, at): (usize, f64)) -> Vec<f64> {
    let cells = surface.terrain.cells(0);
    let mut corners: Vec<[f64; 2]> = surface
        .triangles(tile)
        .iter()
        .flatten()
        .filter(|corner| corner[axis] == at)
        .map(|corner| [corner[1 - axis], corner[2]])
        .collect();
    corners.sort_by(|a, b| a[0].total_cmp(&b[0]));
    corners.dedup_by(|a, b| a[0] == b[0]);
    let (first, last) = (corners[0][0], corners[corners.len() - 1][0]);
    (0..=cells)
        .map(|k| {
            let place = first + (last - first) * k as f64 / cells as f64;
            let next =
                corners.iter().position(|corner| corner[0] >= place).unwrap_or(corners.len() - 1).max(1);
            let ([a, low], [b, high]) = (corners[next - 1], corners[next]);
            low + (high - low) * (place - a) / (b - a)
        })
        .collect()
}

/// Largest gap (m) between the two sides of any edge.
fn largest_gap(terrain: &Terrain, state: &State, edges: Edges, stitch: Stitch) -> f64 {
    let surface = Surface { terrain, state, levels: 3, edges, stitch };
    let [columns, rows] = terrain.counts();
    let mut largest = 0.0f64;
    for tile in terrain.tiles() {
        let [x, y] = terrain.place(tile, 0, [32, 32]);
        let right = (tile.column + 1 < columns).then_some((Tile { column: tile.column + 1, ..tile }, (0, x)));
        let top = (tile.row + 1 < rows).then_some((Tile { row: tile.row + 1, ..tile }, (1, y)));
        for (other, edge) in [right, top].into_iter().flatten() {
            let [own, beyond] = [tile, other].map(|tile| line(&surface, tile, edge));
            largest = own.iter().zip(&beyond).map(|(a, b)| (a - b).abs()).fold(largest, f64::max);
        }
    }
    largest
}

fn every_twentieth(edges: Edges, stitch: Stitch, switched: bool) -> f64 {
    let (terrain, levels) = (terrain(), levels());
    let gap = |frame: usize| {
        let state = State::new(&terrain, &levels, moving(frame));
        let state = if switched { state.switched() } else { state };
        largest_gap(&terrain, &state, edges, stitch)
    };
    (0..=1800).step_by(20).map(gap).fold(0.0, f64::max)
}

/// Check values of 9.4: 6e-14 m, 1.50 m, 8.19 m.
#[test]
fn gaps_over_the_flight_are_those_of_the_document() {
    assert!(every_twentieth(Edges::Shared, Stitch::FineSide, false) < 1e-12);
    assert!(every_twentieth(Edges::Shared, Stitch::CoarseSide, false) < 1e-12);
    let per_tile = every_twentieth(Edges::PerTile, Stitch::FineSide, false);
    assert!((per_tile - 1.503545649337).abs() < 1e-9, "{per_tile}");
    let none = every_twentieth(Edges::PerTile, Stitch::None, true);
    assert!((none - 8.191682738822).abs() < 1e-9, "{none}");
}

/// Numbers from 0 to 1 by a counter.
pub struct Dice(pub u64);

impl Dice {
    pub fn next(&mut self) -> f64 {
        let unit = quantities::unit_interval(self.0, &[]);
        self.0 = quantities::hash_words(self.0, &[]);
        unit
    }
}

/// 3 x 3 tiles of 9 x 9 posts with random heights.
pub fn rough(dice: &mut Dice) -> Terrain {
    let places: Vec<f64> = (0..25).map(f64::from).collect();
    let heights = (0..625).map(|_| 100.0 * dice.next()).collect();
    Terrain::new(3, [places.clone(), places], heights).unwrap()
}

/// Heights of vertices that both tiles of an edge have, and of those that the coarser one lacks, against the line between its own.
fn worst_vertex(surface: &Surface<'_>, terrain: &Terrain) -> f64 {
    let [columns, rows] = terrain.counts();
    let mut worst = 0.0f64;
    for tile in terrain.tiles() {
        let right = (tile.column + 1 < columns).then_some((Tile { column: tile.column + 1, ..tile }, 0));
        let top = (tile.row + 1 < rows).then_some((Tile { row: tile.row + 1, ..tile }, 1));
        for (other, axis) in [right, top].into_iter().flatten() {
            let level = |tile| surface.state.tile(terrain.number(tile)).level;
            // Along the edge, in cells of the finest level.
            let at = |tile: Tile, k: usize, is_high: bool| {
                let across = if is_high { terrain.cells(level(tile)) } else { 0 };
                let along = k >> level(tile);
                surface.height(tile, if axis == 0 { [across, along] } else { [along, across] })
            };
            let coarse = 1 << level(tile).max(level(other));
            for k in (0..=8).step_by(coarse) {
                worst = worst.max((at(tile, k, true) - at(other, k, false)).abs());
            }
            let fine = 1 << level(tile).min(level(other));
            for k in (fine..8).step_by(2 * fine).filter(|_| fine < coarse) {
                let finer_is_own = level(tile) < level(other);
                let (finer, coarser) = if finer_is_own { (tile, other) } else { (other, tile) };
                let mean =
                    (at(coarser, k - fine, !finer_is_own) + at(coarser, k + fine, !finer_is_own)) / 2.0;
                worst = worst.max((at(finer, k, finer_is_own) - mean).abs());
            }
        }
    }
    worst
}

/// A hundred thousand random states: no gap above 1e-9 m; a fraction a tile cracks.
#[test]
fn random_states_have_no_gaps() {
    let mut dice = Dice(1);
    let (mut worst, mut worst_per_tile) = (0.0f64, 0.0f64);
    for _ in 0..200 {
        let terrain = rough(&mut dice);
        for _ in 0..500 {
            let tiles =
                (0..9).map(|_| TileState { level: (3.0 * dice.next()) as usize, fraction: dice.next() });
            let state = State::of(&terrain, tiles.collect());
            let surface = |edges| Surface {
                terrain: &terrain,
                state: &state,
                levels: 4,
                edges,
                stitch: Stitch::FineSide,
            };
            worst = worst.max(worst_vertex(&surface(Edges::Shared), &terrain));
            worst_per_tile = worst_per_tile.max(worst_vertex(&surface(Edges::PerTile), &terrain));
        }
    }
    assert!(worst < 1e-9 && worst_per_tile > 10.0, "{worst} {worst_per_tile}");
}

/// Corners of a tile's triangles on a line across the map, as bits, each once.
fn corners_on(surface: &Surface<'_>, tile: Tile, (axis, at): (usize, f64)) -> Vec<[u64; 3]> {
    let all = surface.triangles(tile);
    let on_line = all.iter().flatten().filter(|corner| corner[axis] == at);
    let mut corners: Vec<[u64; 3]> = on_line.map(|corner| corner.map(f64::to_bits)).collect();
    corners.sort_unstable();
    corners.dedup();
    corners
}

/// Twice the area of a triangle on the map.
fn doubled_area([a, b, c]: &[[f64; 3]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
}

#[test]
fn a_coarser_tile_has_the_vertices_of_its_neighbour_to_the_bit() {
    let mut dice = Dice(7);
    for _ in 0..300 {
        let terrain = rough(&mut dice);
        let tiles = (0..9).map(|_| TileState { level: (4.0 * dice.next()) as usize, fraction: dice.next() });
        let state = State::of(&terrain, tiles.collect());
        let surface = Surface {
            terrain: &terrain,
            state: &state,
            levels: 4,
            edges: Edges::Shared,
            stitch: Stitch::CoarseSide,
        };
        for tile in terrain.tiles() {
            let triangles = surface.triangles(tile);
            assert!(triangles.iter().all(|triangle| doubled_area(triangle) > 0.0));
            assert!((triangles.iter().map(doubled_area).sum::<f64>() - 128.0).abs() < 1e-9);
            for (column, row, axis) in [(1, 0, 0), (0, 1, 1)] {
                let other = Tile { column: tile.column + column, row: tile.row + row };
                if other.column < 3 && other.row < 3 {
                    let edge = (axis, terrain.place(other, 0, [0, 0])[axis]);
                    assert_eq!(corners_on(&surface, tile, edge), corners_on(&surface, other, edge));
                }
            }
        }
    }
}
