//! Codes, grey curve and noise.

use features::Features;
use photo_make::{Wishes, make};
use picture::{Depth, GreyPicture, Transfer};

use crate::{plane, stage, wishes};

/// Light of the level plane under the sun of the stage.
fn light() -> f64 {
    libm::sin(35.0_f64.to_radians())
}

#[test]
fn codes_follow_depth_and_grey_curve() {
    let stage = stage(plane(0.0, [0.0; 2]), Features::default());
    for (depth, white, gamma) in
        [(Depth::Eight, 1.0, 1.0), (Depth::Eight, 0.8, 2.2), (Depth::Sixteen, 2.0, 1.8)]
    {
        let transfer = Transfer::new(white as f32, gamma as f32).expect("a curve");
        let made = make(&stage, &Wishes { depth, transfer, ..wishes() }).expect("a photograph");
        let level = libm::pow(light() / white, 1.0 / gamma);
        let expected = (level * f64::from(depth.white())).round();
        let found = f64::from(made.picture.code(20, 20));
        assert!((found - expected).abs() <= 1.0, "{found}, not {expected}");
        assert_eq!(made.picture.depth(), depth);
        assert_eq!(made.file.light.grey(), Some([white, gamma]));
    }
}

/// Mean, deviation and share beyond one deviation of the noise, and what it follows from.
#[test]
fn noise_is_gaussian_and_follows_from_its_seed() {
    let stage = stage(plane(0.0, [0.0; 2]), Features::default());
    let made = |noise, seed| {
        let wishes = Wishes { size: [90, 90], ground_sample: 0.5, noise, seed, ..wishes() };
        make(&stage, &wishes).expect("a photograph").picture
    };
    let picture = made(0.02, 4);
    let off: Vec<f64> =
        picture.codes().iter().map(|code| (f64::from(*code) / 65_535.0 - light()) / 0.02).collect();
    let count = off.len() as f64;
    let mean = off.iter().sum::<f64>() / count;
    let deviation = (off.iter().map(|x| x * x).sum::<f64>() / count).sqrt();
    let beyond = off.iter().filter(|x| x.abs() > 1.0).count() as f64 / count;
    // Standard errors of 8100 numbers: 0.011, 0.008, 0.005.
    assert!(mean.abs() < 0.04 && (deviation - 1.0).abs() < 0.03 && (beyond - 0.3173).abs() < 0.02);
    assert_eq!(picture, made(0.02, 4));
    assert_ne!(picture, made(0.02, 5));
    // The share is one of white: under another white the codes are as far off.
    let transfer = Transfer::new(0.8, 1.0).expect("a curve");
    let dim = Wishes { size: [90, 90], ground_sample: 0.5, noise: 0.02, seed: 4, transfer, ..wishes() };
    let dim = make(&stage, &dim).expect("a photograph").picture;
    let spread = |picture: &GreyPicture, level: f64| {
        let off = |code: &u16| f64::from(*code) / 65_535.0 - level;
        (picture.codes().iter().map(|code| off(code) * off(code)).sum::<f64>() / count).sqrt()
    };
    let [one, other] = [spread(&picture, light()), spread(&dim, light() / 0.8)];
    assert!((one / other - 1.0).abs() < 1e-3, "{one} {other}");
    assert_ne!(made(0.0, 4), picture);
    assert_eq!(made(0.0, 4), made(0.0, 5));
}
