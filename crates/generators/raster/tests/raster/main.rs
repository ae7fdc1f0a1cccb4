//! The rasteriser against evaluators that share no code with it, closed forms and exact areas.

mod brute_force;
mod check_values;
mod clipping;
mod convergence;
mod lists;
mod partition;
mod patterns;
mod random;

use raster::{Coverage, Lists, Point, Sampling, Screen, Triangle};

/// The triangle of corners in pixels, if it has an area.
fn triangle(corners: [[f64; 2]; 3]) -> Option<Triangle> {
    Triangle::new(corners.map(|corner| Point::snap(corner).expect("a corner near the raster")))
}

/// What is covered of a whole screen through its lists: pixel (x, y), number of the triangle, bits of the samples.
fn covered(screen: &Screen, triangles: &[Triangle], sampling: &Sampling) -> Vec<([u32; 2], u32, u32)> {
    let (mut lists, mut coverage, mut found) = (Lists::default(), Coverage::default(), Vec::new());
    lists.fill(screen, triangles);
    for number in 0..screen.sub_areas() {
        let area = screen.sub_area(number);
        let (left, top) = (area.columns().start, area.rows().start);
        for &entry in lists.of(number) {
            coverage.find(&triangles[entry as usize], &area, sampling);
            for (pixel, mask) in coverage.pixels() {
                let place = [left + pixel as u32 % 8, top + pixel as u32 / 8];
                assert!(area.columns().contains(&place[0]) && area.rows().contains(&place[1]), "{place:?}");
                assert_ne!(mask, 0);
                found.push((place, entry, mask));
            }
        }
    }
    found
}
