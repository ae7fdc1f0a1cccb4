//! Calligraphic points: aperture, attenuation, veil.

use light_points::{Accumulation, Blending, Light, Share, Veil, add_up, count_under, mask_under};
use raster::{Pattern, Sampling};

use crate::assert_published;

/// Display intensity of two points over the same four samples, with the stacks before each.
fn two_points(accumulation: Accumulation, stacks: [[f64; 4]; 2]) -> [f64; 2] {
    let mut veil = Veil::new(4, accumulation);
    let mut shown = [0.0; 2];
    for (i, intensity) in [0.8, 0.6].into_iter().enumerate() {
        let translucency = Light::new(intensity, Blending::Hiding).translucency;
        let share = veil.read_out(0..4, |sample| stacks[i][sample], translucency);
        shown[i] = share.display(intensity).expect("on the screen");
    }
    shown
}

#[test]
fn two_points_of_the_check_values() {
    let stacks = [[1.0, 0.7, 0.35, 0.0], [1.0, 0.7, 0.7, 0.0]];
    let mut veil = Veil::new(4, Accumulation::Points);
    let first = veil.read_out(0..4, |sample| stacks[0][sample], 0.2);
    assert_eq!(first.aperture, 4);
    assert_published(first.attenuation, 2.05);
    let second = veil.read_out(0..4, |sample| stacks[1][sample], 0.4);
    assert_published(second.attenuation, 0.48);
    // A third one tells the veil: 0.2 times 0.4 everywhere.
    assert_published(veil.read_out(0..4, |_| 1.0, 1.0).attenuation, 4.0 * 0.08);
    let [near, far] = two_points(Accumulation::Points, stacks);
    assert_published(near, 0.41);
    assert_published(far, 0.072);
    assert_published(two_points(Accumulation::StackOnly, stacks)[1], 0.36);
}

#[test]
fn a_point_half_hidden_and_half_behind_a_sheet() {
    let mut veil = Veil::new(16, Accumulation::Points);
    let stack = |sample| match sample {
        0..7 => 0.0,
        7..10 => 0.4,
        _ => 1.0,
    };
    let share = veil.read_out(0..16, stack, 0.1);
    assert_published(share.attenuation / 16.0, 0.45);
    assert_published(share.display(0.9).expect("on the screen"), 0.405);
}

#[test]
fn through_dust_a_point_keeps_the_product() {
    for intensity in [1.0, 0.3, 0.01] {
        let share = Veil::new(9, Accumulation::Points).read_out(0..9, |_| 0.7 * 0.5, 0.9);
        let calligraphic = share.display(intensity).expect("on the screen");
        let raster = 0.7 * 0.5 * Light::new(intensity, Blending::Hiding).added;
        assert!((calligraphic / intensity - 0.35).abs() < 1e-12 && (raster / intensity - 0.35).abs() < 1e-12);
    }
}

#[test]
fn behind_a_point_in_line_the_far_one_has_what_it_lets_through() {
    let clear = [[1.0; 4]; 2];
    assert!((two_points(Accumulation::Points, clear)[1] / 0.6 - 0.2).abs() < 1e-12);
    assert_eq!(two_points(Accumulation::StackOnly, clear)[1], 0.6);
}

#[test]
fn a_lifted_veil_hides_nothing() {
    let mut veil = Veil::new(4, Accumulation::Points);
    veil.read_out(0..4, |_| 1.0, 0.0);
    veil.lift();
    assert_eq!(veil, Veil::new(4, Accumulation::Points));
}

#[test]
fn sums_do_not_depend_on_the_order_of_delivery() {
    let share = |i: u32| Share { aperture: i, attenuation: 1.0 / f64::from(3 + i) };
    let shares: Vec<_> = (0..40).map(|i| (i / 2, i % 2, share(i))).collect();
    let sums = add_up(shares.clone(), 3);
    assert_eq!(sums[0].aperture, (0..40).step_by(2).sum::<u32>());
    assert_eq!(sums[2].display(1.0), None);
    let forwards = (0..40).step_by(2).fold(0.0, |sum, i| sum + share(i).attenuation);
    assert_eq!(sums[0].attenuation.to_bits(), f64::to_bits(forwards));
    for turn in 1..40 {
        let mut turned = shares.clone();
        turned.rotate_left(turn);
        turned.swap(0, turn);
        assert_eq!(add_up(turned, 3), sums);
    }
}

/// A ridge rises before a lamp: its light falls with the part of the disc that is seen.
#[test]
fn sunset_of_a_beacon() {
    let sampling = Sampling::new(Pattern::Sixteen);
    let (middle, diameter) = ([5.3, 5.6], 4.0);
    let aperture = count_under(middle, diameter, &sampling);
    let mut before = 1.0;
    for step in 0..=100 {
        let ridge = 8.0 - 0.05 * f64::from(step);
        let mut seen = 0;
        for pixel in (0..144).map(|i| [i % 12, i / 12]) {
            let mask = mask_under(middle, diameter, pixel, &sampling);
            let samples = sampling.places(pixel).enumerate().filter(|(i, _)| mask >> i & 1 == 1);
            seen += samples.filter(|(_, [_, y])| *y < ridge).count();
        }
        let shown = Share { aperture, attenuation: seen as f64 }.display(1.0).expect("on the screen");
        let depth = ((ridge - middle[1]) / (diameter / 2.0)).clamp(-1.0, 1.0);
        let uncovered =
            1.0 - (libm::acos(depth) - depth * (1.0 - depth * depth).sqrt()) / std::f64::consts::PI;
        // One row of samples lies on either side of the ridge: 4 pixels of 4 rows in 16.
        assert!((shown - uncovered).abs() < 0.03, "{shown}, uncovered {uncovered} at {ridge}");
        assert!(shown <= before);
        before = shown;
    }
    assert_eq!(before, 0.0);
}
