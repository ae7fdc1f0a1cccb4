//! The table of normals, sea states and held means (sections 4.1, 4.2, check values 8.3).

use faces::{Cone, FaceError, Mean, SeaState, Warning, brightness, sun_vector};
use glam::DVec3;
use quantities::{degrees, radians};

use crate::near;

fn cone() -> Cone {
    Cone::new(16, radians(75.0)).expect("a cone")
}

#[test]
fn normals_of_the_table() {
    let expected = [
        (0, [0.258819045102521, 0.0, 0.965925826289068]),
        (1, [0.239117618394334, 0.099045760541288, 0.965925826289068]),
        (5, [-0.099045760541288, 0.239117618394334, 0.965925826289068]),
        (21, [-0.099045760541288, 0.239117618394334, 0.965925826289068]),
    ];
    for (number, normal) in expected {
        assert!(cone().normal(number).distance(DVec3::from_array(normal)) < 1e-14, "{number}");
    }
}

#[test]
fn brightness_of_a_turning_sun() {
    let eps = radians(60.0);
    near(cone().mean(eps), 0.836516303737808);
    near(cone().amplitude(eps), 0.129409522551260);
    near(cone().contrast(eps), 0.154700538379252);
    // A quarter turn a second.
    let at =
        |number, seconds: f64| brightness(cone().normal(number), sun_vector(radians(90.0 * seconds), eps));
    near(at(0, 0.0), 0.965925826289068);
    near(at(5, 0.0), 0.786993423467164);
    near(at(5, 0.7), 0.920561065594065);
    near(at(8, 2.0), 0.965925826289068);
    near(at(8, 0.0), std::f64::consts::FRAC_1_SQRT_2);
    for (number, azimuth) in [(3, 0.4), (7, 2.0), (15, 5.5)] {
        let wave = libm::cos(cone().azimuth(number) - azimuth);
        near(
            brightness(cone().normal(number), sun_vector(azimuth, eps)),
            cone().mean(eps) + cone().amplitude(eps) * wave,
        );
    }
}

#[test]
fn states_have_their_contrast() {
    let expected = [
        (0.0, 90.0, 0.965925826289, 0.0, [1, 10]),
        (0.15, 60.759565412079, 0.842845209551, 0.126426781433, [3, 20]),
        (0.30, 41.770080225775, 0.643444817423, 0.193033445227, [1, 5]),
        (0.50, 28.186785432014, 0.456252640040, 0.228126320020, [1, 4]),
    ];
    for (state, (contrast, elevation, mean, amplitude, rate)) in SeaState::ALL.into_iter().zip(expected) {
        let eps = state.elevation(&cone()).expect("an elevation");
        near(state.contrast(), contrast);
        near(degrees(eps), elevation);
        near(cone().mean(eps), mean);
        near(cone().amplitude(eps), amplitude);
        near(cone().contrast(eps), contrast);
        assert_eq!(state.rate(), rate);
    }
}

#[test]
fn a_held_mean_leaves_contrast_alone() {
    for state in SeaState::ALL {
        let eps = state.elevation(&cone()).expect("an elevation");
        let gain = Mean::USUAL.gain(&cone(), eps).expect("a gain");
        near(gain * cone().mean(eps), 0.5);
        near(gain * cone().amplitude(eps), 0.5 * state.contrast());
        assert_eq!(Mean::AsReported.gain(&cone(), eps), Ok(1.0));
    }
    let highest = cone().elevation_of(1.0).expect("an elevation");
    near(degrees(highest), 15.0);
    assert!(Mean::USUAL.gain(&cone(), highest).is_ok());
    let too_bright = Mean::Held(0.51).gain(&cone(), highest).expect_err("a crest above 1").to_string();
    assert_eq!(too_bright, "crest of the held pattern is 1.02: expected 1 or less: lower the held mean");
    for (mean, elevation) in [(0.0, 1.0), (-0.5, 1.0), (f64::NAN, 1.0), (0.5, 0.0), (0.5, -1.0)] {
        assert!(Mean::Held(mean).gain(&cone(), elevation).is_err(), "{mean} {elevation}");
    }
}

#[test]
fn figures_out_of_range_are_refused() {
    for (count, alpha) in [(1, 75.0), (0, 75.0), (16, 0.0), (16, 90.1), (16, -1.0), (16, f64::NAN)] {
        let found = Cone::new(count, radians(alpha));
        assert!(matches!(found, Err(FaceError::Figure { .. })), "{count} {alpha}");
    }
    for contrast in [-0.1, 1.01, f64::NAN] {
        assert!(cone().elevation_of(contrast).is_err());
    }
}

#[test]
fn clipped_troughs_and_vertical_normals_are_told() {
    assert_eq!(cone().warnings(radians(15.0)), []);
    assert!(matches!(cone().warnings(radians(14.9))[..], [Warning::Clipped { .. }]));
    let vertical = Cone::new(16, radians(90.0)).expect("a cone");
    assert_eq!(vertical.warnings(radians(30.0)), [Warning::NoContrast]);
    assert_eq!(vertical.contrast(radians(30.0)), 0.0);
}
