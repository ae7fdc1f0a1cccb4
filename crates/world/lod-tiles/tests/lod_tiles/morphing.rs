//! Where vertices go, and that both ends are exact.

use crate::edges::Dice;
use lod_tiles::{Edges, State, Stitch, Surface, Terrain, Tile, TileState};

/// One tile of the order n with heights by vertex.
fn tile(order: u32, height: impl Fn(f64, f64) -> f64) -> Terrain {
    let places: Vec<f64> = (0..=(1 << order)).map(f64::from).collect();
    let heights = places.iter().flat_map(|&y| places.iter().map(move |&x| [x, y]));
    let heights = heights.map(|[x, y]| height(x, y)).collect();
    Terrain::new(order, [places.clone(), places], heights).unwrap()
}

const ONLY: Tile = Tile { column: 0, row: 0 };

/// Height of a vertex at a level and a fraction.
fn at(terrain: &Terrain, level: usize, fraction: f64, vertex: [usize; 2]) -> f64 {
    let state = State::of(terrain, vec![TileState { level, fraction }]);
    Surface { terrain, state: &state, levels: 3, edges: Edges::Shared, stitch: Stitch::FineSide }
        .height(ONLY, vertex)
}

/// Check values of 9.3: what a vertex loses on its way.
#[test]
fn vertices_lose_the_deltas_of_the_check_values() {
    let bump =
        |x: f64, y: f64| 3.0 * x * x + 5.0 * y * y + x * y + if (x, y) == (1.0, 1.0) { 7.0 } else { 0.0 };
    let terrain = tile(2, bump);
    let delta = |level: usize, vertex: [usize; 2]| {
        at(&terrain, level, 0.0, vertex) - at(&terrain, level, 1.0, vertex)
    };
    let fine = [([1, 0], -3.0), ([0, 1], -5.0), ([1, 1], 0.0), ([3, 1], -7.0), ([1, 2], -3.0), ([2, 2], 0.0)];
    for (vertex, expected) in fine {
        assert_eq!(delta(0, vertex), expected, "{vertex:?}");
    }
    assert_eq!((delta(1, [1, 0]), delta(1, [1, 1])), (-12.0, -28.0));
}

/// At fraction 0 a level is itself, and at fraction 1 it is the next one.
#[test]
fn both_ends_are_exact() {
    let mut dice = Dice(5);
    let heights: Vec<f64> = (0..33 * 33).map(|_| 1e3 * dice.next()).collect();
    let places: Vec<f64> = (0..33).map(f64::from).collect();
    let terrain = Terrain::new(5, [places.clone(), places], heights).unwrap();
    let of = |level: usize, fraction: f64, place: [f64; 2]| {
        let state = State::of(&terrain, vec![TileState { level, fraction }]);
        let surface = Surface {
            terrain: &terrain,
            state: &state,
            levels: 6,
            edges: Edges::Shared,
            stitch: Stitch::FineSide,
        };
        surface.under(place)
    };
    for level in 0..4 {
        for vertex in [[1, 0], [0, 1], [1, 1], [2, 1]] {
            assert_eq!(at(&terrain, level, 0.0, vertex), terrain.height(ONLY, level, vertex));
        }
        for _ in 0..2000 {
            let place = [32.0 * dice.next(), 32.0 * dice.next()];
            let gone = of(level, 1.0, place) - of(level + 1, 0.0, place);
            assert!(gone.abs() < 1e-10, "level {level} at {place:?}: {gone}");
        }
    }
}

/// Halfway it is halfway, everywhere.
#[test]
fn morphing_is_linear_in_the_fraction() {
    let mut dice = Dice(9);
    let terrain = tile(3, |x, y| 40.0 * libm::sin(0.7 * x) + 25.0 * libm::cos(1.3 * y));
    for _ in 0..500 {
        let place = [8.0 * dice.next(), 8.0 * dice.next()];
        let of = |fraction: f64| {
            let state = State::of(&terrain, vec![TileState { level: 0, fraction }]);
            let surface = Surface {
                terrain: &terrain,
                state: &state,
                levels: 2,
                edges: Edges::Shared,
                stitch: Stitch::FineSide,
            };
            surface.under(place)
        };
        assert!((of(0.5) - (of(0.0) + of(1.0)) / 2.0).abs() < 1e-12);
    }
}
