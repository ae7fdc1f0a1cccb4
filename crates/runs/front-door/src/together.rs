//! One error for several: all faults of files at once.

use diagnostics::{Problem, Problems};

use crate::OpenError;

/// One error for `first` and `others`. Lists of problems come together, each problem once; where the first is no list it is told alone.
pub(crate) fn together(first: OpenError, others: impl IntoIterator<Item = OpenError>) -> OpenError {
    let OpenError::Problems(list) = &first else { return first };
    let mut all: Vec<Problem> = list.iter().cloned().collect();
    for other in others {
        let OpenError::Problems(list) = other else { continue };
        let new: Vec<Problem> = list.iter().filter(|problem| !all.contains(problem)).cloned().collect();
        all.extend(new);
    }
    let problems = Problems::new();
    all.into_iter().for_each(|problem| problems.push(problem));
    problems.into_result().map_or_else(OpenError::Problems, |()| first)
}
