//! What a session tells of its levels: what they lose, which of them change, and what a camera sees that stands.

use generator::{DrawnGround, PlaneKind, Planes};
use lod_mesh::{Parameters, Transition};
use lod_tiles::{Edges, Stitch};
use raster::Pattern;
use sight::Posts;

use crate::shots::{SIDE, draw, pose, run, session, stage};

/// The ground at one level everywhere, seen whole from 5 km.
fn from_above(levels: u32) -> DrawnGround {
    let ranges = vec![0.001, 0.002, 0.003];
    let one_level = Parameters { levels: Some(levels), ranges, shares: vec![0.0], ..run() };
    let session = session(stage(64), one_level);
    session.detailed().unwrap().drawn_ground(0, &pose([800.0, 800.0, 5000.0], 0.0, -90.0)).unwrap()
}

#[test]
fn a_loss_is_that_of_the_posts_that_a_level_lacks() {
    let [finest, second, third] = [1, 2, 3].map(from_above);
    assert_eq!((finest.loss.metres.worst, finest.loss.posts), (0.0, 160 * 160));
    assert_eq!([finest, second, third].map(|ground| ground.triangles), [51_200, 12_800, 3_200]);
    // Posts of the second level are every second one; the others lie on the mean of two of them, along the diagonal where both are odd.
    let landscape = stage(64).landscape;
    let height =
        |i: usize, j: usize| landscape.at_spacing(10.0 * j as f64, 10.0 * i as f64, 10.0).unwrap().height;
    let mean = |a: f64, b: f64| (a + b) / 2.0;
    let drawn = |i: usize, j: usize| match (i % 2, j % 2) {
        (0, 0) => height(i, j),
        (_, 0) => mean(height(i - 1, j), height(i + 1, j)),
        (0, _) => mean(height(i, j - 1), height(i, j + 1)),
        _ => mean(height(i - 1, j + 1), height(i + 1, j - 1)),
    };
    let posts = (0..160).flat_map(|j| (0..160).map(move |i| (i, j)));
    let errors: Vec<f64> = posts.map(|(i, j)| drawn(i, j) - height(i, j)).collect();
    let worst = errors.iter().fold(0.0, |worst: f64, error| worst.max(error.abs()));
    let rms = (errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64).sqrt();
    assert!((second.loss.metres.worst - worst).abs() < 1e-9 && worst > 0.5, "{second:?} {worst}");
    assert!((second.loss.metres.rms(second.loss.posts) - rms).abs() < 1e-9, "{second:?} {rms}");
    assert!(third.loss.metres.rms(third.loss.posts) > 2.0 * rms, "{third:?}");
}

#[test]
fn pixels_of_a_loss_follow_from_focal_length_and_distance() {
    let loss = from_above(2).loss;
    // The picture is 64 pixels for a tangent of 1 across. Ground lies 4.9 to 5.1 km below the eye, its corners 1131 m beside the foot.
    let per_metre = [5250.0, 4850.0].map(|distance| 64.0 / distance);
    let pixels = loss.pixels.rms(loss.posts) / loss.metres.rms(loss.posts);
    assert!((per_metre[0]..per_metre[1]).contains(&pixels), "{pixels} {per_metre:?}");
    // Straight down a height moves a place by its tangent off the axis: at most 0.16 x 2^(1/2) here.
    assert!(loss.moved.worst < 0.24 * loss.pixels.worst && loss.moved.worst > 0.0, "{loss:?}");
}

#[test]
fn a_camera_that_stands_sees_levels_go_on() {
    let switch = Parameters { transition: Transition::Switch, ..run() };
    let session = session(stage(64), switch);
    let detailed = session.detailed().unwrap();
    let ground = stage(64).landscape.at_spacing(760.0, 760.0, 10.0).unwrap().height;
    let [high, low] = [450.001, 449.999].map(|above| pose([760.0, 760.0, ground + above], 0.0, -90.0));
    let held = |levels| {
        let mut planes = Planes::new(64, 64, &[PlaneKind::Distance]);
        detailed.held_frame(0, &high, levels, &mut planes).unwrap();
        planes.get(PlaneKind::Distance).unwrap().to_vec()
    };
    assert_eq!(held(&high), draw(&*session, 64, &high).get(PlaneKind::Distance).unwrap());
    let largest = held(&high).iter().zip(held(&low)).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(largest > 1.0, "{largest}");
    let changes = |levels| detailed.level_changes(0, &high, levels).unwrap();
    assert_eq!((changes([&high, &high]), changes([&high, &low])), (0, 1));
    assert!(detailed.level_changes(0, &high, [&high, &pose([SIDE, SIDE, -500.0], 0.0, -90.0)]).is_err());
}

/// Where a camera straight down sees the ground, the drawn posts have it too, at every level and fraction.
#[test]
fn drawn_posts_are_the_ground_of_the_picture() {
    // One sampling point, in the middle of its pixel.
    let sampling = scene_sampler::Parameters { pattern: Pattern::One, ..run().sampling };
    let session = session(stage(64), Parameters { sampling, ..run() });
    let detailed = session.detailed().unwrap();
    let heights = |ground: &generator::DrawnPosts| {
        let columns = ground.east.len();
        let southwards = ground.heights.chunks(columns).rev().flatten().copied().collect();
        Posts::new([ground.north.len(), columns], [SIDE, 0.0], 10.0, southwards).unwrap()
    };
    let finest = heights(&detailed.drawn_posts(0, &pose([800.0, 800.0, 60.0], 0.0, -90.0)).unwrap());
    let mut moved: f64 = 0.0;
    for eye in [[700.0, 760.0, 300.0], [731.0, 903.0, 500.0], [800.0, 800.0, 900.0]] {
        let from = pose(eye, 0.0, -90.0);
        let posts = heights(&detailed.drawn_posts(0, &from).unwrap());
        let picture = draw(&*session, 64, &from);
        let distances = picture.get(PlaneKind::Distance).unwrap();
        for (pixel, distance) in distances.iter().enumerate() {
            // The picture is upright to the north; its half is a tangent of 0.5.
            let [right, down] = [pixel % 64, pixel / 64].map(|at| (at as f64 + 0.5) / 64.0 - 0.5);
            let ahead = f64::from(*distance) / (1.0 + right * right + down * down).sqrt();
            let place = [eye[0] - down * ahead, eye[1] + right * ahead];
            let drawn = posts.height(place).unwrap();
            assert!((drawn - (eye[2] - ahead)).abs() < 0.02, "{eye:?}, {pixel}: {drawn} at {place:?}");
            moved = moved.max((drawn - finest.height(place).unwrap()).abs());
        }
    }
    assert!(moved > 1.0, "coarse ground is off the finest one: {moved} m");
}

#[test]
fn ground_with_holes_or_other_triangles_has_no_drawn_posts() {
    let from = pose([800.0, 800.0, 500.0], 0.0, -90.0);
    for wrong in [
        Parameters { edges: Edges::PerTile, ..run() },
        Parameters { stitch: Stitch::None, ..run() },
        Parameters { stitch: Stitch::FineSide, ..run() },
    ] {
        let session = session(stage(64), wrong);
        let refused = session.detailed().unwrap().drawn_posts(0, &from).unwrap_err().to_string();
        assert!(refused.contains("lod.stitch = \"coarse-side\""), "{refused}");
    }
}
