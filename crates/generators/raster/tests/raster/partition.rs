//! Every sampling point inside a mesh is covered exactly once.

use raster::{Pattern, Point, Sampling, Screen, Triangle, doubled_area};

use crate::covered;
use crate::random::Random;

const SIZE: u32 = 48;

/// Triangles of a square of random corners, split again and again at random points: most end as slivers. All turn the same way.
fn mesh(random: &mut Random) -> Vec<[Point; 3]> {
    let place = |x: f64, y: f64| Point::snap([x, y]).expect("on the raster");
    let end = f64::from(SIZE);
    let around = [[-3.0, -2.0], [end + 2.0, -4.0], [end + 3.0, end + 1.0], [-2.0, end + 4.0]]
        .map(|[x, y]| place(x, y));
    let hub = place(random.between(10.0, 38.0), random.between(10.0, 38.0));
    let mut mesh: Vec<_> = (0..4).map(|i| [around[i], around[(i + 1) % 4], hub]).collect();
    while mesh.len() < 400 {
        let chosen = random.below(mesh.len() as u32) as usize;
        let [p, q, r] = mesh[chosen];
        let shares = [random.unit(), random.unit()];
        let within = |axis: usize| {
            let [p, q, r] = [p, q, r].map(|corner| corner.position()[axis]);
            let toward = p + (q - p) * shares[0];
            // Coarse places put corners and edges onto sampling points.
            ((toward + (r - toward) * shares[1]) * 16.0).round() / 16.0
        };
        let new = place(within(0), within(1));
        let parts = [[p, q, new], [q, r, new], [r, p, new]];
        if parts.iter().all(|&part| doubled_area(part) > 0) {
            mesh.swap_remove(chosen);
            mesh.extend(parts);
        } else if random.below(50) == 0 {
            break;
        }
    }
    mesh
}

#[test]
fn every_sample_of_a_closed_mesh_has_one_cover() {
    let mut random = Random(3);
    let screen = Screen::new([SIZE, SIZE], 8).expect("a screen");
    let mut count = 0;
    for round in 0..35 {
        let sampling = Sampling::new(Pattern::ALL[round % Pattern::ALL.len()]);
        let triangles: Vec<_> = mesh(&mut random).into_iter().filter_map(Triangle::new).collect();
        count += triangles.len();
        let mut covers = vec![[0; 32]; (SIZE * SIZE) as usize];
        for ([x, y], _, mask) in covered(&screen, &triangles, &sampling) {
            (0..32).for_each(|i| covers[(y * SIZE + x) as usize][i] += mask >> i & 1);
        }
        for (pixel, covers) in covers.iter().enumerate() {
            let pattern = sampling.pattern().name();
            assert!(
                covers[..sampling.count()].iter().all(|&times| times == 1),
                "{pattern} {pixel}: {covers:?}"
            );
        }
    }
    assert!(count > 5000, "only {count} triangles");
}

/// Corners that are moved at random fold triangles over. A sample is then covered once more from the front than from the back.
#[test]
fn folds_cover_from_the_front_once_more_than_from_the_back() {
    let mut random = Random(33);
    let screen = Screen::new([SIZE, SIZE], 8).expect("a screen");
    for pattern in [Pattern::Four, Pattern::Sixteen, Pattern::OffCentre16] {
        let cells = 12;
        let corner = |i: usize, j: usize, random: &mut Random| {
            let wander = if i.is_multiple_of(cells) || j.is_multiple_of(cells) { 0.0 } else { 6.0 };
            let along = |k: usize, random: &mut Random| 4.0 * k as f64 + random.between(-wander, wander);
            Point::snap([along(i, random), along(j, random)]).expect("on the raster")
        };
        let grid: Vec<Vec<_>> =
            (0..=cells).map(|i| (0..=cells).map(|j| corner(i, j, &mut random)).collect()).collect();
        let mut mesh = Vec::new();
        for (i, j) in (0..cells * cells).map(|k| (k / cells, k % cells)) {
            let [p, q, r, s] = [grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]];
            mesh.extend([[p, q, r], [p, r, s]]);
        }
        let mut covers = vec![[0; 32]; (SIZE * SIZE) as usize];
        let sampling = Sampling::new(pattern);
        let mut backs = 0;
        for side in [1, -1] {
            let facing = mesh.iter().filter(|&&corners| doubled_area(corners).signum() == side);
            let triangles: Vec<_> = facing.filter_map(|&corners| Triangle::new(corners)).collect();
            for ([x, y], _, mask) in covered(&screen, &triangles, &sampling) {
                backs += u32::from(side < 0);
                (0..32).for_each(|i| covers[(y * SIZE + x) as usize][i] += side * i64::from(mask >> i & 1));
            }
        }
        assert!(backs > 100, "nothing is folded");
        for covers in covers {
            assert!(covers[..sampling.count()].iter().all(|&times| times == 1), "{covers:?}");
        }
    }
}
