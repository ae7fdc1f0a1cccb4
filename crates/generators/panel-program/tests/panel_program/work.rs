//! Work of the listing, counted by the program and once more from its results.

use panel_program::{FillPieces, Program, Work, WrittenFill};

use crate::block::{block, observer, usual};
use crate::counts::as_written;

/// The block from an observer: work, and whole-number places of the posts on the screen.
fn seen(number: usize) -> (Program, Work, Vec<[i64; 2]>) {
    let program = Program::new(&block(0.0), crate::block::lie(), usual(), as_written()).unwrap();
    let view = observer(number);
    let places = program.posts_on_screen(&view);
    let whole = places.iter().map(|(place, _)| place.map(|at| at.trunc() as i64)).collect();
    let work = program.draw(&view).unwrap().listing;
    (program, work, whole)
}

#[test]
fn work_before_the_picture_follows_from_posts_and_panels() {
    let (program, work, _) = seen(1);
    // 9 x 12 posts, 176 panels, a frame of 512 x 512.
    assert_eq!([work.numbers, work.bytes, work.rows, work.affine], [49_980, 262_144, 9, 1]);
    assert_eq!([work.visits, work.placed, work.referenced], [216, 108, 108]);
    assert_eq!([work.projected, work.measured, work.panels], [108, 108, 176]);
    let pixels: u64 = program.panels().iter().map(|panel| u64::from(panel.grey.pixels)).sum();
    assert_eq!(work.averaged, pixels);
    // A cell covers 30.8 m x 24.6 m: 697 pixels of 1.043 m, and the box of a cell is larger, since north is turned in the photograph.
    assert!((88 * 690..88 * 900).contains(&pixels), "{pixels}");
}

#[test]
fn work_of_the_fill_is_that_of_its_boxes() {
    let (program, Work { fill, .. }, places) = seen(1);
    let picture = program.draw(&observer(1)).unwrap();
    let counts = picture.counts;
    assert_eq!([fill.cells, fill.panels, fill.records], [2 * 262_144, 176, 512]);
    assert_eq!(fill.written.buckets, counts.filled * 524, "512 buckets and 12 words a panel that is filled");
    // Boxes of panels inside the screen that are not edge-on.
    let inside = program.panels().iter().filter_map(|panel| {
        let corners = panel.posts.map(|post| places[post]);
        let is_inside = corners.iter().flatten().all(|at| (1..=512).contains(at));
        let [a, b, c] = corners;
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        let side = |axis: usize| {
            let along = corners.map(|corner| corner[axis]);
            along.iter().max().unwrap() - along.iter().min().unwrap() + 1
        };
        (is_inside && area != 0).then(|| (side(0) * side(1)) as u64)
    });
    let boxes: Vec<u64> = inside.collect();
    assert_eq!((boxes.len() as u64, fill.written.boxed), (counts.filled, boxes.iter().sum()));
    let writes: u64 = picture.writes.iter().map(|writes| u64::from(*writes)).sum();
    assert_eq!(fill.pixels, writes);
    assert!(writes <= fill.written.marked && fill.written.marked < fill.written.boxed);
}

#[test]
fn panels_beyond_the_screen_cost_their_record_alone() {
    let (_, Work { fill, .. }, _) = seen(3);
    let nothing = WrittenFill::default();
    let pixels = 0;
    assert_eq!(fill, FillPieces { cells: 524_288, panels: 176, written: nothing, pixels, records: 512 });
}
