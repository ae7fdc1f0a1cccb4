//! The record of a frame: work of the units, deadlines, misses and what they lead to.

use std::collections::{BTreeMap, BTreeSet};

use faces::{Animate, Mode, Pattern, SeaState, Sequence};
use generator::{SizedFigure, Timed};
use glam::DVec3;
use scenario::FaceList;
use smooth_faces::{Clocked, Hardware, Parameters, RealTime};
use timing::{Cause, FORMAT, FrameTiming, TimingRecord};

use crate::shots::{PIXELS, fine_sea, from_above, gear, pose, run, sea, sea_list, session_on, square, stage};

fn clocked(lists: Vec<FaceList>, parameters: Parameters, hardware: Hardware) -> Clocked {
    Clocked::new(stage(lists), parameters, hardware).unwrap()
}

fn normals() -> Parameters {
    Parameters { animate: Animate::Normals, ..run() }
}

/// Frames of a sea of so many squares.
fn frames(squares: [i64; 2], parameters: Parameters, count: u64) -> Vec<FrameTiming> {
    let clocked = clocked(vec![sea_list(&fine_sea(squares[0], squares[1]))], parameters, gear());
    (0..count).map(|frame| clocked.frame(frame, &from_above()).unwrap()).collect()
}

/// Pieces and ticks of a task.
fn task(timing: &FrameTiming, unit: &str, task: &str) -> Option<(u64, u64)> {
    let found = timing.tasks.iter().find(|found| (found.unit.as_str(), found.task.as_str()) == (unit, task));
    found.map(|found| (found.pieces, found.ticks))
}

fn slack(timing: &FrameTiming, name: &str) -> Option<(u64, u64, Option<i64>)> {
    let found = timing.deadlines.iter().find(|(deadline, _)| deadline.word() == name);
    found.map(|(_, slack)| (slack.count, slack.missed, slack.least))
}

/// Section 11 of the specification: 651 normals take 9.8 ms, 2601 39 ms, a sun vector 30 us.
#[test]
fn normals_and_suns_take_the_times_of_the_specification() {
    let of = |squares, parameters| frames(squares, parameters, 1).remove(0);
    assert_eq!(task(&of([20, 30], normals()), "rt", "normals"), Some((651, 9_765_000)));
    assert_eq!(task(&of([50, 50], normals()), "rt", "normals"), Some((2601, 39_015_000)));
    let by_sun = of([50, 50], run());
    assert_eq!(task(&by_sun, "rt", "sun-vectors"), Some((1, 30_000)));
    assert_eq!(task(&by_sun, "rt", "normals"), None);
    assert_eq!(slack(&by_sun, "frame-tasks"), Some((1, 0, Some(4_970_000))));
    assert_eq!(slack(&by_sun, "update"), Some((1, 0, Some(4_970_000))));
    assert_eq!((slack(&by_sun, "edge"), slack(&by_sun, "edge-store")), (None, None));
}

/// 651 normals are ready 4.765 ms after the second spare time begins; frame 1 shows those of frame 0, a frame of 33.3 ms late.
#[test]
fn late_normals_are_misses_that_name_their_list() {
    let frames = frames([20, 30], normals(), 4);
    let updates: Vec<_> = frames.iter().map(|frame| slack(frame, "update").unwrap()).collect();
    let (new, late) = ((1, 0, Some(5_000_000 - 4_765_000)), (1, 1, Some(5_000_000 - 33_333_333 - 4_765_000)));
    assert_eq!(updates, [new, late, new, late]);
    let missed: Vec<_> =
        frames[1].misses.iter().filter(|missed| missed.deadline.word() == "update").collect();
    assert_eq!(missed.len(), 1);
    assert_eq!((missed[0].part.as_deref(), missed[0].cause), (Some("normals.sea"), Cause::Processor));
    assert_eq!((missed[0].due, missed[0].came), (5e6, Some(38_098_333.0)));
    // All of the work is asked for in each frame.
    assert!(frames.iter().all(|frame| slack(frame, "frame-tasks") == Some((1, 1, Some(-4_765_000)))));
}

/// Work of a frame by hand: a square of two triangles, its four vertices, 60 x 60 samples, a ramp for each line of its 20 columns.
#[test]
fn units_work_as_their_pieces_say() {
    // 40 m of 120 m in 60 pixels; the diagonal puts two triangles on each line.
    let list = square("raft", DVec3::new(150.0, 100.0, 0.0), 40.0, 1, [1.0; 3]);
    let timing = clocked(vec![list], run(), gear()).frame(0, &from_above()).unwrap();
    assert_eq!(task(&timing, "geometry", "vertices"), Some((4, 800)));
    assert_eq!(task(&timing, "geometry", "faces"), Some((1, 100)));
    assert_eq!(task(&timing, "geometry", "triangles"), Some((2, 200)));
    assert_eq!(task(&timing, "video", "samples"), Some((3600, 180_000)));
    let (ramps, _) = task(&timing, "video.ramps", "ramps").unwrap();
    assert!((38..=40).contains(&ramps), "{ramps}");
    assert_eq!(timing.ticks, 33_333_333);
    let edges = timing.units.iter().find(|unit| unit.unit == "edges").unwrap();
    assert_eq!((edges.busy, edges.longest_queue), (0, 2));
    // Each scan line is an event.
    assert_eq!(timing.events, PIXELS as u64);
}

/// Two squares take turns every second frame: a list of which another member shows goes through the transfer, 28 words of four corners.
#[test]
fn a_step_of_a_sequence_is_transferred() {
    let mut list = square("turns", DVec3::new(150.0, 100.0, 0.0), 40.0, 1, [1.0; 3]);
    let members = vec![Some(vec![0]), Some(vec![])];
    let turns = Sequence::new(members, 2, 0, Mode::Cycle).unwrap();
    list.group = list.group.with_sequences(vec![turns]).unwrap();
    let words = |hardware: Hardware| {
        let clocked = clocked(vec![list.clone()], run(), hardware);
        let words = |frame| task(&clocked.frame(frame, &from_above()).unwrap(), "transfer", "words");
        (0..6).map(words).collect::<Vec<_>>()
    };
    assert_eq!(words(gear()), [None, None, None, None, Some((28, 28_000)), None]);
    // A pointer that is late by a frame: it goes back to the first member in frame 6.
    let late = Hardware { rt: RealTime { late_frames: 1, ..gear().rt }, ..gear() };
    assert_eq!(words(late), [None; 6]);
    let missed = |frame| {
        let timing = clocked(vec![list.clone()], run(), late).frame(frame, &from_above()).unwrap();
        timing.misses.iter().filter_map(|missed| missed.part.clone()).collect::<Vec<_>>()
    };
    assert_eq!((missed(1), missed(2)), (vec![], vec!["sequence.turns".to_owned()]));
}

/// Every line asks for more than 24 slots. Each miss names a line and a face, and a pixel of that face on that line tells the miss.
#[test]
fn a_miss_of_an_edge_leads_to_its_streak_and_back() {
    let lists = || vec![sea_list(&sea(SeaState::High, Pattern::Random { seed: 1 }))];
    let few = Hardware { edges_line: Some(24), ..gear() };
    let eye = pose([10.0, 100.0, 30.0], 0.0, -20.0);
    let timing = clocked(lists(), run(), few).frame(0, &eye).unwrap();
    let session = session_on(stage(lists()), run(), few);
    let counts = crate::shots::draw(&*session, 0, &eye).1;
    let misses: Vec<_> = timing.misses.iter().filter(|missed| missed.deadline.word() == "edge").collect();
    assert_eq!(misses.len() as u64, counts["missed"]);
    let (count, missed, least) = slack(&timing, "edge").unwrap();
    assert_eq!((count, missed), (counts["crossings"], counts["missed"]));
    assert_eq!(least, Some(24 - counts["most_crossings"] as i64));
    let of_record: BTreeSet<(u32, &str)> =
        misses.iter().map(|missed| (missed.sweep, missed.part.as_deref().unwrap())).collect();
    assert!(misses.iter().all(|missed| missed.cause == Cause::Occupied));
    let mut of_pixels = BTreeSet::new();
    for column in 0..PIXELS {
        for line in 0..PIXELS {
            for fact in session.explain(0, &eye, [column, line]).unwrap() {
                if fact.what == "missed" {
                    let face = fact.value.strip_prefix("face ").unwrap().split(' ').next().unwrap();
                    of_pixels.insert((column as u32, format!("sea.face.{face}")));
                }
            }
        }
    }
    let of_pixels: BTreeSet<(u32, &str)> =
        of_pixels.iter().map(|(line, part)| (*line, part.as_str())).collect();
    assert!(of_pixels.is_subset(&of_record));
    // Faces of the record without a pixel on their line lie between its samples.
    assert!(of_pixels.len() > of_record.len() / 2, "{} of {}", of_pixels.len(), of_record.len());
}

#[test]
fn sizing_has_the_formula_beside_the_measurement() {
    let frames = frames([50, 50], normals(), 16);
    let clocked = clocked(vec![sea_list(&fine_sea(50, 50))], normals(), gear());
    let figures = clocked.sizing(&frames);
    let of = |key: &str| {
        let figure: &SizedFigure = figures.iter().find(|figure| figure.key == key).unwrap();
        (figure.measured, figure.formula)
    };
    assert_eq!(of("rt_us"), (Some(39_015.0), Some(5000.0)));
    assert_eq!(of("normals_frames"), (Some(8.0), Some(8.0)));
    assert_eq!(of("delay_us"), (None, Some(100_000.0)));
    // 2601 normals are 7.8 ms of look-ups, which no channel fits; a sun vector leaves room for 415 of 12 us.
    assert_eq!(of("channels"), (Some(1.0), Some(0.0)));
    let by_sun = self::clocked(vec![sea_list(&fine_sea(50, 50))], run(), gear()).sizing(&[]);
    let channels = by_sun.iter().find(|figure| figure.key == "channels").unwrap();
    assert_eq!(channels.formula, Some(415.0));
    assert_eq!(of("video_us").0, Some(180.0));
    assert_eq!(of("crossings").1, None);
}

#[test]
fn a_record_with_these_deadlines_holds_together_and_reads_back() {
    let few = Hardware { edges_line: Some(4), edges_frame: Some(100), ..gear() };
    let clocked = clocked(vec![sea_list(&fine_sea(20, 30))], normals(), few);
    let record = TimingRecord {
        format: FORMAT,
        scenario: "a sea".into(),
        machine: smooth_faces::ROW.name.into(),
        inputs: "0".into(),
        keys: BTreeMap::new(),
        master: clocked.master().to_string(),
        before_mission: clocked.before_mission(&from_above()).unwrap(),
        frames: (0..3).map(|frame| clocked.frame(frame, &from_above()).unwrap()).collect(),
    };
    assert_eq!(record.check(), Ok(()));
    let text = serde_json::to_string(&record).unwrap();
    assert_eq!(serde_json::from_str::<TimingRecord>(&text).unwrap(), record);
    let told = record.text();
    assert!(["update", "edge", "edge-store", "frame-tasks"].iter().all(|kind| told.contains(kind)), "{told}");
}
