//! What five ways to fill cost over the panels of the artificial block: cells, and with a way's word no more than its work.
//!
//! `cargo run -p panel-program --example fill_cost` prints the cells. With `edge-buffer`, `fence`, `seed`, `span` or `rasteriser` it fills one
//! frame by that way, and with `none` it fills nothing: `valgrind --tool=callgrind` then counts the instructions.

use std::hint::black_box;

use panel_program::{Fill, FillWork, Filler};
use raster::Point;

const SIZE: [usize; 2] = [512, 512];
/// Cells of ground along a side: 512 panels.
const CELLS: usize = 16;

/// Triangles of a ground in perspective: rows of cells from far to near, as wide as the screen at its foot.
fn ground() -> Vec<[Point; 3]> {
    let corner = |row: usize, column: usize| {
        let depth = 1.0 + (CELLS - row) as f64 / 4.0;
        let across = (column as f64 / CELLS as f64 - 0.5) * 1.1;
        Point::snap([256.0 + 460.0 * across / depth, 30.0 + 440.0 / depth]).expect("near the screen")
    };
    let cells = (0..CELLS).flat_map(|row| (0..CELLS).map(move |column| (row, column)));
    cells
        .flat_map(|(row, column)| {
            let [sw, se, nw, ne] =
                [(1, 0), (1, 1), (0, 0), (0, 1)].map(|(down, right)| corner(row + down, column + right));
            [[sw, se, nw], [se, ne, nw]]
        })
        .collect()
}

fn fill(way: Fill, ground: &[[Point; 3]]) -> FillWork {
    let mut filler = Filler::new(way, SIZE);
    let mut sum = 0;
    for corners in ground {
        filler.fill(*corners, |column, row| sum += column ^ row);
    }
    black_box(sum);
    filler.work
}

fn main() {
    let ground = ground();
    if let Some(word) = std::env::args().nth(1) {
        if let Some((_, way)) = Fill::ALL.iter().find(|(known, _)| *known == word) {
            fill(*way, black_box(&ground));
        }
        return;
    }
    for (word, way) in Fill::ALL {
        let FillWork { cleared, marked, scanned, tested, found } = fill(way, &ground);
        println!(
            "{word:>12}: {cleared} cleared, {marked} marked, {scanned} scanned, {tested} tested, {found} found"
        );
    }
}
