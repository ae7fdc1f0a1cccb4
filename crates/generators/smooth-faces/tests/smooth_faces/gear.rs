//! The gear file: status of every figure, and what is refused.

use diagnostics::{Problems, TomlFile};
use faces::Animate;
use generator::Timed;
use smooth_faces::{Clocked, Hardware, Parameters, ROW, RealTime};

use crate::shots::{fine_sea, from_above, gear, run, sea_list, stage};

/// As in every file of `hardware-models/`.
#[test]
fn every_value_says_where_it_comes_from() {
    let text = ROW.gear.unwrap().text;
    let values: Vec<&str> =
        text.lines().filter(|line| line.contains(" = ") && !line.starts_with('#')).collect();
    assert_eq!(values.len(), 14);
    for line in values {
        let (_, comment) = line.split_once(" # ").unwrap_or_default();
        assert!(
            ["reported", "unsourced", "chosen"].iter().any(|status| comment.starts_with(status)),
            "{line}"
        );
    }
}

#[test]
fn values_out_of_range_are_refused_by_name() {
    for (written, wrong) in [
        ("spare_us = 5000 ", "spare_us = 0 "),
        ("instruction_us = 1 ", "instruction_us = 0 "),
        ("words_s = 1e6", "words_s = 0.5"),
        ("vertex_us = 0.2 ", "vertex_us = -0.2 "),
        ("edges_line = 0 ", "edges_line = 1000001 "),
        ("sample_ns = 50 ", "sample_ns = 50.5 "),
        ("adds_levels = true", "adds_levels = 1"),
        ("delay_frames = 3 ", "delay_frames = -3 "),
        ("dead_sun = 0 ", "dead = 0 "),
    ] {
        let text = ROW.gear.unwrap().text;
        assert!(text.contains(written), "{written}");
        let problems = Problems::new();
        let file = TomlFile::parse("a file", &text.replace(written, wrong), &problems).unwrap();
        assert!((ROW.configure)(&file.root(&problems)).is_none(), "{wrong}");
        let told = problems.into_result().unwrap_err().to_string();
        assert!(told.contains(written.split(' ').next().unwrap()), "{told}");
    }
}

/// A spare time of a nanosecond's length and a sea that is never done: numbers stay numbers.
#[test]
fn the_least_and_the_largest_figures_make_a_record() {
    let rt = RealTime { spare_ns: 1, instruction_ns: 1_000_000_000, ..gear().rt };
    let hardware = Hardware { rt, vertex_ns: 1_000_000_000, transfer_words_s: 1, ..gear() };
    let normals = Parameters { animate: Animate::Normals, ..run() };
    let clocked = Clocked::new(stage(vec![sea_list(&fine_sea(20, 30))]), normals, hardware).unwrap();
    let timing = clocked.frame(1, &from_above()).unwrap();
    let update = timing.misses.iter().find(|missed| missed.deadline.word() == "update").unwrap();
    assert!(update.came.is_some_and(|came| came.is_finite() && came > 1e17), "{update:?}");
    assert!(timing.units.iter().any(|unit| unit.busy > 6e11 as u64));
}
