//! Records on disk: the same bits back, and no damage unseen.

use std::path::PathBuf;

use proptest::prelude::{prop_assert_eq, proptest};
use serde_json::{Value, json};
use tempfile::TempDir;
use timing::{Deadline, Fault, RecordError, Slack, TimingRecord, read, write};

use crate::samples::{record, small};

const GOLDEN: &str = include_str!("small.json");

fn room() -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("record.json");
    (folder, path)
}

fn read_text(text: impl AsRef<[u8]>) -> Result<TimingRecord, RecordError> {
    let (_folder, path) = room();
    std::fs::write(&path, text).expect("written");
    read(&path)
}

#[test]
fn a_file_as_it_stands_under_version_control() {
    let (_folder, path) = room();
    write(&path, &small()).expect("written");
    assert_eq!(std::fs::read_to_string(&path).expect("there"), GOLDEN);
    assert_eq!(read(&path).expect("whole"), small());
}

proptest! {
    #[test]
    fn what_is_written_is_read_to_the_bit(record in record()) {
        let (_folder, path) = room();
        write(&path, &record).expect("written");
        let back = read(&path).expect("whole");
        // Debug tells -0.0 from 0.0.
        prop_assert_eq!(format!("{record:?}"), format!("{back:?}"));
        let bytes = std::fs::read(&path).expect("there");
        write(&path, &back).expect("written");
        prop_assert_eq!(bytes, std::fs::read(&path).expect("there"));
    }

    #[test]
    fn a_file_cut_short_is_refused(at in 0..GOLDEN.len() - 2) {
        let error = read_text(&GOLDEN[..at]).expect_err("cut short");
        assert!(matches!(error, RecordError::Damaged { .. }), "{error}");
    }

    #[test]
    fn no_byte_brings_it_down(at in 0..GOLDEN.len(), byte: u8) {
        let mut bytes = GOLDEN.as_bytes().to_vec();
        bytes[at] = byte;
        if let Err(error) = read_text(bytes) {
            assert!(error.to_string().contains("record.json"), "{error}");
        }
    }
}

#[test]
fn messages_name_file_place_expectation_and_remedy() {
    let message = |text: &str| {
        let message = read_text(text).expect_err("refused").to_string();
        message.split_once("record.json").expect("the file is named").1.to_owned()
    };
    assert_eq!(
        message(&GOLDEN.replacen("\"folds\": 9400", "\"folds\": \"many\"", 1)),
        ":25:21: invalid type: string \"many\", expected u64; expected a timing record of format 2: restore the file, or \
         record it again with `lunoid timing record`"
    );
    assert_eq!(
        message("{ \"format\": 3, \"frames\": 7 }"),
        ": format: found 3, expected at most 2; read it with the lunoid that wrote it, or record it again with \
         `lunoid timing record`"
    );
    assert_eq!(
        message("{ \"format\": 1, \"frames\": 7 }"),
        ": format: found 1, expected 2; record it again with `lunoid timing record`"
    );
    assert_eq!(
        message(&GOLDEN.replacen("\"count\": 3", "\"count\": 4", 1)),
        ": frame 12, deadlines.transfer, count: found 4, expected the sum of the bins; restore the file, or record it \
         again with `lunoid timing record`"
    );
    assert!(message("").starts_with(":1:0: EOF while parsing"), "{}", message(""));
}

/// Every key of the file, as the way down to it.
fn keys(value: &Value, way: &str) -> Vec<String> {
    let of = |(key, value): (String, &Value)| {
        let way = format!("{way}/{key}");
        let below = keys(value, &way);
        [vec![way], below].concat()
    };
    match value {
        Value::Object(map) => map.iter().flat_map(|(key, value)| of((key.clone(), value))).collect(),
        Value::Array(list) => list
            .iter()
            .enumerate()
            .flat_map(|(index, value)| keys(value, &format!("{way}/{index}")))
            .collect(),
        _ => Vec::new(),
    }
}

#[test]
fn every_key_is_needed_and_no_other_is_known() {
    let whole: Value = serde_json::from_str(GOLDEN).expect("JSON");
    let all = keys(&whole, "");
    assert!(all.len() > 60, "{all:?}");
    for way in all {
        let (parent, key) = way.rsplit_once('/').expect("a way down");
        if parent.ends_with("/deadlines") {
            continue;
        }
        let mut without = whole.clone();
        let object = without.pointer_mut(parent).and_then(Value::as_object_mut).expect("an object");
        let value = object.remove(key).expect("the key");
        let found = read_text(without.to_string());
        if way == "/before_mission" {
            // A machine that is ready at once has no such list.
            assert_eq!(found.expect("a record").before_mission, []);
        } else {
            let error = found.expect_err(&way).to_string();
            assert!(error.contains(&format!("missing field `{key}`")), "{way}: {error}");
        }

        let object = without.pointer_mut(parent).and_then(Value::as_object_mut).expect("an object");
        object.extend([(key.to_owned(), value), ("strange".to_owned(), Value::Null)]);
        let error = read_text(without.to_string()).expect_err(&way).to_string();
        assert!(error.contains("unknown field `strange`"), "{way}: {error}");
    }
}

#[test]
fn values_that_cannot_be_are_refused() {
    let whole: Value = serde_json::from_str(GOLDEN).expect("JSON");
    for (way, value, place) in [
        ("/inputs", json!("01 23"), "inputs"),
        ("/inputs", json!(""), "inputs"),
        ("/frames", json!([]), "frames"),
        ("/frames/1/frame", json!(12), "frames"),
        ("/frames/0/ticks", json!(0), "frame 12, ticks"),
        ("/frames/1/vertices/ready", json!(321), "frame 13, vertices.ready"),
        ("/frames/0/events_blake3", json!("12"), "frame 12, events_blake3"),
        ("/frames/0/deadlines/transfer/missed", json!(1), "frame 12, deadlines.transfer, missed"),
        ("/frames/0/deadlines/transfer/least", json!(-5), "frame 12, deadlines.transfer, least"),
        ("/frames/0/deadlines/transfer/least", json!(null), "frame 12, deadlines.transfer, least"),
        ("/frames/0/units/1/unit", json!("cpu"), "frame 12, units"),
        ("/frames/1/misses/1/words", json!(512), "frame 13, misses[1], words"),
    ] {
        let mut changed = whole.clone();
        *changed.pointer_mut(way).expect(way) = value;
        match read_text(changed.to_string()) {
            Err(RecordError::Faulty { fault, .. }) => assert_eq!(fault.place, place),
            other => panic!("{way}: {other:?}"),
        }
    }
    for bins in [[u64::MAX; 16], [1; 16]] {
        let mut changed = small();
        let slack = Slack { count: 15, missed: 8, least: Some(-2_000_000), bins };
        changed.frames[0].deadlines.values_mut().for_each(|found| *found = slack);
        assert!(changed.check().is_err());
    }
}

#[test]
fn what_is_not_finite_is_not_written() {
    let (_folder, path) = room();
    for (place, value) in [("due", f64::NAN), ("came", f64::INFINITY), ("range_m", f64::NEG_INFINITY)] {
        let mut changed = small();
        let missed = &mut changed.frames[1].misses[1];
        match place {
            "due" => missed.due = value,
            "came" => missed.came = Some(value),
            _ => missed.range_m = Some(value),
        }
        let expected = Fault {
            place: format!("frame 13, misses[1], {place}"),
            found: value.to_string(),
            expected: "a finite number".into(),
        };
        assert_eq!(changed.check(), Err(expected));
        assert!(matches!(write(&path, &changed), Err(RecordError::Faulty { .. })));
        assert!(!path.exists());
    }
    let overflow = GOLDEN.replacen("365.5", "1e999", 1);
    assert!(matches!(read_text(overflow), Err(RecordError::Damaged { .. })));
}

#[test]
fn a_file_that_is_not_there() {
    let (folder, path) = room();
    assert!(matches!(read(&path), Err(RecordError::File(files::FileError::Missing { .. }))));
    assert!(matches!(read(folder.path()), Err(RecordError::File(files::FileError::IsFolder { .. }))));
}

#[test]
fn a_generator_names_deadlines_of_its_own() {
    const POLYGONS: Deadline = Deadline::new("all-polygons");
    let (_folder, path) = room();
    let mut record = small();
    let slack = record.frames[0].deadlines[&Deadline::TRANSFER];
    record.frames[0].deadlines.insert(POLYGONS, slack);
    write(&path, &record).expect("written");
    let back = read(&path).expect("read");
    assert_eq!(back, record);
    let order: Vec<_> = back.frames[0].deadlines.keys().map(Deadline::word).collect();
    assert_eq!(order, ["transfer", "frame-tasks", "all-polygons"]);
    for name in ["", "All", "two words", "a-name-that-is-far-too-long"] {
        let refused = read_text(GOLDEN.replacen("\"frame-tasks\"", &format!("\"{name}\""), 1)).unwrap_err();
        assert!(refused.to_string().contains("expected a deadline: 1 to 24"), "{refused}");
    }
}
