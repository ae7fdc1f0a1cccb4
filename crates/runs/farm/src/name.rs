//! The name of a shard's folder.

use shard::Shard;

/// The run and the shard that the name of a folder says: `full-drive-shard-2-of-7` is shard 2/7 of `full-drive`.
pub(crate) fn named(folder: &str) -> Option<(&str, Shard)> {
    let (run, words) = match folder.rsplit_once("-shard-") {
        Some((run, words)) => (run, words),
        None => ("", folder.strip_prefix("shard-")?),
    };
    let (number, of) = words.split_once("-of-")?;
    let shard: Shard = format!("{number}/{of}").parse().ok()?;
    Some((run, shard))
}
