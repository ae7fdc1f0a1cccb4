//! Roughness, and bilinear heights between posts.

use terrain_builder::{HeightGrid, Posts, Roughness, bilinear};

use crate::near;

const AREA: [[f64; 2]; 2] = [[0.0; 2], [2000.0; 2]];

fn rough(seeds: &[u64]) -> Roughness {
    Roughness { seeds: seeds.to_vec(), scale: 2.0, spacing: 10.0, smoothing: 0.0 }
}

#[test]
fn the_bilinear_height_of_the_check_table_comes_out() {
    near(bilinear([[10.0, 14.0], [20.0, 30.0]], [0.6, 0.25]), 17.9, 1e-12);
}

#[test]
fn a_grid_has_its_posts_and_a_plane_between_them() {
    let posts = Posts::new([[10.0, -20.0], [40.0, 30.0]], 7.0);
    let plane = |[north, east]: [f64; 2]| 0.3 * north - 0.2 * east + 5.0;
    let grid = HeightGrid::new(posts, |post| plane(posts.place(post)));
    for place in [[10.0, -20.0], [40.0, 30.0], [22.2, 0.3], [39.999, 29.999]] {
        near(grid.height(place), plane(place), 1e-12);
    }
    assert_eq!([[9.9, 0.0], [20.0, 30.1]].map(|place| grid.height(place)), [0.0; 2]);
}

#[test]
fn roughness_does_not_lift_the_ground_and_does_as_reported() {
    let seeds = [1, 2, 3];
    let centred = rough(&seeds).heights(AREA, false).unwrap();
    let reported = rough(&seeds).heights(AREA, true).unwrap();
    // 40401 posts of three passes: the mean of a centred pass strays by 0.003 m.
    assert!(centred.mean().abs() < 0.02, "{}", centred.mean());
    near(reported.mean(), 3.0, 0.02);
}

#[test]
fn passes_add_up_in_any_order_and_the_last_is_undone_by_its_seed() {
    let both = rough(&[4, 9]).heights(AREA, false).unwrap();
    assert_eq!(rough(&[9, 4]).heights(AREA, false).unwrap(), both);
    let [one, other] = [4, 9].map(|seed| rough(&[seed]).heights(AREA, false).unwrap());
    let place = [703.0, 1201.0];
    near(both.height(place), one.height(place) + other.height(place), 1e-12);
    assert_ne!(one, other);
    let many = |seeds: [u64; 4]| rough(&seeds).heights(AREA, false).unwrap();
    assert_eq!(many([1, 2, 3, 4]), many([4, 2, 1, 3]));
    let none = rough(&[]).heights(AREA, false).unwrap();
    assert_eq!(none.height(place), 0.0);
}

#[test]
fn a_pass_is_even_between_its_bounds() {
    let pass = rough(&[5]).heights(AREA, true).unwrap();
    let heights: Vec<_> = pass.posts().all().map(|post| pass.post(post)).collect();
    assert!(heights.iter().all(|height| (0.0..2.0).contains(height)));
    for bound in [0.5, 1.0, 1.5] {
        let share = heights.iter().filter(|height| **height < bound).count() as f64 / heights.len() as f64;
        near(share, bound / 2.0, 0.01);
    }
}

#[test]
fn smoothing_lowers_the_spread_and_keeps_the_mean() {
    let spread = |smoothing: f64| {
        let heights = Roughness { smoothing, ..rough(&[8]) }.heights(AREA, true).unwrap();
        let mean = heights.mean();
        let squares =
            heights.posts().all().map(|post| (heights.post(post) - mean) * (heights.post(post) - mean));
        (mean, (squares.sum::<f64>() / 40_401.0).sqrt())
    };
    let ((mean, rough), (smooth_mean, smooth)) = (spread(0.0), spread(40.0));
    near(mean, smooth_mean, 0.01);
    near(rough, 2.0 / 12f64.sqrt(), 0.01);
    assert!(smooth < 0.3 * rough, "{smooth} of {rough}");
}

#[test]
fn bad_roughness_is_refused_by_its_key() {
    let refused = |rough: Roughness| rough.heights(AREA, false).expect_err("refused").key;
    assert_eq!(refused(Roughness { scale: -1.0, ..rough(&[1]) }), "scale_m");
    assert_eq!(refused(Roughness { scale: f64::NAN, ..rough(&[1]) }), "scale_m");
    assert_eq!(refused(Roughness { spacing: 0.0, ..rough(&[1]) }), "spacing_m");
    assert_eq!(refused(Roughness { smoothing: 600.0, ..rough(&[1]) }), "smoothing_m");
    assert_eq!(refused(rough(&[1; 1001])), "seeds");
}
