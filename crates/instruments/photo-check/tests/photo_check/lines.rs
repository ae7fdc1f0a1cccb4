//! The line drawing: posts where the camera has them, heights magnified about their mean.

use photo_camera::voids::Fill;
use photo_check::drawing;

use crate::{elevation, filled, from_above, ground};

/// All corners of the paths of a drawing.
fn corners(svg: &str) -> Vec<[f64; 2]> {
    let paths = svg.split(" d=\"").skip(1).filter_map(|rest| rest.split('"').next());
    let pieces = paths.flat_map(|path| path.split(['M', 'L']).filter(|piece| !piece.is_empty()));
    let numbers = |piece: &str| {
        let (i, j) = piece.split_once(' ').expect("two numbers");
        [i, j].map(|number| number.parse().expect("a number"))
    };
    pieces.map(numbers).collect()
}

fn nearest(corners: &[[f64; 2]], [i, j]: [f64; 2]) -> f64 {
    corners.iter().map(|corner| libm::hypot(corner[0] - i, corner[1] - j)).fold(f64::INFINITY, f64::min)
}

/// From 1000 m above, 2 m a pixel: a post that is `rise` m higher lies `1000 / (1000 - rise)` times as far from the middle.
#[test]
fn a_peak_lies_where_its_magnified_height_puts_it() {
    let ground =
        ground(&elevation([21, 21], |n, e| if n == 50.0 && e == 150.0 { 30.0 } else { 10.0 }), &from_above());
    for magnify in [1.0, 10.0] {
        let corners = corners(&drawing(&ground, &from_above(), magnify));
        let mean = 10.0 + 20.0 / 441.0;
        let height = mean + magnify * (30.0 - mean);
        let scale = 1000.0 / (1000.0 - height) / 2.0;
        let expected = [50.0 + 50.0 * scale, 50.0 + 50.0 * scale];
        let off = nearest(&corners, expected);
        assert!(off < 0.08, "{magnify}: {off} pixels");
    }
}

#[test]
fn every_post_of_a_small_grid_is_drawn_and_nothing_else() {
    let ground = ground(&elevation([6, 8], |_, _| 0.0), &from_above());
    let svg = drawing(&ground, &from_above(), 10.0);
    let found = corners(&svg);
    // Six rows of 8 and eight columns of 6.
    assert_eq!(found.len(), 96);
    assert!(nearest(&found, [0.0, 100.0]) < 0.06 && nearest(&found, [35.0, 75.0]) < 0.06, "{svg}");
    assert!(svg.contains("viewBox=\"0 0 100 100\"") && svg.contains("heights times 10"));
}

#[test]
fn former_voids_are_amber_and_voids_are_gaps() {
    let made = elevation([7, 7], |n, e| if n == 30.0 && e == 30.0 { f64::NAN } else { 1.0 });
    let path =
        |svg: &str| svg.split(" d=\"").nth(2).expect("a path").split('"').next().expect("ends").to_owned();
    let amber = path(&drawing(&filled(&made, &from_above(), Fill::Harmonic), &from_above(), 10.0));
    assert_eq!(amber.matches('L').count(), 4);
    let left = drawing(&filled(&made, &from_above(), Fill::Leave), &from_above(), 10.0);
    assert_eq!(path(&left), "");
    assert_eq!(left.matches('L').count(), 2 * 7 * 6 - 4);
}
