//! Faults of a long list, which may have one in every row.

use crate::problem::{Problem, Problems};

/// Faults that are told in full.
const TOLD: usize = 20;

/// Faults of one file: the first twenty as they are, the others by their number.
#[derive(Debug)]
pub struct LongList {
    file: String,
    told: Vec<Problem>,
    more: usize,
}

impl LongList {
    /// No fault yet of `file`, as the user named it.
    pub fn new(file: impl Into<String>) -> Self {
        Self { file: file.into(), told: Vec::new(), more: 0 }
    }

    /// Adds a fault; beyond the first few, faults are only counted.
    pub fn push(&mut self, problem: Problem) {
        if self.told.len() < TOLD {
            self.told.push(problem);
        } else {
            self.more += 1;
        }
    }

    /// True while nothing is wrong.
    pub fn is_empty(&self) -> bool {
        self.told.is_empty()
    }

    /// Hands them on; what was `read` if there are none.
    pub fn finish<T>(self, read: T, problems: &Problems) -> Option<T> {
        let is_empty = self.is_empty();
        self.told.into_iter().for_each(|problem| problems.push(problem));
        if self.more > 0 {
            let title = format!("{} more faults of this file are not listed", self.more);
            problems.push(Problem::of_file(self.file, title));
        }
        is_empty.then_some(read)
    }
}
