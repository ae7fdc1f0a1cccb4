//! Voids of a grid, filled harmonically, against one pass of plain relaxation over the same voids.

use std::time::Instant;

use benchmarks::peers::median;
use photo_camera::voids::{Fill, Wishes, fill};
use quantities::sin_cos;
use rayon::ThreadPool;

use crate::guests::Sense;
use crate::row::Row;

/// Posts along a side.
const POSTS: usize = 1000;
/// Share of them that is missing.
const MISSING: f64 = 0.2;
/// Turns of each side.
const TURNS: usize = 7;

/// Rows of one lake, and of scattered voids.
pub fn rows(pool: &ThreadPool) -> Result<[Row; 2], String> {
    Ok([row("one lake", is_lake, [150.0, 60.0], pool)?, row("scattered", is_scattered, [40.0, 15.0], pool)?])
}

fn is_lake(post: usize) -> bool {
    let [row, column] =
        [post / POSTS, post % POSTS].map(|at| (at as f64 - 0.5 * POSTS as f64) / POSTS as f64);
    row * row + column * column < MISSING / std::f64::consts::PI
}

fn is_scattered(post: usize) -> bool {
    // SplitMix64 of the post's number.
    let mut bits = (post as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((bits ^ (bits >> 31)) as f64) < MISSING * u64::MAX as f64
}

fn row(name: &str, is_void: fn(usize) -> bool, figures: [f64; 2], pool: &ThreadPool) -> Result<Row, String> {
    let is_inside = |post: usize| [post / POSTS, post % POSTS].iter().all(|at| (1..POSTS - 1).contains(at));
    let voids: Vec<usize> = (0..POSTS * POSTS).filter(|post| is_inside(*post) && is_void(*post)).collect();
    let mut relaxed: Vec<f64> = (0..POSTS * POSTS).map(height).collect();
    let mut heights = relaxed.clone();
    voids.iter().for_each(|post| heights[*post] = f64::NAN);
    let wishes = Wishes { fill: Fill::Harmonic, ..Wishes::default() };
    let (mut ours, mut passes, mut left) = (Vec::new(), Vec::new(), 0.0);
    for _ in 0..TURNS {
        let begin = Instant::now();
        let filled =
            pool.install(|| fill([POSTS; 2], &heights, wishes)).map_err(|error| error.to_string())?;
        ours.push(begin.elapsed().as_secs_f64());
        let begin = Instant::now();
        voids.iter().for_each(|post| relaxed[*post] = mean_around(&relaxed, *post));
        passes.push(begin.elapsed().as_secs_f64());
        let apart = |post: &usize| (filled.heights[*post] - mean_around(&filled.heights, *post)).abs();
        left = voids.iter().map(apart).fold(0.0, f64::max);
    }
    let quantity =
        format!("fill of voids, {POSTS} x {POSTS} posts, {name}, against one pass of plain relaxation");
    let remark = format!("{} voids, at most {left:.1e} m from the mean of their neighbours", voids.len());
    Ok(Row::of_times(38, quantity, (Sense::TimesTheTime, figures), [median(ours), median(passes)], remark))
}

/// Height of a post (m): two waves.
fn height(post: usize) -> f64 {
    let wave = |at: usize, length: f64| sin_cos(at as f64 / length).0;
    50.0 * (wave(post / POSTS, 20.0) + wave(post % POSTS, 33.0))
}

fn mean_around(heights: &[f64], post: usize) -> f64 {
    0.25 * (heights[post - 1] + heights[post + 1] + heights[post - POSTS] + heights[post + POSTS])
}
