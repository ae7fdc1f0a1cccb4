//! Borders of panels blended: two sides of a border have one mean, outlines stay sharp.

use panel_program::{Fill, NO_PANEL, Picture, Program, Restrictions, Settings};

use crate::block::{block, lie, observer, usual};

/// Panels of the block from observer 1, repaired, and the picture with borders or without.
fn drawn(blends_borders: bool) -> (Program, Picture) {
    let settings = Settings {
        restrictions: Restrictions::only("quadrant").unwrap(),
        fill: Fill::Span,
        outside: 0.0,
        marks_voids: false,
        blends_borders,
    };
    let program = Program::new(&block(0.0), lie(), usual(), settings).unwrap();
    let picture = program.draw(&observer(1)).unwrap();
    (program, picture)
}

/// Whether pixels show two panels that share a side.
fn is_border(program: &Program, picture: &Picture, pixels: [usize; 2]) -> bool {
    let [a, b] = pixels.map(|pixel| picture.panel[pixel]);
    let posts = |panel: u32| program.panels()[panel as usize].posts;
    a != b
        && ![a, b].contains(&NO_PANEL)
        && posts(a).into_iter().filter(|post| posts(b).contains(post)).count() == 2
}

#[test]
fn both_sides_of_a_border_have_the_mean() {
    let ((program, plain), (_, blended)) = (drawn(false), drawn(true));
    assert_eq!((&plain.panel, &plain.distance), (&blended.panel, &blended.distance));
    let inside = |pixel: &usize| (1..511).contains(&(pixel % 512)) && (1..511).contains(&(pixel / 512));
    let (mut upright, mut sharp) = (0, 0);
    for pixel in (0..512 * 512).filter(inside) {
        let across = [pixel - 1, pixel + 1, pixel - 512, pixel + 512]
            .map(|next| is_border(&program, &plain, [pixel, next]).then_some(next));
        match across {
            // A pixel far from any border, or beside sky and farther ground alone.
            [None, None, None, None] => {
                assert_eq!(blended.light[pixel], plain.light[pixel]);
                let beside = [pixel + 1, pixel + 512].map(|next| plain.panel[next] != plain.panel[pixel]);
                sharp += usize::from(beside.contains(&true));
            }
            [None, Some(right), None, None] => {
                let mean = (plain.light[pixel] + plain.light[right]) / 2.0;
                assert!((blended.light[pixel] - mean).abs() < 1e-6);
                upright += 1;
            }
            _ => {}
        }
    }
    assert!(upright > 100 && sharp > 100, "{upright} borders, {sharp} outlines");
}
