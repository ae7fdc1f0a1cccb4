//! Area and boundaries against rays cast to the sun from random points.

use crate::common::{cratered, ray_is_blocked, winding};
use landscape::{Landscape, Sun};
use quantities::{radians, unit_interval};
use remote_shadow::{Resolution, ShadowBank};
use std::sync::Arc;

/// Spacing of the profiles (m): a sixteenth of the smallest radius.
const SPACING: f64 = 0.5;
/// Higher than any ground of the cases (m).
const HIGHEST: f64 = 30.0;

struct Tally {
    dark: u32,
    wrongly_dark: u32,
    wrongly_lit: u32,
}

fn compare(landscape: Landscape, sun: &Sun, seed: u64, points: u64) -> Tally {
    let landscape = Arc::new(landscape);
    let bank = ShadowBank::new(landscape.clone(), Resolution { finest: SPACING, angle: 0.0 });
    let tiles = bank.around(sun, [320.0, 320.0], 160.0, None);
    let beside = |place: [f64; 2], dark: bool| {
        (0..16).any(|k| {
            let (sin, cos) = quantities::sin_cos(radians(22.5) * f64::from(k));
            let moved = [place[0] + SPACING * cos, place[1] + SPACING * sin];
            ray_is_blocked(&landscape, sun, moved, HIGHEST) != dark
        })
    };
    let mut tally = Tally { dark: 0, wrongly_dark: 0, wrongly_lit: 0 };
    for n in 0..points {
        let place = [0, 1].map(|axis| 210.0 + 220.0 * unit_interval(seed, &[n, axis]));
        let dark = ray_is_blocked(&landscape, sun, place, HIGHEST);
        let found = winding(&tiles, place);
        assert!(found == 0 || found == 1, "winding {found} at {place:?}");
        assert!(bank.is_dark(sun, place) == dark || beside(place, dark), "{place:?}: one point, {dark}");
        tally.dark += u32::from(dark);
        if dark == (found == 1) {
            continue;
        }
        *(if dark { &mut tally.wrongly_lit } else { &mut tally.wrongly_dark }) += 1;
        // Where the two differ, a boundary of the reference passes within one spacing.
        assert!(beside(place, dark), "{place:?}: the ray says dark = {dark}");
    }
    tally
}

/// `points` random points on each of three grounds.
fn areas_agree(elevation: f64, azimuths: [f64; 3], points: u64) {
    let mut all = Tally { dark: 0, wrongly_dark: 0, wrongly_lit: 0 };
    for (seed, azimuth) in (1..).zip(azimuths) {
        let sun = Sun { azimuth: radians(azimuth), elevation: radians(elevation) };
        let tally = compare(cratered(seed), &sun, seed, points);
        all.dark += tally.dark;
        all.wrongly_dark += tally.wrongly_dark;
        all.wrongly_lit += tally.wrongly_lit;
    }
    let error = (f64::from(all.wrongly_dark) - f64::from(all.wrongly_lit)) / f64::from(all.dark);
    println!(
        "{elevation} deg: dark {} of {}, wrongly dark {}, wrongly lit {}: {:.3} %",
        all.dark,
        3 * points,
        all.wrongly_dark,
        all.wrongly_lit,
        100.0 * error
    );
    assert!(all.dark > 100, "there is shadow to compare");
    assert!(error.abs() < 0.005, "area error {error}");
}

#[test]
fn at_one_degree() {
    areas_agree(1.0, [77.0, 203.5, 341.0], 3000);
}

#[test]
fn at_three_degrees() {
    areas_agree(3.0, [12.3, 135.0, 270.0], 3000);
}

#[test]
fn at_ten_degrees() {
    areas_agree(10.0, [90.0, 180.0, 301.7], 10_000);
}

#[test]
fn at_forty_degrees() {
    areas_agree(40.0, [45.0, 222.2, 359.0], 30_000);
}
