//! Errors of the database against the surface that `lod-tiles` draws.

use lod_tiles::{Edges, Stitch, Surface, Terrain, TileState};

use crate::{USUAL, exported};

/// At every post of every tile, the drawn level lies within the stated error, and at one post it reaches the error.
#[test]
fn stated_errors_are_those_of_the_drawn_levels() {
    let (_, exported) = exported(USUAL);
    let contents = exported.database.contents().clone();
    let terrain = Terrain::new(contents.order, contents.places, contents.heights).unwrap();
    for level in 0..=contents.order as usize {
        let states = vec![TileState { level, fraction: 0.0 }; exported.database.tiles().len()];
        let state = lod_tiles::State::of(&terrain, states);
        let levels = terrain.cells(0).ilog2() as usize + 1;
        let surface = Surface {
            terrain: &terrain,
            state: &state,
            levels,
            edges: Edges::Shared,
            stitch: Stitch::FineSide,
        };
        for tile in terrain.tiles() {
            let stated = exported.database.tile(terrain.number(tile)).errors[level];
            let side = terrain.cells(0);
            // Inner posts alone: a border belongs to two tiles.
            let posts = (1..side).flat_map(|j| (1..side).map(move |i| [i, j]));
            let found = posts.map(|post| {
                let drawn = surface.under(terrain.place(tile, 0, post));
                (drawn - terrain.height(tile, 0, post)).abs()
            });
            let found = found.fold(0.0, f64::max);
            assert!(found <= stated + 1e-9, "level {level}, tile {tile:?}: {found} above {stated}");
            assert!(
                level == 0 || found > 0.3 * stated || stated < 1e-9,
                "level {level}, tile {tile:?}: {found} of {stated}"
            );
        }
    }
}
