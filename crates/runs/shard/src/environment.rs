//! The shard of a worker that a cluster started.

use crate::{Shard, ShardError};

/// Variable that states the number of shards.
pub const SHARDS: &str = "LUNOID_SHARDS";

/// Number of a task in a Slurm array.
const TASK: &str = "SLURM_ARRAY_TASK_ID";
/// Smallest number of a task of the array.
const LEAST: &str = "SLURM_ARRAY_TASK_MIN";
/// Number of tasks of the array.
const COUNT: &str = "SLURM_ARRAY_TASK_COUNT";
/// Largest number of a task of the array.
const MOST: &str = "SLURM_ARRAY_TASK_MAX";
/// Number of a pod in an indexed Kubernetes job, from 0.
const INDEX: &str = "JOB_COMPLETION_INDEX";

/// The shard that the environment names. `get` returns the value of a variable; an empty value counts as none.
///
/// - A Slurm array with [`SHARDS`]: task K is shard K, whatever tasks the array has, so that a failed task can be run again alone.
/// - A Slurm array without it: the tasks must be 0..N-1 or 1..N, and are the shards in order.
/// - An indexed Kubernetes job, with [`SHARDS`]: index K is shard K + 1.
///
/// # Errors
/// If the environment is of no such job, or of both kinds, or a variable is missing or is no such number.
pub fn from_environment(get: impl Fn(&str) -> Option<String>) -> Result<Shard, ShardError> {
    let get = |name: &str| get(name).filter(|value| !value.is_empty());
    match (get(TASK).is_some(), get(INDEX).is_some()) {
        (false, false) => Err(ShardError::NoJob),
        (true, true) => Err(ShardError::TwoJobs),
        (true, false) if get(SHARDS).is_some() => stated(&get),
        (true, false) => whole_array(&get),
        (false, true) => indexed(&get),
    }
}

/// Task K of a Slurm array, where the number of shards is stated.
fn stated(get: &impl Fn(&str) -> Option<String>) -> Result<Shard, ShardError> {
    let (task, of) = (number(get, TASK, "1 to the number of shards")?, shards(get)?);
    Shard::new(task, of).ok_or_else(|| ShardError::Variable {
        name: TASK,
        found: task.to_string(),
        expected: format!("1 to {of}, because {SHARDS} is {of}"),
    })
}

/// A task of a Slurm array that has a task for every shard.
fn whole_array(get: &impl Fn(&str) -> Option<String>) -> Result<Shard, ShardError> {
    let (task, least) = (number(get, TASK, "the number of the task")?, number(get, LEAST, "the first task")?);
    let (count, most) = (number(get, COUNT, "the number of tasks")?, number(get, MOST, "the last task")?);
    let has_all = least <= 1 && u64::from(most) + 1 == u64::from(least) + u64::from(count);
    let shard = task.checked_sub(least).and_then(|before| Shard::new(before.checked_add(1)?, count));
    shard.filter(|_| has_all).ok_or_else(|| ShardError::Variable {
        name: TASK,
        found: task.to_string(),
        expected: format!(
            "an array of tasks 1-N or 0-(N-1), not {count} tasks from {least} to {most}; of another array state the number of \
             shards, as {SHARDS}=7"
        ),
    })
}

/// A pod of an indexed Kubernetes job.
fn indexed(get: &impl Fn(&str) -> Option<String>) -> Result<Shard, ShardError> {
    let (index, of) = (number(get, INDEX, "the index of the pod, from 0")?, shards(get)?);
    let shard = index.checked_add(1).and_then(|number| Shard::new(number, of));
    shard.ok_or_else(|| ShardError::Variable {
        name: INDEX,
        found: index.to_string(),
        expected: format!("0 to {}, because {SHARDS} is {of}", of - 1),
    })
}

/// The number of shards, as it is stated.
fn shards(get: &impl Fn(&str) -> Option<String>) -> Result<u32, ShardError> {
    let of = number(get, SHARDS, "the number of shards")?;
    let expected = || "a whole number from 1 on".to_owned();
    if of == 0 {
        return Err(ShardError::Variable { name: SHARDS, found: "0".into(), expected: expected() });
    }
    Ok(of)
}

fn number(
    get: &impl Fn(&str) -> Option<String>,
    name: &'static str,
    meaning: &'static str,
) -> Result<u32, ShardError> {
    let found = get(name).ok_or(ShardError::Missing { name, meaning })?;
    let expected = || format!("{meaning}, a whole number");
    found.parse().map_err(|_| ShardError::Variable { name, found: found.clone(), expected: expected() })
}
