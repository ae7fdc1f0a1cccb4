//! What is wrong with a list, so far.

use std::ops::Range;
use std::sync::Arc;

use diagnostics::{Place, Problem, ProblemList, Problems, Source};

/// A long list with one fault in every row is reported by its first rows.
const LISTED: usize = 20;

/// Faults of one file: the first in full, the others by their number.
pub(super) struct Faults {
    source: Arc<Source>,
    listed: Vec<Problem>,
    unlisted: usize,
}

impl Faults {
    pub fn new(source: Arc<Source>) -> Self {
        Self { source, listed: Vec::new(), unlisted: 0 }
    }

    pub fn is_empty(&self) -> bool {
        self.listed.is_empty()
    }

    /// What stands in a cell, without quotes.
    pub fn text(&self, span: &Range<usize>) -> &str {
        self.source.text[span.clone()].trim_matches('"')
    }

    /// Records a fault.
    pub fn push(&mut self, span: Range<usize>, title: String, expected: &str) {
        if self.listed.len() == LISTED {
            self.unlisted += 1;
            return;
        }
        let found = self.text(&span).to_owned();
        let place = Place { source: self.source.clone(), span };
        self.listed.push(Problem::at(&place, title).found(found).expected(expected));
    }

    /// What was read, if nothing was wrong.
    pub fn finish<T>(self, read: T) -> Result<T, ProblemList> {
        let problems = Problems::new();
        self.listed.into_iter().for_each(|problem| problems.push(problem));
        if self.unlisted > 0 {
            let title = format!("{} more faults of this file are not listed", self.unlisted);
            problems.push(Problem::of_file(&self.source.name, title));
        }
        problems.into_result().map(|()| read)
    }
}
