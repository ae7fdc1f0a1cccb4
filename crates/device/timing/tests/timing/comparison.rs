//! Baselines: nothing that changes is let pass, nothing that stays is told.

use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};
use proptest::sample::Index;
use serde_json::{Value, json};
use timing::{Allowance, Comparison, Missed, TimingRecord, Tolerance, compare};

use crate::samples::{program, record, small, torn_corner};

fn exact() -> Tolerance {
    Tolerance::new(0.0, 0.0).expect("a tolerance")
}

fn changed(change: impl FnOnce(&mut TimingRecord)) -> Comparison {
    let mut found = small();
    change(&mut found);
    compare(&small(), &found, &exact())
}

fn places(comparison: &Comparison) -> Vec<&str> {
    let of_frames = comparison.frames.iter().flat_map(|frame| &frame.differences);
    let of_mission = comparison.head.iter().chain(&comparison.before_mission);
    of_mission.chain(of_frames).map(|difference| difference.place.as_str()).collect()
}

/// Pointers to every single value of a document.
fn leaves(value: &Value, way: &str, found: &mut Vec<String>) {
    let escaped = |key: &str| key.replace('~', "~0").replace('/', "~1");
    match value {
        Value::Object(map) => {
            map.iter().for_each(|(key, value)| leaves(value, &format!("{way}/{}", escaped(key)), found));
        }
        Value::Array(list) => {
            list.iter().enumerate().for_each(|(i, value)| leaves(value, &format!("{way}/{i}"), found));
        }
        _ => found.push(way.to_owned()),
    }
}

/// Another value of the same kind. What is not there comes to be there.
fn another(key: &str, value: &Value) -> Value {
    match value {
        Value::Null if ["colour", "register", "part"].contains(&key) => json!("red"),
        Value::Null if key == "region" => json!([7, -7]),
        Value::Null => json!(7),
        Value::Number(number) if number.as_u64() == Some(u64::MAX) => json!(u64::MAX - 1),
        Value::Number(number) if number.is_f64() => json!(next(number.as_f64().expect("a float"))),
        Value::Number(number) if number.as_u64().is_some() => other_count(key, number.as_u64().expect("u64")),
        Value::Number(number) => json!(number.as_i64().expect("an integer") + 1),
        Value::String(_) if key == "cause" && value == "drum" => json!("queue"),
        Value::String(_) if key == "cause" => json!("drum"),
        Value::String(_) if key == "deadline" && value == "corner" => json!("transfer"),
        Value::String(_) if key == "deadline" => json!("corner"),
        Value::String(text) => json!(format!("{text}+")),
        other => panic!("{other} is no leaf"),
    }
}

/// One less where more may not fit.
fn other_count(key: &str, count: u64) -> Value {
    let narrow = ["sweep", "crossing", "crater", "words", "longest_queue", "format"].contains(&key);
    let most = if narrow { 500 } else { i64::MAX as u64 - 1 };
    json!(if count > most { count - 1 } else { count + 1 })
}

/// The least change that a float knows.
fn next(value: f64) -> f64 {
    if value == f64::MAX { value.next_down() } else { value.next_up() }
}

fn values_of(record: &TimingRecord) -> Vec<String> {
    let mut all = Vec::new();
    leaves(&serde_json::to_value(record).expect("JSON"), "", &mut all);
    // Keys decide nothing: they name what differs where the inputs do.
    all.retain(|way| !way.starts_with("/keys/"));
    all
}

/// Changes the value at `way`, and nothing else.
fn expect_change_is_found(record: &TimingRecord, way: &str) {
    let key = way.rsplit('/').find(|part| part.parse::<usize>().is_err()).expect("a key");
    let mut document = serde_json::to_value(record).expect("JSON");
    let leaf = document.pointer_mut(way).expect("a leaf");
    *leaf = another(key, leaf);
    let found: TimingRecord = serde_json::from_value(document).expect("still a record");
    assert!(found != *record, "{way}");

    let comparison = compare(record, &found, &exact());
    assert!(!comparison.is_met(), "{way}");
    let places = places(&comparison);
    let text = comparison.text(99);
    let named = match key {
        "unit" | "task" if way.starts_with("/before_mission") => "before_mission.",
        "unit" | "task" if way.contains("/tasks/") => "tasks.",
        "unit" => "units.",
        "tile" => "level_changes.",
        "deadline" | "sweep" | "crossing" | "colour" | "register" | "part" | "crater" => "miss (",
        key => key,
    };
    assert!(places.iter().all(|place| place.contains(named) && text.contains(place)), "{way}: {places:?}");
    // What changes its name goes, and comes.
    let changes_name = named != key || key == "frame";
    assert_eq!(places.len(), if changes_name { 2 } else { 1 }, "{way}: {places:?}");
}

#[test]
fn every_value_of_a_record_counts() {
    for mut record in [small(), program()] {
        // Frame 13 is one more than frame 12.
        record.frames[1].frame = 20;
        let all = values_of(&record);
        assert!(all.len() > 60, "{all:?}");
        all.iter().for_each(|way| expect_change_is_found(&record, way));
    }
}

proptest! {
    #[test]
    fn a_record_meets_itself(record in record()) {
        let comparison = compare(&record, &record, &exact());
        prop_assert!(comparison.is_met(), "{}", comparison.text(9));
        prop_assert_eq!(&comparison.json()["met"], &json!(true));
    }

    #[test]
    fn any_single_change_is_found_and_named(record in record(), at in any::<Index>()) {
        let all: Vec<String> = values_of(&record);
        expect_change_is_found(&record, at.get::<String>(&all));
    }

    #[test]
    fn both_directions_tell_the_same_places(baseline in record(), found in record()) {
        let there = compare(&baseline, &found, &exact());
        let back = compare(&found, &baseline, &exact());
        prop_assert_eq!(places(&there).len(), places(&back).len());
        prop_assert_eq!(there.is_met(), baseline == found);
    }
}

#[test]
fn other_inputs_are_told_first() {
    let comparison = changed(|found| {
        found.inputs = "ff".into();
        found.frames[0].folds += 1;
    });
    assert_eq!(places(&comparison), ["inputs", "folds"]);
    assert_eq!(
        comparison.text(10),
        "baseline not met: mare-drive on pra-nominal, frames that differ: 1 of 2\n\
         the baseline is of other inputs; it is older than the keys of a record, so it cannot name them\n\
         @@ head @@\n-inputs: 0123abcd\n+inputs: ff\n\
         @@ frame 12 @@\n-folds: 9400\n+folds: 9401\n"
    );
    assert!(!changed(|found| found.master = "10 Hz".into()).is_met());
}

/// A record whose inputs differ names the keys first, then the totals.
#[test]
fn keys_that_differ_are_named_before_all_else() {
    let with = |access: &str, record: TimingRecord| {
        let keys = [("machine.loader.access_ns", access), ("scenario.frames", "90")];
        TimingRecord { keys: keys.map(|(key, value)| (key.into(), value.into())).into(), ..record }
    };
    let baseline = with("45", small());
    let mut found = with("90", small());
    found.inputs = "ff".into();
    found.frames[1].late_words += 9;
    let comparison = compare(&baseline, &found, &exact());
    let text = comparison.text(10);
    let [key, total, head] =
        ["-machine.loader.access_ns: 45\n+machine.loader.access_ns: 90\n", "  late words ", "@@ head @@"]
            .map(|part| text.find(part).unwrap_or_else(|| panic!("{part} in {text}")));
    assert!(key < total && total < head && !text.contains("scenario.frames"), "{text}");
    assert!(text.contains("of other inputs: machine.loader.access_ns differs\n"), "{text}");
    assert_eq!(comparison.json()["keys"][0]["place"], "machine.loader.access_ns");
    // Keys of a run with the same inputs are nobody's concern.
    let same = TimingRecord { inputs: baseline.inputs.clone(), frames: small().frames, ..found };
    assert!(compare(&baseline, &same, &exact()).is_met());
    let other = TimingRecord { inputs: "ff".into(), ..baseline.clone() };
    assert!(compare(&baseline, &other, &exact()).text(9).contains("every key is the same"));
}

#[test]
fn bounds_let_a_record_differ() {
    let mut found = small();
    found.frames[1].late_words += 9;
    let late = found.frames.iter().map(|frame| frame.late_words).sum::<u64>();
    let asked = |bounds: &[&str]| {
        let bounds: Vec<Allowance> = bounds.iter().map(|bound| bound.parse().expect("a bound")).collect();
        compare(&small(), &found, &exact()).within(&bounds, [&small(), &found])
    };
    let within = |bounds: &[&str]| asked(bounds).expect("known deadlines");
    let (met, missed) = (format!("late-words<={late}"), format!("late-words<={}", late - 1));
    assert!(!within(&[]).is_met() && within(&[&met]).is_met() && !within(&[&missed]).is_met());
    assert!(!within(&[&met, "slack>=1000000"]).is_met());
    // Of the hybrid machine a deadline may not be there; a name that nobody has is refused, with those that there are.
    assert!(within(&[&met, "slack.segment>=0"]).is_met());
    let unknown = asked(&[&met, "slack.transfr>=-99"]).expect_err("no such deadline").to_string();
    assert!(unknown.starts_with("`slack.transfr>=-99`: no such deadline; expected one of "), "{unknown}");
    assert!(unknown.contains("transfer"), "{unknown}");
    let text = within(&[&missed]).text(9);
    assert!(text.contains(&format!("beyond late-words<={}: found {late}", late - 1)), "{text}");
    let junit = within(&[&met]).junit(9);
    assert!(junit.contains("failures=\"0\"") && junit.contains("late-words&lt;="), "{junit}");
    assert!(within(&[&missed]).junit(9).contains("failures=\"1\""));
    for wrong in
        ["late-words", "late-words>=3", "slack<=3", "late-words.transfer<=3", "missed<=x", "words<=3", ""]
    {
        let error = wrong.parse::<Allowance>().expect_err(wrong).to_string();
        assert!(error.contains(&format!("`{wrong}`")) && error.contains("late-words<=N"), "{error}");
    }
}

#[test]
fn analog_values_have_a_tolerance_and_digital_ones_have_none() {
    let near = |samples: f64, metres: f64| {
        let mut found = small();
        let missed = &mut found.frames[1].misses[1];
        missed.due += 0.125;
        missed.came = missed.came.map(|came| came - 0.125);
        missed.range_m = missed.range_m.map(|range| range + 0.5);
        let comparison = compare(&small(), &found, &Tolerance::new(samples, metres).expect("a tolerance"));
        places(&comparison)
            .iter()
            .map(|place| place.rsplit('.').next().expect("a key").to_owned())
            .collect::<Vec<_>>()
    };
    assert_eq!(near(0.125, 0.5), [""; 0]);
    assert_eq!(near(0.124, 0.5), ["due", "came"]);
    assert_eq!(near(0.125, 0.49), ["range_m"]);
    for wrong in [-1e-9, f64::NAN, f64::INFINITY] {
        assert!(Tolerance::new(wrong, 0.0).is_err() && Tolerance::new(0.0, wrong).is_err());
    }
}

#[test]
fn never_is_not_near_any_instant() {
    let mut found = small();
    found.frames[1].misses[1].came = None;
    let wide = Tolerance::new(1e9, 1e9).expect("a tolerance");
    assert!(!compare(&small(), &found, &wide).is_met());
    // A record made in memory may hold what no file may.
    found.frames[1].misses[1].came = Some(f64::NAN);
    assert!(!compare(&small(), &found, &wide).is_met());
    assert!(!compare(&found, &found, &wide).is_met());
}

#[test]
fn misses_come_and_go_by_identity() {
    let gone = changed(|found| drop(found.frames[1].misses.pop()));
    assert_eq!(
        gone.text(10),
        "baseline not met: mare-drive on pra-nominal, frames that differ: 1 of 2\n\
         totals:\n  misses by queue 1 to 0\n@@ frame 13 @@\n\
         -miss (sweep 402, crossing 7, red y-first, transfer): due 365.5, came 369.75 (4.250 late), corner 12 -4, range \
         1530.25 m, words 0x1ff, queue\n"
    );
    let new = changed(|found| {
        let missed = Missed { sweep: 403, came: None, region: None, range_m: None, ..torn_corner() };
        found.frames[1].misses.insert(0, missed);
    });
    let differences = &new.frames[1].differences;
    assert_eq!(differences.len(), 1);
    assert_eq!(differences[0].baseline, None);
    assert_eq!(differences[0].found.as_deref(), Some("due 365.5, never came, words 0x1ff, queue"));
}

#[test]
fn of_two_misses_of_one_identity_none_is_lost() {
    let twice = changed(|found| found.frames[1].misses.push(torn_corner()));
    assert_eq!(places(&twice), ["miss (sweep 402, crossing 7, red y-first, transfer)"]);
    let mut unit_twice = small();
    let units = &mut unit_twice.frames[0].units;
    units.push(units[0].clone());
    assert!(!compare(&small(), &unit_twice, &exact()).is_met());
}

#[test]
fn deadlines_and_units_come_and_go_by_name() {
    let gone = changed(|found| {
        found.frames[0].deadlines.remove(&timing::Deadline::TRANSFER);
        found.frames[0].units.remove(1);
    });
    let gone = gone.text(10);
    let expected = "@@ frame 12 @@\n-deadlines.transfer: 3 deadlines, 0 missed\n-units.loader.red: 33000 ticks at work\n";
    assert!(gone.ends_with(expected), "{gone}");
    let new = changed(|found| found.frames[0].deadlines = found.frames[1].deadlines.clone());
    assert!(places(&new).contains(&"deadlines.corner") && places(&new).contains(&"deadlines.frame-tasks"));
    assert!(changed(|found| found.frames[1].units.reverse()).is_met());
}

#[test]
fn frames_of_one_side_are_told() {
    let fewer = changed(|found| found.frames.truncate(1));
    assert!(fewer.text(10).ends_with("@@ frame 13 @@\n-frame: recorded\n"), "{}", fewer.text(10));
    let more = changed(|found| {
        let next = timing::FrameTiming { frame: 14, ..found.frames[1].clone() };
        found.frames.push(next);
    });
    assert!(more.text(10).ends_with("@@ frame 14 @@\n+frame: recorded\n"), "{}", more.text(10));
}

#[test]
fn a_long_diff_is_cut_and_counted() {
    let many = changed(|found| {
        for frame in &mut found.frames {
            (frame.ticks, frame.folds, frame.events) = (1, 1, 7);
        }
    });
    let text = many.text(4);
    assert_eq!(text.lines().filter(|line| line.starts_with('+')).count(), 4);
    assert!(text.contains("@@ frame 13 @@\n-ticks") && text.ends_with("and 2 more\n"), "{text}");
    assert!(many.text(3).ends_with("+events: 7\nand 3 more\n"), "{}", many.text(3));
    assert!(!many.text(6).contains("more"));
}

#[test]
fn verdict_of_a_baseline_that_is_met() {
    let comparison = changed(|_| {});
    assert_eq!(comparison.text(10), "baseline met: mare-drive on pra-nominal, frames: 2\n");
    let document = comparison.json();
    assert_eq!(document["frames"][1], json!({ "frame": 13, "differences": [] }));
    assert_eq!(document["tolerance"], json!({ "samples": 0.0, "metres": 0.0 }));
}
