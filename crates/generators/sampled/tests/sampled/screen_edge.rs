//! A lamp that leaves the screen (acceptance test 12).

use crate::shots::{Frame, Shot, is_same};
use generator::PlaneKind;
use scenario::LightPoint;

const COLUMNS: u32 = 16;
const FOCAL: f64 = 200.0;

/// The lamp `beyond` pixels right of the edge of a screen, on a screen that is `wider` by so many pixels to either side.
fn leaving(beyond: f64, wider: u32, calligraphic: bool) -> Frame {
    let mut shot = Shot::new(COLUMNS + 2 * wider, 16, FOCAL);
    // The sharpest spot, so that its light is in its pixel.
    shot.run.sampling.spot = 0.05;
    let at = [f64::from(COLUMNS + wider) + beyond, 6.1];
    let lamp = shot.lamp(0, at, 100.0 / shot.eye().ray(at).length(), 1.0);
    shot.effects.lights = vec![LightPoint { calligraphic, intensity: 0.7, ..lamp }];
    shot.draw()
}

/// A disc of 2 pixels leaves between 1 pixel before the edge and 1 behind it.
#[test]
fn a_lamp_at_the_edge_is_as_bright_as_within() {
    for calligraphic in [false, true] {
        for step in 0..60 {
            let beyond = f64::from(step) / 20.0 - 1.51;
            let (narrow, wide) = (leaving(beyond, 0, calligraphic), leaving(beyond, 8, calligraphic));
            let [narrow_red, wide_red] = [&narrow, &wide].map(|frame| frame.plane(PlaneKind::Red));
            for index in 0..(COLUMNS * 16) as usize {
                let [column, line] = [index % COLUMNS as usize, index / COLUMNS as usize];
                let other = wide_red[line * (COLUMNS as usize + 16) + column + 8];
                let (found, expected) = (f64::from(narrow_red[index]), f64::from(other));
                assert!(is_same(found / 2.0, expected / 2.0), "{beyond}: {found}, not {expected}");
            }
            let light = narrow.sum(PlaneKind::Red);
            assert_eq!(light == 0.0, wide_red_left(&wide) == 0.0, "{beyond}");
            assert!(beyond < 1.0 || light == 0.0, "{beyond}: {light}");
        }
    }
}

/// Light that the wide screen has where the narrow one is.
fn wide_red_left(wide: &Frame) -> f64 {
    let rows = wide.plane(PlaneKind::Red).chunks_exact(COLUMNS as usize + 16);
    rows.flat_map(|row| &row[8..8 + COLUMNS as usize]).copied().map(f64::from).sum()
}
