//! The spectrum, and its integrals in closed form against quadrature.

use proptest::prelude::*;
use wind_waves::{ALPHA, BETA, GRAVITY, WindSpectrum, exponential_integral, wave_number};

/// Simpson's rule over the logarithm of what is integrated.
fn integral(of: impl Fn(f64) -> f64, [low, high]: [f64; 2]) -> f64 {
    let (steps, ratio) = (4000, libm::log(high / low));
    let value = |step: i32| {
        let at = low * libm::exp(ratio * f64::from(step) / f64::from(steps));
        of(at) * at
    };
    let inner = |from: i32| (from..steps).step_by(2).map(value).sum::<f64>();
    ratio / f64::from(steps) / 3.0 * (value(0) + 4.0 * inner(1) + 2.0 * inner(2) + value(steps))
}

#[test]
fn the_exponential_integral_has_the_values_of_tables() {
    // Table 5.1 of Abramowitz and Stegun: 0.5597735948 and 0.2193839344; 0.1000195824 lies on the other side of the switch.
    for (x, expected) in [(0.5, 0.559_773_594_8), (1.0, 0.219_383_934_4), (1.5, 0.100_019_582_4)] {
        assert!((exponential_integral(x) - expected).abs() < 1e-10, "{x}");
    }
    let across = [1.5, 1.5 + 1e-12].map(exponential_integral);
    assert!((across[0] / across[1] - 1.0).abs() < 1e-11, "both forms meet: {across:?}");
    for x in [1e-6, 0.02, 0.9, 1.6, 4.0, 30.0] {
        let by_quadrature = integral(|t| libm::exp(-t) / t, [x, x + 60.0]);
        assert!((exponential_integral(x) / by_quadrature - 1.0).abs() < 1e-7, "{x}");
    }
}

#[test]
fn the_sea_of_ten_metres_a_second_is_that_of_the_textbook() {
    let sea = WindSpectrum::new(10.0).unwrap();
    // Hs = 2 sqrt(a / b) U^2 / g, and 0.877 g / U.
    let height = 2.0 * (ALPHA / BETA).sqrt() * 100.0 / GRAVITY;
    assert!((sea.significant_height() - height).abs() < 1e-12 && (height - 2.1337).abs() < 1e-4);
    assert!((sea.peak() * 10.0 / GRAVITY - 0.877).abs() < 1e-3);
    let beside = [0.999, 1.0, 1.001].map(|share| sea.density(share * sea.peak()));
    assert!(beside[0] < beside[1] && beside[2] < beside[1]);
    assert!((wave_number(2.0) * GRAVITY - 4.0).abs() < 1e-15);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn integrals_are_those_of_the_density(wind in 0.5..50.0f64, low in 0.3..3.0f64, width in 1.05..20.0f64) {
        let sea = WindSpectrum::new(wind).unwrap();
        let ends = [low * sea.peak(), low * width * sea.peak()];
        let variance = sea.variance_below(ends[1]) - sea.variance_below(ends[0]);
        let found = integral(|at| sea.density(at), ends);
        prop_assert!((variance - found).abs() <= 1e-9 * sea.variance(), "{} {}", variance, found);
        let slopes = sea.slope_variance_below(ends[1]) - sea.slope_variance_below(ends[0]);
        let squared = |at: f64| wave_number(at) * wave_number(at) * sea.density(at);
        let found = integral(squared, ends);
        prop_assert!((slopes - found).abs() <= 1e-9 * slopes.max(1e-3), "{} {}", slopes, found);
    }
}
