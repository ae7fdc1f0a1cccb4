//! One error for several: all faults of files at once.

use std::collections::HashSet;

use diagnostics::{Problem, Problems};

use crate::OpenError;

/// One error for `first` and `others`. Lists of problems come together, each problem once; where the first is no list it is told alone.
pub(crate) fn together(first: OpenError, others: impl IntoIterator<Item = OpenError>) -> OpenError {
    let OpenError::Problems(list) = &first else { return first };
    let others = others.into_iter().filter_map(|other| match other {
        OpenError::Problems(list) => Some(list),
        _ => None,
    });
    let mut known: HashSet<String> = list.iter().map(identity).collect();
    let mut new: Vec<Problem> = others.flat_map(|list| list.iter().cloned().collect::<Vec<_>>()).collect();
    new.retain(|problem| known.insert(identity(problem)));
    // A list that has reached its limit has counted what it does not hold, and counts that once.
    if new.is_empty() {
        return first;
    }
    let problems = Problems::new();
    list.iter().cloned().chain(new).for_each(|problem| problems.push(problem));
    problems.into_result().map_or_else(OpenError::Problems, |()| first)
}

/// Two problems are one if they say the same of the same place.
fn identity(problem: &Problem) -> String {
    let start = problem.place.as_ref().map(|place| place.span.start);
    format!("{}\n{start:?}\n{}", problem.file, problem.title)
}
