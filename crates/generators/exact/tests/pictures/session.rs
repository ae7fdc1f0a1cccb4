//! The session: refusals, threads, extremes.

use std::sync::Arc;

use crate::scenes::{draw, landscape, laws, level, plane, pose, prepare, settings, sun};
use exact::Exact;
use generator::{FrameError, Generator, PlaneKind, Planes};
use hardware_model::Settings;
use landscape::Landscape;
use scenario::{Curvature, PixelRule, Pose, Projection, RangeLaw};
use signal::Probe;

fn usual(rule: PixelRule) -> Settings {
    settings(16, 12, laws(Projection::Exact, Curvature::Parabolic, rule), [1.5, 300.0])
}

fn rough(scale: f64) -> Arc<Landscape> {
    let word =
        |m: f64, n: f64, k: usize| (((m * 31.0 + n * 17.0 + k as f64 * 7.0) * 2654.43).fract() - 0.5) * scale;
    landscape(level(20.0, [16, 16], |m, n| std::array::from_fn(|k| word(m, n, k))), 1.0)
}

fn refusal(pose: &Pose) -> FrameError {
    let session =
        prepare(landscape(plane(40.0, [4, 4], 3.0, [0.0; 2]), 1.0), sun(0.0, 9.0), &usual(PixelRule::Centre));
    let mut planes = Planes::new(16, 12, &[PlaneKind::Intensity]);
    session.frame(7, pose, &mut planes, &mut Probe::off()).unwrap_err()
}

#[test]
fn poses_that_cannot_be_drawn_are_refused() {
    assert_eq!(
        refusal(&pose([80.0, 80.0, 2.5], 0.0, 0.0)),
        FrameError::EyeUnderGround { frame: 7, below: 0.5 }
    );
    assert_eq!(
        refusal(&pose([80.0, 80.0, 3.0], 0.0, 0.0)),
        FrameError::EyeUnderGround { frame: 7, below: 0.0 }
    );
    let not_a_pose = [
        pose([80.0, 80.0, 5.0], f64::NAN, 0.0),
        pose([80.0, 80.0, 5.0], 0.0, f64::INFINITY),
        pose([80.0, f64::NAN, 5.0], 0.0, 0.0),
        pose([80.0, 80.0, f64::NAN], 0.0, 0.0),
        pose([80.0, -1.1e9, 5.0], 0.0, 0.0),
        pose([80.0, 80.0, 1.1e9], 0.0, 0.0),
        Pose { yoke: f64::NAN, ..pose([80.0, 80.0, 5.0], 0.0, 0.0) },
    ];
    for pose in &not_a_pose {
        let FrameError::Refused { frame: 7, reason } = refusal(pose) else { panic!("{pose:?}") };
        assert!(reason.contains("an eye at [80.0, ") && reason.contains("expected numbers"), "{reason}");
    }
}

#[test]
fn every_pitch_is_drawn() {
    for pitch in [64.9, -64.9, 65.1, -65.1, 90.0, -90.0, 179.0, -179.0] {
        let (intensity, range) = draw(
            &rough(1.0),
            sun(50.0, 20.0),
            &usual(PixelRule::LineMean),
            &pose([160.0, 161.0, 3.0], pitch, 20.0),
        );
        assert!(intensity.iter().chain(&range).all(|value| !value.is_nan()));
        let ground = range.iter().filter(|range| range.is_finite()).count();
        assert_eq!(ground > 0, !(0.0..=170.0).contains(&pitch));
    }
}

#[test]
fn nothing_is_probed_and_nothing_left_out() {
    assert_eq!((Exact.name(), Exact.signals().len()), ("exact", 0));
    assert!(prepare(rough(1.0), sun(0.0, 9.0), &usual(PixelRule::Centre)).omissions().is_empty());
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    for rule in [PixelRule::Centre, PixelRule::LineMean] {
        let picture = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let pose = pose([160.0, 161.0, 3.0], -4.0, 77.0);
            let (intensity, range) = pool.install(|| draw(&rough(4.0), sun(50.0, 20.0), &usual(rule), &pose));
            intensity.into_iter().chain(range).map(f32::to_bits).collect::<Vec<_>>()
        };
        let one = picture(1);
        assert!(one.iter().any(|&bits| bits != 0));
        assert_eq!(one, picture(2));
        assert_eq!(one, picture(3));
    }
}

#[test]
fn extremes_stay_finite() {
    let light = sun(50.0, 1.0);
    for (scale, height) in [(1e-300, 1e-6), (1.0, 1e-6), (1e6, 1e-3), (1e6, 1e6), (1.0, 1e5)] {
        let ground = rough(scale);
        let foot = ground.height(160.0, 160.0).unwrap();
        for rule in [PixelRule::Centre, PixelRule::LineMean] {
            for (heading, pitch) in [(0.0, 0.0), (45.0, -30.0), (271.0, 20.0)] {
                let pose = pose([160.0, 160.0, foot + height], pitch, heading);
                let (intensity, range) = draw(&ground, light, &usual(rule), &pose);
                assert!(intensity.iter().all(|value| (0.0..=1.0).contains(value)), "{scale} {height}");
                assert!(range.iter().all(|&range| range >= 1.5), "{scale} {height}");
            }
        }
    }
}

#[test]
fn ground_nearer_than_the_first_sample_is_black() {
    let ground = landscape(plane(40.0, [8, 8], 0.0, [0.0; 2]), 1.0);
    let pose = pose([160.0, 160.0, 2.0], 0.0, 0.0);
    for (law, first) in [
        (RangeLaw::Geometric, 12.0),
        (RangeLaw::ConstantElevation, 12.0),
        (RangeLaw::ConstantRate, 0.3),
        (RangeLaw::TwoRate { switch: 5000.0, fine_share: 0.5 }, 5000.0 / 501.0),
    ] {
        let mut settings =
            settings(1, 400, laws(Projection::Exact, Curvature::None, PixelRule::Centre), [12.0, 300.0]);
        settings.range.law = law;
        let (intensity, range) = draw(&ground, sun(0.0, 30.0), &settings, &pose);
        let lowest = intensity.iter().rposition(|&value| value > 0.0).unwrap();
        assert!(intensity[lowest + 1..].iter().all(|&value| value == 0.0));
        let nearest = f64::from(range[lowest]);
        assert_eq!(lowest < 399, first > 8.0, "{law:?}: black lines at the bottom");
        let bottom = 2.0 / settings.raster.field.tan_half_height;
        assert!(nearest >= first && nearest < first.max(bottom) * 1.05, "{law:?}: {nearest}");
    }
}

#[test]
fn only_the_planes_asked_for_are_filled() {
    let session = prepare(rough(1.0), sun(50.0, 20.0), &usual(PixelRule::Centre));
    let mut range = Planes::new(16, 12, &[PlaneKind::Range]);
    session.frame(0, &pose([160.0, 161.0, 3.0], -4.0, 77.0), &mut range, &mut Probe::off()).unwrap();
    assert!(range.get(PlaneKind::Intensity).is_none());
    assert!(range.get(PlaneKind::Range).unwrap().iter().any(|range| range.is_finite()));
}

/// What the generator says that it fills is filled, and no other plane is touched.
#[test]
fn planes_are_filled_as_told() {
    let session = prepare(rough(1.0), sun(50.0, 20.0), &usual(PixelRule::Centre));
    let mut planes = Planes::new(16, 12, &PlaneKind::ALL);
    for kind in PlaneKind::ALL {
        planes.get_mut(kind).unwrap().fill(f32::NAN);
    }
    session.frame(0, &pose([160.0, 161.0, 3.0], -4.0, 77.0), &mut planes, &mut Probe::off()).unwrap();
    for kind in PlaneKind::ALL {
        let is_told = Exact.planes().contains(&kind);
        let values = planes.get(kind).unwrap();
        assert!(values.iter().all(|value| value.is_nan() != is_told), "{}", kind.name());
    }
    // Along the ray is never shorter than along the ground, and longer where the ray looks down.
    let (along, over) = (planes.get(PlaneKind::Distance).unwrap(), planes.get(PlaneKind::Range).unwrap());
    assert!(along.iter().zip(over).all(|(along, over)| along >= over));
    assert!(along.iter().zip(over).any(|(along, over)| along.is_finite() && along > over));
}
