//! The error against the closed form of the ground.

use features::{Crater, Features, Shape};
use glam::DVec3;
use ground_mesh::{GroundMesh, Rings};
use landscape::Landscape;

use super::{Random, corners, of_levels};

const SIDE: f64 = 400.0;

fn smooth(seed: u64) -> Landscape {
    of_levels(vec![Random(seed).level(50.0, [0.0; 2], [9, 9], 3.0)])
}

/// Craters of 2 to 40 m that may overlap.
fn cratered(seed: u64) -> Landscape {
    let mut random = Random(seed);
    let crater = |_| {
        let r2 = random.between(2.0, 40.0);
        let centre = [random.between(0.0, SIDE), random.between(0.0, SIDE)];
        let shape = Shape::RimmedBowl { r1: 0.7 * r2, r2 };
        Crater::new(centre, shape, 0.2 * r2, 0.04 * r2).unwrap()
    };
    let craters = (0..60).map(crater).collect();
    smooth(seed).with_features(Features::new(craters))
}

/// Largest error (m) at random points of all triangles.
fn seen(mesh: &GroundMesh, landscape: &Landscape, random: &mut Random) -> f64 {
    let mut largest = 0.0f64;
    for [p, q, r] in corners(mesh) {
        for _ in 0..25 {
            let [a, b] = [random.unit(), random.unit()];
            let [a, b] = if a + b > 1.0 { [1.0 - a, 1.0 - b] } else { [a, b] };
            let place = p + a * (q - p) + b * (r - p);
            let height = landscape.height(place.x.clamp(0.0, SIDE), place.y.clamp(0.0, SIDE)).unwrap();
            largest = largest.max((height - place.z).abs());
        }
    }
    largest
}

#[test]
fn the_bound_is_never_exceeded_on_random_ground() {
    let (mut random, mut mesh) = (Random(11), GroundMesh::default());
    for seed in 0..6 {
        for landscape in [smooth(seed), cratered(seed)] {
            let eye = random.eye([0.0, 0.0, SIDE, SIDE]);
            let cells = [8, 16, 32][seed as usize % 3];
            mesh.fill(&landscape, eye, Rings { half_side: 40.0, cells }).unwrap();
            let bound = mesh.height_error(&landscape, eye, 1000.0).metres;
            let seen = seen(&mesh, &landscape, &mut random);
            assert!(seen <= bound, "{seen} m, bound {bound} m");
            assert!(seen > 0.2 * bound, "the bound {bound} m says little of {seen} m");
        }
    }
}

/// As the picture shows it, by angles.
#[test]
fn the_bound_holds_in_pixels_from_the_eye() {
    let (mut random, mut mesh) = (Random(12), GroundMesh::default());
    for seed in 0..6 {
        let landscape = cratered(seed);
        let eye = random.eye([0.0, 0.0, SIDE, SIDE]) + DVec3::Z * 20.0;
        mesh.fill(&landscape, eye, Rings { half_side: 20.0, cells: 8 }).unwrap();
        let bound = mesh.height_error(&landscape, eye, 1000.0).pixels;
        let mut largest = 0.0f64;
        for [p, q, r] in corners(&mesh) {
            for _ in 0..25 {
                let [a, b] = [random.unit(), random.unit()];
                let [a, b] = if a + b > 1.0 { [1.0 - a, 1.0 - b] } else { [a, b] };
                let place = p + a * (q - p) + b * (r - p);
                let height = landscape.height(place.x.clamp(0.0, SIDE), place.y.clamp(0.0, SIDE)).unwrap();
                let ground = DVec3 { z: height, ..place };
                // The angle between both, as the middle of a picture shows it.
                let angle = (ground - eye).angle_between(place - eye);
                largest = largest.max(1000.0 * libm::tan(angle));
            }
        }
        assert!(largest <= bound, "{largest} pixels, bound {bound}");
    }
}

#[test]
fn half_the_step_leaves_a_quarter_of_the_error() {
    let (landscape, eye, mut mesh) = (smooth(5), DVec3::new(190.0, 210.0, 15.0), GroundMesh::default());
    // One ring over all: the borders of several move a little with the step.
    let mut errors = [64, 128, 256].map(|cells| {
        mesh.fill(&landscape, eye, Rings { half_side: SIDE, cells }).unwrap();
        mesh.height_error(&landscape, eye, 1000.0).metres
    });
    errors.reverse();
    for pair in errors.windows(2) {
        let ratio = pair[1] / pair[0];
        assert!((3.5..4.5).contains(&ratio), "{errors:?}");
    }
}

/// On `h = c (x^2 + y^2) / 2` a cell of step s is off by `c s^2 / 4` in the middle of its longest side.
#[test]
fn a_bowl_is_off_by_its_closed_form() {
    let (curvature, region) = (0.01, 100.0);
    let corner = |m: f64, n: f64| {
        let mut words = [0.0; 9];
        words[0] = 0.5 * curvature * region * region * (m * m + n * n);
        (words[3], words[1]) = (curvature * region * region * m, curvature * region * region * n);
        (words[6], words[2]) = (curvature * region * region, curvature * region * region);
        words
    };
    let words = (0..25).map(|k| corner(f64::from(k / 5), f64::from(k % 5))).collect();
    let landscape = of_levels(vec![landscape::Level::new(region, [0.0; 2], [5, 5], words).unwrap()]);
    let mut mesh = GroundMesh::default();
    let eye = DVec3::new(200.0, 200.0, 900.0);
    mesh.fill(&landscape, eye, Rings { half_side: SIDE, cells: 8 }).unwrap();
    let step = SIDE / 8.0;
    let off = curvature * step * step / 4.0;
    let seen = seen(&mesh, &landscape, &mut Random(1));
    let bound = mesh.height_error(&landscape, eye, 1000.0).metres;
    assert!(seen <= off * (1.0 + 1e-9) && seen > 0.98 * off, "{seen}, closed form {off}");
    assert!(bound >= off && bound < 1.7 * off, "{bound}, closed form {off}");
}

#[test]
fn a_crater_between_the_points_counts() {
    let flat = of_levels(vec![landscape::Level::new(50.0, [0.0; 2], [9, 9], vec![[0.0; 9]; 81]).unwrap()]);
    let crater = Crater::new([333.0, 341.0], Shape::Bowl { r1: 0.5 }, 0.2, 0.0).unwrap();
    let landscape = flat.clone().with_features(Features::new(vec![crater]));
    let (mut mesh, eye) = (GroundMesh::default(), DVec3::new(20.0, 20.0, 5.0));
    let rings = Rings { half_side: 20.0, cells: 8 };
    mesh.fill(&landscape, eye, rings).unwrap();
    assert_eq!(mesh.height_error(&landscape, eye, 1000.0).metres, 0.2);
    mesh.fill(&flat, eye, rings).unwrap();
    assert_eq!(mesh.height_error(&flat, eye, 1000.0), ground_mesh::HeightError::default());
}
