//! Pixels in triangles: each centre once.

use glam::DVec3;
use photo_drape::Choice;
use quantities::unit_interval;

use crate::{drape, from_above, plane};

#[test]
fn triangles_share_out_the_pixels_of_a_polygon() {
    // Light is 2^-20 a pixel but for its number, so that sums tell which pixels were met.
    let number = |column: usize, line: usize| ((column * 7 + line * 13) % 100) as f64 / 100.0;
    let drape = drape(plane([0.0; 2]), vec![from_above(500.0, number, None)], 10.0, Choice::Best).unwrap();
    for seed in 0..50 {
        // A square of the map whose corners are pixel corners or lie anywhere, cut into a fan about a point that may lie on a side.
        let at = |word: u64| 60.0 * unit_interval(seed, &[word]);
        let whole = |word: u64| if seed % 2 == 0 { at(word).round() / 2.0 } else { at(word) };
        let middle = DVec3::new(190.0 + whole(1) / 4.0, 190.0 + whole(2) / 4.0, 0.0);
        let corners = [[180.0, 180.0], [180.0, 220.0], [220.0, 220.0], [220.0, 180.0]]
            .map(|[north, east]| DVec3::new(north, east, 0.0));
        let (mut sum, mut count) = (0.0, 0);
        for k in 0..4 {
            let triangle = [middle, corners[k], corners[(k + 1) % 4]];
            // Either way round.
            let triangle = if k % 2 == 0 { triangle } else { [triangle[0], triangle[2], triangle[1]] };
            if let Some((light, pixels)) = drape.mean_in(0, triangle) {
                (sum, count) = (sum + light * f64::from(pixels), count + pixels);
            }
        }
        // 40 m x 40 m of half a metre: lines 160 to 239, columns 160 to 239.
        let expected: f64 =
            (160..240).flat_map(|line| (160..240).map(move |column| number(column, line))).sum();
        assert_eq!(count, 6400, "seed {seed}");
        assert!((sum - expected).abs() < 0.1, "seed {seed}: {sum} {expected}");
    }
}

#[test]
fn a_triangle_between_centres_has_no_pixel() {
    let drape =
        drape(plane([0.0; 2]), vec![from_above(500.0, |_, _| 0.5, None)], 10.0, Choice::Best).unwrap();
    let at = |north: f64, east: f64| DVec3::new(200.0 + north, 200.0 + east, 0.0);
    assert_eq!(drape.mean_in(0, [at(0.0, 0.0), at(0.0, 0.1), at(0.1, 0.0)]), None);
    assert_eq!(drape.mean_in(0, [at(0.0, 0.0), at(1.0, 1.0), at(2.0, 2.0)]), None, "no area");
}
