//! Frames as work of the viewer's computer and its board.

use std::collections::BTreeMap;
use std::sync::Arc;

use generator::{Generator, PlaneKind, Planes, Session, Stage};
use lod_mesh::{Board, Clock, Hardware, LodMesh, Parameters, ROW, Slots, Viewer};
use lod_tiles::Edges;
use scenario::Pose;
use signal::Probe;
use timing::{Cause, FORMAT, FrameTiming, LevelChange, TimingRecord};

use crate::shots::{generator, pose, run, session, stage};

const PIXELS: u32 = 64;

/// The stage with the course of a mission.
fn along(poses: &[Pose]) -> Stage {
    let stage = stage(PIXELS);
    let scenery = Arc::new((*stage.scenery).clone().with_course(poses.to_vec()));
    Stage { scenery, ..stage }
}

/// Eyes straight above the middle of the tile in column 9 of row 9.
fn above(heights: &[f64]) -> Vec<Pose> {
    let ground = stage(PIXELS).landscape.at_spacing(760.0, 760.0, 10.0).unwrap().height;
    heights.iter().map(|above| pose([760.0, 760.0, ground + above], 0.0, -90.0)).collect()
}

fn timings(generator: &LodMesh, poses: &[Pose]) -> Vec<FrameTiming> {
    let timed = generator.timed(along(poses)).unwrap().unwrap();
    let frames = (0..).zip(poses).map(|(frame, pose)| timed.frame(frame, pose).unwrap());
    frames.collect()
}

fn pieces(timing: &FrameTiming, unit: &str, task: &str) -> u64 {
    let tasks = timing.tasks.iter().filter(|found| found.unit == unit && found.task.starts_with(task));
    tasks.map(|task| task.pieces).sum()
}

fn slack(timing: &FrameTiming, name: &str) -> Option<i64> {
    timing.deadlines.iter().find(|(deadline, _)| deadline.word() == name).and_then(|(_, slack)| slack.least)
}

fn counts(session: &dyn Session, pose: &Pose) -> BTreeMap<&'static str, u64> {
    let mut planes = Planes::new(PIXELS as usize, PIXELS as usize, &[PlaneKind::Intensity]);
    let counts = session.frame(0, pose, &mut planes, &mut Probe::off()).unwrap();
    ["tiles", "visits", "vertices", "morphing", "ground_triangles"].map(|name| (name, counts[name])).into()
}

#[test]
fn tasks_count_what_is_drawn() {
    let poses = above(&[700.0]);
    let timing = timings(&generator(run()), &poses).remove(0);
    let counts = counts(&*session(stage(PIXELS), run()), &poses[0]);
    assert_eq!(pieces(&timing, "gpu.triangle", "level-"), counts["ground_triangles"]);
    assert_eq!(pieces(&timing, "gpu.vertex", "morphing"), counts["morphing"]);
    assert_eq!(pieces(&timing, "gpu.vertex", ""), counts["vertices"]);
    assert!(counts["morphing"] > 0);
    // 20 x 20 tiles, of which every one is looked at, has a word, and sets all its nodes in the first frame.
    let of = |unit: &str, task: &str| pieces(&timing, unit, task);
    assert_eq!([of("cpu", "distance"), of("cpu", "neighbours")], [400, counts["visits"]]);
    assert_eq!([of("bus", "percentages"), of("bus", "switches")], [400, 9 * 400]);
    assert_eq!(of("capture", "read-back"), u64::from(PIXELS * PIXELS) * 4);
    assert_eq!(timing.ticks, 100_000_000);
    let sum =
        |unit: &str| timing.tasks.iter().filter(|task| task.unit == unit).map(|task| task.ticks).sum::<u64>();
    let board = sum("gpu.vertex").max(sum("gpu.triangle"));
    let all = sum("cpu") + sum("bus") + board + sum("capture");
    assert_eq!(slack(&timing, "frame-tasks"), Some(100_000_000 - all as i64));
    assert!(sum("gpu.vertex") != sum("gpu.triangle") && board > 0);
}

/// At 455 m the middle tile has level 1; at 445 m, 175 of the 180 m of its zone are behind it.
#[test]
fn a_tile_that_takes_another_level_is_told() {
    let poses = above(&[455.0, 445.0, 445.0]);
    let [first, second, third] = timings(&generator(run()), &poses).try_into().unwrap();
    assert!(first.level_changes.is_empty() && third.level_changes.is_empty());
    let own = second.level_changes.iter().find(|change| change.tile == "tile.9.9").unwrap();
    let LevelChange { from, to, distance_m, fraction, .. } = own;
    assert_eq!((*from, *to), (1, 0));
    assert!((distance_m - 445.0).abs() < 1e-9 && (fraction - 175.0 / 180.0).abs() < 1e-9, "{own:?}");
    assert_eq!(own.borders_m, [720.0, 720.0, 800.0, 800.0]);
    // Nothing is set where nothing changes; a tile that changes sets nine nodes, and its neighbours some of theirs.
    assert_eq!(pieces(&third, "bus", "switches"), 0);
    assert!(pieces(&second, "bus", "switches") >= 9 * second.level_changes.len() as u64);
    assert_eq!((second.events, third.events), (second.level_changes.len() as u64 + 1, 1));
}

#[test]
fn a_pop_leads_to_the_change_that_made_it() {
    let poses = above(&[455.0, 445.0]);
    let switch = Parameters { transition: lod_mesh::Transition::Switch, ..run() };
    let facts = session(along(&poses), switch.clone()).explain(1, &poses[1], [32, 32]).unwrap();
    let tile = facts.iter().find(|fact| fact.what == "tile").unwrap().value.clone();
    assert!(tile.starts_with("column 9, row 9"), "{tile}");
    let changes = timings(&generator(switch), &poses).remove(1).level_changes;
    assert!(changes.iter().any(|change| change.tile == "tile.9.9" && change.fraction == 0.0), "{changes:?}");
}

#[test]
fn more_tiles_than_slots_are_told_refused_or_shared() {
    let poses = above(&[700.0]);
    let told = timings(&generator(run()), &poses).remove(0);
    assert_eq!(slack(&told, "uniform-slot"), Some(224 - 400));
    let missed = told.misses.iter().find(|missed| missed.deadline.word() == "uniform-slot").unwrap();
    assert_eq!((missed.part.as_deref(), missed.cause), (Some("tile.224"), Cause::Occupied));

    let refuse = generator(Parameters { slots: Slots::Refuse, ..run() });
    let error = refuse.prepare(stage(PIXELS)).err().unwrap().to_string();
    // 160 cells a side are 10 tiles of 16.
    for word in ["400 tiles", "224 slots", "order 4", "lod.slots = \"share\""] {
        assert!(error.contains(word), "{error}");
    }
    let larger = Parameters { slots: Slots::Refuse, order: 4, ranges: vec![], levels: None, ..run() };
    assert!(generator(larger).prepare(stage(PIXELS)).is_ok());

    // Blocks of two by two tiles: 100 words. The edge rule keeps the ground whole; a fraction a tile cracks between blocks.
    let share = Parameters { slots: Slots::Share, ..run() };
    let shared = timings(&generator(share.clone()), &poses).remove(0);
    assert_eq!((pieces(&shared, "bus", "percentages"), slack(&shared, "uniform-slot")), (100, None));
    let cracks = |run: Parameters| {
        let mut planes = Planes::new(PIXELS as usize, PIXELS as usize, &[PlaneKind::Intensity]);
        let session = session(stage(PIXELS), run);
        session.frame(0, &poses[0], &mut planes, &mut Probe::off()).unwrap()["cracked_edges"]
    };
    assert_eq!(cracks(share.clone()), 0);
    assert!(cracks(Parameters { edges: Edges::PerTile, ..share }) > 0);
}

/// A computer whose frame takes a little more than two of ten periods a second.
fn slow() -> Hardware {
    let hardware = Hardware::shipped().unwrap();
    Hardware { viewer: Viewer { tile_ns: 130_000, ..hardware.viewer }, ..hardware }
}

/// The picture of a frame, with the count of repeated pictures.
fn picture(session: &dyn Session, frame: u64, pose: &Pose) -> (Vec<f32>, u64) {
    let mut planes = Planes::new(PIXELS as usize, PIXELS as usize, &[PlaneKind::Intensity]);
    let counts = session.frame(frame, pose, &mut planes, &mut Probe::off()).unwrap();
    (planes.get(PlaneKind::Intensity).unwrap().to_vec(), counts["repeated"])
}

#[test]
fn under_a_clock_of_real_time_the_next_pose_is_that_of_the_time() {
    let poses = above(&[700.0, 650.0, 600.0, 550.0, 500.0, 450.0, 400.0]);
    let clock = Parameters { clock: Clock::RealTime, ..run() };
    let late = LodMesh { parameters: clock.clone(), hardware: slow() };
    let timings = timings(&late, &poses);
    let times: Vec<Option<f64>> = timings
        .iter()
        .map(|timing| timing.misses.iter().find(|missed| missed.deadline.word() == "frame-tasks")?.came)
        .collect();
    // Frames 0, 3 and 6 are begun, and each takes three periods.
    let begun: Vec<u64> =
        timings.iter().filter(|timing| !timing.tasks.is_empty()).map(|timing| timing.frame).collect();
    assert_eq!(begun, [0, 3, 6]);
    assert!(times[0].is_some_and(|came| came > 2e8 && came < 3e8) && times[1].is_none(), "{times:?}");
    assert!(slack(&timings[1], "frame-tasks") == Some(-100_000_000));

    let session = late.prepare(along(&poses)).unwrap();
    let shown: Vec<_> = (0..).zip(&poses).map(|(frame, pose)| picture(&*session, frame, pose)).collect();
    let stepped = crate::shots::session(along(&poses), run());
    let own = |frame: usize| picture(&*stepped, frame as u64, &poses[frame]).0;
    assert!(shown[0].0.iter().all(|light| *light == 0.0), "nothing is complete yet");
    assert_eq!((&shown[2].0, shown[2].1), (&own(0), 0));
    assert_eq!((&shown[4].0, shown[4].1), (&own(0), 1));
    assert_eq!((&shown[5].0, shown[5].1), (&own(3), 0));
    // A frame by itself is the same.
    let alone = late.prepare(along(&poses)).unwrap();
    assert_eq!(picture(&*alone, 5, &poses[5]), shown[5]);
    // Without the course there is nothing to go by.
    let error = late.prepare(stage(PIXELS)).err().unwrap().to_string();
    assert!(error.contains("a clock of real time") && error.contains("course"), "{error}");
    // A computer that is fast enough shows every pose.
    let quick = generator(clock).prepare(along(&poses)).unwrap();
    assert_eq!(picture(&*quick, 4, &poses[4]), (own(4), 0));
}

#[test]
fn a_full_memory_is_a_miss_of_the_picture() {
    let poses = above(&[700.0, 650.0, 600.0]);
    let shipped = Hardware::shipped().unwrap();
    let two = 2 * u64::from(PIXELS * PIXELS) * 4;
    let capture = lod_mesh::Capture { memory_bytes: two, ..shipped.capture };
    let small = LodMesh { parameters: run(), hardware: Hardware { capture, ..shipped } };
    let found: Vec<_> =
        timings(&small, &poses).iter().map(|timing| slack(timing, "capture-memory")).collect();
    assert_eq!(found, [Some(1), Some(0), Some(-1)]);
    let capture = lod_mesh::Capture { is_held: false, ..shipped.capture };
    let none = LodMesh { parameters: run(), hardware: Hardware { capture, ..shipped } };
    let timing = timings(&none, &poses).remove(2);
    assert_eq!((slack(&timing, "capture-memory"), pieces(&timing, "capture", "")), (None, 0));
}

#[test]
fn figures_stand_beside_what_the_board_has() {
    let poses = above(&[700.0, 650.0]);
    let shipped = generator(run());
    let timed = shipped.timed(along(&poses)).unwrap().unwrap();
    let frames = timings(&shipped, &poses);
    let figures = timed.sizing(&frames);
    let figure = |key: &str| figures.iter().find(|figure| figure.key == key).unwrap();
    assert_eq!(
        (figure("uniform_slots").measured, figure("uniform_slots").formula),
        (Some(400.0), Some(224.0))
    );
    assert_eq!((figure("order").measured, figure("order").formula), (Some(3.0), Some(4.0)));
    assert_eq!(figure("kept_bytes").measured, Some(161.0 * 161.0 * 16.0));
    // 64 x 64 pixels of four bytes in 16 GB.
    assert_eq!(figure("held_pictures").formula, Some(1_048_576.0));
    assert_eq!(figure("triangles").formula, Some(18_100_000.0));
    let before = timed.before_mission(&poses[0]).unwrap();
    let rays = before.iter().find(|task| task.task == "light-map").unwrap();
    assert_eq!((rays.pieces, rays.ticks), (161 * 161, 161 * 161 * 20_000));
}

#[test]
fn a_record_holds_together_and_does_not_depend_on_threads() {
    let poses = above(&[700.0, 500.0, 455.0, 445.0]);
    let record = |generator: &LodMesh| TimingRecord {
        format: FORMAT,
        scenario: "above a tile".into(),
        machine: ROW.name.into(),
        inputs: "0".into(),
        keys: BTreeMap::new(),
        master: "1000000000 Hz".into(),
        before_mission: Vec::new(),
        frames: timings(generator, &poses),
    };
    let board = Board { uniform_slots: None, ..Hardware::shipped().unwrap().board };
    let free = LodMesh { parameters: run(), hardware: Hardware { board, ..slow() } };
    let whole = record(&free);
    assert_eq!(whole.check(), Ok(()));
    let told = whole.text();
    assert!(
        ["level changes", "tile.7.0", "119 more changes"].iter().all(|word| told.contains(word)),
        "{told}"
    );
    let text = serde_json::to_string(&whole).unwrap();
    assert_eq!(serde_json::from_str::<TimingRecord>(&text).unwrap(), whole);
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    assert_eq!(one.install(|| record(&free)), whole);
}
