//! A lamp that moves by hundredths of a pixel (acceptance test 10).

use crate::shots::{Shot, is_same_sum};
use generator::PlaneKind;
use raster::Pattern;
use scenario::LightPoint;

/// Least and largest light of a lamp of 1.5 pixels, as a share of what it should be, while it moves over a pixel.
fn range(pattern: Pattern, normalise: bool, calligraphic: bool) -> [f64; 2] {
    let focal = 150.0;
    let mut shot = Shot::new(20, 20, focal);
    (shot.run.sampling.pattern, shot.run.sampling.normalise) = (pattern, normalise);
    let mut range = [f64::INFINITY, 0.0_f64];
    for step in 0..200 {
        // Across a hundredth of a pixel a step; down along the golden ratio, so that all of the pixel is seen.
        let at = [9.5 + f64::from(step % 100) / 100.0, 9.5 + (f64::from(step) * 0.618_034).fract()];
        let distance = 100.0;
        let lamp = shot.lamp(0, at, distance / shot.eye().ray(at).length(), 1.0);
        shot.effects.lights = vec![LightPoint { calligraphic, intensity: 0.5, ..lamp }];
        let light = shot.draw().sum(PlaneKind::Red);
        let share = light / (0.5 * std::f64::consts::PI * 1.5 * 1.5 / 4.0);
        range = [range[0].min(share), range[1].max(share)];
    }
    range
}

#[test]
fn light_that_is_not_normalised_twinkles_as_the_pattern_says() {
    for (pattern, least, most) in [(Pattern::Four, 0.849, 1.273), (Pattern::Grid16, 0.920, 1.132)] {
        let [found_least, found_most] = range(pattern, false, false);
        assert!((found_least - least).abs() < 0.001, "{}: {found_least}", pattern.name());
        assert!((found_most - most).abs() < 0.001, "{}: {found_most}", pattern.name());
    }
}

#[test]
fn normalised_and_calligraphic_light_does_not_twinkle() {
    for pattern in [Pattern::Four, Pattern::Grid16] {
        for calligraphic in [false, true] {
            let [least, most] = range(pattern, true, calligraphic);
            assert!(
                is_same_sum(least, 1.0) && is_same_sum(most, 1.0),
                "{}: {least} to {most}",
                pattern.name()
            );
        }
    }
}
