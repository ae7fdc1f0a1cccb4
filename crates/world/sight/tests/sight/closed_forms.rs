//! Ground whose shadow is known.

use sight::{Curvature, Point, Sight};

use crate::{Random, posts};

const MOON: f64 = 1_737_400.0;

#[test]
fn flat_ground_is_seen_from_every_height() {
    let flat = posts([40, 57], 25.0, |_, _| 12.5);
    for height in [0.001, 1.0, 1e3, 1e6] {
        let eye = Point::above_ground([-333.0, 471.0], height);
        let seen = flat.viewshed(&eye, 0.0, Curvature::FLAT).unwrap();
        assert!(seen.iter().all(|&sight| sight == Sight::Visible), "{height}");
        assert!(flat.least_heights(&eye, Curvature::FLAT).unwrap().iter().all(|&least| least == 0.0));
    }
}

#[test]
fn a_ridge_hides_what_similar_triangles_say() {
    // A ridge of 8 m at column 20; the eye stands 10 m high at column 0. The line over the ridge falls 2 m in 20 posts.
    let ridge = posts([3, 141], 5.0, |_, column| if column == 20 { 8.0 } else { 0.0 });
    let eye = Point::above_ground([-5.0, 0.0], 10.0);
    let least = ridge.least_heights(&eye, Curvature::FLAT).unwrap();
    let seen = ridge.viewshed(&eye, 0.0, Curvature::FLAT).unwrap();
    for column in 21..141 {
        let expected = (10.0 - 0.1 * column as f64).max(0.0);
        assert!((least[141 + column] - expected).abs() < 1e-12, "{column}");
        let touching = column == 100;
        assert!(touching || (seen[141 + column] == Sight::Visible) == (column > 100), "{column}");
    }
}

#[test]
fn touching_ground_is_seen() {
    let ridge = posts([3, 9], 1.0, |_, column| if column == 4 { 2.0 } else { 0.0 });
    let eye = Point::above_ground([-1.0, 0.0], 4.0);
    let seen = ridge.line_of_sight(&eye, &Point::above_ground([-1.0, 8.0], 0.0), Curvature::FLAT).unwrap();
    assert_eq!((seen.sight, seen.clearance, seen.blocker), (Sight::Visible, 0.0, None));
    assert_eq!(ridge.viewshed(&eye, 0.0, Curvature::FLAT).unwrap()[9 + 8], Sight::Visible);
    let lower = Point::above_ground([-1.0, 0.0], 3.999);
    let hidden =
        ridge.line_of_sight(&lower, &Point::above_ground([-1.0, 8.0], 0.0), Curvature::FLAT).unwrap();
    assert_eq!(hidden.sight, Sight::Hidden);
    assert!((hidden.clearance + 0.0005).abs() < 1e-12);
    assert!((hidden.least_height.unwrap() - 0.001).abs() < 1e-12);
}

#[test]
fn the_first_blocker_is_where_the_line_meets_the_slope() {
    // The flank rises by 6 m from column 4 to column 5; the line falls from 4 m by 0.5 m a post.
    let two = posts([3, 9], 10.0, |_, column| if column == 5 || column == 7 { 6.0 } else { 0.0 });
    let eye = Point::above_ground([-10.0, 0.0], 4.0);
    let line = two.line_of_sight(&eye, &Point::above_ground([-10.0, 80.0], 0.0), Curvature::FLAT).unwrap();
    let meets = 10.0 * (4.0 + 2.0 / 6.5);
    let blocker = line.blocker.unwrap();
    assert!((blocker.distance - meets).abs() < 1e-12 * meets);
    assert!((blocker.place[0] + 10.0).abs() < 1e-12 && (blocker.place[1] - meets).abs() < 1e-12 * meets);
    // The second ridge stands farther above the line: 6 m against 0.5 m.
    assert!((line.clearance + 5.5).abs() < 1e-12);
}

/// Over one cell of smooth ground of radius R the ground stands L^2 / 8R above the chord, in the middle of the cell.
#[test]
fn ground_bulges_between_two_neighbouring_posts() {
    let curvature = Curvature::parabolic(1000.0, 0.0).unwrap();
    let flat = posts([2, 3], 100.0, |_, _| 0.0);
    let bulge = 100.0 * 100.0 / 8000.0;
    for (height, sight) in [(bulge - 0.25, Sight::Hidden), (bulge + 0.25, Sight::Visible)] {
        let eye = Point::above_ground([0.0, 0.0], height);
        let seen = flat.line_of_sight(&eye, &Point::above_ground([0.0, 100.0], height), curvature).unwrap();
        assert_eq!(seen.sight, sight, "{height}");
        assert!((seen.clearance - (height - bulge)).abs() < 1e-9, "{}", seen.clearance);
    }
}

#[test]
fn the_horizon_of_a_smooth_body_is_at_the_root_of_twice_radius_times_height() {
    for (refraction, height) in [(0.0, 2.0), (0.0, 50.0), (0.13, 20.0)] {
        let curvature = Curvature::parabolic(MOON, refraction).unwrap();
        let horizon = (2.0 * MOON / (1.0 - refraction) * height).sqrt();
        let spacing = horizon / 700.3;
        let flat = posts([2, 1001], spacing, |_, _| 0.0);
        let eye = Point::above_ground([0.0, 0.0], height);
        let seen = flat.viewshed(&eye, 0.0, curvature).unwrap();
        let least = flat.least_heights(&eye, curvature).unwrap();
        for column in 1..1001 {
            let beyond = column as f64 * spacing - horizon;
            assert_eq!(seen[column] == Sight::Visible, beyond <= 0.0, "{column}");
            let expected = curvature.drop(beyond.max(0.0));
            assert!((least[column] - expected).abs() < 1e-9, "{column}: {} {expected}", least[column]);
        }
    }
}

#[test]
fn a_target_at_its_least_height_is_seen_and_below_it_is_not() {
    let mut random = Random(5);
    let heights = random.rough([33, 40], 20.0);
    let ground = posts([33, 40], 10.0, |row, column| heights[row * 40 + column]);
    for curvature in [Curvature::FLAT, Curvature::parabolic(4000.0, 0.0).unwrap()] {
        let eye = Point::above_ground([-152.0, 187.0], 1.7);
        let least = ground.least_heights(&eye, curvature).unwrap();
        let mut hidden = 0;
        for (post, &least) in least.iter().enumerate() {
            let place = ground.place(post / 40, post % 40);
            let sight = |height: f64| {
                let target = Point::above_ground(place, height);
                ground.line_of_sight(&eye, &target, curvature).unwrap().sight
            };
            assert_eq!(sight(least + 1e-9), Sight::Visible);
            if least > 1e-6 {
                hidden += 1;
                assert_eq!(sight(least - 1e-9), Sight::Hidden);
            }
        }
        assert!(hidden > 300, "{hidden}");
    }
}

#[test]
fn who_sees_is_seen() {
    let mut random = Random(11);
    let heights = random.rough([50, 50], 15.0);
    let ground = posts([50, 50], 7.0, |row, column| heights[row * 50 + column]);
    let mut counts = [0, 0];
    for trial in 0..3000 {
        let curvature = [Curvature::FLAT, Curvature::parabolic(5000.0, 0.0).unwrap()][trial % 2];
        let mut point = || {
            let place = [random.between(-343.0, 0.0), random.between(0.0, 343.0)];
            Point::above_ground(place, 2.0)
        };
        let (a, b) = (point(), point());
        let [there, back] = [(a, b), (b, a)].map(|(a, b)| ground.line_of_sight(&a, &b, curvature).unwrap());
        assert!((there.clearance - back.clearance).abs() < 1e-10);
        if there.clearance.abs() > 1e-10 {
            assert_eq!(there.sight, back.sight);
            counts[usize::from(there.sight == Sight::Hidden)] += 1;
        }
    }
    assert!(counts.into_iter().all(|count| count > 300), "{counts:?}");
}

#[test]
fn a_level_is_the_mesh_of_its_own_posts() {
    let mut random = Random(3);
    let heights = random.rough([33, 49], 9.0);
    let ground = posts([33, 49], 4.0, |row, column| heights[row * 49 + column]);
    let level = ground.level(2).unwrap();
    let own = posts([9, 13], 16.0, |row, column| heights[4 * row * 49 + 4 * column]);
    let eye = Point::above_ground([-50.0, 60.0], 1.0);
    assert_eq!(level.size(), [9, 13]);
    let [level, own] = [level, own].map(|mesh| mesh.viewshed(&eye, 0.5, Curvature::FLAT).unwrap());
    assert_eq!(level, own);
}
