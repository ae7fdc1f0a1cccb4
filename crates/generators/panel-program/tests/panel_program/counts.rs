//! How many panels of the real set each observer gets to see, and where the block falls on the screen.

use panel_program::{Fill, Picture, Posts, Program, Restrictions, Settings, View};

use crate::block::{block, lie, observer, posts, usual};

pub fn as_written() -> Settings {
    Settings {
        restrictions: Restrictions::as_written(),
        fill: Fill::EdgeBuffer,
        outside: 0.0,
        marks_voids: false,
        blends_borders: false,
    }
}

fn program(posts: &Posts, settings: Settings) -> Program {
    Program::new(posts, lie(), usual(), settings).unwrap()
}

/// Least and greatest column and row of the posts, cut to whole numbers.
fn range(program: &Program, view: &View) -> [[i64; 2]; 2] {
    let places = program.posts_on_screen(view);
    [0, 1].map(|axis| {
        let along = || places.iter().map(|(place, _)| place[axis].trunc() as i64);
        [along().min().unwrap(), along().max().unwrap()]
    })
}

fn discarded(picture: &Picture) -> [u64; 2] {
    [picture.counts.panels(), picture.counts.discarded]
}

/// Panels and lost panels of each observer as written, and where the posts fall. The ranges of the specification are those of 53 bits; with 24 the
/// picture stands a third of a row higher.
fn seen(posts: &Posts) -> [([u64; 2], [[i64; 2]; 2]); 3] {
    let written = program(posts, as_written());
    let restrictions = Restrictions { real4: false, ..Restrictions::as_written() };
    let fine = program(posts, Settings { restrictions, ..as_written() });
    [1, 2, 3].map(|number| {
        let view = observer(number);
        let counts = [&written, &fine].map(|program| discarded(&program.draw(&view).unwrap()));
        assert_eq!(counts[0], counts[1]);
        (counts[0], range(&fine, &view))
    })
}

#[test]
fn the_flat_set_loses_three_panels_none_and_all() {
    let found = seen(&posts(0.0, |_, _| 3.0));
    assert_eq!(found[0], ([176, 3], [[-10, 471], [188, 204]]));
    assert_eq!(found[1], ([176, 0], [[318, 496], [80, 82]]));
    assert_eq!((found[2].0, found[2].1[1]), ([176, 176], [694, 888]));
}

#[test]
fn the_block_stands_where_the_specification_has_it() {
    let found = seen(&block(0.0));
    assert_eq!(found[0], ([176, 3], [[-10, 471], [59, 204]]));
    assert_eq!(found[1], ([176, 0], [[318, 496], [30, 82]]));
    assert_eq!((found[2].0, found[2].1[1]), ([176, 176], [378, 888]));
}

#[test]
fn the_near_edge_of_the_upper_block_is_2_65_times_as_long_from_near() {
    let restrictions = Restrictions { skewed_axes: true, quadrant: true, ..Restrictions::default() };
    let program = program(&block(0.0), Settings { restrictions, ..as_written() });
    let ends = [1, 2].map(|number| {
        let places = program.posts_on_screen(&observer(number));
        // Row 74, columns 176 and 179.
        [3 * 12 + 4, 3 * 12 + 7].map(|post| places[post].0)
    });
    let expected = [[175.162488, 301.412257], [384.706583, 432.377769]];
    for (ends, expected) in ends.iter().zip(expected) {
        assert!(
            (ends[0][0] - expected[0]).abs() < 1e-5 && (ends[1][0] - expected[1]).abs() < 1e-5,
            "{ends:?}"
        );
    }
    assert!((ends[0][0][1] - 60.91).abs() < 0.01, "{ends:?}");
}
