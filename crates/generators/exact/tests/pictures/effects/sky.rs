//! Stars, the Earth and the sun in whole pictures.

use super::*;

#[test]
fn a_star_is_hidden_by_ground_and_by_the_earth() {
    let bare = seen(Effects::default());
    let up = DVec3::new(1.0, 0.03, 0.1);
    let flux = |magnitude: f64| libm::exp10(-0.4 * magnitude);
    for magnitude in [-3.0, 0.03, 4.0] {
        let found = seen(lights(vec![star(up, magnitude)]));
        let expected = flux(magnitude) * PI * 1.5 * 1.5 / 4.0;
        assert!((sum(&found, &bare) / expected - 1.0).abs() < 1e-6, "{magnitude}");
    }
    let below = seen(lights(vec![star(DVec3::new(1.0, 0.03, -0.1), 0.0)]));
    assert_eq!(sum(&below, &bare), 0.0);
    let earth = SkyDisc { angular_diameter: radians(8.0), ..ball(up.normalize(), PI) };
    let dark = seen(Effects { discs: vec![earth], ..Effects::default() });
    let both = seen(Effects { discs: vec![earth], ..lights(vec![star(up, 0.0)]) });
    assert_eq!(sum(&both, &dark), 0.0);
}

/// Lit area by pixels within 3 %, and the light of a ball of Lambert's law within 0.5 %.
#[test]
fn the_earth_has_its_phase() {
    let settings = narrow(3.0);
    // Only sky: the eye looks over the edge of the ground from far above.
    let pose = pose([50.0, 100.0, 1e5], 0.0, 0.0);
    let radius = focal(&settings) * libm::tan(radians(1.899 / 2.0));
    for degrees in [0.0, 40.0, 90.0, 135.0] {
        let phase = radians(degrees);
        let found =
            seen_from(Effects { discs: vec![ball(DVec3::X, phase)], ..Effects::default() }, &pose, &settings);
        let values: Vec<f64> = (0..2400).map(|index| value(&found, PlaneKind::Intensity, index)).collect();
        let area = PI * radius * radius;
        let light = values.iter().sum::<f64>() / area;
        let lambert = 2.0 / 3.0 * 0.5 * (libm::sin(phase) + (PI - phase) * libm::cos(phase)) / PI;
        assert!((light - lambert).abs() < 0.005 * lambert.max(0.05), "{degrees}: {light}, not {lambert}");
        // Half of a pixel that a rim crosses is lit in the mean.
        let lit = values.iter().filter(|&&value| value > 0.0).count() as f64;
        let rim = PI * radius * (1.0 + libm::cos(phase).abs()) / 2.0 + PI * radius;
        let expected = area * (1.0 + libm::cos(phase)) / 2.0;
        assert!((lit - 0.32 * rim - expected).abs() < 0.03 * area, "{degrees}: {lit}, not {expected}");
        assert!(found.get(PlaneKind::Label).unwrap().iter().all(|&label| label == 0.0));
    }
}

#[test]
fn the_sun_has_its_diameter() {
    let settings = narrow(1.0);
    let face = DiscFace::Sun { colour: [1.0; 3] };
    let disc = SkyDisc { direction: DVec3::X, angular_diameter: radians(0.532906214492), face };
    let pose = pose([50.0, 100.0, 1e5], 0.0, 0.0);
    let found = seen_from(Effects { discs: vec![disc], ..Effects::default() }, &pose, &settings);
    let light: f64 = (0..2400).map(|index| value(&found, PlaneKind::Intensity, index)).sum();
    let diameter = 2.0 * (light / PI).sqrt();
    let expected = 2.0 * focal(&settings) * libm::tan(radians(0.532906214492 / 2.0));
    assert!((diameter / expected - 1.0).abs() < 1e-3, "{diameter}, not {expected}");
}
