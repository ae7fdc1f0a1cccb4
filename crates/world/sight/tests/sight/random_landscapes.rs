//! Random landscapes against dense sampling, and areas against their lines.

use features::{Crater, Shape};
use rayon::ThreadPoolBuilder;
use sight::{Curvature, Point, Raster, Sight, Terrain};

use crate::Random;
use crate::landscapes::{FLAT, level, terrain};

/// Random terrain with craters of all kinds, on two levels.
fn random_ground(random: &mut Random, levels: usize) -> Terrain {
    let mut words = |_: f64, _: f64| std::array::from_fn(|_| random.between(-6.0, 6.0));
    let fine = level(6, 40.0, &mut words);
    let coarse = level(6, 80.0, &mut words);
    let crater = |number: u32| {
        let reach = random.between(6.0, 28.0);
        let centre = [random.between(30.0, 170.0), random.between(30.0, 170.0)];
        let (shape, rim) = match number % 3 {
            0 => (Shape::Bowl { r1: reach }, 0.0),
            1 => (Shape::RimmedBowl { r1: 0.7 * reach, r2: reach }, 2.5),
            _ => (Shape::FlatFloor { r1: 0.3 * reach, r2: 0.7 * reach, r3: reach }, 1.5),
        };
        Crater::new(centre, shape, 4.0, rim).unwrap()
    };
    let craters = (0..9).map(crater).collect();
    let levels = [fine, coarse].into_iter().take(levels).collect();
    terrain(levels, craters)
}

struct Sampled {
    /// Least clearance of the line (m).
    clearance: f64,
    /// Distance (m) of the first place below the line, by more than 1e-6 m.
    first: Option<f64>,
    /// Least rise (m) of the target.
    rise: f64,
}

fn sampled(ground: &Terrain, from: [f64; 3], to: [f64; 3], curvature: Curvature) -> Sampled {
    const STEPS: u32 = 40_000;
    let length = libm::hypot(to[0] - from[0], to[1] - from[1]);
    let end = to[2] - curvature.drop(length);
    let mut found = Sampled { clearance: f64::INFINITY, first: None, rise: 0.0 };
    for step in 1..STEPS {
        let t = f64::from(step) / f64::from(STEPS);
        let place = [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])];
        let line = from[2] + t * (end - from[2]) + curvature.drop(t * length);
        let clearance = line - ground.height(place).unwrap();
        found.clearance = found.clearance.min(clearance);
        found.rise = found.rise.max(-clearance / t);
        if clearance < -1e-6 && found.first.is_none() {
            found.first = Some(t * length);
        }
    }
    found
}

#[test]
fn random_ground_agrees_with_dense_sampling() {
    let mut random = Random(11);
    let bodies = [FLAT, Curvature::parabolic(2e3, 0.0).unwrap(), Curvature::spherical(900.0, 0.1).unwrap()];
    let [mut visible, mut hidden, mut judged] = [0; 3];
    for round in 0..90 {
        let levels = 1 + round % 2;
        let side = if levels == 1 { 199.0 } else { 399.0 };
        let ground = random_ground(&mut random, levels);
        let curvature = bodies[round % 3];
        let [eye, target] = [0, 1].map(|_| [random.between(1.0, side), random.between(1.0, side)]);
        let heights = [random.between(0.01, 25.0), random.between(0.01, 15.0)];
        let point = |end: usize| Point::above_ground([eye, target][end], heights[end]);
        let line = ground.line_of_sight(&point(0), &point(1), curvature).unwrap();
        let at = |place: [f64; 2], height: f64| [place[0], place[1], ground.height(place).unwrap() + height];
        let many = sampled(&ground, at(eye, heights[0]), at(target, heights[1]), curvature);
        let least = many.clearance.min(heights[0]).min(heights[1]);
        // Samples stand 1 cm apart at most: between two of them ground of this steepness moves by less than a few centimetres.
        assert!(
            line.clearance <= least + 1e-9 && line.clearance > least - 0.05,
            "{round}: {} {least}",
            line.clearance
        );
        if line.clearance > 1e-6 || least < -1e-6 {
            assert_eq!(line.sight == Sight::Hidden, least < 0.0, "{round}");
            judged += 1;
        }
        if let (Some(blocker), Some(first)) = (line.blocker, many.first) {
            assert!(
                blocker.distance <= first + 1e-9 && blocker.distance > first - 1.0,
                "{round}: {blocker:?} {first}"
            );
        }
        let bare = sampled(&ground, at(eye, heights[0]), at(target, 0.0), curvature);
        let rise = line.least_height.unwrap();
        assert!(rise >= bare.rise - 1e-7 && rise < bare.rise + 0.2, "{round}: {rise} {}", bare.rise);
        let sight = |height: f64| {
            let target = Point::above_ground(target, height);
            ground.line_of_sight(&point(0), &target, curvature).unwrap().sight
        };
        assert_eq!(sight(rise + 1e-6), Sight::Visible, "{round}");
        assert!(rise < 1e-5 || sight(rise - 1e-6) == Sight::Hidden, "{round}: {rise}");
        visible += usize::from(line.sight == Sight::Visible);
        hidden += usize::from(line.sight == Sight::Hidden);
    }
    assert!(visible > 10 && hidden > 10 && judged > 80, "{visible} {hidden} {judged}");
}

#[test]
fn an_area_is_its_lines_by_any_number_of_threads() {
    let ground = random_ground(&mut Random(3), 1);
    let targets = Raster { size: [9, 11], corner: [210.0, 5.0], spacing: 19.0 };
    let eye = Point::above_ground([77.0, 88.0], 6.0);
    let of = |threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let seen = ground.viewshed(&eye, &targets, 0.5, FLAT, &|| ()).unwrap();
            (seen, ground.least_heights(&eye, &targets, FLAT, &|| ()).unwrap())
        })
    };
    let (seen, least) = of(1);
    let (again, least_again) = of(3);
    assert_eq!(seen, again);
    assert!(least.iter().zip(&least_again).all(|(a, b)| a.to_bits() == b.to_bits()));
    assert_eq!((seen[0], least[0].is_nan()), (Sight::Unknown, true));
    for at in 11..99 {
        let place = targets.place(at / 11, at % 11);
        let line = ground.line_of_sight(&eye, &Point::above_ground(place, 0.5), FLAT).unwrap();
        assert_eq!((line.sight, line.least_height), (seen[at], Some(least[at])), "{place:?}");
    }
    let points: Vec<Point> =
        (11..99).map(|at| Point::above_ground(targets.place(at / 11, at % 11), 0.5)).collect();
    let along = ground.along(&eye, &points, FLAT).unwrap();
    assert!(along.iter().zip(&seen[11..]).all(|(line, &sight)| line.sight == sight));
}
