//! The published triangle: its lists and its samples.

use std::collections::BTreeSet;

use raster::{Lists, Pattern, Sampling, Screen};

use crate::{covered, triangle};

const CORNERS: [[f64; 2]; 3] = [[10.0, 10.0], [50.0, 20.0], [20.0, 60.0]];

fn screen() -> Screen {
    Screen::new([64, 64], 8).expect("a screen")
}

#[test]
fn its_lists_have_one_sub_area_too_many() {
    let triangles = [triangle(CORNERS).expect("an area")];
    let mut lists = Lists::default();
    lists.fill(&screen(), &triangles);
    assert_eq!(lists.entries(), 27);
    let hit = covered(&screen(), &triangles, &Sampling::new(Pattern::Sixteen));
    let sub_areas: BTreeSet<_> = hit.iter().map(|([x, y], ..)| [x / 8, y / 8]).collect();
    assert_eq!(sub_areas.len(), 26);
}

#[test]
fn its_samples_are_counted_with_every_pattern() {
    let triangles = [triangle(CORNERS).expect("an area")];
    for (pattern, expected) in [
        (Pattern::One, 955),
        (Pattern::Four, 3810),
        (Pattern::Eight, 7620),
        (Pattern::Sixteen, 15230),
        (Pattern::Grid16, 15220),
        (Pattern::Lattice32, 30410),
        (Pattern::OffCentre16, 15190),
    ] {
        let hit = covered(&screen(), &triangles, &Sampling::new(pattern));
        let samples: u32 = hit.iter().map(|(.., mask)| mask.count_ones()).sum();
        assert_eq!(samples, expected, "{}", pattern.name());
    }
}

/// Only the off-centre table has samples on an edge of the triangle, so only it tells the top-left rule from others.
#[test]
fn the_off_centre_table_tells_the_rules_apart() {
    let on_or_inside = |[x, y]: [f64; 2]| {
        let edges =
            [-10.0 * x + 40.0 * y - 300.0, -40.0 * x - 30.0 * y + 2600.0, 50.0 * x - 10.0 * y - 400.0];
        edges.iter().all(|&value| value >= 0.0)
    };
    for (pattern, expected) in [(Pattern::OffCentre16, 15210), (Pattern::Sixteen, 15230)] {
        let sampling = Sampling::new(pattern);
        let pixels = (0..64 * 64).map(|i| [i % 64, i / 64]);
        let all = pixels.flat_map(|pixel| sampling.places(pixel).collect::<Vec<_>>());
        assert_eq!(all.filter(|&place| on_or_inside(place)).count(), expected, "{}", pattern.name());
    }
}
