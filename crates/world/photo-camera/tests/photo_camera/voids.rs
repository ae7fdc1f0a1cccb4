//! Voids: check values of the specification (7.4), planes, maxima, other ways, and what is refused.

use photo_camera::voids::{Border, Fill, VoidError, Wishes, fill};

use crate::Random;

const HARMONIC: Wishes = Wishes { fill: Fill::Harmonic, border: Border::StaysVoid, allow_large_holes: false };

fn by(fill: Fill) -> Wishes {
    Wishes { fill, ..HARMONIC }
}

/// Heights by row and column, with voids where `void` says.
fn grid(
    [rows, columns]: [usize; 2],
    height: impl Fn(f64, f64) -> f64,
    void: impl Fn(usize, usize) -> bool,
) -> Vec<f64> {
    (0..rows * columns)
        .map(|post| [post / columns, post % columns])
        .map(|[row, column]| if void(row, column) { f64::NAN } else { height(row as f64, column as f64) })
        .collect()
}

fn written_plane() -> Vec<f64> {
    grid([5, 5], |r, c| 100.0 + 10.0 * r + 3.0 * c, |r, c| [(1, 1), (1, 2), (2, 2)].contains(&(r, c)))
}

#[test]
fn fills_are_those_of_the_specification() {
    let filled = fill([5, 5], &written_plane(), HARMONIC).expect("a grid");
    for (post, expected) in [(6, 113.0), (7, 116.0), (12, 126.0)] {
        assert!((filled.heights[post] - expected).abs() < 1e-10);
    }
    assert_eq!((filled.holes, filled.largest_hole, filled.still_void), (1, 3, 0));
    assert_eq!(filled.was_void.iter().filter(|&&void| void).count(), 3);
    let mean = fill([5, 5], &written_plane(), by(Fill::WrittenMean)).expect("a grid");
    assert_eq!([6, 7, 12].map(|post| mean.heights[post]), [127.0; 3]);
    let curved = grid([5, 5], |r, c| r * r * c + 7.0 * c * c, |r, c| (r, c) == (2, 2));
    assert!((fill([5, 5], &curved, HARMONIC).expect("a grid").heights[12] - 40.5).abs() < 1e-12);
    // The mean of the known is 54.75 before it is cut to a metre.
    assert_eq!(fill([5, 5], &curved, by(Fill::WrittenMean)).expect("a grid").heights[12], 54.0);
}

#[test]
fn the_written_mean_makes_a_cliff_where_the_harmonic_fill_has_none() {
    let steepest = |wishes| {
        let heights = fill([5, 5], &written_plane(), wishes).expect("a grid").heights;
        let step = |pair: &[f64]| (pair[1] - pair[0]).abs();
        heights.chunks(5).flat_map(|row| row.windows(2).map(step)).fold(0.0, f64::max)
    };
    // 127 m beside the 110 m of row 1, column 0.
    assert!((steepest(by(Fill::WrittenMean)) - 17.0).abs() < 1e-9);
    assert!((steepest(HARMONIC) - 3.0).abs() < 1e-9);
}

#[test]
fn every_filled_post_is_the_mean_of_its_neighbours_and_within_the_rim() {
    let mut random = Random(7);
    for _ in 0..40 {
        let noise: Vec<f64> = (0..30 * 40).map(|_| random.between(-500.0, 3000.0)).collect();
        let holes: Vec<bool> = noise.iter().map(|_| random.unit() < 0.35).collect();
        let heights = grid([30, 40], |r, c| noise[r as usize * 40 + c as usize], |r, c| holes[r * 40 + c]);
        let wishes = Wishes { border: Border::Filled, ..HARMONIC };
        let filled = fill([30, 40], &heights, wishes).expect("a grid");
        for post in (0..heights.len()).filter(|&post| heights[post].is_nan()) {
            let (row, column) = (post / 40, post % 40);
            let mut beside = Vec::new();
            for (r, c) in [
                (row.wrapping_sub(1), column),
                (row + 1, column),
                (row, column.wrapping_sub(1)),
                (row, column + 1),
            ] {
                if r < 30 && c < 40 {
                    beside.push(filled.heights[r * 40 + c]);
                }
            }
            let mean = beside.iter().sum::<f64>() / beside.len() as f64;
            assert!((filled.heights[post] - mean).abs() < 1e-9, "{row} {column}");
            assert!((-500.0..=3000.0).contains(&filled.heights[post]));
        }
        assert!(heights.iter().zip(&filled.heights).all(|(was, is)| was.is_nan() || was == is));
    }
}

#[test]
fn planes_come_back_exactly_from_a_lake() {
    let plane = |r: f64, c: f64| 4000.0 - 7.0 * r + 11.0 * c;
    let lake = grid([60, 60], plane, |r, c| (20..45).contains(&r) && (18..48).contains(&c));
    let filled = fill([60, 60], &lake, HARMONIC).expect("a grid");
    for (post, height) in filled.heights.iter().enumerate() {
        assert!((height - plane((post / 60) as f64, (post % 60) as f64)).abs() < 1e-8, "{post}");
    }
}

/// Whether the post of a row and column is void.
type IsVoid = fn(usize, usize) -> bool;

/// Holes of many posts, by row and column of 150: a lake, one with islands, a ring, a thin slanting line, one whose islands leave the grid.
fn many_posts() -> [(&'static str, IsVoid); 5] {
    fn squared(row: usize, column: usize) -> usize {
        row.abs_diff(75).pow(2) + column.abs_diff(72).pow(2)
    }
    fn is_island(row: usize, column: usize) -> bool {
        (row * 7919 + column * 104_729) % 97 < 9
    }
    [
        ("a lake", |r, c| squared(r, c) < 40 * 40),
        ("a lake with islands", |r, c| squared(r, c) < 40 * 40 && !is_island(r, c)),
        ("a ring", |r, c| (50 * 50..54 * 54).contains(&squared(r, c))),
        ("a slanting line", |r, c| (20..130).contains(&r) && (r == c || r == c + 1)),
        ("posts between posts", |r, c| {
            (30..100).contains(&r) && (30..100).contains(&c) && (r % 3 > 0 || c % 5 > 0)
        }),
    ]
}

#[test]
fn holes_of_many_posts_and_any_shape_have_what_is_harmonic_around_them() {
    // The mean of four neighbours is the middle one, exactly.
    let harmonic = |r: f64, c: f64| 0.2 * (r - 60.0) * (r - 60.0) - 0.2 * c * c + 0.3 * r * c + 11.0;
    let truth = grid([150, 150], harmonic, |_, _| false);
    for (name, void) in many_posts() {
        let heights = grid([150, 150], harmonic, void);
        let filled = fill([150, 150], &heights, HARMONIC).expect("a grid");
        assert!(filled.largest_hole > 24 && filled.still_void == 0, "{name}");
        let worst = filled.heights.iter().zip(&truth).map(|(is, was)| (is - was).abs()).fold(0.0, f64::max);
        assert!(worst < 1e-7, "{name}: {worst}");
    }
}

#[test]
fn a_hole_of_many_posts_at_the_border_comes_to_balance() {
    let heights =
        grid([90, 70], |r, c| 3.0 * r - c * c, |r, c| r < 30 && c > 35 && (r * 31 + c * 17) % 23 > 1);
    let wishes = Wishes { border: Border::Filled, ..HARMONIC };
    let filled = fill([90, 70], &heights, wishes).expect("a grid").heights;
    for post in (0..heights.len()).filter(|&post| heights[post].is_nan()) {
        let [row, column] = [post / 70, post % 70].map(|at| at as i64);
        let beside: Vec<f64> = [(-1, 0), (1, 0), (0, -1), (0, 1)]
            .map(|(down, right)| [row + down, column + right])
            .into_iter()
            .filter(|[r, c]| (0..90).contains(r) && (0..70).contains(c))
            .map(|[r, c]| filled[(r * 70 + c) as usize])
            .collect();
        let mean = beside.iter().sum::<f64>() / beside.len() as f64;
        assert!((filled[post] - mean).abs() < 1e-8, "{row} {column}: {} {mean}", filled[post]);
    }
}

#[test]
fn threads_change_no_bit_of_a_fill() {
    let [_, (_, void), ..] = many_posts();
    let heights = grid([150, 150], |r, c| libm::sin(r / 9.0) + c, void);
    let by = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| fill([150, 150], &heights, HARMONIC)).expect("a grid").heights
    };
    let bits = |heights: Vec<f64>| heights.into_iter().map(f64::to_bits).collect::<Vec<_>>();
    assert_eq!(bits(by(1)), bits(by(3)));
}

#[test]
fn harmonic_beats_the_written_mean_for_scattered_voids_and_for_a_lake() {
    let ground = |r: f64, c: f64| 300.0 + 60.0 * libm::sin(r / 9.0) + 40.0 * libm::cos(c / 7.0) + r;
    let truth = grid([64, 64], ground, |_, _| false);
    let mut random = Random(8);
    let draws: Vec<f64> = truth.iter().map(|_| random.unit()).collect();
    let inside = |r: usize, c: usize| (1..63).contains(&r) && (1..63).contains(&c);
    for case in [0.01, 0.05, 0.2, f64::NAN] {
        let lake = |r: usize, c: usize| (20..44).contains(&r) && (20..44).contains(&c);
        let void = |r: usize, c: usize| {
            if case.is_nan() { lake(r, c) } else { inside(r, c) && draws[r * 64 + c] < case }
        };
        let heights = grid([64, 64], ground, void);
        let error = |wishes| {
            let filled = fill([64, 64], &heights, wishes).expect("a grid");
            let squares = filled.heights.iter().zip(&truth).map(|(is, was)| (is - was) * (is - was));
            (squares.sum::<f64>() / filled.was_void.iter().filter(|&&void| void).count() as f64).sqrt()
        };
        let [harmonic, mean] = [error(HARMONIC), error(by(Fill::WrittenMean))];
        println!("voids {case}: harmonic {harmonic:.3} m, written mean {mean:.3} m");
        assert!(harmonic < mean, "{case}: {harmonic} {mean}");
    }
}

#[test]
fn the_other_ways_do_what_they_say() {
    let heights = grid([5, 5], |r, c| 10.0 * r + c, |r, c| r == 2 && (1..4).contains(&c));
    let of = |way| fill([5, 5], &heights, by(way)).expect("a grid").heights;
    // The posts above come first by row.
    assert_eq!(of(Fill::Nearest)[11..14], [11.0, 12.0, 13.0]);
    let [above, below, left, right] = [[11.0, 12.0, 13.0], [31.0, 32.0, 33.0], [20.0; 3], [24.0; 3]];
    let weights = [[1.0, 0.5, 0.2], [1.0, 0.5, 0.2]];
    let sum: f64 = (0..3).map(|k| weights[0][k] * above[k] + weights[1][k] * below[k]).sum::<f64>()
        + left[0]
        + right[0] / 9.0;
    let total: f64 = 2.0 * (1.0 + 0.5 + 0.2) + 1.0 + 1.0 / 9.0;
    assert!((of(Fill::InverseDistance)[11] - sum / total).abs() < 1e-12);
    let left = fill([5, 5], &heights, by(Fill::Leave)).expect("a grid");
    assert_eq!((left.still_void, left.holes), (3, 1));
}

#[test]
fn posts_at_the_border_that_were_never_surveyed_stay_void() {
    let heights = grid([6, 6], |r, c| r + c, |r, c| c == 0 || (r, c) == (3, 1) || (r, c) == (2, 4));
    let filled = fill([6, 6], &heights, HARMONIC).expect("a grid");
    assert_eq!((filled.still_void, filled.holes, filled.largest_hole), (7, 2, 7));
    assert!(filled.heights[19].is_nan() && !filled.heights[16].is_nan());
    let all = fill([6, 6], &heights, Wishes { border: Border::Filled, ..HARMONIC }).expect("a grid");
    assert_eq!(all.still_void, 0);
}

#[test]
fn a_hole_above_a_quarter_is_refused_unless_it_is_allowed() {
    let heights = grid([7, 7], |r, c| r + c, |r, c| (1..5).contains(&r) && (1..5).contains(&c));
    let refused = fill([7, 7], &heights, HARMONIC);
    assert_eq!(refused, Err(VoidError::LargeHole { row: 1, column: 1, size: 16, posts: 49 }));
    let allowed = Wishes { allow_large_holes: true, ..HARMONIC };
    assert_eq!(fill([7, 7], &heights, allowed).expect("allowed").still_void, 0);
    assert!(fill([7, 7], &heights, by(Fill::Leave)).is_ok());
    let quarter = grid([8, 8], |r, c| r + c, |r, c| (2..6).contains(&r) && (2..6).contains(&c));
    assert!(fill([8, 8], &quarter, HARMONIC).is_ok());
}

#[test]
fn grids_that_are_none_are_refused() {
    let shape = |rows, columns, heights| fill([rows, columns], &vec![0.0; heights], HARMONIC);
    for (rows, columns, heights) in [(1, 4, 4), (4, 1, 4), (2, 2, 3), (usize::MAX, 2, 4)] {
        assert_eq!(shape(rows, columns, heights), Err(VoidError::Shape { rows, columns, heights }));
    }
    assert_eq!(fill([2, 2], &[f64::NAN; 4], HARMONIC), Err(VoidError::AllVoid { posts: 4 }));
    for found in [f64::INFINITY, f64::NEG_INFINITY, 9001.0, -40_000.0] {
        let refused = fill([2, 2], &[0.0, 0.0, 0.0, found], HARMONIC);
        assert_eq!(refused, Err(VoidError::Height { row: 1, column: 1, found }));
    }
}
