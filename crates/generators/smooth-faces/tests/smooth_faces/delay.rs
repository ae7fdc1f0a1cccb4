//! Pictures that are as late as the gear makes them.

use std::sync::Arc;

use faces::{Pattern, SeaState};
use generator::{Generator, Stage, Timed};
use scenario::Pose;
use smooth_faces::{Clocked, Parameters, SmoothFaces};

use crate::shots::{gear, light, pose, run, sea, sea_list, session, stage};

/// The pose of a frame: the eye climbs.
fn at(frame: u64) -> Pose {
    pose([150.0, 100.0, 40.0 + 20.0 * frame as f64], 0.0, -90.0)
}

fn on_course(frames: u64) -> Stage {
    let mut stage = stage(vec![sea_list(&sea(SeaState::High, Pattern::Random { seed: 1 }))]);
    stage.scenery = Arc::new((*stage.scenery).clone().with_course((0..frames).map(at).collect::<Vec<_>>()));
    stage
}

fn delayed() -> Parameters {
    Parameters { delayed: true, ..run() }
}

#[test]
fn a_picture_shows_the_pose_and_the_sun_of_three_frames_before() {
    let (own, late) = (session(on_course(9), run()), session(on_course(9), delayed()));
    for frame in 0..9_u64 {
        let shown = frame.saturating_sub(3);
        assert_eq!(light(&*late, frame, &at(frame)), light(&*own, shown, &at(shown)), "{frame}");
    }
    assert_ne!(light(&*late, 8, &at(8)), light(&*own, 8, &at(8)));
}

/// The record of a late picture is that of the frame that it shows.
#[test]
fn a_record_is_of_the_frame_that_shows() {
    let clocked = |parameters| Clocked::new(on_course(9), parameters, gear()).unwrap();
    let (own, late) =
        (clocked(run()).frame(5, &at(5)).unwrap(), clocked(delayed()).frame(8, &at(8)).unwrap());
    assert_eq!((late.frame, late.tasks), (8, own.tasks));
    assert_eq!(late.events_blake3, own.events_blake3);
    assert_ne!(clocked(run()).frame(8, &at(8)).unwrap().events_blake3, own.events_blake3);
}

#[test]
fn a_stage_without_the_frames_before_is_refused() {
    let generator = |parameters| SmoothFaces { parameters, hardware: gear() };
    let still = || stage(vec![sea_list(&sea(SeaState::High, Pattern::Random { seed: 1 }))]);
    let error = generator(delayed()).prepare(still()).err().unwrap().to_string();
    assert!(error.contains("delayed pictures") && error.contains("course"), "{error}");
    assert!(generator(delayed()).remembers_frames() && !generator(run()).remembers_frames());
    let beyond = session(on_course(2), delayed()).check(8, &at(8)).unwrap_err().to_string();
    assert!(beyond.contains("frame 5") && beyond.contains("mission"), "{beyond}");
}
