//! The sum of sines against the integrals of its spectrum.

use std::f64::consts::{FRAC_PI_2, TAU};

use proptest::prelude::*;
use wind_waves::{GRAVITY, Wind, WindSpectrum, WindWaves};

use super::BREEZE;

/// Both ends of the band (rad/s).
fn band(wind: &Wind) -> [f64; 2] {
    [0.5 * WindSpectrum::new(wind.speed).unwrap().peak(), (GRAVITY * TAU / wind.shortest).sqrt()]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn variance_and_slopes_are_the_integrals(
        speed in 3.0..30.0f64, seed in any::<u64>(), components in 1..200u32, towards in -7.0..7.0f64, shortest in 0.5..5.0f64,
    ) {
        let wind = Wind { speed, towards, seed, components, shortest };
        let (waves, spectrum) = (WindWaves::new(&wind).unwrap(), WindSpectrum::new(speed).unwrap());
        let [low, high] = band(&wind);
        let expected = spectrum.variance_below(high) - spectrum.variance_below(low);
        prop_assert!((waves.variance() / expected - 1.0).abs() < 1e-12);
        let slopes = waves.slope_variance(towards) + waves.slope_variance(towards + FRAC_PI_2);
        let expected = spectrum.slope_variance_below(high) - spectrum.slope_variance_below(low);
        prop_assert!((slopes / expected - 1.0).abs() < 1e-9, "{} {}", slopes, expected);
    }
}

#[test]
fn nearly_all_of_the_height_of_the_spectrum_is_in_the_sum() {
    let spectrum = WindSpectrum::new(BREEZE.speed).unwrap();
    let share = WindWaves::new(&BREEZE).unwrap().variance() / spectrum.variance();
    assert!(share > 0.99 && share < 1.0, "{share}");
}

/// Three quarters of the slope lie along the wind: the mean of cos^2 under a density of cos^2.
#[test]
fn slopes_lie_along_the_wind() {
    let share = |seed: u64| {
        let waves = WindWaves::new(&Wind { seed, ..BREEZE }).unwrap();
        let along = waves.slope_variance(BREEZE.towards);
        along / (along + waves.slope_variance(BREEZE.towards + FRAC_PI_2))
    };
    let mean = (0..200).map(share).sum::<f64>() / 200.0;
    assert!((mean - 0.75).abs() < 0.01, "{mean}");
}

#[test]
fn a_seed_names_a_sea() {
    let of = |seed| WindWaves::new(&Wind { seed, ..BREEZE }).unwrap();
    assert_eq!(of(1), of(1));
    assert_ne!(of(1), of(2));
}
