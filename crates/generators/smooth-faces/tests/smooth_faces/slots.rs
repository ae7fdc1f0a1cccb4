//! Edge slots of a frame: edges in view, levels of detail that fall, faces that go.

use faces::{Detail, Pattern, SeaState};
use generator::{FrameCounts, PlaneKind, Planes, Session, Stage};
use glam::DVec3;
use scenario::{FaceKind, FaceList};
use signal::Probe;
use smooth_faces::{Clocked, Hardware};

use crate::shots::{gear, pose, run, sea, sea_list, session_on, square, stage};

/// Pixels of a side: squares of the sea are several pixels wide.
const FINE: usize = 240;

/// The sea of 20 x 30 squares, and before it a level upon it and a raft, seen from above as a whole.
fn whole_sea() -> Stage {
    let at = DVec3::new(150.0, 100.0, 0.0);
    let mut level = FaceList { kind: FaceKind::Level, ..square("level", at, 60.0, 2, [0.5; 3]) };
    level.group = level.group.detailed(Detail::Add);
    let raft = square("raft", at + DVec3::Z, 10.0, 1, [1.0, 0.0, 0.0]);
    let sea = sea(SeaState::High, Pattern::Random { seed: 1 });
    let mut stage = stage(vec![raft, level, sea_list(&sea)]);
    [stage.view.columns, stage.view.lines] = [FINE as u32; 2];
    stage
}

fn above() -> scenario::Pose {
    pose([150.0, 100.0, 350.0], 0.0, -90.0)
}

fn drawn(edges_frame: Option<u32>) -> (Planes, FrameCounts, Box<dyn Session>) {
    let session = session_on(whole_sea(), run(), Hardware { edges_frame, ..gear() });
    let mut planes = Planes::new(FINE, FINE, &[PlaneKind::Red, PlaneKind::Label]);
    let counts = session.frame(0, &above(), &mut planes, &mut Probe::off()).unwrap();
    (planes, counts, session)
}

/// A grid of 20 x 30 squares has 1850 edges; raft and level have 5 each with their diagonals.
#[test]
fn levels_fall_first_and_then_faces_from_the_last() {
    let lost = |slots| {
        let (_, counts, _) = drawn(Some(slots));
        [counts["fallen_levels"], counts["lost_faces"]]
    };
    let asked = 1850 + 5 + 5;
    assert_eq!(lost(asked), [0, 0]);
    assert_eq!(lost(asked - 1), [1, 0]);
    assert_eq!(lost(asked - 5), [1, 0]);
    // The last square has two edges that no other has.
    assert_eq!(lost(asked - 6), [1, 1]);
    // Those of the raft alone.
    assert_eq!(lost(5), [1, 600]);
    assert_eq!(lost(4), [1, 601]);
}

/// A pixel of a lost face tells which it is, and the record has a miss of that face.
#[test]
fn a_lost_face_and_its_pixels_lead_to_each_other() {
    let (whole, ..) = drawn(None);
    let slots = 1000;
    let (short, counts, session) = drawn(Some(slots));
    let clocked = Clocked::new(whole_sea(), run(), Hardware { edges_frame: Some(slots), ..gear() }).unwrap();
    let timing = generator::Timed::frame(&clocked, 0, &above()).unwrap();
    let misses: Vec<&str> = timing.misses.iter().filter_map(|missed| missed.part.as_deref()).collect();
    // The level has one face.
    assert_eq!(misses.len() as u64, counts["lost_faces"] + 1);
    let red = |planes: &Planes, at: usize| planes.get(PlaneKind::Red).unwrap()[at];
    let mut told = std::collections::BTreeSet::new();
    for at in (0..FINE * FINE).step_by(37) {
        let facts = session.explain(0, &above(), [at % FINE, at / FINE]).unwrap();
        let lost: Vec<_> = facts.iter().filter(|fact| fact.what == "lost").collect();
        let differs = red(&whole, at) != red(&short, at);
        // The raft stands before what is lost.
        let is_behind = facts[0].value.contains(" of raft ");
        assert_eq!(differs, !lost.is_empty() && !is_behind, "{at}: {facts:?}");
        for fact in lost {
            let (face, rest) = fact.value.strip_prefix("face ").unwrap().split_once(" of ").unwrap();
            let part = format!("{}.face.{face}", rest.split_once(" (").unwrap().0);
            assert!(misses.contains(&part.as_str()), "{part}");
            told.insert(part);
        }
    }
    assert!(told.len() > misses.len() / 2, "{} of {}", told.len(), misses.len());
}
