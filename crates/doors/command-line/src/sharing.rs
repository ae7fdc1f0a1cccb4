//! `--shard`: the part of a run that one worker does.

use std::env;
use std::ops::Range;

use clap::Args;
use shard::{Shard, ShardError, block_by_cost, block_by_count, from_environment};

use crate::Failure;

/// Options that choose a shard.
#[derive(Debug, Default, Clone, Args)]
pub struct Sharing {
    /// Do shard K of N alone, numbered from 1; `auto` takes K and N from a Slurm array or an indexed Kubernetes job.
    /// docs/shards.md says what is shared out, and what `lunoid merge` joins.
    #[arg(long, value_name = "K/N|auto", value_parser = asked)]
    pub shard: Option<Asked>,
}

/// Which shard is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Asked {
    /// The one that the environment names.
    Auto,
    /// The part of this worker.
    Named(Shard),
}

fn asked(text: &str) -> Result<Asked, ShardError> {
    if text == "auto" { Ok(Asked::Auto) } else { text.parse().map(Asked::Named) }
}

impl Sharing {
    /// The shard that is asked for.
    ///
    /// # Errors
    /// If the environment names none.
    pub fn asked(&self) -> Result<Option<Shard>, Failure> {
        match self.shard {
            None => Ok(None),
            Some(Asked::Named(shard)) => Ok(Some(shard)),
            Some(Asked::Auto) => {
                let get = |name: &str| env::var_os(name).map(|value| value.to_string_lossy().into_owned());
                from_environment(get)
                    .map(Some)
                    .map_err(|error| Failure::usage(format!("--shard auto: {error}")))
            }
        }
    }
}

/// The frames of `shard` among `all`.
///
/// # Errors
/// If there are more shards than frames.
pub fn block(shard: Shard, all: &Range<u64>) -> Result<Range<u64>, Failure> {
    block_by_count(shard, all).map_err(refused)
}

/// The frames of `shard` among `all`, by the `costs` of all.
///
/// # Errors
/// If there are more shards than frames.
pub fn by_cost(shard: Shard, all: &Range<u64>, costs: &[u64]) -> Result<Range<u64>, Failure> {
    block_by_cost(shard, all, costs).map_err(refused)
}

/// What `shard` has of `all` numbers of entries; `what` are the entries, as a word.
///
/// # Errors
/// If there are more shards than entries.
pub fn numbers(shard: Shard, all: &Range<u64>, what: &str) -> Result<Range<u64>, Failure> {
    block_by_count(shard, all).map_err(|_| {
        let found = all.end - all.start;
        Failure::usage(format!(
            "--shard {shard}: there are {found} {what}, expected at most as many shards; give fewer shards"
        ))
    })
}

fn refused(error: ShardError) -> Failure {
    Failure::usage(format!("--{error}"))
}

/// What `shard` has of `all`, in order, if one is asked for. `what` are the entries, as a word.
///
/// # Errors
/// If there are more shards than entries.
pub fn part<T>(shard: Option<Shard>, all: Vec<T>, what: &str) -> Result<Vec<T>, Failure> {
    let Some(shard) = shard else { return Ok(all) };
    let Range { start, end } = numbers(shard, &(0..all.len() as u64), what)?;
    Ok(all.into_iter().skip(start as usize).take((end - start) as usize).collect())
}
