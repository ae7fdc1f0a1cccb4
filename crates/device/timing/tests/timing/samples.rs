//! Records to test with: one small by hand, and any that can be.

use std::collections::BTreeMap;

use proptest::collection::{btree_map, vec};
use proptest::option;
use proptest::prelude::{Just, Strategy, any, prop_oneof};
use proptest::sample::select;
use timing::{
    Cause, Deadline, EventHash, FORMAT, FrameTiming, LevelChange, Missed, Sets, Slack, Task, TimingRecord,
    UnitUse, Vertices,
};

fn slack_of(ticks: impl IntoIterator<Item = i64>) -> Slack {
    let mut slack = Slack::default();
    ticks.into_iter().for_each(|ticks| slack.add(ticks));
    slack
}

fn unit(name: &str, busy: u64, longest_queue: u32) -> UnitUse {
    UnitUse { unit: name.into(), busy, longest_queue }
}

pub fn torn_corner() -> Missed {
    Missed {
        deadline: Deadline::TRANSFER,
        sweep: 402,
        crossing: Some(7),
        colour: Some("red".into()),
        register: Some("y-first".into()),
        part: None,
        crater: None,
        region: Some([12, -4]),
        range_m: Some(1530.25),
        due: 365.5,
        came: Some(369.75),
        words: 0x1ff,
        cause: Cause::Queue,
    }
}

pub fn starved_corner() -> Missed {
    Missed {
        deadline: Deadline::CORNER,
        sweep: 17,
        crossing: None,
        colour: None,
        register: None,
        part: None,
        crater: None,
        region: Some([30, 31]),
        range_m: None,
        due: -1.0,
        came: None,
        words: 0,
        cause: Cause::Drum,
    }
}

fn task(unit: &str, task: &str, pieces: u64, ticks: u64) -> Task {
    Task { unit: unit.into(), task: task.into(), pieces, ticks }
}

fn level_change(tile: &str, from: u32, to: u32) -> LevelChange {
    let borders_m = [100.0, 200.0, 150.5, 250.5];
    LevelChange { tile: tile.into(), from, to, distance_m: 15_000.25, fraction: 0.998, borders_m }
}

/// Two frames: a clean one, and one with two misses.
pub fn small() -> TimingRecord {
    let mut events = EventHash::new();
    events.push(40, "loader.red", "strobe", &[1, 2, 3]);
    let (events, events_blake3) = events.finish();
    let clean = FrameTiming {
        frame: 12,
        ticks: 666_667,
        folds: 9400,
        sets: Sets { wanted: 37_600, loaded: 37_598, late: 0, wasted: 18_800, cancelled: 2 },
        late_words: 0,
        vertices: Vertices { asked: 320, ready: 320 },
        deadlines: BTreeMap::from([
            (Deadline::TRANSFER, slack_of([5, 90, 4000])),
            (Deadline::FRAME_TASKS, slack_of([200_000])),
        ]),
        units: vec![unit("cpu", 340_000, 2), unit("loader.red", 33_000, 3)],
        tasks: Vec::new(),
        level_changes: Vec::new(),
        misses: Vec::new(),
        events,
        events_blake3,
    };
    let faulty = FrameTiming {
        frame: 13,
        sets: Sets { late: 1, ..clean.sets },
        late_words: 9,
        vertices: Vertices { asked: 320, ready: 96 },
        deadlines: BTreeMap::from([
            (Deadline::TRANSFER, slack_of([5, -5, 4000])),
            (Deadline::CORNER, slack_of([-70_000, 12])),
        ]),
        units: vec![unit("cpu", 350_000, 1), unit("drum.fine.0", 666_667, 11)],
        tasks: Vec::new(),
        misses: vec![starved_corner(), torn_corner()],
        ..clean.clone()
    };
    TimingRecord {
        format: FORMAT,
        scenario: "mare-drive".into(),
        machine: "pra-nominal".into(),
        inputs: "0123abcd".into(),
        keys: BTreeMap::new(),
        master: "20000000 Hz".into(),
        before_mission: vec![
            task("cpu", "sine-table", 525, 531_300),
            task("drum.fine", "first-sector", 16, 350_000),
        ],
        frames: vec![clean, faulty],
    }
}

fn text() -> impl Strategy<Value = String> {
    prop_oneof![any::<String>(), "[a-z.]{1,12}"]
}

fn finite() -> impl Strategy<Value = f64> {
    prop_oneof![any::<f64>().prop_filter("finite", |value| value.is_finite()), -1e4..1e4]
}

fn missed() -> impl Strategy<Value = Missed> {
    let place = (any::<u32>(), option::of(any::<u32>()), option::of(text()), option::of(text()));
    let what = (select(&Deadline::HYBRID[..]), select(&Cause::ALL[..]), 0u16..512);
    let where_ = (option::of(any::<[i64; 2]>()), option::of(finite()), finite(), option::of(finite()));
    let part = (option::of(text()), option::of(any::<u32>()));
    (place, what, where_, part).prop_map(|(place, what, where_, part)| {
        let ((deadline, cause, words), (region, range_m, due, came)) = (what, where_);
        let (sweep, crossing, colour, register) = place;
        let (part, crater) = part;
        Missed {
            deadline,
            sweep,
            crossing,
            colour,
            register,
            part,
            crater,
            region,
            range_m,
            due,
            came,
            words,
            cause,
        }
    })
}

fn sets() -> impl Strategy<Value = Sets> {
    any::<[u64; 5]>().prop_map(|[wanted, loaded, late, wasted, cancelled]| Sets {
        wanted,
        loaded,
        late,
        wasted,
        cancelled,
    })
}

fn units() -> impl Strategy<Value = Vec<UnitUse>> {
    btree_map(text(), any::<(u64, u32)>(), 0..4)
        .prop_map(|units| units.into_iter().map(|(name, (busy, queue))| unit(&name, busy, queue)).collect())
}

fn deadlines() -> impl Strategy<Value = BTreeMap<Deadline, Slack>> {
    let slack = vec(prop_oneof![any::<i64>(), -1000i64..1000], 0..20).prop_map(slack_of);
    btree_map(select(&Deadline::HYBRID[..]), slack, 0..4)
}

fn tasks() -> impl Strategy<Value = Vec<Task>> {
    btree_map((text(), text()), (1..u64::MAX, 1..u64::MAX), 0..4).prop_map(|tasks| {
        let of = |((unit, name), (pieces, ticks)): ((String, String), _)| task(&unit, &name, pieces, ticks);
        tasks.into_iter().map(of).collect()
    })
}

fn level_changes() -> impl Strategy<Value = Vec<LevelChange>> {
    let change = (any::<u32>(), 1..u32::MAX, 0.0..1e9, 0.0..=1.0);
    btree_map(text(), change, 0..4).prop_map(|changes| {
        let of = |(tile, (from, more, distance_m, fraction))| LevelChange {
            tile,
            from,
            to: from.wrapping_add(more),
            distance_m,
            fraction,
            borders_m: [-10.0, 20.0, 30.0, 40.5],
        };
        changes.into_iter().map(of).collect()
    })
}

fn frame() -> impl Strategy<Value = FrameTiming> {
    let vertices = any::<[u64; 2]>().prop_map(|[a, b]| Vertices { asked: a.max(b), ready: a.min(b) });
    let counters = (1u64.., any::<u64>(), sets(), any::<u64>(), vertices);
    let lists = (deadlines(), units(), tasks(), level_changes(), vec(missed(), 0..4));
    (counters, lists, any::<u64>(), "[0-9a-f]{64}").prop_map(|(counters, lists, events, events_blake3)| {
        let (ticks, folds, sets, late_words, vertices) = counters;
        let (deadlines, units, tasks, level_changes, misses) = lists;
        FrameTiming {
            frame: 0,
            ticks,
            folds,
            sets,
            late_words,
            vertices,
            deadlines,
            units,
            tasks,
            level_changes,
            misses,
            events,
            events_blake3,
        }
    })
}

/// Two frames of a program: it has no deadlines, and tells its time task by task.
pub fn program() -> TimingRecord {
    let mut record = small();
    for (frame, pieces) in record.frames.iter_mut().zip([1000, 3000]) {
        frame.deadlines.clear();
        frame.misses.clear();
        frame.ticks = 10 * pieces;
        frame.tasks =
            vec![task("cpu", "slopes", pieces, 8 * pieces), task("recorder", "plotting", pieces, 2 * pieces)];
        frame.units = vec![unit("cpu", 8 * pieces, 0), unit("recorder", 2 * pieces, 0)];
    }
    record.frames[1].level_changes = vec![level_change("tile.3.7", 2, 1), level_change("tile.4.7", 1, 2)];
    record
}

/// Any record that holds together.
pub fn record() -> impl Strategy<Value = TimingRecord> {
    let frames = btree_map(any::<u64>(), frame(), 1..4).prop_map(|frames| {
        frames.into_iter().map(|(number, frame)| FrameTiming { frame: number, ..frame }).collect()
    });
    let keys = btree_map(text(), text(), 0..4);
    (Just(FORMAT), text(), text(), "[0-9a-f]{1,64}", keys, text(), tasks(), frames).prop_map(
        |(format, scenario, machine, inputs, keys, master, before_mission, frames)| TimingRecord {
            format,
            scenario,
            machine,
            inputs,
            keys,
            master,
            before_mission,
            frames,
        },
    )
}
