//! Light in footprints that cover many pixels.

use glam::DVec3;
use photo_drape::{Choice, Footprint};

use crate::{drape, from_above, plane};

/// Half axes of so many metres to the east and to the north.
fn footprint(east: f64, north: f64) -> Footprint {
    Footprint { across: DVec3::Y * east, along: DVec3::X * north }
}

#[test]
fn a_wide_footprint_has_the_mean_of_its_pixels() {
    let chess = |column: usize, line: usize| ((column + line) % 2) as f64;
    let drape = drape(plane([0.0; 2]), vec![from_above(500.0, chess, None)], 10.0, Choice::Best).unwrap();
    for place in [[200.0, 200.0], [181.3, 222.7], [240.1, 155.5]] {
        let light = drape.at(DVec3::new(place[0], place[1], 0.0), &footprint(8.0, 8.0)).unwrap().light;
        assert!((light - 0.5).abs() < 0.01, "{place:?}: {light}");
    }
}

#[test]
fn a_long_footprint_is_sharp_across() {
    // Stripes of 4 m to the north and south of one another; they run east.
    let stripes = |_: usize, line: usize| ((line / 8) % 2) as f64;
    let drape = drape(plane([0.0; 2]), vec![from_above(500.0, stripes, None)], 10.0, Choice::Best).unwrap();
    // The middle of a stripe: line 204 of 0.5 m a pixel is 2 m south of the middle.
    let place = DVec3::new(198.0, 200.0, 0.0);
    let along_stripe = drape.at(place, &footprint(12.0, 1.0)).unwrap().light;
    assert!((along_stripe - 1.0).abs() < 0.02, "{along_stripe}");
    let across_stripes = drape.at(place, &footprint(1.0, 12.0)).unwrap().light;
    assert!((across_stripes - 0.5).abs() < 0.1, "{across_stripes}");
    // The same ellipse by other half axes: conjugate ones.
    let turned = Footprint {
        across: (DVec3::Y * 12.0 + DVec3::X) / std::f64::consts::SQRT_2,
        along: (DVec3::Y * 12.0 - DVec3::X) / std::f64::consts::SQRT_2,
    };
    let conjugate = drape.at(place, &turned).unwrap().light;
    assert!((conjugate - along_stripe).abs() < 1e-9, "{conjugate} {along_stripe}");
}

#[test]
fn a_seen_footprint_grows_with_distance_and_slant() {
    let eye = DVec3::new(0.0, 0.0, 30.0);
    let found = Footprint::seen(DVec3::new(40.0, 0.0, 0.0), DVec3::Z, eye, 1e-3);
    assert!((found.across.length() - 0.05).abs() < 1e-12, "half a pixel's angle times 50 m");
    assert!((found.along.length() - 0.05 * 50.0 / 30.0).abs() < 1e-12, "over the cosine of the slant");
    assert!(found.across.x.abs() < 1e-12 && found.along.y.abs() < 1e-12);
    let below = Footprint::seen(DVec3::ZERO, DVec3::Z, eye, 1e-3);
    assert!((below.across.length() - 0.03).abs() < 1e-12 && (below.along.length() - 0.03).abs() < 1e-12);
}
