//! The differentiator: slopes, and the noise it makes.

use std::f64::consts::PI;

use parts::{Differentiator, NoiseSource, SecondOrderState, differentiated_noise};

use crate::assert_near;

#[test]
fn a_ramp_comes_out_as_its_slope() {
    let (h, tau_d) = (50e-9, 1e-6);
    for tau_f in [0.0, 1e-15, 10e-9, 80e-9] {
        let part = Differentiator::<f64>::new(h, tau_d, tau_f);
        let mut state = SecondOrderState::default();
        let mut out = 0.0;
        for n in 1..=400 {
            out = part.step(&mut state, 1e3 * h * f64::from(n - 1), 1e3 * h * f64::from(n));
            // Two equal lags: 1 - e^-x (1 + x).
            let x = f64::from(n) * h / tau_f;
            let late = if x > 700.0 { 0.0 } else { libm::exp(-x) * (1.0 + x) };
            assert_near(out, tau_d * 1e3 * (1.0 - late), 1e-14);
        }
        assert_near(state.y, 1e3 * (h * 400.0 - 2.0 * tau_f), 1e-12);
        assert_near(out, 1e-3, 1e-14);
    }
}

/// Noise white up to `bandwidth` and nothing above: many sine waves of one size each, phases by their normal pair.
struct Band {
    waves: Vec<[f64; 3]>,
}

impl Band {
    fn new(bandwidth: f64, sigma: f64, count: u64) -> Self {
        let source = NoiseSource::new(3, "band", 0);
        let size = sigma / (count as f64).sqrt();
        let wave = |k: u64| {
            let omega = 2.0 * PI * bandwidth * (k as f64 + 0.5) / count as f64;
            [omega, size * source.normal(0, 2 * k), size * source.normal(0, 2 * k + 1)]
        };
        Self { waves: (0..count).map(wave).collect() }
    }

    fn at(&self, t: f64) -> f64 {
        self.waves.iter().map(|&[omega, a, b]| a * libm::cos(omega * t) + b * libm::sin(omega * t)).sum()
    }
}

#[test]
fn white_noise_comes_out_as_two_pi_band_over_root_three() {
    // 10 MHz and 1 mV: 36 mV a microsecond.
    let (bandwidth, sigma) = (10e6, 1e-3);
    let exact = differentiated_noise(sigma, bandwidth);
    assert_near(exact * 1e-6, 36.3e-3, 0.05e-3);
    let h = 1.0 / (2.0 * bandwidth) / 25.0;
    let band = Band::new(bandwidth, sigma, 500);
    // Lags far above the band.
    let part = Differentiator::<f64>::new(h, 1.0, 0.2e-9);
    let mut state = SecondOrderState::default();
    let (mut sum, mut before, steps) = (0.0, band.at(0.0), 20_000);
    for n in 1..=steps {
        let u = band.at(f64::from(n) * h);
        let out = part.step(&mut state, before, u);
        before = u;
        sum += if n > 100 { out * out } else { 0.0 };
    }
    let found = (sum / f64::from(steps - 100)).sqrt();
    assert_near(found / exact, 1.0, 0.04);
}
