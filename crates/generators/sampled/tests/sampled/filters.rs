//! Filters that reach beyond a pixel, over the borders of sub-areas and of the screen.

use crate::shots::Shot;
use generator::PlaneKind;
use raster::Filter;

const SIDE: u32 = 26;

/// Red of a lamp that is seen at a place on the screen (pixels).
fn lamp_at(filter: Filter, at: [f64; 2]) -> Vec<f64> {
    let mut shot = Shot::new(SIDE, SIDE, 150.0);
    shot.run.sampling.filter = filter;
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
        shot.run.sampling.filter = filter;
        shot.effects.sheets = vec![shot.filling(0, 5.0, [0.25, 0.5, 0.75], 0.0)];
        let frame = shot.draw();
        for index in 0..(SIDE * SIDE) as usize {
            let found = frame.colour(index);
            let far = found.iter().zip([0.25, 0.5, 0.75]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(far < 1e-7, "{filter:?}, {index}: {found:?}");
        }
    }
}

/// Mean of the sampling points of pattern `4` under the lamp's disc (pixels).
fn middle_of_covered(at: [f64; 2]) -> [f64; 2] {
    let (mut sum, mut count) = ([0.0; 2], 0.0);
    for pixel in 0..SIDE * SIDE {
        for offset in [[12.0, 4.0], [28.0, 12.0], [4.0, 20.0], [20.0, 28.0]] {
            let corner = [pixel % SIDE, pixel / SIDE].map(f64::from);
            let point: [f64; 2] = [0, 1].map(|axis| corner[axis] + offset[axis] / 32.0);
            if libm::hypot(point[0] - at[0], point[1] - at[1]) < 1.95 / 2.0 {
                sum = [sum[0] + point[0], sum[1] + point[1]];
                count += 1.0;
            }
        }
    }
    sum.map(|along| along / count)
}

/// A tent of 2 pixels spreads each sampling point over the pixels about it and leaves its middle where it is.
#[test]
fn a_tent_leaves_light_where_it_is() {
    for step in 0..40 {
        let at = [10.0 + 0.17 * f64::from(step), 11.0 + 0.13 * f64::from(step)];
        let red = lamp_at(Filter::Tent, at);
        let side = SIDE as usize;
        let place = |index: usize| [index % side, index / side].map(|pixel| pixel as f64 + 0.5);
        let moment = |axis: usize| -> f64 {
            red.iter().enumerate().map(|(index, light)| light * place(index)[axis]).sum()
        };
        let light: f64 = red.iter().sum();
        let expected = middle_of_covered(at);
        for axis in 0..2 {
            let found = moment(axis) / light;
            assert!((found - expected[axis]).abs() < 1e-5, "{at:?}: {found}, not {}", expected[axis]);
        }
    }
}
