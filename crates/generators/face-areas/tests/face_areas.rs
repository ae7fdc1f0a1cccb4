//! Pictures by area against closed forms and against dense sampling points that share no code.

use face_areas::draw;
use generator::{FaceScene, Look, ScreenFace};

/// Faces with looks of their own.
fn scene(faces: Vec<(ScreenFace, Look)>) -> FaceScene {
    let (faces, looks): (Vec<_>, Vec<_>) = faces.into_iter().unzip();
    FaceScene { faces, looks: Box::new(move |face, _| looks[face]), coincidence: 0.0 }
}

fn face(id: u32, corners: &[[f64; 2]], q: [f64; 3]) -> ScreenFace {
    ScreenFace { corners: corners.to_vec(), q, priority: 0, id }
}

fn opaque(level: f64) -> Look {
    Look { light: [level, 0.5 * level, 0.0], translucency: [0.0; 3] }
}

fn sheet(level: f64, translucency: f64) -> Look {
    Look { light: [(1.0 - translucency) * level, 0.0, 0.0], translucency: [translucency; 3] }
}

const ALL: [[f64; 2]; 4] = [[-5.0, -5.0], [9.0, -5.0], [9.0, 9.0], [-5.0, 9.0]];

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-12, "{found} {expected}");
}

#[test]
fn a_triangle_shows_its_area() {
    let triangle = face(0, &[[0.25, 0.0], [2.0, 0.0], [0.25, 1.75]], [0.0, 0.0, 1.0]);
    let picture = draw(&scene(vec![(triangle, opaque(1.0))]), [2, 2]);
    let areas = [0.75 * 1.0 - 0.0, 1.0 - 0.5, 0.75 * 0.75 - 0.0, 0.0];
    // The slope is x + y = 2: it cuts the upper right pixel in half and the lower left one to a triangle.
    near(picture[0][0], areas[0]);
    near(picture[1][0], areas[1]);
    near(picture[2][0], 0.5 * 0.75 * 0.75);
    near(picture[3][0], areas[3]);
    near(picture.iter().map(|pixel| pixel[0]).sum(), 0.5 * 1.75 * 1.75);
}

/// Planes that cross inside a pixel: q = x against q = 1/4 + y/2, with a wall behind.
#[test]
fn planes_that_cross_share_a_pixel_by_their_line() {
    let one = face(0, &ALL, [1.0, 0.0, 0.0]);
    let other = face(1, &ALL, [0.0, 0.5, 0.25]);
    let wall = face(2, &ALL, [0.0, 0.0, -1.0]);
    let picture = draw(&scene(vec![(wall, opaque(9.0)), (other, opaque(0.0)), (one, opaque(1.0))]), [1, 1]);
    // The first is nearer where x > 1/4 + y/2: 3/4 less the mean of y/2.
    near(picture[0][0], 0.5);
}

#[test]
fn sheets_let_through_what_they_say() {
    let near_one = face(5, &ALL, [0.0, 0.0, 0.1]);
    let far_one = face(4, &ALL, [0.0, 0.0, 0.05]);
    let ground = face(3, &ALL, [0.0, 0.0, 0.01]);
    // Check values of 8.1: 0.9 and 0.2 before 0.4.
    let faces = vec![(ground, opaque(0.4)), (far_one, sheet(0.2, 0.5)), (near_one, sheet(0.9, 0.7))];
    near(draw(&scene(faces), [1, 1])[0][0], 0.48);
}

#[test]
fn equal_distances_go_by_priority_and_then_by_id() {
    let at = |id: u32, priority: i32| ScreenFace { priority, ..face(id, &ALL, [0.0, 0.0, 0.1]) };
    let first = draw(&scene(vec![(at(1, 0), opaque(0.1)), (at(0, 0), opaque(0.7))]), [1, 1]);
    near(first[0][0], 0.7);
    let higher = draw(&scene(vec![(at(1, 2), opaque(0.1)), (at(0, 0), opaque(0.7))]), [1, 1]);
    near(higher[0][0], 0.1);
}

/// Light that is quadratic over the screen has its exact mean.
#[test]
fn quadratic_light_is_integrated_exactly() {
    let faces = vec![face(0, &ALL, [0.0, 0.0, 1.0])];
    let looks = |_: usize, [x, y]: [f64; 2]| Look { light: [x * x, x * y, 1.0], translucency: [0.0; 3] };
    let picture = draw(&FaceScene { faces, looks: Box::new(looks), coincidence: 0.0 }, [2, 1]);
    near(picture[1][0], 7.0 / 3.0);
    near(picture[1][1], 0.75);
    near(picture[1][2], 1.0);
}

/// Numbers from 0 to 1 by a counter.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> f64 {
        let unit = quantities::unit_interval(self.0, &[]);
        self.0 = quantities::hash_words(self.0, &[]);
        unit
    }
}

const SIDE: usize = 4;
const POINTS: usize = 60;

/// Whether a triangle holds a point, by the signs of its edges.
fn holds(corners: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let side = |i: usize| {
        let ([ax, ay], [bx, by]) = (corners[i], corners[(i + 1) % 3]);
        (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 0.0
    };
    side(0) == side(1) && side(1) == side(2)
}

/// Light at a point, by sorting all faces that hold it.
fn sampled(faces: &[(ScreenFace, Look)], at: [f64; 2]) -> f64 {
    let mut held: Vec<&(ScreenFace, Look)> =
        faces.iter().filter(|(face, _)| holds(&face.corners, at)).collect();
    let q = |face: &ScreenFace| face.q[0] * at[0] + face.q[1] * at[1] + face.q[2];
    held.sort_by(|a, b| q(&b.0).total_cmp(&q(&a.0)));
    let mut through = 1.0;
    held.iter()
        .map(|(_, look)| {
            let light = through * look.light[0];
            through *= look.translucency[0];
            light
        })
        .sum()
}

#[test]
fn random_scenes_are_what_dense_sampling_says() {
    let (mut dice, mut worst) = (Dice(7), 0.0f64);
    for _ in 0..60 {
        let mut random = |low: f64, high: f64| low + (high - low) * dice.next();
        let faces: Vec<(ScreenFace, Look)> = (0..12)
            .map(|id| {
                let corners = [0; 3].map(|_| [random(-1.0, 5.0), random(-1.0, 5.0)]);
                let q = [random(-0.1, 0.1), random(-0.1, 0.1), random(0.5, 1.5)];
                let tau = if random(0.0, 1.0) < 0.5 { 0.0 } else { random(0.0, 1.0) };
                (face(id, &corners, q), Look { light: [random(0.0, 1.0), 0.0, 0.0], translucency: [tau; 3] })
            })
            .collect();
        let picture = draw(&scene(faces.clone()), [SIDE, SIDE]);
        for (pixel, light) in picture.iter().enumerate() {
            let places = (0..POINTS * POINTS).map(|k| {
                let within = |k: usize| (k as f64 + 0.5) / POINTS as f64;
                [(pixel % SIDE) as f64 + within(k % POINTS), (pixel / SIDE) as f64 + within(k / POINTS)]
            });
            let mean = places.map(|at| sampled(&faces, at)).sum::<f64>() / (POINTS * POINTS) as f64;
            worst = worst.max((light[0] - mean).abs());
        }
    }
    // A grid of 60 x 60 points is off by some hundredths of the length of the edges over 60.
    assert!(worst < 6e-3, "{worst}");
}

#[test]
fn the_number_of_threads_does_not_matter() {
    let mut dice = Dice(3);
    let faces = (0..40)
        .map(|id| {
            let corners = [0; 3].map(|_| [8.0 * dice.next(), 8.0 * dice.next()]);
            (face(id, &corners, [0.0, 0.0, dice.next()]), sheet(dice.next(), 0.4))
        })
        .collect();
    let scene = scene(faces);
    let by = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| draw(&scene, [8, 8]))
    };
    assert_eq!(by(1), by(3));
}
