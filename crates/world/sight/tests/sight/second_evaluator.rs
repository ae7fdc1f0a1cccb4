//! Every triangle of a mesh, one after the other, against the walk and its pyramid.

use rayon::ThreadPoolBuilder;
use sight::{Curvature, Point, Posts, Sight};

use crate::{Random, posts};

/// Heights and places of an observer and a target, with the radius of the body.
pub struct Ends {
    pub from: [f64; 3],
    pub to: [f64; 3],
    pub radius: f64,
}

/// Least clearance (m) over all triangles, and the height by which the target must rise to clear them, ends of the way left out.
/// The line is cut at the sides of each triangle, and the ground looked at in `parts` + 1 places of what is left.
pub fn over_all_triangles(posts: &Posts, ends: &Ends, parts: u32) -> [f64; 2] {
    let mut found = [f64::INFINITY, f64::NEG_INFINITY];
    let [rows, columns] = posts.size();
    for cell in 0..(rows - 1) * (columns - 1) {
        let [i, j] = [cell / (columns - 1), cell % (columns - 1)];
        for middle in [[i + 1, j], [i, j + 1]] {
            let corners = [[i, j], middle, [i + 1, j + 1]].map(|[row, column]| {
                let [north, east] = posts.place(row, column);
                [north, east, posts.post(row, column)]
            });
            over_triangle(&corners, ends, parts, &mut found);
        }
    }
    found
}

fn over_triangle(corners: &[[f64; 3]; 3], ends: &Ends, parts: u32, found: &mut [f64; 2]) {
    // Barycentric weights at both ends of the way; each is linear along it.
    let weights = [&ends.from, &ends.to].map(|point| barycentric(corners, point));
    let (mut first, mut last) = (0.0f64, 1.0f64);
    for k in 0..3 {
        let [a, b] = [weights[0][k], weights[1][k]];
        if a < 0.0 && b < 0.0 {
            return;
        }
        let zero = a / (a - b);
        if a < 0.0 {
            first = first.max(zero)
        } else if b < 0.0 {
            last = last.min(zero)
        }
    }
    if first > last {
        return;
    }
    let length2: f64 = (0..2).map(|axis| square(ends.to[axis] - ends.from[axis])).sum();
    for part in 0..=parts {
        let t = first + (last - first) * f64::from(part) / f64::from(parts);
        if !(1e-9..=1.0 - 1e-9).contains(&t) {
            continue;
        }
        let weight = |k: usize| weights[0][k] + t * (weights[1][k] - weights[0][k]);
        let ground: f64 = (0..3).map(|k| weight(k) * corners[k][2]).sum();
        // As the observer's tangent plane has it: what is away has dropped.
        let drop = |share: f64| length2 * share * share / (2.0 * ends.radius);
        let line = ends.from[2] + t * (ends.to[2] - drop(1.0) - ends.from[2]);
        let clearance = line - (ground - drop(t));
        *found = [found[0].min(clearance), found[1].max(-clearance / t)];
    }
}

fn barycentric([p, q, r]: &[[f64; 3]; 3], point: &[f64; 3]) -> [f64; 3] {
    let area = |a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]| {
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    let whole = area(p, q, r);
    [area(point, q, r) / whole, area(p, point, r) / whole, area(p, q, point) / whole]
}

/// What a comparison counted.
#[derive(Default, Debug)]
pub struct Counts {
    pub visible: usize,
    pub hidden: usize,
    /// Nearer to touching than the tolerance: not compared.
    pub undecided: usize,
}

/// Holds a viewshed and its least heights to the evaluator, for targets of a height, every `stride`th post.
pub fn hold(
    ground: &Posts,
    eye: &Point,
    height: f64,
    body: (Curvature, f64, u32),
    stride: usize,
    counts: &mut Counts,
) {
    let (curvature, radius, parts) = body;
    let seen = ground.viewshed(eye, height, curvature).unwrap();
    let least = ground.least_heights(eye, curvature).unwrap();
    let columns = ground.size()[1];
    let eye_height = match eye.height {
        sight::Height::AboveGround(above) => ground.height(eye.place).unwrap() + above,
        sight::Height::AboveDatum(height) => height,
    };
    for post in (0..seen.len()).step_by(stride) {
        let [row, column] = [post / columns, post % columns];
        let place = ground.place(row, column);
        let from = [eye.place[0], eye.place[1], eye_height];
        let to = [place[0], place[1], ground.post(row, column) + height];
        let distance = (0..3).map(|axis| square(to[axis] - from[axis])).sum::<f64>().sqrt();
        let ends = Ends { from, to, radius };
        let [clearance, rise] = over_all_triangles(ground, &ends, parts);
        let tolerance = if parts == 1 { 1e-9 } else { 1e-7 } * distance;
        let rise = (rise + height).max(0.0);
        // Samples of curved ground miss its top by a little, most near the observer; never the other way.
        let missed = if parts == 1 { tolerance } else { 1e-4 };
        if parts == 1 || rise > 0.01 {
            let above = least[post] - rise;
            assert!(above >= -tolerance && above <= missed, "{post}: {} {rise}", least[post]);
        }
        if clearance.abs() <= tolerance {
            counts.undecided += 1;
            continue;
        }
        let single = ground.line_of_sight(eye, &Point::above_ground(place, height), curvature).unwrap();
        let expected = if clearance > 0.0 { Sight::Visible } else { Sight::Hidden };
        assert_eq!([seen[post], single.sight], [expected; 2], "{post}: clearance {clearance} of {eye:?}");
        assert!(clearance > 0.0 || (single.clearance - clearance).abs() <= tolerance);
        if clearance > 0.0 { counts.visible += 1 } else { counts.hidden += 1 }
    }
}

/// Observers from 1 mm to 1000 km, on a post, between posts, and off the mesh.
fn observers() -> [Point; 6] {
    [
        Point::above_ground([-120.0, 170.0], 0.001),
        Point::above_ground([-131.7, 88.3], 2.0),
        Point::above_ground([-5.3, 200.1], 30.0),
        Point::above_ground([-77.0, 141.0], 1e6),
        Point::above_datum([55.0, -34.0], 60.0),
        Point::above_datum([-160.0, 4000.0], 300.0),
    ]
}

#[test]
fn ten_rough_landscapes_agree_with_all_triangles() {
    let mut counts = Counts::default();
    for seed in 0..10 {
        let heights = Random(seed).rough([30, 37], 25.0);
        let ground = posts([30, 37], 10.0, |row, column| heights[row * 37 + column]);
        for eye in observers() {
            for height in [0.0, 2.0] {
                hold(&ground, &eye, height, (Curvature::FLAT, f64::INFINITY, 1), 3, &mut counts);
            }
        }
    }
    println!("{counts:?}");
    assert!(counts.visible > 10_000 && counts.hidden > 5_000 && counts.undecided < 200, "{counts:?}");
}

#[test]
fn curved_ground_agrees_with_all_triangles() {
    let mut counts = Counts::default();
    // A body so small that its bend shows within one triangle.
    let curvature = Curvature::parabolic(900.0, 0.0).unwrap();
    for seed in 20..24 {
        let heights = Random(seed).rough([30, 37], 6.0);
        let ground = posts([30, 37], 10.0, |row, column| heights[row * 37 + column]);
        for eye in observers() {
            hold(&ground, &eye, 2.0, (curvature, 900.0, 256), 11, &mut counts);
        }
    }
    println!("{counts:?}");
    assert!(counts.visible > 500 && counts.hidden > 500 && counts.undecided < 20, "{counts:?}");
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let heights = Random(77).rough([70, 90], 30.0);
    let ground = posts([70, 90], 10.0, |row, column| heights[row * 90 + column]);
    let eye = Point::above_ground([-333.0, 421.0], 1.5);
    let of = |threads: usize| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let least = ground.least_heights(&eye, Curvature::FLAT).unwrap();
            let bits: Vec<u64> = least.into_iter().map(f64::to_bits).collect();
            (bits, ground.viewshed(&eye, 0.0, Curvature::FLAT).unwrap())
        })
    };
    let one = of(1);
    assert!([2, 3, 7].into_iter().all(|threads| of(threads) == one));
}

fn square(number: f64) -> f64 {
    number * number
}
