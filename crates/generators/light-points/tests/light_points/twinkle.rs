//! A disc that moves over the sampling points: raw it twinkles, divided by what it covers it does not.

use light_points::{Disc, LeastDiameter, Share, count_under};
use raster::{Pattern, Sampling};

/// Steps of the disc in a pixel, along each axis.
const STEPS: u32 = 100;

fn places() -> impl Iterator<Item = [f64; 2]> {
    (0..STEPS * STEPS).map(|i| [i % STEPS, i / STEPS].map(|step| 5.0 + f64::from(step) / f64::from(STEPS)))
}

#[test]
fn samples_under_a_disc_are_those_of_the_table() {
    for (pattern, least, most) in [
        (Pattern::One, 1, 4),
        (Pattern::Four, 6, 9),
        (Pattern::Eight, 12, 17),
        (Pattern::Sixteen, 25, 32),
        (Pattern::Grid16, 26, 32),
        (Pattern::Lattice32, 53, 61),
    ] {
        let sampling = Sampling::new(pattern);
        let counts: Vec<u32> = places().map(|place| count_under(place, 1.5, &sampling)).collect();
        let (found_least, found_most) = (counts.iter().min(), counts.iter().max());
        assert_eq!((found_least, found_most), (Some(&least), Some(&most)), "{}", pattern.name());
        let mean = f64::from(counts.iter().sum::<u32>()) / f64::from(STEPS * STEPS);
        let area = std::f64::consts::PI * 0.75 * 0.75 * sampling.count() as f64;
        assert!((mean / area - 1.0).abs() < 0.01, "{}: mean {mean}, area {area}", pattern.name());
    }
}

/// Light of the frame over light of the disc, at every place.
fn shown(pattern: Pattern, intensity: impl Fn(&Disc, u32, usize) -> f64) -> [f64; 2] {
    let sampling = Sampling::new(pattern);
    let least = LeastDiameter::new(1.5, &sampling).expect("wide enough");
    let disc = Disc::of_lamp(0.5, 0.8, least);
    places().fold([f64::INFINITY, 0.0], |[low, high], place| {
        let covered = count_under(place, disc.diameter, &sampling);
        let light =
            f64::from(covered) * intensity(&disc, covered, sampling.count()) / sampling.count() as f64;
        let share = light / disc.light();
        [low.min(share), high.max(share)]
    })
}

#[test]
fn raw_points_twinkle_as_published_and_normalised_ones_do_not() {
    for (pattern, twinkle) in [
        (Pattern::One, [-0.43, 1.26]),
        (Pattern::Four, [-0.151, 0.273]),
        (Pattern::Eight, [-0.151, 0.203]),
        (Pattern::Sixteen, [-0.116, 0.132]),
        (Pattern::Grid16, [-0.080, 0.132]),
        (Pattern::Lattice32, [-0.063, 0.079]),
    ] {
        let raw = shown(pattern, |disc, _, _| disc.intensity);
        for (found, published) in raw.iter().zip(twinkle) {
            let digits = if pattern == Pattern::One { 0.006 } else { 0.0006 };
            assert!((found - 1.0 - published).abs() < digits, "{}: {raw:?}, {twinkle:?}", pattern.name());
        }
        let normalised = shown(pattern, Disc::normalised);
        assert!(normalised.iter().all(|share| (share - 1.0).abs() < 1e-12), "{normalised:?}");
    }
}

#[test]
fn a_calligraphic_point_in_the_clear_has_its_intrinsic_intensity() {
    for sampling in Pattern::ALL.map(Sampling::new) {
        for place in places().step_by(7) {
            let aperture = count_under(place, 1.5, &sampling);
            let share = Share { aperture, attenuation: f64::from(aperture) };
            let shown = share.display(0.8).expect("on the screen");
            assert!((shown - 0.8).abs() < 1e-15, "{shown} at {place:?}");
        }
    }
}

#[test]
fn turned_pixels_are_never_missed() {
    for pattern in [Pattern::Four, Pattern::Eight, Pattern::Sixteen, Pattern::Grid16, Pattern::Lattice32] {
        let sampling = Sampling::turned(pattern).expect("not off centre");
        let at = |i: u32| [f64::from(i % 211) / 7.0 - 3.0, f64::from(i / 211) / 7.0 - 3.0];
        assert!((0..40_000).all(|i| count_under(at(i), 1.4143, &sampling) > 0), "{}", pattern.name());
    }
}
