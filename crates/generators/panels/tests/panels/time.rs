//! How long a frame takes: tasks against the work that is counted, seconds against the gear and against the thesis.

use std::collections::BTreeMap;

use generator::{ReportedTime, Timed};
use panel_program::{FillPieces, Work, WrittenFill};
use panels::{Hardware, REPORTED, tasks};
use timing::{FrameTiming, Task};

use crate::moffett::{configured, frame_stage, poses, scenario};

fn job(text: &str) -> Option<Box<dyn Timed>> {
    configured(text).unwrap().timed(frame_stage("frame")).unwrap()
}

/// Observer 2, 1 or 3 of the path.
fn frame(text: &str, row: usize) -> FrameTiming {
    job(text).unwrap().frame(0, &poses("moffett")[row]).unwrap()
}

fn pieces(tasks: &[Task]) -> BTreeMap<&str, u64> {
    tasks.iter().map(|task| (task.task.as_str(), task.pieces)).collect()
}

fn seconds(tasks: &[Task], routine: &str) -> f64 {
    let ours = tasks.iter().filter(|task| task.task.split('.').next() == Some(routine));
    ours.map(|task| task.ticks as f64 / 1e9).sum()
}

/// A piece of everything, each number another.
fn one_of_each() -> Work {
    let written = WrittenFill { buckets: 14, boxed: 15, marked: 16 };
    Work {
        numbers: 1,
        bytes: 2,
        visits: 3,
        rows: 4,
        placed: 5,
        referenced: 6,
        averaged: 7,
        panels: 8,
        affine: 9,
        projected: 10,
        measured: 11,
        fill: FillPieces { cells: 12, panels: 13, written, pixels: 17, records: 18 },
    }
}

#[test]
fn every_task_is_a_part_of_a_routine_of_the_thesis_in_its_order() {
    let tasks = tasks(&one_of_each(), &Hardware::shipped().unwrap());
    assert_eq!(tasks.iter().map(|task| task.pieces).collect::<Vec<_>>(), (1..=18).collect::<Vec<_>>());
    let mut routines: Vec<&str> = tasks.iter().filter_map(|task| task.task.split('.').next()).collect();
    routines.dedup();
    assert_eq!(routines, REPORTED.map(|time| time.routine));
    let sum: f64 = REPORTED.iter().map(|time| time.seconds).sum();
    assert!((sum - 155.90).abs() < 1e-9, "{sum}");
}

#[test]
fn times_follow_from_pieces_and_hardware() {
    let shipped = Hardware::shipped().unwrap();
    let with = |hardware: Hardware| tasks(&one_of_each(), &hardware);
    let usual = with(shipped);
    let more = |hardware: Hardware| -> BTreeMap<String, u64> {
        let both = usual.iter().zip(with(hardware));
        let more = both.map(|(before, after)| (before.task.clone(), after.ticks - before.ticks));
        more.filter(|(_, more)| *more > 0).collect()
    };
    let of = |expected: &[(&str, u64)]| -> BTreeMap<String, u64> {
        expected.iter().map(|(task, more)| ((*task).to_owned(), *more)).collect()
    };
    let numbers = Hardware { formatted_number: shipped.formatted_number + 1, ..shipped };
    let expected = [("ter-crop", 1), ("ter-dms", 15), ("im-refij", 18), ("new-ij", 60), ("node-depth", 33)];
    assert_eq!(more(numbers), of(&expected));
    let bytes = Hardware { record_byte: shipped.record_byte + 1, ..shipped };
    let expected = [
        ("read-image", 2),
        ("real-el", 4 * 512),
        ("im-refavg.records", 8 * 512),
        ("fill.panels", 13 * 512),
        ("fill.records", 18 * 512),
    ];
    assert_eq!(more(bytes), of(&expected));
    let trigs = Hardware { trig: shipped.trig + 1, ..shipped };
    assert_eq!(more(trigs), of(&[("ter-dms", 35), ("im-refij", 72)]));
    let roots = Hardware { root: shipped.root + 1, ..shipped };
    assert_eq!(more(roots), of(&[("ter-dms", 5), ("node-depth", 11)]));
    let cells = more(Hardware { cell: shipped.cell + 1, ..shipped });
    assert_eq!([cells["fill.cells"], cells["fill.boxed"], cells["fill.marked"]], [12, 30, 48]);
}

#[test]
fn two_stages_are_those_of_the_thesis() {
    let found = frame(&scenario("moffett"), 1);
    for routine in ["ter-crop", "read-image"] {
        let reported = REPORTED.iter().find(|time| time.routine == routine).unwrap().seconds;
        let ratio = seconds(&found.tasks, routine) / reported;
        assert!((ratio - 1.0).abs() < 0.002, "{routine}: {ratio}");
    }
    assert_eq!(found.ticks, found.tasks.iter().map(|task| task.ticks).sum::<u64>());
    assert!(found.deadlines.is_empty() && found.misses.is_empty());
}

#[test]
fn observers_cost_what_they_see() {
    let text = scenario("moffett");
    let [far, near, blind] = [0, 1, 2].map(|row| frame(&text, row));
    let [far, near, blind] = [&far, &near, &blind].map(|frame| (frame, pieces(&frame.tasks)));
    for (_, found) in [&far, &near, &blind] {
        assert_eq!([found["ter-dms"], found["new-ij"], found["fill.panels"]], [108, 108, 176]);
        assert_eq!([found["ter-crop"], found["fill.cells"], found["fill.records"]], [49_980, 524_288, 512]);
    }
    assert!(!blind.1.contains_key("fill.boxed") && far.1["fill.boxed"] < near.1["fill.boxed"]);
    // 512 records of the picture, whether it shows anything or not; their codes are in the hash.
    assert_eq!([far.0.events, near.0.events, blind.0.events], [512; 3]);
    assert!(near.0.events_blake3 != blind.0.events_blake3);
}

#[test]
fn only_the_fill_of_the_listing_takes_time() {
    let text = scenario("moffett");
    for lifted in ["restrictions = false", "restrictions = true\nboth_ends = false"] {
        assert!(job(&text.replace("restrictions = true", lifted)).is_none(), "{lifted}");
    }
    let kept = text.replace("restrictions = true", "restrictions = true\nreal4 = false");
    assert!(job(&kept).is_some());
}

/// As in every file of `hardware-models/`.
#[test]
fn every_value_says_where_it_comes_from() {
    let file = panels::ROW.gear.unwrap().text;
    let values: Vec<&str> =
        file.lines().filter(|line| line.contains(" = ") && !line.starts_with('#')).collect();
    assert_eq!(values.len(), 8);
    for line in values {
        let (_, comment) = line.split_once(" # ").unwrap_or_default();
        assert!(
            ["inferred", "unsourced", "chosen"].iter().any(|status| comment.starts_with(status)),
            "{line}"
        );
    }
}

/// The data sheet, which has the seconds of the block.
const SHEET: &str = include_str!("../../../../../docs/blocks/panels.md");

#[test]
fn the_sheet_has_the_seconds_of_the_block() {
    let found = frame(&scenario("moffett"), 1);
    let row = |time: ReportedTime| {
        let predicted = seconds(&found.tasks, time.routine);
        let ratio = predicted / time.seconds;
        format!("| `{}` | {predicted:.3} | {:.2} | {ratio:.3} |", time.routine, time.seconds)
    };
    let covered = pieces(&found.tasks)["fill.boxed"] as f64 / (512.0 * 512.0);
    let told = format!("The boxes of our block cover {covered:.2} of it");
    let all = REPORTED.map(row).into_iter().chain([told]);
    let missing: Vec<String> = all.filter(|text| !SHEET.contains(text.as_str())).collect();
    assert!(missing.is_empty(), "not in the sheet:\n{}", missing.join("\n"));
}
