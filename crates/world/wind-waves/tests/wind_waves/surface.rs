//! The water at a time: slopes, travel, statistics and bounds.

use std::f64::consts::TAU;

use proptest::prelude::*;
use quantities::unit_interval;
use wind_waves::{GRAVITY, Wind, WindSpectrum, WindWaves};

use super::BREEZE;

/// A sum of one sine, and its length (m), which its slopes and heights tell.
fn one_sine() -> (WindWaves, f64) {
    let waves = WindWaves::new(&Wind { components: 1, ..BREEZE }).unwrap();
    let slopes = waves.slope_variance(0.0) + waves.slope_variance(TAU / 4.0);
    let length = TAU / (slopes / waves.variance()).sqrt();
    (waves, length)
}

/// A wave of length L has the period of deep water, `sqrt(2 pi L / g)`.
#[test]
fn a_wave_comes_back_after_the_period_of_deep_water() {
    let (waves, length) = one_sine();
    let period = (TAU * length / GRAVITY).sqrt();
    let height = |time: f64| waves.at(time).at([3.0, -8.0]).height;
    for time in [0.0, 0.31, 2.0] {
        assert!((height(time) - height(time + period)).abs() < 1e-9);
        assert!((height(time) + height(time + period / 2.0)).abs() < 1e-9);
    }
    assert!((height(0.0) - height(period / 3.0)).abs() > 1e-3);
}

/// Crests run to where the wind blows: what is here now is a little farther on later.
#[test]
fn waves_run_with_the_wind() {
    let (waves, length) = one_sine();
    let speed = (GRAVITY * length / TAU).sqrt();
    let (now, later) = (waves.at(0.0), waves.at(0.25));
    // The direction of the one sine is that of its slopes.
    let slopes = now.at([0.0; 2]).slopes;
    let size = libm::hypot(slopes[0], slopes[1]);
    let (sin, cos) = quantities::sin_cos(BREEZE.towards);
    let along = slopes.map(|slope| slope / size);
    let sense = (along[0] * cos + along[1] * sin).signum();
    let way = along.map(|part| part * sense * speed * 0.25);
    for place in [[0.0, 0.0], [13.0, 40.0]] {
        let farther = [place[0] + way[0], place[1] + way[1]];
        assert!((now.at(place).height - later.at(farther).height).abs() < 1e-9, "{place:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn slopes_are_differences_within_their_bounds(
        place in proptest::array::uniform2(-2000.0..2000.0f64), time in 0.0..3000.0f64, seed in any::<u64>(),
    ) {
        let surface = WindWaves::new(&Wind { seed, ..BREEZE }).unwrap().at(time);
        let rise = surface.at(place);
        prop_assert!(rise.height.abs() <= surface.crest());
        for axis in 0..2 {
            let beside = |by: f64| {
                let mut place = place;
                place[axis] += by;
                surface.at(place)
            };
            let difference = (beside(1e-4).height - beside(-1e-4).height) / 2e-4;
            prop_assert!((rise.slopes[axis] - difference).abs() < 1e-6);
            let change = (beside(0.5).slopes[axis] - rise.slopes[axis]).abs();
            prop_assert!(change <= 0.5 * surface.bend());
        }
    }
}

/// Heights at random places: four standard deviations are the significant height, and the mean is the calm water.
#[test]
fn heights_have_the_spread_of_the_spectrum() {
    let places = 4000;
    let mut sums = [0.0; 2];
    for number in 0..places {
        let of = |word| 4e4 * unit_interval(9, &[number, word]);
        let wind = Wind { seed: number % 40, ..BREEZE };
        let height = WindWaves::new(&wind).unwrap().at(of(2)).at([of(0), of(1)]).height;
        sums = [sums[0] + height, sums[1] + height * height];
    }
    let [mean, square] = sums.map(|sum| sum / places as f64);
    let expected = WindSpectrum::new(BREEZE.speed).unwrap().significant_height();
    assert!((4.0 * square.sqrt() / expected - 1.0).abs() < 0.03, "{square}");
    assert!(mean.abs() < 0.05, "{mean}");
}
