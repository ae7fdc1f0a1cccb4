//! Faces that take turns (check values 8.5, acceptance test 7).

use faces::{Drive, FaceError, Mode, Sequence};

fn of(count: usize, frames: u64, start: i64, mode: Mode) -> Sequence<usize> {
    Sequence::new((0..count).map(Some).collect(), frames, start, mode).expect("a sequence")
}

#[test]
fn the_pointer_of_28_faces() {
    let wake = of(28, 2, 0, Mode::Cycle);
    let found = [0, 1, 56, 59, 60, 1000].map(|frame| wake.index(frame, 0.0));
    assert_eq!(found, [0, 0, 0, 1, 2, 24]);
    assert_eq!(wake.round(), 56);
    let shown: Vec<usize> = (0..56).map(|frame| *wake.shown(frame, 0.0)).collect();
    let expected: Vec<usize> = (0..56).map(|frame| frame / 2).collect();
    assert_eq!(shown, expected);
}

/// Each step of F frames takes F + 1: member `floor(n / 3)` where it was `floor(n / 2)`. A signal has no steps.
#[test]
fn a_late_pointer_shows_each_member_for_longer() {
    let cycle = of(28, 2, 0, Mode::Cycle);
    for frame in 0..1000_u64 {
        assert_eq!(cycle.index_late(frame, 1, 0.0), (frame / 3 % 28) as usize);
        assert_eq!(cycle.index_late(frame, 0, 0.0), cycle.index(frame, 0.0));
    }
    let drive = Drive { signal: "pitch".into(), low: 0.0, step: 1.0 };
    assert_eq!(of(4, 2, 0, Mode::Driven(drive)).index_late(9, 5, 2.5), 2);
}

#[test]
fn the_first_member_stands_before_the_start() {
    let late = of(3, 2, 5, Mode::Cycle);
    let found: Vec<usize> = (0..13).map(|frame| late.index(frame, 0.0)).collect();
    assert_eq!(found, [0, 0, 0, 0, 0, 0, 0, 1, 1, 2, 2, 0, 0]);
    assert_eq!(of(3, 2, -3, Mode::Cycle).index(0, 0.0), 1);
    assert_eq!(of(3, 1, i64::MIN, Mode::Once).index(u64::MAX, 0.0), 2);
}

#[test]
fn once_and_back_and_forth() {
    let found = |mode| {
        let sequence = of(3, 1, 0, mode);
        (0..9).map(|frame| sequence.index(frame, 0.0)).collect::<Vec<_>>()
    };
    assert_eq!(found(Mode::Once), [0, 1, 2, 2, 2, 2, 2, 2, 2]);
    assert_eq!(found(Mode::PingPong), [0, 1, 2, 1, 0, 1, 2, 1, 0]);
    let alone = of(1, 1, 0, Mode::PingPong);
    assert_eq!((alone.index(7, 0.0), alone.round()), (0, 1));
    assert_eq!(of(3, 2, 0, Mode::PingPong).round(), 8);
}

#[test]
fn a_signal_drives_and_clamps() {
    let drive = |step| Mode::Driven(Drive { signal: "pitch".into(), low: -1.0, step });
    let up = of(4, 1, 0, drive(0.5));
    let found = [-9.0, -1.0, -0.6, -0.5, 0.9, 1.0, f64::INFINITY, f64::NAN].map(|pitch| up.index(99, pitch));
    assert_eq!(found, [0, 0, 0, 1, 3, 3, 3, 0]);
    assert_eq!(
        [-1.1, -1.0, 0.99, 1.0, f64::NAN].map(|pitch| up.is_clamped(pitch)),
        [true, false, false, true, true]
    );
    assert_eq!(of(4, 1, 0, drive(-0.5)).index(0, -2.1), 2);
    assert_eq!((up.signal(), up.round()), (Some("pitch"), 0));
    assert!(!of(4, 1, 0, Mode::Cycle).is_clamped(f64::NAN));
}

#[test]
fn staggered_copies_show_different_members_at_any_time() {
    let wheel = of(28, 2, 0, Mode::Cycle);
    for frame in 0..200 {
        let mut shown: Vec<usize> = (0..4).map(|k| wheel.staggered(k, 4).index(frame, 0.0)).collect();
        assert_eq!(shown[1], (shown[0] + 7) % 28);
        shown.sort_unstable();
        shown.dedup();
        assert_eq!(shown.len(), 4);
    }
}

#[test]
fn sequences_that_cannot_be() {
    let missing = Sequence::new(vec![Some(1), None, Some(3)], 1, 0, Mode::Cycle);
    assert_eq!(missing, Err(FaceError::MissingMember { missing: 1, members: 3 }));
    let refused = |members: Vec<Option<u8>>, frames, mode| Sequence::new(members, frames, 0, mode).is_err();
    assert!(refused(vec![], 1, Mode::Cycle) && refused(vec![Some(1)], 0, Mode::Once));
    let drive = |low, step| Mode::Driven(Drive { signal: "s".into(), low, step });
    for mode in [drive(0.0, 0.0), drive(f64::NAN, 1.0), drive(0.0, f64::INFINITY)] {
        assert!(refused(vec![Some(1)], 1, mode));
    }
}
