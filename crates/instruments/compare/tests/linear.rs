//! Errors of linear intensity.

use compare::{CompareError, compare_linear, linear_intensity};
use picture::{Depth, Encoder, GreyPicture, Transfer};

#[test]
fn errors_by_hand() {
    let found = compare_linear(&[0.5, 0.25, 1.0, 0.0], &[0.25, 0.25, 1.0, 0.25], None).unwrap();
    assert_eq!((found.compared, found.masked), (4, 0));
    assert_eq!((found.rmse, found.bias, found.maximum), ((0.125_f64 / 4.0).sqrt(), 0.0, 0.25));
    assert!((found.psnr_db.unwrap() + 20.0 * libm::log10(found.rmse)).abs() < 1e-12);
    let mask = [true, false, false, false];
    let found = compare_linear(&[0.5, 0.25, 1.0, 0.0], &[0.25, 0.25, 1.0, 0.25], Some(&mask)).unwrap();
    assert_eq!((found.compared, found.masked, found.bias), (3, 1, -0.25 / 3.0));
    assert_eq!(compare_linear(&[1.0], &[1.0], None).unwrap().psnr_db, None);
}

#[test]
fn sizes_must_fit() {
    let refused = compare_linear(&[0.0], &[0.0, 1.0], None);
    assert!(matches!(refused, Err(CompareError::Plane { found: 1, expected: 2, .. })), "{refused:?}");
    let masked = compare_linear(&[0.0], &[0.0], Some(&[true]));
    assert!(matches!(masked, Err(CompareError::AllMasked { pixels: 1 })), "{masked:?}");
}

/// What goes through the display law and back is off by at most half a code, whatever white and gamma.
#[test]
fn codes_lead_back_to_intensity() {
    for (white, gamma, depth) in
        [(0.3, 2.2, Depth::Eight), (1.0, 1.0, Depth::Eight), (2.0, 0.5, Depth::Sixteen)]
    {
        let transfer = Transfer::new(white, gamma).unwrap();
        let plane: Vec<f32> = (0..1000).map(|at| white * at as f32 / 999.0).collect();
        let picture = Encoder::new(transfer, depth).encode(&plane, 1000, 1).unwrap();
        let back = linear_intensity(&picture, &transfer);
        for (at, (found, expected)) in back.iter().zip(&plane).enumerate() {
            let code = picture.codes()[at];
            let step = |by: i32| {
                let code = (i32::from(code) + by).clamp(0, i32::from(depth.white())) as u16;
                transfer.intensity(code, depth)
            };
            let [low, high] = [step(-1), step(1)];
            assert!((low..=high).contains(expected) && (low..=high).contains(found), "{white} {gamma} {at}");
        }
        let clipped = GreyPicture::new(1, 1, depth, vec![depth.white()]).unwrap();
        assert_eq!(linear_intensity(&clipped, &transfer), [white]);
    }
}
