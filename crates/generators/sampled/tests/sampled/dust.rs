//! A lamp behind translucent sheets (acceptance test 8).

use crate::shots::{Frame, Shot};
use generator::PlaneKind;
use scenario::LightPoint;

/// The lamp behind black sheets of these shares.
fn behind(shares: &[f64], calligraphic: bool) -> Frame {
    let mut shot = Shot::new(24, 24, 300.0);
    let lamp = shot.lamp(0, [12.3, 9.1], 200.0, 1.0);
    shot.effects.lights = vec![LightPoint { calligraphic, intensity: 0.9, ..lamp }];
    shot.effects.sheets = (0..)
        .zip(shares)
        .map(|(id, share)| shot.filling(id, 10.0 * f64::from(id + 1), [0.0; 3], *share))
        .collect();
    shot.draw()
}

/// Compares all pixels of two frames, with the first one's light times a factor.
fn compare(clear: &Frame, dimmed: &Frame, factor: f64, is_same: impl Fn(f64, f64) -> bool) {
    let pixels = clear.plane(PlaneKind::Red).iter().zip(dimmed.plane(PlaneKind::Red));
    for (clear, dimmed) in pixels.map(|(clear, dimmed)| (f64::from(*clear), f64::from(*dimmed))) {
        assert!(is_same(dimmed, factor * clear), "{dimmed}, not {factor} times {clear}");
    }
    assert!(clear.sum(PlaneKind::Red) > 1.0);
}

#[test]
fn sheets_multiply_before_a_lamp() {
    for calligraphic in [false, true] {
        let clear = behind(&[], calligraphic);
        // Both planes are rounded to 24 bits.
        let twice = |found: f64, expected: f64| (found - expected).abs() <= expected / f64::from(1 << 23);
        compare(&clear, &behind(&[0.7, 0.5], calligraphic), 0.35, twice);
        // Powers of two leave the digits of both as they are.
        compare(&clear, &behind(&[0.5, 0.25], calligraphic), 0.125, |found, expected| found == expected);
    }
}
