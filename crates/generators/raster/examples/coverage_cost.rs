//! What a sub-area costs: lists and coverage of about 20 000 triangles on 799 x 459 pixels, pattern by pattern.
//!
//! `cargo run --release -p raster --example coverage_cost` prints the times. With the name of a pattern it covers one frame and prints no
//! time: `valgrind --tool=callgrind` then counts the instructions of that pattern, and of none (`lists`) those of the lists.

use std::hint::black_box;
use std::time::Instant;

use raster::{Coverage, Lists, Pattern, Point, Sampling, Screen, Triangle};

const SIZE: [u32; 2] = [799, 459];
/// Frames of which the fastest counts.
const FRAMES: usize = 40;

/// A grid of uneven triangles over the screen, as a ground looks from above: 140 by 72 cells of two triangles.
fn ground() -> Vec<Triangle> {
    let cells = [140, 72];
    let mut seed = 1u32;
    let mut wander = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(seed >> 8) / f64::from(1 << 24) - 0.5
    };
    let mut corner = |i: u32, j: u32| {
        let along = |k: u32, axis: usize, off: f64| {
            (f64::from(k) + 0.8 * off) * f64::from(SIZE[axis]) / f64::from(cells[axis])
        };
        Point::snap([along(i, 0, wander()), along(j, 1, wander())]).expect("near the screen")
    };
    let grid: Vec<Vec<Point>> =
        (0..=cells[0]).map(|i| (0..=cells[1]).map(|j| corner(i, j)).collect()).collect();
    let squares = grid.windows(2).flat_map(|pair| {
        let [left, right] = [&pair[0], &pair[1]];
        (0..left.len() - 1).map(move |j| [left[j], right[j], right[j + 1], left[j + 1]])
    });
    squares.flat_map(|[p, q, r, s]| [[p, q, r], [p, r, s]]).filter_map(Triangle::new).collect()
}

/// Covers every sub-area by its list; returns the covered sampling points.
fn cover(screen: &Screen, triangles: &[Triangle], lists: &Lists, sampling: &Sampling) -> u64 {
    let mut coverage = Coverage::default();
    let mut samples = 0;
    for number in 0..screen.sub_areas() {
        let area = screen.sub_area(number);
        for &entry in lists.of(number) {
            coverage.find(&triangles[entry as usize], &area, sampling);
            samples += coverage.pixels().map(|(_, mask)| u64::from(mask.count_ones())).sum::<u64>();
        }
    }
    samples
}

/// The fastest of some calls (µs).
fn fastest(mut call: impl FnMut()) -> f64 {
    let once = |_| {
        let start = Instant::now();
        call();
        start.elapsed().as_secs_f64() * 1e6
    };
    (0..FRAMES).map(once).fold(f64::INFINITY, f64::min)
}

fn main() {
    let screen = Screen::new(SIZE, 8).expect("a screen");
    let triangles = ground();
    let mut lists = Lists::default();
    lists.fill(&screen, &triangles);
    if let Some(name) = std::env::args().nth(1) {
        if let Some(pattern) = Pattern::named(&name) {
            black_box(cover(&screen, &triangles, &lists, &Sampling::new(pattern)));
        }
        return;
    }
    let sub_areas = screen.sub_areas() as f64;
    println!("{} triangles, {sub_areas} sub-areas, {} entries", triangles.len(), lists.entries());
    println!("lists: {:.0} µs a frame", fastest(|| lists.fill(&screen, black_box(&triangles))));
    for pattern in Pattern::ALL {
        let sampling = Sampling::new(pattern);
        let mut samples = 0;
        let time = fastest(|| samples = cover(&screen, black_box(&triangles), &lists, &sampling));
        println!(
            "{:>12}: {:.0} µs a frame, {:.3} µs a sub-area, {samples} samples",
            pattern.name(),
            time,
            time / sub_areas
        );
    }
}
