//! Check values of the specification: the synthesised view as written, depth, voids, signed greys.

use glam::DVec3;
use panel_program::{DepthPlane, Fill, NoDepth, Program, Restrictions, Settings};

use crate::block::{COLUMNS, ROWS, lie, observer, posts, usual};

/// The axes and the quadrant of the listing, in 53 bits.
fn axes() -> Restrictions {
    Restrictions { skewed_axes: true, quadrant: true, ..Restrictions::default() }
}

/// Column, row and distance of the post in row 75 and column 177, 5 m high, with this height at the first post of the last row.
fn of_post(last: f64) -> ([f64; 2], f64) {
    let height = |row: usize, column: usize| match (row, column) {
        (75, 177) => 5.0,
        (79, 172) => last,
        _ => 3.0,
    };
    let settings = Settings {
        restrictions: axes(),
        fill: Fill::Span,
        outside: 0.0,
        marks_voids: false,
        blends_borders: false,
    };
    let program = Program::new(&posts(0.0, height), lie(), usual(), settings).unwrap();
    let number = (75 - ROWS[0]) * (COLUMNS[1] - COLUMNS[0] + 1) + 177 - COLUMNS[0];
    program.posts_on_screen(&observer(1))[number]
}

#[test]
fn the_synthesised_view_is_that_of_the_specification() {
    let close = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-6, "{found} {expected}");
    let ([column, row], distance) = of_post(3.0);
    close(column, 220.446287262816);
    close(row, 192.426359279036);
    close(distance, 2843.404686597175);
    // A rise of 9 m along the first column pitches the axes.
    let ([column, row], _) = of_post(12.0);
    close(column, 219.859953415324);
    close(row, 192.813341452537);
}

#[test]
fn depth_of_the_listing_is_linear_on_the_screen() {
    let corners = [[56.0, 306.0], [456.0, 306.0], [256.0, 249.75]];
    let places = [[-20.0, 5.0, 50.0], [20.0, 5.0, 50.0], [0.0, -5.0, 400.0]];
    let lifted =
        [0, 1, 2].map(|k| DVec3::new(corners[k][0], corners[k][1], DVec3::from_array(places[k]).length()));
    let plane = DepthPlane::written(lifted).unwrap();
    let found = plane.at([256.0, 287.25]);
    assert!((found - 169.399262347771).abs() < 1e-9, "{found}");
    let DepthPlane::Written { coefficients } = plane else { panic!("the listing's") };
    for (found, expected) in coefficients.iter().zip([0.0, -0.003176683033620, -0.000516518179477]) {
        assert!((found - expected).abs() < 1e-14, "{coefficients:?}");
    }
}

#[test]
fn a_panel_of_ordinary_size_is_lost_to_its_determinant() {
    let corners = [[100.0, 100.0, 90.0], [200.0, 100.0, 130.0], [100.0, 200.0, 140.0]];
    assert_eq!(DepthPlane::written(corners.map(DVec3::from_array)), Err(NoDepth::Determinant));
    let line = [[1.0, 1.0, 5.0], [2.0, 2.0, 6.0], [3.0, 3.0, 9.0]];
    assert_eq!(DepthPlane::written(line.map(DVec3::from_array)), Err(NoDepth::EdgeOn));
}
