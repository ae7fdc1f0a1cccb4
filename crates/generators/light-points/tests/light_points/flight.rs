//! Lamps that move: past the eye, and out of the screen.

use light_points::{
    Accumulation, Disc, LeastDiameter, Share, Veil, count_under, mask_under, projected_diameter,
};
use raster::{Pattern, Sampling};

use crate::focal;

#[test]
fn from_50_m_to_5_km_the_frame_gets_light_by_the_inverse_square() {
    for (pattern, least_disc, any_disc) in [(Pattern::Four, 0.28, 0.33), (Pattern::Grid16, 0.14, 0.14)] {
        let sampling = Sampling::new(pattern);
        let least = LeastDiameter::new(LeastDiameter::DEFAULT, &sampling).expect("wide enough");
        let mut most = [0.0f64; 2];
        for step in 0..2000 {
            let distance = 50.0 * libm::pow(100.0, f64::from(step) / 1999.0);
            let disc = Disc::of_lamp(projected_diameter(0.3, distance, focal()).expect("sound"), 1.0, least);
            let middle = [20.0 + 7.3 * f64::from(step) / 1999.0, 20.0 + libm::sin(f64::from(step))];
            let covered = count_under(middle, disc.diameter, &sampling);
            let frame = |intensity: f64| intensity * f64::from(covered) / sampling.count() as f64;
            let expected = 8.126944682202 * (100.0 / distance) * (100.0 / distance);
            let normalised = frame(disc.normalised(covered, sampling.count())) / expected;
            assert!((normalised - 1.0).abs() < 1e-9, "{normalised} at {distance} m");
            let most = &mut most[usize::from(disc.diameter > least.pixels())];
            *most = most.max((frame(disc.intensity) / expected - 1.0).abs());
        }
        println!("{}: raw twinkle of the least disc and of wider ones {most:?}", pattern.name());
        assert!(most[0] < least_disc && most[1] < any_disc && most[0] > 0.05, "{}: {most:?}", pattern.name());
    }
}

/// Numbers of the samples under a disc on a screen of 16 x 16 pixels.
fn on_screen(middle: [f64; 2], diameter: f64, sampling: &Sampling) -> Vec<usize> {
    let pixels = (0..256).map(|i| [i % 16, i / 16]);
    let count = sampling.count();
    let samples = pixels.enumerate().flat_map(|(number, pixel)| {
        let mask = mask_under(middle, diameter, pixel, sampling);
        (0..count).filter(move |i| mask >> i & 1 == 1).map(move |i| number * count + i)
    });
    samples.collect()
}

#[test]
fn a_lamp_that_leaves_sideways_stays_as_it_is_until_its_last_sample() {
    let sampling = Sampling::new(Pattern::Sixteen);
    let (mut gone, mut seen) = (0, 0);
    for step in 0..200 {
        let middle = [14.0 + 0.02 * f64::from(step), 7.7];
        let covered = on_screen(middle, 1.5, &sampling);
        let share = Veil::new(256 * 16, Accumulation::Points).read_out(covered.iter().copied(), |_| 1.0, 0.5);
        match share.display(0.7) {
            Some(shown) => {
                assert!((shown - 0.7).abs() < 1e-15 && gone == 0, "{shown} at {middle:?}");
                seen += 1;
            }
            None => gone += 1,
        }
        // In the raster its light leaves with its disc.
        let disc = Disc { diameter: 1.5, intensity: 0.7 };
        let whole = count_under(middle, 1.5, &sampling);
        let frame = disc.normalised(whole, 16) * covered.len() as f64 / 16.0;
        let share = frame / disc.light();
        assert!((share - covered.len() as f64 / f64::from(whole)).abs() < 1e-12 && share <= 1.0 + 1e-12);
    }
    assert!(seen > 100 && gone > 50, "{seen} {gone}");
    assert_eq!(Share::default().display(0.7), None);
}
