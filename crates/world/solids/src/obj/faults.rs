//! The faults of one text, each with its place.

use std::ops::Range;
use std::sync::Arc;

use diagnostics::{LongList, Place, Problem, ProblemList, Problems, Source};

/// What is wrong with a text.
pub(super) struct Faults {
    source: Arc<Source>,
    list: LongList,
}

impl Faults {
    /// Makes an empty list of faults for the text `source`.
    pub fn new(source: Arc<Source>) -> Self {
        let list = LongList::new(source.name.clone());
        Self { source, list }
    }

    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    pub fn push(&mut self, problem: Problem) {
        self.list.push(problem);
    }

    /// Adds what is wrong at `span` (bytes of the text).
    pub fn add(&mut self, span: &Range<usize>, title: String, expected: &str) {
        let problem = self.problem(span, title, expected);
        self.push(problem);
    }

    /// What is wrong at `span`, not added yet.
    pub fn problem(&self, span: &Range<usize>, title: String, expected: &str) -> Problem {
        let found = self.source.text[span.clone()].to_owned();
        Problem::at(&self.place(span), title).found(found).expected(expected)
    }

    /// The line of a place, from 1.
    pub fn line(&self, span: &Range<usize>) -> usize {
        self.place(span).line()
    }

    fn place(&self, span: &Range<usize>) -> Place {
        Place { source: self.source.clone(), span: span.clone() }
    }

    /// `read` if nothing is wrong.
    ///
    /// # Errors
    /// Every fault.
    pub fn resolve<T>(self, read: T) -> Result<T, ProblemList> {
        let problems = Problems::new();
        let read = self.list.finish(read, &problems);
        problems.resolve(read)
    }
}
