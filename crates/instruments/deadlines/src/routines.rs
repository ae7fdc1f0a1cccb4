//! Times of a program beside those that its source reports.

use generator::ReportedTime;
use serde::Serialize;
use text::table;
use timing::{Task, TimingRecord, Totals};

/// A routine: what its work comes to, and what the source measured.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Routine {
    /// Name of the routine.
    pub routine: &'static str,
    /// Pieces a frame of each of its tasks, in their order.
    pub pieces: Vec<f64>,
    /// Time a frame (s) that pieces and gear come to.
    pub predicted_s: f64,
    /// Part of the predicted time of all routines.
    pub predicted_share: f64,
    /// Time (s) that the source reports.
    pub reported_s: f64,
    /// Part of the time of all routines that the source reports.
    pub reported_share: f64,
    /// Predicted over reported time.
    pub ratio: f64,
}

/// The routines of `record`, whose clock has `tick_s` seconds a tick, in the order in which the source reports them.
pub fn routines(record: &TimingRecord, tick_s: f64, reported: &[ReportedTime]) -> Vec<Routine> {
    let totals = Totals::of(record);
    let frames = totals.frames.max(1) as f64;
    let tasks_of = |routine: &str| -> Vec<&Task> {
        let name = |task: &Task| task.task.split('.').next() == Some(routine);
        totals.tasks.iter().filter(|task| name(task)).collect()
    };
    let seconds_of = |routine: &str| {
        let ticks: u64 = tasks_of(routine).iter().map(|task| task.ticks).sum();
        ticks as f64 * tick_s / frames
    };
    let predicted_sum: f64 = reported.iter().map(|time| seconds_of(time.routine)).sum();
    let reported_sum: f64 = reported.iter().map(|time| time.seconds).sum();
    let of = |&ReportedTime { routine, seconds }: &ReportedTime| {
        let predicted = seconds_of(routine);
        Routine {
            routine,
            pieces: tasks_of(routine).iter().map(|task| task.pieces as f64 / frames).collect(),
            predicted_s: predicted,
            predicted_share: predicted / predicted_sum,
            reported_s: seconds,
            reported_share: seconds / reported_sum,
            ratio: predicted / seconds,
        }
    };
    reported.iter().map(of).collect()
}

/// A table of routines, with their sum in the last line; nothing where there are none.
pub fn routines_text(routines: &[Routine]) -> String {
    if routines.is_empty() {
        return String::new();
    }
    let head = ["routine", "pieces a frame", "predicted (s)", "share", "reported (s)", "share", "ratio"];
    let share = |share: f64| format!("{:.2} %", 100.0 * share);
    let row = |routine: &Routine| {
        let pieces: Vec<String> = routine.pieces.iter().map(|pieces| format!("{pieces:.0}")).collect();
        vec![
            routine.routine.to_owned(),
            pieces.join(" "),
            format!("{:.3}", routine.predicted_s),
            share(routine.predicted_share),
            format!("{:.2}", routine.reported_s),
            share(routine.reported_share),
            format!("{:.3}", routine.ratio),
        ]
    };
    let [predicted, reported] =
        [|routine: &Routine| routine.predicted_s, |routine: &Routine| routine.reported_s]
            .map(|time| routines.iter().map(time).sum::<f64>());
    let all = Routine {
        routine: "in all",
        pieces: Vec::new(),
        predicted_s: predicted,
        predicted_share: 1.0,
        reported_s: reported,
        reported_share: 1.0,
        ratio: predicted / reported,
    };
    let rows: Vec<_> = [head.map(str::to_owned).to_vec()]
        .into_iter()
        .chain(routines.iter().chain([&all]).map(row))
        .collect();
    format!("\n{}", table(&rows))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use generator::ReportedTime;
    use timing::{EventHash, FORMAT, FrameTiming, Task, TimingRecord, UnitUse};

    use super::{routines, routines_text};

    fn record() -> TimingRecord {
        let task = |task: &str, pieces, ticks| Task { unit: "cpu".into(), task: task.into(), pieces, ticks };
        let frame = |frame: u64, more: u64| {
            let tasks =
                vec![task("fill.boxes", 10, 300), task("fill.pixels", 4 + more, 100), task("fi", 1, 200)];
            let busy = tasks.iter().map(|task| task.ticks).sum();
            let units = vec![UnitUse { unit: "cpu".into(), busy, longest_queue: 0 }];
            FrameTiming::of_work(frame, units, tasks, &EventHash::new())
        };
        TimingRecord {
            format: FORMAT,
            scenario: "a block".into(),
            machine: "panels".into(),
            inputs: "0".into(),
            keys: BTreeMap::new(),
            master: "1000 Hz".into(),
            before_mission: Vec::new(),
            frames: vec![frame(0, 0), frame(1, 2)],
        }
    }

    #[test]
    fn a_routine_has_the_time_of_its_tasks() {
        let reported = [("fi", 0.1), ("fill", 0.8), ("affin", 0.1)]
            .map(|(routine, seconds)| ReportedTime { routine, seconds });
        let found = routines(&record(), 1e-3, &reported);
        assert_eq!(found[0].pieces, [1.0]);
        assert_eq!(found[1].pieces, [10.0, 5.0], "the mean of both frames");
        for (routine, (predicted, share)) in
            found.iter().zip([(0.2, 1.0 / 3.0), (0.4, 2.0 / 3.0), (0.0, 0.0)])
        {
            assert!((routine.predicted_s - predicted).abs() < 1e-12, "{routine:?}");
            assert!((routine.predicted_share - share).abs() < 1e-12, "{routine:?}");
        }
        assert!((found[1].reported_share - 0.8).abs() < 1e-12 && (found[1].ratio - 0.5).abs() < 1e-12);
        let text = routines_text(&found);
        assert!(text.contains("10 5") && text.contains("66.67 %") && text.contains("80.00 %"), "{text}");
        let last = text.lines().last().unwrap();
        assert!(last.starts_with("in all") && last.ends_with("0.600"), "{text}");
        assert_eq!(routines_text(&[]), "");
    }
}
