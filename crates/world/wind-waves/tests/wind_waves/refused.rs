//! Winds that raise no such waves.

use wind_waves::{Wind, WindSpectrum, WindWaves};

use super::BREEZE;

#[test]
fn figures_out_of_range_are_refused_by_name() {
    let told = |wind: Wind| WindWaves::new(&wind).unwrap_err().to_string();
    assert_eq!(told(Wind { speed: 0.2, ..BREEZE }), "wind (m/s) is 0.2: expected 0.5 to 50");
    assert!(told(Wind { speed: f64::NAN, ..BREEZE }).starts_with("wind (m/s) is NaN"));
    assert!(told(Wind { towards: f64::INFINITY, ..BREEZE }).starts_with("azimuth of the wind (rad) is inf"));
    assert_eq!(told(Wind { components: 0, ..BREEZE }), "number of sines is 0: expected 1 to 4096");
    assert!(told(Wind { shortest: 0.0, ..BREEZE }).starts_with("length of the shortest wave (m) is 0"));
    assert!(WindSpectrum::new(50.1).is_err());
}

#[test]
fn a_band_without_its_peak_is_refused_with_the_peak() {
    let told = WindWaves::new(&Wind { speed: 2.0, shortest: 5.0, ..BREEZE }).unwrap_err().to_string();
    assert!(told.contains("shortest wave is 5 m") && told.contains("3.33 m long"), "{told}");
}
