//! The listing and the timing record are of one machine.

use std::collections::BTreeMap;

use serde_json::Value;
use timing::EventHash;

use crate::scene::Scene;
use crate::{json, with};

fn trace(scene: &Scene, stage: &[&str], more: &[&str]) -> Value {
    let command = [&["trace", "tiny.toml", "--frame", "1", "--json"], stage, more].concat();
    json(&scene.expect(0, &command).0)
}

fn record(scene: &Scene, stage: &[&str]) -> Value {
    let command = [&["timing", "show", "tiny.toml", "--frames", "1", "--json"], stage].concat();
    json(&scene.expect(0, &command).0)["record"]["frames"][0].clone()
}

fn events(listing: &Value) -> &Vec<Value> {
    listing["events"].as_array().unwrap()
}

fn text<'v>(event: &'v Value, key: &str) -> &'v str {
    event[key].as_str().unwrap_or_default()
}

/// All events, `limit` and those of the same tick at a time.
fn in_pages(scene: &Scene, stage: &[&str], limit: usize) -> Vec<Value> {
    let (limit, mut from) = (limit.to_string(), Some(0));
    let mut all = Vec::new();
    while let Some(tick) = from {
        let page = trace(scene, stage, &["--limit", &limit, "--from", &tick.to_string()]);
        all.extend_from_slice(events(&page));
        from = page["next"].as_u64();
        assert_eq!(page["is_all"], Value::from(from.is_none()));
    }
    all
}

const SLOW: [&str; 4] = ["--set", "buffer.words=unlimited", "--set", "loader.access_ns=300000"];

/// Machines whose digital sides differ in kind.
fn stages() -> Vec<Vec<&'static str>> {
    let on = |machine: &'static str, more: &[&'static str]| [&["--machine", machine], more].concat();
    vec![
        on("ideal", &[]),
        on("pra-nominal", &SLOW),
        on("pra-nominal", &[&SLOW[..], &["--set", "loader.late_policy=\"latched\""]].concat()),
        on("pra-nominal", &[&SLOW[..], &["--set", "loader.diagonal_register=true"]].concat()),
        on("pra-frugal", &["--set", "buffer.words=unlimited"]),
        // Sets wait through more than one move of their colour.
        on("pra-frugal", &SLOW),
        on("pra-frugal", &[&SLOW[..], &["--set", "loader.diagonal_register=true"]].concat()),
        on("pra-overloaded", &[]),
    ]
}

#[test]
fn counts_are_those_of_the_record() {
    let scene = Scene::new();
    for stage in stages() {
        let (listing, record) = (trace(&scene, &stage, &[]), record(&scene, &stage));
        let mut counts: BTreeMap<&str, u64> = BTreeMap::new();
        events(&listing).iter().for_each(|event| *counts.entry(text(event, "event")).or_default() += 1);
        let of = |word: &str| counts.get(word).copied().unwrap_or(0);
        let sets = &record["sets"];
        let late: u64 = events(&listing)
            .iter()
            .filter(|event| event["event"] == "late")
            .map(|event| event["words"].as_u64().unwrap())
            .sum();
        let found = [of("stop"), of("wanted"), of("access"), of("late"), of("wasted"), of("cancelled"), late];
        let names = ["folds", "wanted", "loaded", "late", "wasted", "cancelled", "late_words"];
        let expected = names
            .map(|name| if matches!(name, "folds" | "late_words") { &record[name] } else { &sets[name] });
        assert_eq!(found.map(Value::from).each_ref(), expected, "{stage:?}: {names:?}");
        assert_eq!(Value::from(of("stop") + of("load")), record["events"], "{stage:?}");
        assert!(of("transfer") <= 2 * of("stop") && of("stop") > 100, "{stage:?}");
        let ticks: Vec<u64> = events(&listing).iter().map(|event| event["tick"].as_u64().unwrap()).collect();
        assert!(ticks.is_sorted(), "{stage:?}");
        assert_eq!(listing["listed"], ticks.len(), "{stage:?}");
    }
}

/// Not only as many: the same ones in the same order.
#[test]
fn the_hash_of_the_events_is_that_of_the_record() {
    let scene = Scene::new();
    for stage in stages() {
        let (listing, record) = (trace(&scene, &stage, &[]), record(&scene, &stage));
        let hash = |sweep: u64| {
            let mut hash = EventHash::new();
            events(&listing)
                .iter()
                .filter(|event| event["sweep"] == sweep)
                .for_each(|event| push(&mut hash, event));
            hash.part()
        };
        let (count, hash) = EventHash::join((0..40).map(hash));
        assert_eq!(
            (Value::from(count), Value::from(hash)),
            (record["events"].clone(), record["events_blake3"].clone()),
            "{stage:?}"
        );
    }
}

fn push(hash: &mut EventHash, event: &Value) {
    let tick = event["tick"].as_u64().unwrap();
    match text(event, "event") {
        "stop" => hash.push(tick, "stop", text(event, "axis"), &[event["stop"].as_u64().unwrap()]),
        "load" => {
            // 400 m in regions of 50 m are nine corners; what is not there has no place.
            let corner = match event["corner"].as_array() {
                Some(place) => place[0].as_u64().unwrap() * COLUMNS + place[1].as_u64().unwrap(),
                None => u64::from(u32::MAX),
            };
            let mask = event["mask"].as_u64().unwrap();
            hash.push(tick, text(event, "colour"), text(event, "register"), &[corner, mask]);
        }
        _ => {}
    }
}

const COLUMNS: u64 = 9;

#[test]
fn late_words_are_the_misses_of_the_record() {
    let scene = Scene::new();
    let stage = crate::NOMINAL;
    let listing = trace(&scene, &stage, &["--event", "late"]);
    let record = record(&scene, &stage);
    let key = |event: &Value, comes: &str, register: &str| {
        let words = ["sweep", "crossing", "colour", register, "words"].map(|key| event[key].clone());
        (words.map(|value| value.to_string()), event[comes].to_string())
    };
    let mut found: Vec<_> = events(&listing)
        .iter()
        .map(|event| {
            let mut event = event.clone();
            event["words"] = event["mask"].clone();
            key(&event, "comes_sample", "register")
        })
        .collect();
    let mut expected: Vec<_> =
        record["misses"].as_array().unwrap().iter().map(|miss| key(miss, "came", "register")).collect();
    found.sort();
    expected.sort();
    assert!(!found.is_empty());
    assert_eq!(found, expected);
    let least = events(&listing).iter().filter_map(|event| event["slack_ticks"].as_i64()).min().unwrap();
    assert!(least >= record["deadlines"]["transfer"]["least"].as_i64().unwrap() && least < 0);
}

/// What a filter lets through.
type Passes<'a> = &'a dyn Fn(&Value) -> bool;

#[test]
fn filters_take_from_the_whole_what_they_say() {
    let scene = Scene::new();
    let stage = crate::NOMINAL;
    let whole = trace(&scene, &stage, &[]);
    let all = events(&whole);
    let middle = all[all.len() / 2]["tick"].as_u64().unwrap();
    let tick = middle.to_string();
    let cases: [(&[&str], Passes<'_>); 7] = [
        (&["--sweep", "7..9"], &|event| (7..9).contains(&event["sweep"].as_u64().unwrap_or(99))),
        (&["--unit", "loader"], &|event| text(event, "unit").starts_with("loader.")),
        (&["--unit", "loader.red,dpu"], &|event| matches!(text(event, "unit"), "loader.red" | "dpu")),
        (&["--event", "stop,late"], &|event| matches!(text(event, "event"), "stop" | "late")),
        (&["--colour", "black"], &|event| event["colour"] == "black"),
        (&["--from", &tick], &|event| event["tick"].as_u64().unwrap() >= middle),
        (&["--to", &tick], &|event| event["tick"].as_u64().unwrap() < middle),
    ];
    for (more, passes) in cases {
        let expected: Vec<&Value> = all.iter().filter(|event| passes(event)).collect();
        let found = trace(&scene, &stage, more);
        assert!(!expected.is_empty() && events(&found).iter().eq(expected), "{more:?}");
    }
    assert_eq!(in_pages(&scene, &stage, 5), *all);
    let (csv, _) = scene.expect(0, &with(&["trace", "tiny.toml", "--frame", "1", "--csv"], &[]));
    assert_eq!(csv.lines().count(), all.len() + 1);
    let columns = csv.lines().next().unwrap().split(',').count();
    assert!(csv.lines().all(|line| line.split(',').count() == columns));
    let (said, err) = scene.expect(0, &with(&["trace", "tiny.toml", "--frame", "1"], &["--limit", "3"]));
    let listed = said.lines().count() - 3;
    assert!((3..all.len()).contains(&listed), "{said}");
    assert!(err.contains(&format!("{listed} events, and more: --from ")), "{err}");
}

/// What can never be listed is refused; what happens not to be there is said to be none.
#[test]
fn a_listing_of_nothing_says_why() {
    let scene = Scene::new();
    let trace =
        |code, more: &[&str]| scene.expect(code, &[&["trace", "tiny.toml", "--frame", "1"], more].concat());
    for (more, words) in [
        (&["--from", "999999999"][..], "--from 999999999: the events are at ticks"),
        (&["--to", "0"], "--to 0: the events are at ticks"),
        (&["--level", "coarse"], "--level coarse: the scenario has one level of terrain; expected fine"),
        (&["--unit", "drum"], "--unit drum: the machine has no drums"),
        (
            &["--unit", "drum.fine.77", "-m", "pra-nominal"],
            "--unit drum.fine.77: each kind of data has drums 0..4",
        ),
        (&["--unit", "drum.coarse", "-m", "pra-nominal"], "--unit drum.coarse: the scenario has one level"),
    ] {
        let (out, err) = trace(2, more);
        assert!(out.is_empty() && err.contains(words) && err.lines().count() == 1, "{more:?}: {out}{err}");
    }
    for form in ["--csv", "--json"] {
        let (out, err) = trace(0, &["--event", "late", form]);
        assert!(!out.is_empty() && err.contains("nothing found: none of "), "{out}{err}");
        assert!(err.contains("they are of dpu, loader.black"), "{err}");
    }
}
