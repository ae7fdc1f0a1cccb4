//! The timing of augmented pictures as a timing record, so that the same baselines hold it.

use std::collections::BTreeMap;

use timing::{
    Cause, Deadline, FORMAT, FrameTiming, Missed, Sets, Slack, Task, TimingRecord, UnitUse, Vertices,
};

use crate::frame_work::FrameWork;
use crate::insertion::Method;
use crate::work::{INTERSECTION_S, POINT_S};

/// Ticks of the record in a second: a microsecond each (our choice; hardware table 3.7 has no finer times).
pub(crate) const MASTER_HZ: f64 = 1e6;

/// The record of `made`, pictures with the shadow of `name` under `method`, one every `period` (s); `inputs` is a hash of what decides
/// them.
///
/// Deadline of a picture is the end of the one before: [`Deadline::FRAME_TASKS`]. Units are the computer, busy with points
/// and intersections, and the scan converter, if there is one; these are its tasks, too. Events are those of `Blanking`, vertices
/// the points of the chain; there are no folds, no register sets.
pub fn timing_record(
    name: &str,
    inputs: String,
    method: &Method,
    period: f64,
    made: &[FrameWork],
) -> TimingRecord {
    let machine = match method {
        Method::Synchronised { dac_bits } => format!("augment, synchronised, {dac_bits} bits"),
        Method::ScanConverter(tube) => format!("augment, scan converter, {} lines", tube.tv_lines),
    };
    TimingRecord {
        format: FORMAT,
        scenario: name.to_owned(),
        machine,
        inputs,
        keys: BTreeMap::new(),
        master: format!("{MASTER_HZ} Hz"),
        before_mission: Vec::new(),
        frames: made.iter().map(|frame| frame_timing(frame, method, period)).collect(),
    }
}

fn frame_timing(frame: &FrameWork, method: &Method, period: f64) -> FrameTiming {
    let [setup, write] = [frame.times.setup_s, frame.times.write_s].map(ticks);
    let whole = ticks(period).max(1);
    let slack_ticks = whole as i64 - setup.max(write) as i64;
    let mut slack = Slack::default();
    slack.add(slack_ticks);
    let tube = matches!(method, Method::ScanConverter(_));
    let cause = if setup >= write { Cause::Processor } else { Cause::Occupied };
    let unit = |unit: &str, busy| UnitUse { unit: unit.to_owned(), busy, longest_queue: 0 };
    FrameTiming {
        frame: frame.frame,
        ticks: whole,
        folds: 0,
        sets: Sets::default(),
        late_words: 0,
        vertices: Vertices { asked: frame.work.points, ready: frame.work.points },
        deadlines: BTreeMap::from([(Deadline::FRAME_TASKS, slack)]),
        units: [Some(unit("cpu", setup)), tube.then(|| unit("scan-converter", write))]
            .into_iter()
            .flatten()
            .collect(),
        tasks: tasks(frame, method),
        level_changes: Vec::new(),
        misses: (slack_ticks < 0).then(|| Missed::of(Deadline::FRAME_TASKS, 0, cause)).into_iter().collect(),
        events: frame.blanking.events,
        events_blake3: frame.blanking.events_blake3.clone(),
    }
}

/// What the units are busy with: points and, under the synchronised method, intersections; the tube's picture.
fn tasks(frame: &FrameWork, method: &Method) -> Vec<Task> {
    let work = frame.work;
    let computed = |task, pieces, each: f64| ("cpu", task, pieces, pieces as f64 * each);
    let points = computed("points", work.points, POINT_S);
    let method = match method {
        Method::Synchronised { .. } => computed("intersections", work.intersections, INTERSECTION_S),
        Method::ScanConverter(_) => ("scan-converter", "picture", 1, frame.times.write_s),
    };
    let task = |(unit, task, pieces, seconds): (&str, &str, u64, f64)| Task {
        unit: unit.into(),
        task: task.into(),
        pieces,
        ticks: ticks(seconds),
    };
    [points, method].into_iter().map(task).filter(|task| task.ticks > 0).collect()
}

/// Time in ticks of the record, the nearest.
pub(crate) fn ticks(seconds: f64) -> u64 {
    (seconds * MASTER_HZ).round() as u64
}

#[cfg(test)]
mod tests {
    use timing::{Cause, Deadline};

    use super::timing_record;
    use crate::FrameWork;
    use crate::blanking::Blanking;
    use crate::gate::Gates;
    use crate::insertion::{Method, ScanConverter};
    use crate::work::Work;

    fn made(method: &Method, work: Work) -> FrameWork {
        FrameWork {
            frame: 3,
            time_s: 0.1,
            file: "frame-3.png".into(),
            pixels_blake3: String::new(),
            work,
            times: work.times(method, 0.04),
            blanking: Blanking::of(method, &[Gates::default()], 1.0),
        }
    }

    /// 1000 intersections of 25 us and 100 points of 90 us are 34 ms of a picture of 40 ms; 2000 are too many.
    #[test]
    fn a_shadow_is_due_when_the_picture_before_it_ends() {
        let method = Method::Synchronised { dac_bits: 10 };
        let of = |intersections| {
            let work = Work { points: 100, intersections, ..Work::default() };
            let record = timing_record("rover", "00".into(), &method, 0.04, &[made(&method, work)]);
            record.check().unwrap();
            record.frames[0].clone()
        };
        let [met, missed] = [of(1000), of(2000)];
        assert_eq!((met.ticks, met.units[0].busy, met.vertices.asked), (40_000, 34_000, 100));
        let tasks: Vec<_> =
            met.tasks.iter().map(|task| (task.task.as_str(), task.pieces, task.ticks)).collect();
        assert_eq!(tasks, [("points", 100, 9_000), ("intersections", 1000, 25_000)]);
        assert_eq!(met.deadlines[&Deadline::FRAME_TASKS].least, Some(6_000));
        assert!(met.misses.is_empty() && met.units.len() == 1);
        assert_eq!(missed.deadlines[&Deadline::FRAME_TASKS].least, Some(-19_000));
        assert_eq!(missed.misses[0].cause, Cause::Processor);
    }

    /// A tube all dark takes 66 ms, the computer 9 ms.
    #[test]
    fn a_scan_converter_is_a_unit_of_its_own() {
        let method = Method::ScanConverter(ScanConverter::default());
        let work = Work { points: 100, intersections: 1000, dark: 1.0, ..Work::default() };
        let record = timing_record("rover", "00".into(), &method, 0.04, &[made(&method, work)]);
        record.check().unwrap();
        let frame = &record.frames[0];
        let busy: Vec<_> = frame.units.iter().map(|unit| (unit.unit.as_str(), unit.busy)).collect();
        assert_eq!(busy, [("cpu", 9_000), ("scan-converter", 66_000)]);
        let tasks: Vec<_> = frame.tasks.iter().map(|task| (task.unit.as_str(), task.ticks)).collect();
        assert_eq!(tasks, busy);
        assert_eq!((frame.misses[0].cause, frame.events), (Cause::Occupied, 0));
    }
}
