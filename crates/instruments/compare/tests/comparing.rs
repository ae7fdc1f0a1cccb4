//! The comparison is tested itself: one pixel, one level, one line.

use compare::{CompareError, compare, difference_picture, ssim, triptych};
use picture::{Depth, GAP, GreyPicture};
use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};

fn eight(columns: usize, lines: usize, codes: Vec<u16>) -> GreyPicture {
    GreyPicture::new(columns, lines, Depth::Eight, codes).expect("a good picture")
}

fn flat(code: u16) -> GreyPicture {
    eight(16, 12, vec![code; 16 * 12])
}

/// A picture with structure, the same for everyone who reads this line.
fn pattern(columns: usize, lines: usize) -> GreyPicture {
    let code = |at: usize| ((at % columns * 7) ^ (at / columns * 13)) % 256;
    eight(columns, lines, (0..columns * lines).map(|at| code(at) as u16).collect())
}

fn with(picture: &GreyPicture, column: usize, line: usize, code: u16) -> GreyPicture {
    let mut codes = picture.codes().to_vec();
    codes[line * picture.columns() + column] = code;
    GreyPicture::new(picture.columns(), picture.lines(), picture.depth(), codes).expect("a good picture")
}

#[test]
fn equal_pictures_are_equal() {
    let picture = pattern(40, 30);
    let same = compare(&picture, &picture, None, &[0]).expect("one size");
    assert_eq!((same.compared, same.masked, same.differing), (1200, 0, 0));
    assert_eq!((same.rmse, same.psnr_db, same.ssim), (0.0, None, Some(1.0)));
    assert_eq!(same.beyond[0].count, 0);
}

#[test]
fn one_pixel_by_one_level_is_noticed() {
    let reference = pattern(40, 30);
    for (column, line) in [(0, 0), (39, 0), (0, 29), (39, 29), (17, 11)] {
        let code = reference.code(column, line);
        let changed = if code == 0 { 1 } else { code - 1 };
        let found =
            compare(&with(&reference, column, line, changed), &reference, None, &[0, 1]).expect("one size");
        assert_eq!((found.differing, found.beyond[0].count, found.beyond[1].count), (1, 1, 0));
        assert_eq!((found.worst.column, found.worst.line), (column, line));
        let (test, right) = (f64::from(changed) / 255.0, f64::from(code) / 255.0);
        assert_eq!((found.worst.test, found.worst.reference), (test, right));
        let rmse = 1.0 / 255.0 / 1200.0_f64.sqrt();
        assert!((found.rmse - rmse).abs() < 1e-15);
        assert!((found.psnr_db.expect("they differ") + 20.0 * libm::log10(rmse)).abs() < 1e-9);
    }
}

#[test]
fn one_level_of_sixteen_bits_is_noticed() {
    let deep = |code| GreyPicture::new(2, 1, Depth::Sixteen, vec![500, code]).expect("a good picture");
    let found = compare(&deep(1001), &deep(1000), None, &[0, 1]).expect("one size");
    assert_eq!((found.differing, found.beyond[0].count, found.beyond[1].count), (1, 1, 0));
}

#[test]
fn depths_compare_as_grey() {
    let deep = GreyPicture::new(3, 1, Depth::Sixteen, vec![0, 100 * 257, 65_535]).expect("a good picture");
    let found = compare(&eight(3, 1, vec![0, 100, 255]), &deep, None, &[0]).expect("one size");
    assert_eq!(found.differing, 0);
}

#[test]
fn a_shift_by_one_line_is_noticed() {
    let reference = pattern(40, 30);
    let mut codes = vec![0; 40];
    codes.extend_from_slice(&reference.codes()[..40 * 29]);
    let found = compare(&eight(40, 30, codes), &reference, None, &[2]).expect("one size");
    assert!(found.beyond[0].share > 0.9, "{found:?}");
    assert!(found.ssim.expect("large enough") < 0.5, "{found:?}");
    assert!(found.psnr_db.expect("they differ") < 20.0, "{found:?}");
}

#[test]
fn exactly_two_levels_are_not_more_than_two() {
    for code in 0..=253 {
        let found = compare(&flat(code + 2), &flat(code), None, &[1, 2]).expect("one size");
        assert_eq!((found.beyond[0].share, found.beyond[1].share), (1.0, 0.0));
    }
}

#[test]
fn masked_pixels_do_not_count() {
    let reference = flat(100);
    let test = with(&with(&reference, 3, 2, 255), 4, 2, 101);
    let mut mask = vec![false; 16 * 12];
    mask[2 * 16 + 3] = true;
    let found = compare(&test, &reference, Some(&mask), &[2]).expect("one size");
    assert_eq!((found.compared, found.masked, found.differing, found.beyond[0].count), (191, 1, 1, 0));
    assert_eq!((found.worst.column, found.worst.line), (4, 2));
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let error = compare(&flat(0), &pattern(12, 16), None, &[]).expect_err("another size");
    let text = "a picture of 16x12 against one of 12x16 (columns x lines): draw both on the same raster";
    assert_eq!(error.to_string(), text);
    assert!(matches!(compare(&flat(0), &flat(0), Some(&[true]), &[]), Err(CompareError::Plane { .. })));
    let all = vec![true; 16 * 12];
    assert!(matches!(compare(&flat(0), &flat(0), Some(&all), &[]), Err(CompareError::AllMasked { .. })));
    assert!(matches!(triptych(&flat(0), &pattern(12, 16), 1), Err(CompareError::Size { .. })));
}

/// For flat pictures the variances vanish: SSIM = (2 a b + C1) / (a^2 + b^2 + C1).
#[test]
fn ssim_of_a_constant_shift_is_its_closed_form() {
    for (a, b) in [(0, 1), (100, 110), (0, 255), (200, 20)] {
        let (x, y) = (f64::from(a) / 255.0, f64::from(b) / 255.0);
        let expected = (2.0 * x * y + 1e-4) / (x * x + y * y + 1e-4);
        let found = ssim(&flat(a), &flat(b)).expect("large enough");
        assert!((found - expected).abs() < 1e-12, "{a} {b}: {found} {expected}");
    }
}

/// scikit-image 0.26 `structural_similarity(..., data_range=255, gaussian_weights=True, sigma=1.5,
/// use_sample_covariance=False)` of the pattern and its mirror image, and of the pattern and half of it.
#[test]
fn ssim_is_that_of_another_program() {
    let picture = pattern(48, 37);
    let mirrored = eight(48, 37, picture.codes().iter().rev().copied().collect());
    let halved = eight(48, 37, picture.codes().iter().map(|code| code / 2).collect());
    for (other, expected) in [(mirrored, SKIMAGE_MIRRORED), (halved, SKIMAGE_HALVED)] {
        let found = ssim(&picture, &other).expect("large enough");
        assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    }
}

const SKIMAGE_MIRRORED: f64 = -0.004811777378120207;
const SKIMAGE_HALVED: f64 = 0.6427108972256618;

#[test]
fn ssim_needs_room_for_its_window() {
    assert_eq!(ssim(&pattern(10, 40), &pattern(10, 40)), None);
    assert_eq!(ssim(&pattern(11, 11), &pattern(11, 11)), Some(1.0));
    assert_eq!(ssim(&pattern(11, 12), &pattern(12, 11)), None);
}

#[test]
fn differences_are_signed_amplified_and_cut() {
    let reference = eight(5, 1, vec![100; 5]);
    let test = eight(5, 1, vec![100, 101, 98, 255, 0]);
    assert_eq!(difference_picture(&test, &reference, 8).expect("one size").codes(), [128, 136, 112, 255, 0]);
    let deep = GreyPicture::new(
        5,
        1,
        Depth::Sixteen,
        vec![25_700, 25_700 + 257, 25_700 - 150, 25_700 - 100, 25_700],
    )
    .expect("a good picture");
    assert_eq!(
        difference_picture(&deep, &reference, 1).expect("one size").codes(),
        [128, 129, 127, 128, 128]
    );
    let three = triptych(&test, &reference, 8).expect("one size");
    assert_eq!((three.columns(), three.lines()), (3 * 5 + 2 * GAP, 1));
    assert_eq!((three.code(1, 0), three.code(6 + GAP, 0), three.code(11 + 2 * GAP, 0)), (101, 100, 136));
}

proptest! {
    /// Symmetric, and never above the worst pixel.
    #[test]
    fn rmse_is_a_distance(codes in proptest::collection::vec((any::<u8>(), any::<u8>()), 1..50)) {
        let picture = |of: fn(&(u8, u8)) -> u8| eight(codes.len(), 1, codes.iter().map(|pair| u16::from(of(pair))).collect());
        let (a, b) = (picture(|pair| pair.0), picture(|pair| pair.1));
        let (there, back) = (compare(&a, &b, None, &[]).expect("one size"), compare(&b, &a, None, &[]).expect("one size"));
        prop_assert_eq!(there.rmse, back.rmse);
        prop_assert!(there.rmse <= (there.worst.test - there.worst.reference).abs() + 1e-12);
    }

    #[test]
    fn ssim_is_symmetric_and_at_most_one(seed in any::<u16>()) {
        let a = pattern(14, 13);
        let b = with(&a, usize::from(seed) % 14, usize::from(seed) / 14 % 13, seed % 256);
        let (there, back) = (ssim(&a, &b).expect("large enough"), ssim(&b, &a).expect("large enough"));
        prop_assert_eq!(there, back);
        prop_assert!(there <= 1.0);
    }
}
