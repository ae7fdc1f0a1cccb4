//! A shard of a replay.

use std::ops::Range;

use replay::{Job, frame_costs};
use run_record::ShardRecord;
use shard::Shard;

use super::{DepthWord, Replay};
use command_line::Failure;
use command_line::loading::StageArgs;
use command_line::sharing::{block, by_cost};
use command_line::words::words;

/// What stands behind the name of the folder of one run.
pub fn of_one(channel: Option<&str>, shard: Option<Shard>) -> String {
    let channel = channel.map_or_else(String::new, |name| format!("-{name}"));
    let shard = shard.map(|shard| format!("-shard-{}-of-{}", shard.number(), shard.of()));
    channel + &shard.unwrap_or_default()
}

impl Replay {
    /// Frames of `shard` among those of `all`.
    pub(super) fn part(&self, shard: Shard, all: &Range<u64>) -> Result<Range<u64>, Failure> {
        // More shards than frames are refused before any file is read.
        let by_count = block(shard, all)?;
        let Some(folder) = &self.costs else { return Ok(by_count) };
        by_cost(shard, all, &frame_costs(folder, all)?)
    }

    /// The part of `job` that is `shard`, with these `frames`.
    pub(super) fn share<'a>(
        &self,
        shard: Shard,
        job: Job<'a>,
        frames: Range<u64>,
        stage: &StageArgs,
    ) -> Job<'a> {
        let record = ShardRecord {
            shard: shard.to_string(),
            by: if self.costs.is_some() { "cost" } else { "count" }.into(),
            of: [job.frames.start, job.frames.end],
            words: self.words_of_whole(stage),
        };
        Job { frames, shard: Some(record), ..job }
    }

    /// Words of the command that draws the whole run.
    fn words_of_whole(&self, stage: &StageArgs) -> Vec<String> {
        let depth = (self.depth == DepthWord::Sixteen).then(|| ["--depth", "16"].map(str::to_owned));
        let truth = self.truth_items().map(|items| ["--truth".to_owned(), items.to_string()]);
        let flags = [(self.refresh, "--refresh"), (self.apng, "--apng"), (self.no_page, "--no-page")];
        let flags = flags.into_iter().filter(|(is_given, _)| *is_given).map(|(_, word)| word.to_owned());
        let pairs = depth.into_iter().chain(truth).flatten();
        words(stage).into_iter().chain(pairs).chain(flags).collect()
    }
}
