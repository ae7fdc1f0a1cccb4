//! What a session tells of its levels: what they lose, which of them change, and what a camera sees that stands.

use generator::{DrawnGround, PlaneKind, Planes};
use lod_mesh::{Parameters, Transition};

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
