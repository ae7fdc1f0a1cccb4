//! The session: refusals, codes, threads, extremes.

use generator::{FrameError, Generator, PlaneKind, Planes};
use lunsim::Parameters;
use scenario::{Curvature, Laws};
use signal::Probe;

use crate::scenes::{bowl, draw, plain, pose, prepare, settings, stage, sun, unrestricted};

fn scene() -> std::sync::Arc<landscape::Landscape> {
    plain(8000.0, vec![bowl([4000.0, 4000.0], 500.0, 150.0), bowl([5000.0, 3500.0], 300.0, 40.0)])
}

#[test]
fn eyes_that_see_nothing_are_refused() {
    let session = prepare(stage(&scene(), sun(0.0, 9.0), &settings(8, 30.0, 16))).unwrap();
    let refusal = |eye| {
        let mut planes = Planes::new(8, 8, &[PlaneKind::Intensity]);
        session.frame(7, &pose(eye, -30.0, 0.0), &mut planes, &mut Probe::off()).unwrap_err()
    };
    assert_eq!(refusal([-0.5, 80.0, 5.0]), FrameError::OutsideProblemArea { frame: 7, x: -0.5, y: 80.0 });
    assert_eq!(refusal([80.0, 80.0, -0.5]), FrameError::EyeUnderGround { frame: 7, below: 0.5 });
    assert!(matches!(refusal([80.0, f64::NAN, 5.0]), FrameError::OutsideProblemArea { .. }));
}

/// The film shows whole codes and nothing between them, all of them and none brighter.
#[test]
fn the_film_shows_integer_codes() {
    let mut settings = settings(256, 30.0, 512);
    settings.view.display.white = 0.8;
    for codes in [2, 16, 200] {
        settings.parameters = Parameters { intensity_codes: codes, ..settings.parameters };
        let planes = draw(&scene(), sun(90.0, 20.0), &settings, &pose([3000.0, 4000.0, 2500.0], -60.0, 0.0));
        let highest = f64::from(codes - 1);
        let mut seen = std::collections::BTreeSet::new();
        for value in planes.get(PlaneKind::Intensity).unwrap() {
            let code = f64::from(*value) / 0.8 * highest;
            assert!((code - code.round()).abs() < 1e-4 && (0.0..=highest + 0.1).contains(&code), "{code}");
            seen.insert(code.round() as u32);
        }
        assert!(seen.contains(&0) && seen.len() as f64 > 0.4 * f64::from(codes), "{codes}: {seen:?}");
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let settings = settings(100, 30.0, 300);
    let picture = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let view = pose([3000.0, 4000.0, 900.0], -40.0, 0.0);
        let planes = pool.install(|| draw(&scene(), sun(270.0, 15.0), &settings, &view));
        PlaneKind::ALL.map(|kind| planes.get(kind).unwrap().iter().map(|v| v.to_bits()).collect::<Vec<_>>())
    };
    let one = picture(1);
    assert_eq!(one, picture(1));
    assert_eq!(one, picture(3));
}

#[test]
fn extremes_stay_finite() {
    let mut settings = unrestricted(settings(33, 60.0, 40));
    settings.view.laws = Laws { curvature: Curvature::Parabolic, ..settings.view.laws };
    for eye in [[4000.0, 4000.0, 1e7], [4000.0, 4000.0, -149.9], [0.0, 0.0, 1e-3], [8000.0, 8000.0, 40.0]] {
        for (pitch, heading) in [(-90.0, 0.0), (-89.0, 33.0), (0.0, 45.0), (60.0, 200.0), (89.0, 0.0)] {
            for light in [sun(12.0, 90.0), sun(211.0, 1e-6)] {
                let planes = draw(&scene(), light, &settings, &pose(eye, pitch, heading));
                for kind in PlaneKind::ALL {
                    let values = planes.get(kind).unwrap();
                    let sound = |value: &f32| value.is_finite() || *value == kind.sky();
                    assert!(values.iter().all(sound), "{kind:?} from {eye:?}, {pitch}, {heading}");
                }
            }
        }
    }
}

#[test]
fn only_the_planes_asked_for_are_filled() {
    let session = prepare(stage(&scene(), sun(0.0, 9.0), &settings(8, 30.0, 16))).unwrap();
    let view = pose([3000.0, 4000.0, 900.0], -40.0, 0.0);
    let mut none = Planes::new(8, 8, &[]);
    let counts = session.frame(0, &view, &mut none, &mut Probe::off()).unwrap();
    assert_eq!((counts["samples"], none.any()), (256, false));
    let mut one = Planes::new(8, 8, &[PlaneKind::Height]);
    assert_eq!(session.frame(0, &view, &mut one, &mut Probe::off()).unwrap(), counts);
    assert!(one.get(PlaneKind::Height).unwrap().iter().any(|height| *height < 0.0));
}

/// What LUNSIM says that it fills is filled, and no other plane is touched.
#[test]
fn planes_are_filled_as_told() {
    let session = prepare(stage(&scene(), sun(0.0, 9.0), &settings(24, 30.0, 64))).unwrap();
    let mut planes = Planes::new(24, 24, &PlaneKind::ALL);
    for kind in PlaneKind::ALL {
        planes.get_mut(kind).unwrap().fill(f32::NAN);
    }
    session.frame(0, &pose([4000.0, 3000.0, 900.0], -20.0, 0.0), &mut planes, &mut Probe::off()).unwrap();
    for kind in PlaneKind::ALL {
        let is_told = settings(24, 30.0, 64).program().planes().contains(&kind);
        let values = planes.get(kind).unwrap();
        assert!(values.iter().all(|value| value.is_nan() != is_told), "{}", kind.name());
    }
    let (along, over) = (planes.get(PlaneKind::Distance).unwrap(), planes.get(PlaneKind::Range).unwrap());
    // Level ground under an eye of 900 m, but for two bowls and the lunoid that the settings leave out.
    let slant = |over: f32| libm::hypot(f64::from(over), 900.0) as f32;
    let near = |(along, over): (&f32, &f32)| {
        along.is_infinite() && over.is_infinite() || (along - slant(*over)).abs() < 160.0
    };
    assert!(along.iter().zip(over).all(near) && along.iter().any(|along| along.is_finite()));
    assert!(along.iter().zip(over).all(|(along, over)| along >= over));
}
