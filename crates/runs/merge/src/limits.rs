//! Stretches of frames beyond a limit of the vehicle, over the folders.

use run_record::LimitRecord;

/// Limits in the order of a record.
const ORDER: [&str; 3] = ["speed", "turn", "slope"];

/// The stretches of all `records`, joined where one touches or overlaps the next. Of the worst frames the one with the
/// larger value stays; of equal ones, the earlier.
pub(crate) fn join_limits<'a>(records: impl Iterator<Item = &'a LimitRecord>) -> Vec<LimitRecord> {
    let place = |record: &LimitRecord| ORDER.iter().position(|limit| *limit == record.limit);
    let mut all: Vec<LimitRecord> = records.cloned().collect();
    all.sort_by_key(|record| (place(record), record.frames));
    let mut joined: Vec<LimitRecord> = Vec::new();
    for record in all {
        match joined.last_mut() {
            Some(last) if last.limit == record.limit && record.frames[0] <= last.frames[1] => {
                last.frames[1] = last.frames[1].max(record.frames[1]);
                if record.found > last.found {
                    (last.found, last.frame, last.time_s) = (record.found, record.frame, record.time_s);
                }
            }
            _ => joined.push(record),
        }
    }
    joined
}
