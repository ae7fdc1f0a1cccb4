//! The ladders of a generator that tell what its levels of detail lose.

use front_door::Opened;
use generator::{ErrorLadder, Row};

use crate::Failure;

/// The row of the generator that the scenario names, which has levels of detail.
pub fn levelled(opened: &Opened) -> Result<&'static Row, Failure> {
    let has_levels = |row: &&Row| row.level_ladders().next().is_some();
    opened.row.filter(has_levels).ok_or_else(|| {
        let known: Vec<&str> =
            registry::ROWS.iter().copied().filter(has_levels).map(|row| row.name).collect();
        Failure::usage(format!(
            "{}, --machine {}: it has no levels of detail; expected a generator that has, by --machine: {}",
            opened.scenario_file(),
            opened.drawn_by(),
            known.join(", ")
        ))
    })
}

/// Those of its ladders that `only` names; all if it names none.
pub fn chosen(row: &Row, only: &[String]) -> Result<Vec<&'static ErrorLadder>, Failure> {
    let known: Vec<&str> = row.level_ladders().map(|ladder| ladder.name).collect();
    if let Some(unknown) = only.iter().find(|name| !known.contains(&name.as_str())) {
        let known = known.join(", ");
        return Err(Failure::usage(format!("--only {unknown}: no such ladder of levels; known: {known}")));
    }
    let is_chosen = |ladder: &&ErrorLadder| only.is_empty() || only.iter().any(|name| name == ladder.name);
    Ok(row.level_ladders().filter(is_chosen).collect())
}
