//! The real-time computer: what a normal, a sun vector, a body take, and what is late in drawn frames.

use faces::ship::Motion;
use faces::{Animate, Sea};
use generator::Session;
use glam::DVec3;
use scenario::{Carrier, FaceKind, FaceList, ShipCourse};
use smooth_faces::{Hardware, Parameters, RealTime};

use crate::shots::{draw, fine_sea, from_above, gear, light, rate, run, sea_list, session_on, square, stage};

/// Lists under a real-time computer with a spare time (us).
fn spare(lists: Vec<FaceList>, animate: Animate, spare_us: u64) -> Box<dyn Session> {
    let hardware = Hardware { rt: RealTime { spare_ns: 1000 * spare_us, ..gear().rt }, ..gear() };
    session_on(stage(lists), Parameters { animate, ..run() }, hardware)
}

/// Frames, up to a number, in which the picture is another than in the frame before.
fn changes(session: &dyn Session, frames: u64) -> Vec<u64> {
    let pictures: Vec<_> = (0..=frames).map(|frame| light(session, frame, &from_above())).collect();
    (1..=frames).filter(|frame| pictures[*frame as usize] != pictures[*frame as usize - 1]).collect()
}

fn every(count: u64, frames: u64) -> Vec<u64> {
    (1..=frames).filter(|frame| frame % count == 0).collect()
}

/// Test 15 of the specification, measured in frames: a table of 4096 normals goes on in every frame.
#[test]
fn a_sea_of_651_normals_changes_every_second_frame_and_one_of_2601_every_eighth() {
    for (sea, count) in [(fine_sea(20, 30), 2), (fine_sea(50, 50), 8)] {
        let by = |animate| changes(&*spare(vec![sea_list(&sea)], animate, 5000), 16);
        assert_eq!(by(Animate::Normals), every(count, 16), "{} vertices", sea.board.vertices());
        assert_eq!(by(Animate::Sun), every(1, 16));
    }
}

/// The border of a budget: 651 normals take 9765 us, a sun vector 30.
#[test]
fn work_that_fits_to_the_microsecond_is_in_time() {
    let sea = || vec![sea_list(&fine_sea(20, 30))];
    let of = |animate, spare_us| changes(&*spare(sea(), animate, spare_us), 12);
    assert_eq!(of(Animate::Normals, 9765), every(1, 12));
    assert_eq!(of(Animate::Normals, 9764), every(2, 12));
    assert_eq!(of(Animate::Sun, 30), every(1, 12));
    assert_eq!(of(Animate::Sun, 29), every(2, 12));
    assert_eq!(of(Animate::Sun, 10), every(3, 12));
}

/// A raft that a ship at 60 m/s carries over nothing.
fn raft(name: &str, east: f64, priority: i32) -> FaceList {
    let course = ShipCourse {
        start: DVec3::new(130.0, east, 0.0),
        heading: 0.0,
        speed: 60.0,
        frames: rate(),
        motion: Motion::default(),
        origin: DVec3::ZERO,
        yaw: 0.0,
    };
    FaceList {
        carrier: Carrier::Ship(course),
        kind: FaceKind::Ship,
        ..square(name, DVec3::ZERO, 10.0, priority, [1.0; 3])
    }
}

/// A body takes 114 us. With 130 us of which a sun vector takes 30, two bodies wait for each other: 228 of 100 a frame, every third.
#[test]
fn bodies_wait_behind_suns_in_the_order_of_lists() {
    let far = Sea { board: faces::Board::new(10.0, 0..2, 0..2).unwrap(), ..fine_sea(2, 2) };
    let lists = || vec![raft("first", 90.0, 1), raft("second", 110.0, 2), sea_list(&far)];
    assert_eq!(changes(&*spare(lists(), Animate::Sun, 258), 6), every(1, 6));
    // The first is done in the second of three frames, the other in the third.
    let late = changes(&*spare(lists(), Animate::Sun, 130), 9);
    assert_eq!(late, [2, 3, 5, 6, 8, 9]);
    // The sun takes all.
    assert_eq!(changes(&*spare(lists(), Animate::Sun, 30), 6), Vec::<u64>::new());
}

/// Look-ups and products are done once, words go to each channel: 18 + 12 us a channel for a sun vector, 3 + 12 for a normal.
#[test]
fn channels_share_one_computer() {
    let of = |channels, animate, spare_us: u64| {
        let hardware = Hardware { rt: RealTime { spare_ns: 1000 * spare_us, ..gear().rt }, ..gear() };
        let run = Parameters { animate, channels, ..run() };
        let session = session_on(stage(vec![sea_list(&fine_sea(20, 30))]), run, hardware);
        (changes(&*session, 14), draw(&*session, 1, &from_above()).1["words"])
    };
    assert_eq!(of(4, Animate::Sun, 66), (every(1, 14), 12));
    assert_eq!(of(4, Animate::Sun, 65).0, every(2, 14));
    // 651 normals of 51 us are 33.2 ms of 5 a frame; of 15 us they are 9.8 ms.
    assert_eq!(of(4, Animate::Normals, 5000), (every(7, 14), 4 * 3 * 651));
    assert_eq!(of(1, Animate::Normals, 5000), (every(2, 14), 3 * 651));
}

#[test]
fn a_frame_alone_is_as_in_sequence() {
    let sea = || vec![raft("first", 90.0, 1), sea_list(&fine_sea(20, 30))];
    let session = spare(sea(), Animate::Normals, 5000);
    let sequence: Vec<_> = (0..9).map(|frame| light(&*session, frame, &from_above())).collect();
    for frame in (0..9).rev() {
        let alone = light(&*spare(sea(), Animate::Normals, 5000), frame, &from_above());
        assert_eq!(alone, sequence[frame as usize], "{frame}");
    }
}

#[test]
fn a_pixel_says_what_of_its_list_is_late() {
    let session = spare(vec![sea_list(&fine_sea(20, 30))], Animate::Normals, 5000);
    let late = |frame| {
        let facts = session.explain(frame, &from_above(), [30, 30]).unwrap();
        let late = facts.into_iter().filter(|fact| fact.what == "late");
        late.map(|fact| fact.value).collect::<Vec<_>>()
    };
    assert_eq!(late(4), Vec::<String>::new());
    assert_eq!(late(5), ["normals of sea: that of frame 4"]);
}
