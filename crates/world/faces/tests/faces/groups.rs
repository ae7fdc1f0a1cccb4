//! Lists of faces: which faces show, which list wins, equal priorities.

use faces::{Cover, Drive, FaceError, Group, Mode, Order, Sequence, check_priorities};
use glam::DVec3;

use crate::smooth;

/// Five triangles beside one another.
fn five() -> Group {
    let places: Vec<[f64; 3]> = (0..7).map(|k| [f64::from(k % 2), f64::from(k), 0.0]).collect();
    let faces: Vec<Vec<u32>> =
        (0..5).map(|k| if k % 2 == 0 { vec![k, k + 2, k + 1] } else { vec![k, k + 1, k + 2] }).collect();
    Group::new("five", smooth(&places, &faces.iter().map(Vec::as_slice).collect::<Vec<_>>()), 3)
}

fn turns(members: &[&[usize]], mode: Mode) -> Sequence<Vec<usize>> {
    Sequence::new(members.iter().map(|faces| Some(faces.to_vec())).collect(), 1, 0, mode).expect("a sequence")
}

#[test]
fn faces_without_a_sequence_always_show() {
    let driven = Mode::Driven(Drive { signal: "thrust".into(), low: 0.0, step: 1.0 });
    let sequences = vec![turns(&[&[4], &[1, 2]], Mode::Cycle), turns(&[&[], &[3]], driven)];
    let group = five().with_sequences(sequences).expect("sequences of the list");
    assert_eq!(group.shown(0, |_| 0.0), [0, 4]);
    assert_eq!(group.shown(1, |_| 0.0), [0, 1, 2]);
    assert_eq!(group.shown(0, |name| if name == "thrust" { 5.0 } else { 0.0 }), [0, 3, 4]);
    assert_eq!(five().shown(7, |_| 0.0), [0, 1, 2, 3, 4]);
}

#[test]
fn sequences_name_faces_that_are_there_once() {
    let missing = five().with_sequences(vec![turns(&[&[0], &[5]], Mode::Cycle)]);
    assert_eq!(missing, Err(FaceError::NoFace { list: "five".into(), member: 1, face: 5, faces: 5 }));
    let twice = five().with_sequences(vec![turns(&[&[0]], Mode::Cycle), turns(&[&[1], &[0]], Mode::Cycle)]);
    assert_eq!(twice, Err(FaceError::SharedFace { list: "five".into(), face: 0 }));
}

#[test]
fn a_face_seen_from_behind_is_lit_from_behind() {
    let group = five();
    assert_eq!(group.brightness(0, DVec3::Z, false), [1.0; 3]);
    assert_eq!(group.brightness(0, DVec3::Z, true), [0.0; 3]);
    assert_eq!(group.brightness(0, -DVec3::Z, true), [1.0; 3]);
}

#[test]
fn lists_win_by_number_and_faces_by_depth() {
    let cover = |priority, depth| Cover { priority, depth };
    let covers = [cover(5, 1.0), cover(2, 9.0), cover(2, 8.0), cover(7, 1.0)];
    assert_eq!((Order::Lists.seen(&covers), Order::Depth.seen(&covers)), (Some(1), Some(0)));
    assert!(Order::disagree(&covers) && !Order::disagree(&covers[..1]) && !Order::disagree(&[]));
    assert_eq!(Order::Lists.seen(&[]), None);
}

#[test]
fn equal_priorities_are_refused_by_both_names() {
    assert_eq!(check_priorities([("sea", 9), ("ship", -1), ("wake", 3)]), Ok(()));
    let found =
        check_priorities([("sea", 9), ("ship", 1), ("wake", 9)]).expect_err("equal numbers").to_string();
    assert_eq!(
        found,
        "lists `sea` and `wake` both have priority 9: expected a number of its own for each list"
    );
}
