//! How long a viewshed of 1025 x 1025 posts takes: `cargo run --release -p sight --example viewshed_time`.

use std::time::Instant;

use sight::{Curvature, Point, Posts, Sight};

const SIDE: usize = 1025;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let posts = Posts::new([SIDE; 2], [0.0; 2], 100.0, fractal(1))?;
    for height in [0.001, 2.0, 50.0, 1e3, 1e6] {
        let eye = Point::above_ground([-48_350.0, 53_170.0], height);
        let begin = Instant::now();
        let seen = posts.viewshed(&eye, 0.0, Curvature::FLAT)?;
        let viewshed = begin.elapsed();
        let begin = Instant::now();
        posts.least_heights(&eye, Curvature::FLAT)?;
        let visible = seen.iter().filter(|&&sight| sight == Sight::Visible).count();
        println!(
            "eye {height} m: {visible} visible, viewshed {viewshed:.2?}, least heights {:.2?}",
            begin.elapsed()
        );
    }
    Ok(())
}

/// Midpoint displacement, halved from scale to scale, 300 m at the largest.
fn fractal(seed: u64) -> Vec<f64> {
    let mut heights = vec![0.0; SIDE * SIDE];
    let random = |at: usize, step: usize| {
        let mut mixed = (at as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (step as u64) << 40 ^ seed;
        mixed = (mixed ^ mixed >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ mixed >> 31) >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let mut step = (SIDE - 1) / 2;
    while step > 0 {
        let size = 600.0 * step as f64 / SIDE as f64;
        let fine = |k: usize| !(k / step).is_multiple_of(2);
        for row in (0..SIDE).step_by(step) {
            for column in (0..SIDE).step_by(step) {
                if fine(row) || fine(column) {
                    let near = |k: usize, by: bool| if by { [k - step, k + step] } else { [k, k] };
                    let [rows, columns] = [near(row, fine(row)), near(column, fine(column))];
                    let corners =
                        rows.iter().flat_map(|row| columns.map(|column| heights[row * SIDE + column]));
                    let mean = corners.sum::<f64>() / 4.0;
                    heights[row * SIDE + column] = mean + size * random(row * SIDE + column, step);
                }
            }
        }
        step /= 2;
    }
    heights
}
