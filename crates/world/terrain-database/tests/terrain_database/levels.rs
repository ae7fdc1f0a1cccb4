//! Errors of levels and bounds of tiles, by hand and by an independent surface.

use terrain_database::{Contents, Database};

use crate::{FRAME, ground, places};

fn database(order: u32, heights: Vec<f64>) -> Database {
    let side = 1 << order;
    Database::new(Contents::new(FRAME, order, [places(order, 1, side), places(order, 1, side)], heights))
        .unwrap()
}

#[test]
fn a_single_post_is_lost_whole() {
    let mut heights = vec![0.0; 25];
    heights[6] = 7.0;
    let database = database(2, heights);
    assert_eq!(database.tile(0).errors, [0.0, 7.0, 7.0]);
    assert_eq!(database.tile(0).bounds, [0.0, 7.0]);
    assert_eq!([0, 1, 2, 3].map(|level| database.error(level)), [0.0, 7.0, 7.0, 0.0]);
}

/// Cells are cut from top left to bottom right: one corner at the lower left leaves the middle of its cell at 0, one at the upper left
/// lifts it by half.
#[test]
fn the_diagonal_runs_from_top_left_to_bottom_right() {
    let corner = |post: usize| {
        let mut heights = vec![0.0; 9];
        heights[post] = 8.0;
        database(1, heights).tile(0).errors[1]
    };
    // Posts beside the corner are missed by 4 in every case; the middle by 0 or by 4.
    assert_eq!([corner(0), corner(2), corner(6), corner(8)], [4.0; 4]);
    let with_edges = |post: usize, edges: [usize; 2]| {
        let mut heights = vec![0.0; 9];
        heights[post] = 8.0;
        edges.iter().for_each(|edge| heights[*edge] = 4.0);
        database(1, heights).tile(0).errors[1]
    };
    assert_eq!(with_edges(0, [1, 3]), 0.0, "lower left");
    assert_eq!(with_edges(6, [3, 7]), 4.0, "upper left");
    assert_eq!(with_edges(2, [1, 5]), 4.0, "lower right");
    assert_eq!(with_edges(8, [5, 7]), 0.0, "upper right");
}

#[test]
fn planes_lose_nothing() {
    let heights = (0..81).map(|post| 2.0 * f64::from(post % 9) - 3.0 * f64::from(post / 9)).collect();
    assert_eq!(database(3, heights).tile(0).errors, [0.0; 4]);
}

/// Each tile is a terrain of its own with the same errors, borders with the next tile included.
#[test]
fn tiles_are_worked_out_one_by_one() {
    let all = Database::new(ground(8, 2, [3, 2], None)).unwrap();
    let width = all.contents().places[0].len();
    for (number, tile) in all.tiles().iter().enumerate() {
        let corner = 4 * (number / 3) * width + 4 * (number % 3);
        let heights =
            (0..25).map(|post| all.contents().heights[corner + post / 5 * width + post % 5]).collect();
        assert_eq!(database(2, heights).tile(0), tile, "tile {number}");
        assert!(tile.errors[1] > 0.0 && tile.bounds[0] < tile.bounds[1]);
    }
}
