use std::fs;
use std::path::{Path, PathBuf};

use merge::{MergeError, Timings, merge_timings};
use shard::{Shard, block_by_count};
use tempfile::tempdir;
use timing::TimingRecord;

/// A record of thirteen frames: the first of a baseline, thirteen times, each of another length.
fn record(name: &str) -> TimingRecord {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../tests/timing-baselines");
    let mut record = timing::read(folder.join(format!("{name}.json"))).expect("a baseline");
    let first = record.frames[0].clone();
    let frame =
        |number: u64| timing::FrameTiming { frame: number, ticks: first.ticks + number, ..first.clone() };
    record.frames = (0..13).map(frame).collect();
    record
}

/// The part of `record` with some of its frames, as a file.
fn part(record: &TimingRecord, frames: std::ops::Range<u64>, file: &Path) -> PathBuf {
    let kept = record.frames[frames.start as usize..frames.end as usize].to_vec();
    timing::write(file, &TimingRecord { frames: kept, ..record.clone() }).expect("written");
    file.to_owned()
}

fn shards(record: &TimingRecord, of: u32, at: &Path) -> Vec<PathBuf> {
    let file = |number: u32| {
        let block = block_by_count(Shard::new(number, of).unwrap(), &(0..13)).unwrap();
        part(record, block, &at.join(format!("{number}-of-{of}.json")))
    };
    (1..=of).map(file).collect()
}

#[test]
fn records_of_shards_join_to_the_record_of_one_machine() {
    let at = tempdir().unwrap();
    for name in ["first-light.pra-nominal", "craters.ideal", "lunsim-landing.lunsim"] {
        let record = record(name);
        let whole = part(&record, 0..13, &at.path().join("whole.json"));
        for of in [1, 2, 7, 13] {
            let mut files = shards(&record, of, at.path());
            files.reverse();
            files.push(part(&record, 5..8, &at.path().join("twice.json")));
            let Timings::Joined(joined) = merge_timings(&files, Some(&(0..13))).unwrap() else {
                panic!("gaps")
            };
            let out = at.path().join("joined.json");
            timing::write(&out, &joined).unwrap();
            assert!(fs::read(&whole).unwrap() == fs::read(&out).unwrap(), "{name} of {of}");
        }
    }
}

#[test]
fn gaps_other_records_and_disagreements_are_told() {
    let at = tempdir().unwrap();
    let record = record("craters.ideal");
    let mut files = shards(&record, 7, at.path());
    files.remove(3);
    files.remove(0);
    let gaps = |frames: Option<&std::ops::Range<u64>>| match merge_timings(&files, frames).unwrap() {
        Timings::Gaps(gaps) => gaps.into_iter().map(|gap| gap.frames).collect::<Vec<_>>(),
        Timings::Joined(_) => panic!("joined"),
    };
    assert_eq!(gaps(None), vec![5..7]);
    assert_eq!(gaps(Some(&(0..14))), vec![0..1, 5..7, 13..14]);
    assert!(matches!(merge_timings(&files, Some(&(3..13))), Err(MergeError::Outside { .. })));
    let other = TimingRecord { machine: "other".into(), ..record.clone() };
    let other = part(&other, 5..7, &at.path().join("other.json"));
    let said = merge_timings(&[files[0].clone(), other], None).unwrap_err().to_string();
    assert!(said.contains("machine (\"") && said.contains("other.json"), "{said}");
    let mut late = record.clone();
    late.frames[1].ticks += 7;
    let late = part(&late, 0..3, &at.path().join("late.json"));
    let said = merge_timings(&[files[0].clone(), late], None).unwrap_err().to_string();
    assert!(
        said.starts_with("frame 1: ") && said.contains("late.json have it differently, in ticks"),
        "{said}"
    );
}
