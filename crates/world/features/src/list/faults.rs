//! What is wrong with a list, so far.

use std::ops::Range;
use std::sync::Arc;

use diagnostics::{CsvRow, LongList, Place, Problem, ProblemList, Problems, Source};

/// Faults of one file, each of a cell.
pub(super) struct Faults {
    source: Arc<Source>,
    list: LongList,
}

impl Faults {
    pub fn new(source: Arc<Source>) -> Self {
        Self { list: LongList::new(&source.name), source }
    }

    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Records a fault at the bytes `span`: what is wrong, and what was expected.
    pub fn push(&mut self, span: Range<usize>, title: String, expected: &str) {
        let found = self.source.text[span.clone()].trim_matches('"').to_owned();
        let place = Place { source: self.source.clone(), span };
        self.list.push(Problem::at(&place, title).found(found).expected(expected));
    }

    /// Whether every quote of a row ends in it; records a fault if not.
    pub fn expect_closed(&mut self, row: &CsvRow) -> bool {
        let open = row.open_quote();
        let is_closed = open.is_none();
        open.into_iter()
            .for_each(|quote| self.push(quote, "a quote that is not closed".into(), "a second quote"));
        is_closed
    }

    /// What was read, if nothing was wrong.
    pub fn finish<T>(self, read: T) -> Result<T, ProblemList> {
        let problems = Problems::new();
        let read = self.list.finish(read, &problems);
        problems.resolve(read)
    }
}
