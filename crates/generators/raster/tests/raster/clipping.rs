//! Clipping before projection: nothing visible is lost, nothing is covered twice.

use glam::DVec3;
use raster::{Clipper, Pattern, Projection, Sampling, Screen, Seen, Triangle};

use crate::covered;
use crate::random::Random;

const PROJECTION: Projection = Projection { focal: 50.0, centre: [32.0, 24.0] };
const NEAR: f64 = 0.5;

fn screen() -> Screen {
    Screen::new([64, 48], 8).expect("a screen")
}

fn clipper() -> Clipper<'static> {
    Clipper::new(&PROJECTION, &screen(), NEAR)
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
        let fans = mesh.iter().flat_map(|&corners| clipper().clip(corners).expect("finite corners"));
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
    let clipped = |corners: [[f64; 3]; 3]| clipper().clip(corners.map(DVec3::from_array)).unwrap();
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
        let fan = clipper().clip([corner(), corner(), corner()]).unwrap();
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
            assert!(clipper().clip(corners).is_err(), "{corners:?}");
        }
    }
}

/// Where three corners by themselves say what is left of a triangle, clipping says the same.
#[test]
fn corners_by_themselves_agree_with_clipping() {
    let mut random = Random(21);
    let mut counts = [0; 3];
    for _ in 0..20_000 {
        let middle =
            DVec3::new(random.between(-30.0, 30.0), random.between(-30.0, 30.0), random.between(-9.0, 40.0));
        let size = random.between(0.1, 9.0);
        let corners = [(); 3].map(|()| {
            middle
                + size
                    * DVec3::new(
                        random.between(-1.0, 1.0),
                        random.between(-1.0, 1.0),
                        random.between(-1.0, 1.0),
                    )
        });
        let fan = clipper().clip(corners).unwrap();
        match Seen::whole(corners.map(|corner| clipper().seen(corner))) {
            Some(Some(points)) => assert_eq!(fan.as_slice(), &[points], "{corners:?}"),
            Some(None) => assert!(fan.is_empty(), "{corners:?}"),
            None => counts[2] += 1,
        }
        counts[usize::from(fan.is_empty())] += 1;
    }
    assert!(counts.iter().all(|count| *count > 1000), "{counts:?}");
    for wrong in [f64::NAN, f64::INFINITY, 2e9] {
        let corners = [DVec3::new(wrong, 0.0, 9.0), DVec3::new(1.0, 0.0, 9.0), DVec3::new(0.0, 1.0, 9.0)];
        assert_eq!(clipper().seen(corners[0]), Seen::Unfit);
        assert_eq!(Seen::whole(corners.map(|corner| clipper().seen(corner))), None, "clipping refuses it");
    }
}
