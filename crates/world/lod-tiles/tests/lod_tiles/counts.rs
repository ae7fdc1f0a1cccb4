//! Triangles of tiles, the neighbour rule, and terrains that cannot be.

use crate::flight::{levels, moving, terrain};
use lod_tiles::{Edges, State, Stitch, Surface, Terrain, Tile, TileError, TileState};

fn surface<'a>(terrain: &'a Terrain, state: &'a State) -> Surface<'a> {
    Surface { terrain, state, levels: 6, edges: Edges::Shared, stitch: Stitch::FineSide }
}

fn whole(level: usize) -> TileState {
    TileState { level, fraction: 0.0 }
}

#[test]
fn a_level_has_a_quarter_of_the_triangles() {
    let places: Vec<f64> = (0..33).map(f64::from).collect();
    let terrain = Terrain::new(5, [places.clone(), places], vec![0.0; 33 * 33]).unwrap();
    let count = |level| {
        surface(&terrain, &State::of(&terrain, vec![whole(level)]))
            .triangles(Tile { column: 0, row: 0 })
            .len()
    };
    assert_eq!([0, 1, 2, 3, 4, 5].map(count), [2048, 512, 128, 32, 8, 2]);
}

/// Check values of 9.2: one coarser side takes m / 2 triangles.
#[test]
fn a_stitched_side_has_fewer_triangles() {
    for (order, expected) in [(1, 7), (2, 30), (3, 124)] {
        let cells = 1usize << order;
        let x: Vec<f64> = (0..=2 * cells).map(|k| k as f64).collect();
        let y: Vec<f64> = (0..=cells).map(|k| k as f64).collect();
        let posts = x.len() * y.len();
        let terrain = Terrain::new(order, [x, y], vec![0.0; posts]).unwrap();
        let state = State::of(&terrain, vec![whole(0), whole(1)]);
        assert_eq!(surface(&terrain, &state).triangles(Tile { column: 0, row: 0 }).len(), expected);
        let area: f64 =
            surface(&terrain, &state).triangles(Tile { column: 0, row: 0 }).iter().map(area).sum();
        assert!((area - (cells * cells) as f64).abs() < 1e-9, "no hole and no overlap: {area}");
    }
}

/// Area on the map, above 0 where corners run counter-clockwise.
fn area([p, q, r]: &[[f64; 3]; 3]) -> f64 {
    ((q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1])) / 2.0
}

/// Check values of 9.2 for the whole ground of the flight.
#[test]
fn the_ground_of_the_flight_has_the_triangles_of_the_document() {
    let (terrain, levels) = (terrain(), levels());
    let count = |frame: usize| {
        let state = State::new(&terrain, &levels, moving(frame));
        terrain.tiles().map(|tile| surface(&terrain, &state).triangles(tile).len()).sum::<usize>()
    };
    assert_eq!([0, 900, 1500].map(count), [3200, 12800, 46528]);
}

#[test]
fn neighbours_are_one_level_apart() {
    let places: Vec<f64> = (0..41).map(f64::from).collect();
    let terrain = Terrain::new(3, [places.clone(), places], vec![0.0; 41 * 41]).unwrap();
    let mut tiles = vec![TileState { level: 3, fraction: 0.25 }; 25];
    tiles[12] = whole(0);
    let state = State::of(&terrain, tiles);
    let level = |number: usize| state.tile(number).level;
    assert_eq!([level(12), level(11), level(10), level(7), level(6), level(0)], [0, 1, 2, 1, 2, 3]);
    assert_eq!(
        (state.tile(11).fraction, state.tile(0).fraction),
        (1.0, 0.25),
        "refined ones look like the coarser level"
    );
}

#[test]
fn terrains_that_are_none_are_refused() {
    let places = |count: usize| (0..count).map(|k| k as f64).collect::<Vec<f64>>();
    let of = |order: u32, x: Vec<f64>, heights: Vec<f64>| Terrain::new(order, [x, places(5)], heights);
    assert_eq!(of(13, places(5), vec![]), Err(TileError::Order(13)));
    assert_eq!(of(2, places(6), vec![]), Err(TileError::Posts { axis: 'x', posts: 6, side: 4 }));
    assert_eq!(of(2, places(1), vec![]), Err(TileError::Posts { axis: 'x', posts: 1, side: 4 }));
    assert_eq!(of(2, vec![0.0, 1.0, 1.0, 2.0, 3.0], vec![]), Err(TileError::Places { axis: 'x', index: 2 }));
    assert_eq!(of(2, places(5), vec![0.0; 24]), Err(TileError::Heights { found: 24, expected: 25 }));
    let mut heights = vec![0.0; 25];
    heights[7] = f64::NAN;
    assert_eq!(of(2, places(5), heights), Err(TileError::Void(7)));
}
