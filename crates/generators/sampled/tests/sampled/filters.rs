//! Filters that reach beyond a pixel, over the borders of sub-areas and of the screen.

use crate::shots::Shot;
use generator::PlaneKind;
use raster::Filter;

const SIDE: u32 = 26;

/// Red of a lamp that is seen at a place on the screen (pixels).
fn lamp_at(filter: Filter, at: [f64; 2]) -> Vec<f64> {
    let mut shot = Shot::new(SIDE, SIDE, 150.0);
    shot.run.filter = filter;
    shot.pose.eye[2] = 100.0;
    let distance = 100.0;
    shot.effects.lights = vec![shot.lamp(0, at, distance / shot.eye().ray(at).length(), 1.3)];
    shot.draw().plane(PlaneKind::Red).iter().copied().map(f64::from).collect()
}

#[test]
fn a_filter_does_not_show_where_sub_areas_meet() {
    for filter in [Filter::Box, Filter::Tent, Filter::Gaussian] {
        let first = lamp_at(filter, [10.3, 11.6]);
        let light: f64 = first.iter().sum();
        let area = std::f64::consts::PI * 1.95 * 1.95 / 4.0;
        assert!((light / area - 1.0).abs() < 1e-7, "{filter:?}: {light}");
        for shift in 1..9 {
            let moved = lamp_at(filter, [10.3 + f64::from(shift), 11.6 + f64::from(shift)]);
            let by = (shift * SIDE + shift) as usize;
            for (one, other) in first.iter().zip(&moved[by..]) {
                assert!((one - other).abs() < 1e-7, "{filter:?}, {shift}: {one} {other}");
            }
        }
    }
}

#[test]
fn an_even_picture_stays_even_up_to_the_border() {
    for filter in [Filter::Box, Filter::Tent, Filter::Gaussian] {
        let mut shot = Shot::new(SIDE, SIDE, 150.0);
        shot.run.filter = filter;
        shot.effects.sheets = vec![shot.filling(0, 5.0, [0.25, 0.5, 0.75], 0.0)];
        let frame = shot.draw();
        for index in 0..(SIDE * SIDE) as usize {
            let found = frame.colour(index);
            let far = found.iter().zip([0.25, 0.5, 0.75]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(far < 1e-7, "{filter:?}, {index}: {found:?}");
        }
    }
}
