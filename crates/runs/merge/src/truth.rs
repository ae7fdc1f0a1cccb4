//! Ground truth of all folders.

use replay::{JoinedTruth, TRUTH};
use run_record::{TruthFrame, TruthRecord};

use crate::MergeError;
use crate::frames::{Listed, apart, join_frames};
use crate::rows::poses_of_truth;
use crate::same::expect_same;
use crate::source::Source;

/// Name of the record of the truth, from its folder.
const RECORD: &str = "truth.json";

/// The truth of all `sources`; nothing if none has any.
pub(crate) fn join_truth<'a>(sources: &'a [Source]) -> Result<Option<JoinedTruth<'a>>, MergeError> {
    let path = |source: &Source| source.folder.join(TRUTH).join(RECORD);
    expect_same(sources.iter().filter_map(|source| Some((source.truth.as_ref()?, path(source)))))?;
    let Some(first) = sources.iter().find_map(|source| source.truth.as_ref()) else { return Ok(None) };
    let of = |source: &'a Source| {
        let frames = &source.truth.as_ref()?.frames[..];
        Some(Listed { frames, folder: &source.folder, record: path(source) })
    };
    let (frames, folders): (Vec<TruthFrame>, _) = apart(&join_frames(sources.iter().filter_map(of))?);
    let record = TruthRecord { frames, outputs: Vec::new(), ..first.clone() };
    let poses = poses_of_truth(sources)?.map(|(rows, document)| (rows.table(), document));
    Ok(Some(JoinedTruth { record, sources: folders, poses }))
}
