//! Two roads to one sea: turned sun and renumbered normals, and the steps of the slow one.

use faces::{Animate, Board, Pattern, Sea, SeaState};
use generator::Session;
use smooth_faces::{Hardware, Parameters, RealTime};

use crate::shots::{apart, board_sea, draw, from_above, gear, light, run, sea, sea_list, session_on, stage};

/// A sea moved in one way by a real-time computer with a spare time (ns).
fn by(sea: &Sea, animate: Animate, spare_ns: u64) -> Box<dyn Session> {
    let hardware = Hardware { rt: RealTime { spare_ns, ..gear().rt }, ..gear() };
    session_on(stage(vec![sea_list(sea)]), Parameters { animate, ..run() }, hardware)
}

/// Frames, up to a number, in which the picture is another than in the frame before.
fn changes(sea: &Sea, animate: Animate, frames: u64) -> Vec<u64> {
    let session = by(sea, animate, gear().rt.spare_ns);
    let pictures: Vec<_> = (0..=frames).map(|frame| light(&*session, frame, &from_above())).collect();
    (1..=frames).filter(|frame| pictures[*frame as usize] != pictures[*frame as usize - 1]).collect()
}

#[test]
fn both_roads_give_one_picture() {
    let sea = sea(SeaState::Moderate, Pattern::Random { seed: 4 });
    let roads = [Animate::Sun, Animate::Normals].map(|animate| {
        // With time to spare all normals are written in a frame.
        let session = by(&sea, animate, 1_000_000_000);
        // An eighth of a turn would lie between frames; 16 normals are 75 frames of 150 by 8 steps.
        [0, 75, 150].map(|frame| draw(&*session, frame, &from_above()))
    });
    for (sun, normals) in roads[0].iter().zip(&roads[1]) {
        let light = |drawn: &(generator::Planes, generator::FrameCounts)| {
            drawn.0.get(generator::PlaneKind::Intensity).unwrap().to_vec()
        };
        assert!(apart(&light(sun), &light(normals)) < 1e-6);
        // The document's economy: three words, or three for each of 651 normals.
        assert_eq!((sun.1["words"], normals.1["words"]), (3, 3 * 651));
    }
}

#[test]
fn normals_come_too_late_and_the_sun_does_not() {
    let random = Pattern::Random { seed: 1 };
    let small = sea(SeaState::High, random);
    let large = board_sea(Board::new(6.0, 0..50, 0..50).unwrap(), SeaState::High, random);
    let every = |count: u64| (1..=16).filter(|frame| frame % count == 0).collect::<Vec<_>>();
    assert_eq!(changes(&small, Animate::Sun, 16), every(1));
    assert_eq!(changes(&large, Animate::Sun, 16), every(1));
    // 651 normals take 9.8 ms of 5 a frame, 2601 take 39. Steps of a sixteenth of a turn show each time.
    assert_eq!(changes(&small, Animate::Normals, 16), steps(&small, 2, 16));
    assert_eq!(changes(&large, Animate::Normals, 16), steps(&large, 8, 16));
}

/// Frames in which a table of normals has gone on by a step, seen every `count` frames.
fn steps(sea: &Sea, count: u64, frames: u64) -> Vec<u64> {
    let step = |frame: u64| faces::steps_of(sea.sun.turn().at(frame / count * count), sea.cone.count());
    (1..=frames).filter(|frame| step(*frame) != step(frame - 1)).collect()
}
