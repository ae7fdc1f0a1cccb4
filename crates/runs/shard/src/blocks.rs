//! The frames of a shard.

use std::ops::Range;

use crate::{Shard, ShardError};

/// Frames of `shard` among those of `all`, in blocks of equal count.
///
/// # Errors
/// If there are more shards than frames.
pub fn block_by_count(shard: Shard, all: &Range<u64>) -> Result<Range<u64>, ShardError> {
    let frames = expect_enough(shard, all)?;
    let cut =
        |shards: u32| all.start + (u128::from(shards) * u128::from(frames) / u128::from(shard.of())) as u64;
    Ok(cut(shard.number() - 1)..cut(shard.number()))
}

/// Frames of `shard` among those of `all`, in blocks of equal cost. `cost` has the cost of each frame of `all`, in any unit.
///
/// # Errors
/// If there are more shards than frames.
///
/// # Panics
/// If `cost` has another length than `all`.
pub fn block_by_cost(shard: Shard, all: &Range<u64>, cost: &[u64]) -> Result<Range<u64>, ShardError> {
    let frames = expect_enough(shard, all)?;
    assert_eq!(cost.len() as u64, frames, "a cost for each frame");
    let before = sums(cost);
    let cut = |shards: u32| all.start + cut(&before, shards, shard.of());
    Ok(cut(shard.number() - 1)..cut(shard.number()))
}

fn expect_enough(shard: Shard, all: &Range<u64>) -> Result<u64, ShardError> {
    let frames = all.end.saturating_sub(all.start);
    if u64::from(shard.of()) > frames { Err(ShardError::TooMany { shard, frames }) } else { Ok(frames) }
}

/// Costs before each frame, and of all. A frame costs at least 1.
fn sums(cost: &[u64]) -> Vec<u128> {
    let added = cost.iter().scan(0, |sum: &mut u128, cost| {
        *sum += u128::from(*cost).max(1);
        Some(*sum)
    });
    [0].into_iter().chain(added).collect()
}

/// Frames before the cut behind `shards` shards of `of`. Each shard has at least one frame.
fn cut(before: &[u128], shards: u32, of: u32) -> u64 {
    let frames = before.len() as u64 - 1;
    (1..=shards).fold(0, |last, shards| {
        let most = frames - u64::from(of - shards);
        nearest(before, shards, of).clamp(last + 1, most)
    })
}

/// The number of frames whose costs come nearest to `shards` / `of` of all costs; of two as near, the smaller.
fn nearest(before: &[u128], shards: u32, of: u32) -> u64 {
    let total = before.last().copied().unwrap_or_default();
    // Sums are compared as multiples of 1 / `of`, which are whole.
    let aim = u128::from(shards) * total;
    let distance = |at: usize| (before[at] * u128::from(of)).abs_diff(aim);
    let above = before.partition_point(|sum| sum * u128::from(of) < aim);
    let nearest = if above > 0 && distance(above - 1) <= distance(above) { above - 1 } else { above };
    nearest as u64
}
