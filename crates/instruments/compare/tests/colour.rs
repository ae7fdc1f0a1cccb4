//! Pictures in colour: luminance, channels, and colour against grey.

use compare::{CompareError, compare, compare_any, difference_any, linear_luminance, triptych_any};
use picture::{AnyPicture, ColourPicture, Curve, Depth, GreyPicture, Transfer};

const CURVES: [Curve; 2] = [Curve::Srgb; 2];

fn colour(codes: &[u16]) -> AnyPicture {
    ColourPicture::new(codes.len() / 3, 1, Depth::Eight, codes.to_vec()).expect("a good picture").into()
}

fn grey(codes: &[u16]) -> AnyPicture {
    GreyPicture::new(codes.len(), 1, Depth::Eight, codes.to_vec()).expect("a good picture").into()
}

#[test]
fn channels_are_told_apart() {
    let (test, reference) = (colour(&[10, 20, 30, 40, 50, 60]), colour(&[10, 25, 30, 40, 50, 90]));
    let found = compare_any([&test, &reference], CURVES, None, &[2]).expect("of one size");
    let channels = found.channels.as_ref().expect("both are in colour");
    assert_eq!(channels.each_ref().map(|channel| channel.differing), [0, 1, 1]);
    assert_eq!((channels[1].worst.column, channels[2].worst.column), (0, 1));
    // One of two pixels is off by 30 of 255.
    assert!((channels[2].rmse - 30.0 / 255.0 / 2.0_f64.sqrt()).abs() < 1e-15);
    assert_eq!(found.all().count(), 4);
    // A mask over the second pixel hides the blue one.
    let masked = compare_any([&test, &reference], CURVES, Some(&[false, true]), &[2]).expect("of one size");
    let differing = masked.channels.map(|channels| channels.map(|channel| channel.differing));
    assert_eq!(differing, Some([0, 1, 0]));
}

#[test]
fn a_step_between_channels_that_keeps_the_luminance_is_seen_by_the_channels_alone() {
    // Linear display: 0.2126 * 100 = 21.26 of red against 0.7152 * 30 = 21.456 of green round to one grey.
    let curves = [Curve::Power(1.0); 2];
    let found =
        compare_any([&colour(&[100, 0, 0]), &colour(&[0, 30, 0])], curves, None, &[]).expect("one size");
    assert_eq!(found.luminance.differing, 0);
    assert_eq!(found.channels.expect("both are in colour").map(|channel| channel.differing), [1, 1, 0]);
}

#[test]
fn colour_against_grey_is_by_luminance_and_grey_against_grey_as_ever() {
    let (tinted, plain) = (colour(&[255, 0, 0, 9, 9, 9]), grey(&[127, 9]));
    for pair in [[&tinted, &plain], [&plain, &tinted]] {
        let found = compare_any(pair, CURVES, None, &[0]).expect("of one size");
        assert_eq!((found.luminance.differing, found.channels), (0, None));
    }
    let (AnyPicture::Grey(a), AnyPicture::Grey(b)) = (grey(&[1, 2]), grey(&[1, 7])) else { panic!("grey") };
    let found = compare_any([&a.clone().into(), &b.clone().into()], CURVES, None, &[2]).expect("of one size");
    assert_eq!(found.luminance, compare(&a, &b, None, &[2]).expect("of one size"));
    let small = compare_any([&tinted, &grey(&[1])], CURVES, None, &[]);
    assert!(matches!(small, Err(CompareError::Size { .. })));
}

#[test]
fn differences_have_the_colour_of_what_differs() {
    let (test, reference) = (colour(&[10, 20, 30]), colour(&[10, 25, 20]));
    assert_eq!(difference_any(&test, &reference, 2).expect("of one size"), colour(&[128, 118, 148]));
    assert_eq!(difference_any(&grey(&[10]), &grey(&[12]), 2).expect("of one size"), grey(&[124]));
    let mixed = difference_any(&test, &grey(&[20]), 1).expect("of one size");
    assert_eq!(mixed, colour(&[118, 128, 138]));
    assert!(triptych_any(&test, &grey(&[20]), 1).expect("of one size").is_colour());
}

#[test]
fn linear_luminance_is_that_of_the_planes() {
    let transfer = Transfer::new(2.0, 1.0).expect("a law");
    let found = linear_luminance(&colour(&[255, 0, 0, 255, 255, 255]), &transfer);
    assert!((f64::from(found[0]) - 2.0 * 0.2126).abs() < 1e-6 && (f64::from(found[1]) - 2.0).abs() < 1e-6);
    assert_eq!(linear_luminance(&grey(&[0, 255]), &transfer), [0.0, 2.0]);
}
