//! Clipping before projection: nothing visible is lost, nothing is covered twice.

use glam::DVec3;
use raster::{Pattern, Projection, Sampling, Screen, Triangle, clip};

use crate::covered;
use crate::random::Random;

const PROJECTION: Projection = Projection { focal: 50.0, centre: [32.0, 24.0] };
const NEAR: f64 = 0.5;

fn screen() -> Screen {
    Screen::new([64, 48], 8).expect("a screen")
}

/// Ground 2 m below the eye, from behind it to far in front, as an uneven grid of triangles.
fn ground(random: &mut Random) -> Vec<[DVec3; 3]> {
    let cells = 14;
    let along = |i: usize, from: f64, to: f64, random: &mut Random| {
        let inner = i != 0 && i != cells;
        from + (to - from) * (i as f64 + f64::from(u8::from(inner)) * random.between(-0.4, 0.4))
            / cells as f64
    };
    let grid: Vec<Vec<DVec3>> = (0..=cells)
        .map(|i| {
            (0..=cells)
                .map(|j| DVec3::new(along(i, -90.0, 90.0, random), 2.0, along(j, -20.0, 100.0, random)))
                .collect()
        })
        .collect();
    let mut mesh = Vec::new();
    for (i, j) in (0..cells * cells).map(|k| (k / cells, k % cells)) {
        let [p, q, r, s] = [grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]];
        mesh.extend([[p, q, r], [p, r, s]]);
    }
    mesh
}

#[test]
fn ground_through_the_eye_plane_is_covered_once() {
    let mut random = Random(8);
    for pattern in [Pattern::Four, Pattern::Sixteen, Pattern::Lattice32] {
        let sampling = Sampling::new(pattern);
        let mesh = ground(&mut random);
        let fans = mesh
            .iter()
            .flat_map(|&corners| clip(corners, &PROJECTION, &screen(), NEAR).expect("finite corners"));
        let triangles: Vec<_> = fans.filter_map(Triangle::new).collect();
        let mut covers = vec![[0; 32]; 64 * 48];
        for ([x, y], _, mask) in covered(&screen(), &triangles, &sampling) {
            (0..32).for_each(|i| covers[(y * 64 + x) as usize][i] += mask >> i & 1);
        }
        for (pixel, covers) in covers.iter().enumerate() {
            let at = [pixel as i32 % 64, pixel as i32 / 64];
            for ([_, y], &times) in sampling.places(at).zip(covers) {
                // The ground ends 100 m away: 50 * 2 / 100 = 1 pixel below the horizon.
                let expected = u32::from(y > 25.0);
                let on_the_end = (y - 25.0).abs() < 1.0 / 256.0;
                assert!(times == expected || on_the_end, "{times} covers at {at:?}, height {y}");
            }
        }
    }
}

#[test]
fn what_cannot_be_seen_is_no_triangle() {
    let clipped =
        |corners: [[f64; 3]; 3]| clip(corners.map(DVec3::from_array), &PROJECTION, &screen(), NEAR).unwrap();
    assert!(clipped([[0.0, 0.0, -1.0], [1.0, 0.0, -5.0], [0.0, 1.0, 0.4]]).is_empty());
    assert!(clipped([[90.0, 0.0, 10.0], [99.0, 0.0, 10.0], [90.0, 5.0, 10.0]]).is_empty());
    assert_eq!(clipped([[0.0, 0.0, 5.0], [1.0, 0.0, 5.0], [0.0, 1.0, 5.0]]).len(), 1);
}

#[test]
fn a_cut_has_at_most_eight_corners_within_the_margin() {
    let mut random = Random(9);
    let mut most = 0;
    for _ in 0..20_000 {
        let mut corner = || {
            DVec3::new(random.between(-40.0, 40.0), random.between(-40.0, 40.0), random.between(-9.0, 30.0))
        };
        let fan = clip([corner(), corner(), corner()], &PROJECTION, &screen(), NEAR).unwrap();
        most = most.max(fan.len());
        for [x, y] in fan.iter().flatten().map(|point| point.position()) {
            assert!((-8.0..=72.0).contains(&x) && (-8.0..=56.0).contains(&y), "{x}, {y}");
        }
    }
    assert!((5..=6).contains(&most), "{most} triangles of one");
}

#[test]
fn what_is_not_finite_or_too_far_is_refused() {
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1.1e9] {
        for place in 0..9 {
            let mut values = [1.0, 2.0, 9.0, 3.0, 1.0, 8.0, 2.0, 2.0, 7.0];
            values[place] = wrong;
            let corners = [0, 3, 6].map(|i| DVec3::from_slice(&values[i..]));
            assert!(clip(corners, &PROJECTION, &screen(), NEAR).is_err(), "{corners:?}");
        }
    }
}
