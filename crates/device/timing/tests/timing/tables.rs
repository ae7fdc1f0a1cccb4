//! Tables, totals, numbers for plots.

use timing::{Deadline, Totals};

use crate::samples::{program, small, torn_corner};

#[test]
fn tables_of_the_small_record() {
    assert_eq!(small().text(), include_str!("small.txt"));
}

#[test]
fn tables_of_a_record_without_misses() {
    let mut clean = small();
    clean.frames.truncate(1);
    let text = clean.text();
    assert!(text.contains("frame 12\n") && text.ends_with("\nno misses\n"), "{text}");
}

#[test]
fn many_sweeps_are_cut() {
    let mut torn = small();
    let misses = &mut torn.frames[1].misses;
    misses.clear();
    for sweep in 0..20u32 {
        misses.extend(vec![timing::Missed { sweep, ..torn_corner() }; 1 + sweep as usize % 3]);
    }
    let text = torn.text();
    assert!(
        text.contains("sweep                    misses      in frames\n2                             3"),
        "{text}"
    );
    assert!(text.ends_with("\nand 8 more sweeps\n"), "{text}");
}

#[test]
fn the_worst_is_told_with_its_place() {
    let totals = Totals::of(&small());
    let transfer = &totals.deadlines[&Deadline::TRANSFER];
    assert_eq!((transfer.slack.least, transfer.worst_frame), (Some(-5), Some(13)));
    assert_eq!(transfer.worst_miss, Some(torn_corner()));
    let tasks = &totals.deadlines[&Deadline::FRAME_TASKS];
    assert_eq!((tasks.worst_frame, &tasks.worst_miss), (Some(12), &None));
}

#[test]
fn never_is_later_than_late() {
    let mut record = small();
    let misses = &mut record.frames[1].misses;
    misses.push(timing::Missed { sweep: 500, came: None, ..torn_corner() });
    let worst = Totals::of(&record).deadlines[&Deadline::TRANSFER].worst_miss.clone();
    assert_eq!(worst.map(|missed| missed.sweep), Some(500));
}

#[test]
fn utilisation_is_over_the_frames_that_have_the_unit() {
    let record = small();
    let units = Totals::of(&record).units;
    assert_eq!(units["drum.fine.0"].least, 1.0);
    assert_eq!(units["cpu"].mean, 690_000.0 / 1_333_334.0);
    assert_eq!(units["cpu"].least, 340_000.0 / 666_667.0);
    assert_eq!(units["cpu"].longest_queue, 2);
    assert_eq!(record.utilisation_over_frames("drum.fine.0"), [(13, 1.0)]);
    let used = record.frames[1].unit_utilisation();
    assert_eq!(used[1], ("drum.fine.0".to_owned(), 1.0));
}

#[test]
fn histograms_add_up_over_frames() {
    let histogram = small().slack_histogram(Deadline::TRANSFER);
    assert_eq!(histogram.len(), 16);
    let filled: Vec<_> = histogram.iter().filter(|(_, count)| *count > 0.0).cloned().collect();
    let expected = [("-8..-1", 1.0), ("1..8", 2.0), ("8..128", 1.0), ("1024..8192", 2.0)];
    assert_eq!(filled, expected.map(|(label, count)| (label.to_owned(), count)));
    assert!(small().slack_histogram(Deadline::SWEEP_SET_UP).iter().all(|(_, count)| *count == 0.0));
}

#[test]
fn sums_of_a_strange_record_do_not_run_over() {
    let mut record = small();
    for frame in &mut record.frames {
        (frame.ticks, frame.folds, frame.events) = (u64::MAX, u64::MAX, u64::MAX);
        frame.units[0].busy = u64::MAX;
    }
    assert_eq!(Totals::of(&record).folds, u64::MAX);
    assert!(record.text().contains("100.00 %"));
}

#[test]
fn a_program_has_its_tasks_and_no_deadlines() {
    let text = program().text();
    let (_, tables) = text.split_once("\nunit at work").unwrap();
    let rows: Vec<Vec<&str>> = tables.lines().map(|line| line.split_whitespace().collect()).collect();
    assert_eq!(rows[5], ["cpu", "slopes", "2000.0", "16000.0", "80.00", "%"]);
    assert_eq!(rows[6], ["recorder", "plotting", "2000.0", "4000.0", "20.00", "%"]);
    assert_eq!(rows.len(), 7, "{text}");
    assert!(!text.contains("sets late") && !text.contains("misses"), "{text}");
    assert_eq!(Totals::of(&program()).tasks[0].pieces, 4000);
}
