//! The ladders of a generator that tell what its levels of detail lose.

use generator::{ErrorLadder, Row};

use command_line::Failure;

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
