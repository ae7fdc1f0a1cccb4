//! What is counted of a tile is what its mesh has.

use crate::edges::{Dice, line, rough};
use crate::flight::{levels, moving, terrain};
use lod_tiles::{Edges, Side, State, Stitch, Surface, TileMesh, TilePieces, TileState};

const STITCHES: [Stitch; 3] = [Stitch::CoarseSide, Stitch::FineSide, Stitch::None];
const EDGES: [Edges; 2] = [Edges::Shared, Edges::PerTile];

/// Every way to draw random states over random ground.
fn each_surface(states: usize, see: impl Fn(&Surface<'_>)) {
    let mut dice = Dice(11);
    for _ in 0..states {
        let terrain = rough(&mut dice);
        let mut fraction = || [0.0, 1.0, dice.next()][(3.0 * dice.next()) as usize];
        let fractions: Vec<f64> = (0..9).map(|_| fraction()).collect();
        let tiles = fractions
            .into_iter()
            .map(|fraction| TileState { level: (4.0 * dice.next()) as usize, fraction })
            .collect();
        let state = State::of(&terrain, tiles);
        for (edges, stitch, levels) in EDGES
            .into_iter()
            .flat_map(|edges| STITCHES.map(|stitch| [3, 4].map(|levels| (edges, stitch, levels))))
            .flatten()
        {
            // Levels beyond the last one there is are none.
            if state.tiles().iter().all(|tile| tile.level < levels) {
                see(&Surface { terrain: &terrain, state: &state, levels, edges, stitch });
            }
        }
    }
}

#[test]
fn pieces_are_those_of_the_mesh() {
    each_surface(100, |surface| {
        for tile in surface.terrain.tiles() {
            let TileMesh { vertices, origins, triangles } = surface.mesh(tile);
            let TilePieces { inner, border, still, morphing } = surface.pieces(tile);
            let moved = origins.iter().filter(|origin| origin.share > 0.0).count() as u64;
            assert_eq!((inner + border, still + morphing), (triangles.len() as u64, vertices.len() as u64));
            assert_eq!(morphing, moved, "{:?}", surface.tile_state(tile));
        }
    });
}

/// The document's example: a tile of 32 cells has 30 x 30 cells that touch no side.
#[test]
fn inner_faces_touch_no_side() {
    let (terrain, levels) = (terrain(), levels());
    let state = State::new(&terrain, &levels, moving(1800));
    let surface =
        Surface { terrain: &terrain, state: &state, levels: 3, edges: Edges::Shared, stitch: Stitch::None };
    let finest = terrain.tiles().find(|tile| surface.tile_state(*tile).level == 0).unwrap();
    let TilePieces { inner, border, .. } = surface.pieces(finest);
    assert_eq!((inner, border), (1800, 248));
}

/// Edges whose sides draw lines with a gap, by the lines themselves.
fn gaps(surface: &Surface<'_>) -> u64 {
    let terrain = surface.terrain;
    let edges = terrain.tiles().flat_map(|tile| [(tile, Side::Right, 0), (tile, Side::Top, 1)]);
    let has_gap = |(tile, side, axis): (lod_tiles::Tile, Side, usize)| {
        let Some(other) = side.beyond(terrain, tile) else { return false };
        let edge = (axis, terrain.place(other, 0, [0, 0])[axis]);
        let [own, beyond] = [tile, other].map(|tile| line(surface, tile, edge));
        own.iter().zip(&beyond).any(|(own, beyond)| (own - beyond).abs() > 1e-9)
    };
    edges.filter(|edge| has_gap(*edge)).count() as u64
}

#[test]
fn cracked_edges_are_those_with_a_gap() {
    let most = std::cell::Cell::new(0);
    each_surface(100, |surface| {
        let found = surface.cracked_edges();
        assert_eq!(found, gaps(surface), "{:?} {:?} {:?}", surface.edges, surface.stitch, surface.state);
        most.set(most.get().max(found));
    });
    assert_eq!(most.get(), 12, "all edges of 3 x 3 tiles crack in some state");
}
