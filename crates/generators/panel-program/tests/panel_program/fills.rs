//! Five ways to fill find the same pixels.

use panel_program::{Fill, Filler};
use quantities::unit_interval;
use raster::Point;

const SIZE: [usize; 2] = [61, 47];

/// Pixels of a triangle, in order of rows; each only once.
fn pixels(way: Fill, corners: [Point; 3]) -> Vec<[usize; 2]> {
    let mut found = Vec::new();
    let mut filler = Filler::new(way, SIZE);
    filler.fill(corners, |column, row| found.push([row, column]));
    assert_eq!(filler.work.found, found.len() as u64, "{way:?}");
    found.sort_unstable();
    assert!(found.windows(2).all(|pair| pair[0] < pair[1]), "{way:?} found a pixel twice");
    found
}

/// Whether a pixel's centre lies in a triangle without an edge through a centre.
fn is_inside(corners: [[f64; 2]; 3], pixel: [usize; 2]) -> bool {
    let [y, x] = pixel.map(|at| at as f64 + 0.5);
    let sides = [0, 1, 2].map(|k| {
        let ([ax, ay], [bx, by]) = (corners[k], corners[(k + 1) % 3]);
        (bx - ax) * (y - ay) - (by - ay) * (x - ax)
    });
    sides.iter().all(|side| *side > 0.0) || sides.iter().all(|side| *side < 0.0)
}

#[test]
fn all_ways_find_the_same_pixels() {
    let mut most = 0;
    for seed in 0..600 {
        let random = |word: u64| unit_interval(seed, &[word]);
        // Every third triangle is a sliver, every fifth has whole and half coordinates, and many reach beyond the screen.
        let corners = [0, 1, 2].map(|k| {
            let spread = if seed % 3 == 0 && k > 0 { 0.05 } else { 1.0 };
            let at = |axis: u64| {
                let place = random(2 * k + axis) * spread + random(9 + axis) * (1.0 - spread);
                let side = SIZE[axis as usize] as f64;
                let place = -7.0 + place * (side + 14.0);
                if seed % 5 == 0 { (2.0 * place).round() / 2.0 } else { place }
            };
            Point::snap([at(0), at(1)]).unwrap()
        });
        let expected = pixels(Fill::Rasteriser, corners);
        most = most.max(expected.len());
        for (word, way) in Fill::ALL {
            assert_eq!(pixels(way, corners), expected, "seed {seed}, {word}");
        }
        if seed % 5 != 0 {
            let places = corners.map(Point::position);
            let all = (0..SIZE[1]).flat_map(|row| (0..SIZE[0]).map(move |column| [row, column]));
            assert!(all.filter(|pixel| is_inside(places, *pixel)).eq(expected), "seed {seed}");
        }
    }
    assert!(most > 500, "{most}");
}

#[test]
fn buffers_cost_their_box_and_spans_their_pixels() {
    let corners = [[3.0, 3.0], [43.0, 3.0], [3.0, 43.0]].map(|place| Point::snap(place).unwrap());
    let work = |way| {
        let mut filler = Filler::new(way, SIZE);
        filler.fill(corners, |_, _| ());
        filler.work
    };
    let buffer = work(Fill::EdgeBuffer);
    // 47 buckets and 40 x 40 cells; every pixel of the triangle is marked, every cell scanned.
    assert_eq!([buffer.cleared, buffer.marked, buffer.scanned], [47 + 1600, buffer.found, 1600]);
    let span = work(Fill::Span);
    assert_eq!([span.cleared, span.marked, span.scanned, span.tested], [0; 4]);
    assert_eq!(work(Fill::Rasteriser).scanned, 36, "6 x 6 squares");
    assert!(work(Fill::Fence).marked > buffer.marked && work(Fill::Seed).tested > buffer.found);
}
