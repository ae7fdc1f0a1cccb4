//! Whether records are of one run.

use std::path::PathBuf;

use run_record::differences_of;
use serde::Serialize;
use serde_json::Value;

use crate::MergeError;

/// Keys of a record of a run that depend on its frames.
const OF_FRAMES: [&str; 7] = ["frames", "range", "shard", "totals", "limits", "check", "outputs"];

/// End of the keys of fingerprints.
const FINGERPRINT: &str = "fingerprint";

/// Words behind the values of the first record and of the second.
const WORDS: [&str; 2] = ["in the first", "in the second"];

/// Refuses records that are not of one run. Each has its path.
pub(crate) fn expect_same<'a, R: Serialize + 'a>(
    mut records: impl Iterator<Item = (&'a R, PathBuf)>,
) -> Result<(), MergeError> {
    let Some((first, first_path)) = records.next() else { return Ok(()) };
    let first = without_frames(first);
    for (second, second_path) in records {
        if let Some(differences) = told([first.clone(), without_frames(second)]) {
            return Err(MergeError::OtherRun { first: first_path, second: second_path, differences });
        }
    }
    Ok(())
}

/// Every key of two documents that differs, in words. A fingerprint is a hash of other keys: it is told where no other key differs.
fn told(documents: [Value; 2]) -> Option<String> {
    let mut bare = documents.clone();
    bare.iter_mut().filter_map(Value::as_object_mut).for_each(|document| {
        document.retain(|key, _| !key.ends_with(FINGERPRINT));
    });
    let of = |[first, second]: &[Value; 2]| differences_of([first, second], WORDS);
    of(&bare).or_else(|| of(&documents))
}

/// Every key of two records that differs, in words.
pub(crate) fn differences(first: &impl Serialize, second: &impl Serialize) -> String {
    differences_of([&value(first), &value(second)], WORDS).unwrap_or_default()
}

fn without_frames(record: &impl Serialize) -> Value {
    let mut document = value(record);
    if let Some(keys) = document.as_object_mut() {
        keys.retain(|key, _| !OF_FRAMES.contains(&key.as_str()));
    }
    document
}

fn value(record: &impl Serialize) -> Value {
    serde_json::to_value(record).expect("records are plain values")
}
