//! One problem, the collector, and the list that a failed reading returns.

use std::cell::RefCell;
use std::fmt;
use std::sync::Arc;

use limits::Limit;

use crate::place::{Cursor, Place, Placed};
use crate::render::render;

/// One fault of one file: where, what was found, what was expected, what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The file, as the user named it.
    pub file: String,
    /// Place of the fault, where the file could be read.
    pub place: Option<Place>,
    /// Dotted key path, as `raster.sweeps`.
    pub key: Option<String>,
    /// One sentence that says all that is needed.
    pub title: String,
    /// What was found there, for people.
    pub found: Option<String>,
    /// What was expected, said so that "expected ..." can stand under the place.
    pub expected: Option<String>,
    /// Advice: what the user can do.
    pub help: Option<String>,
}

impl Problem {
    /// A problem at a place.
    pub fn at(place: &Place, title: impl Into<String>) -> Self {
        let file = place.source.name.clone();
        Self { place: Some(place.clone()), ..Self::of_file(file, title) }
    }

    /// A problem of a value that was read with its place.
    pub fn of<T>(value: &Placed<T>, title: impl Into<String>) -> Self {
        Self::at(&value.place, title).key(&value.key).found(value.place.text())
    }

    /// A problem of a whole file, for instance one that cannot be read.
    pub fn of_file(file: impl Into<String>, title: impl Into<String>) -> Self {
        let (file, title) = (file.into(), title.into());
        Self { file, place: None, key: None, title, found: None, expected: None, help: None }
    }

    /// Names the key by its dotted path.
    pub fn key(mut self, key: impl Into<String>) -> Self {
        self.key = Some(key.into());
        self
    }

    /// Says what was found.
    pub fn found(mut self, found: impl Into<String>) -> Self {
        self.found = Some(found.into());
        self
    }

    /// Says what was expected; the word "expected" is put before it.
    pub fn expected(mut self, expected: impl Into<String>) -> Self {
        self.expected = Some(expected.into());
        self
    }

    /// Says what to do.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The same as plain fields, for JSON.
    pub fn record(&self) -> ProblemRecord {
        self.record_at(self.place.as_ref().map(|place| place.source.line_and_column(place.span.start)))
    }

    fn record_at(&self, position: Option<(usize, usize)>) -> ProblemRecord {
        ProblemRecord {
            file: self.file.clone(),
            line: position.map(|(line, _)| line),
            column: position.map(|(_, column)| column),
            key: self.key.clone(),
            title: self.title.clone(),
            found: self.found.clone(),
            expected: self.expected.clone(),
            help: self.help.clone(),
        }
    }
}

/// A problem as plain fields, ready for JSON.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProblemRecord {
    /// The file, as the user named it.
    pub file: String,
    /// Line of the fault, from 1.
    pub line: Option<usize>,
    /// Column in characters, from 1.
    pub column: Option<usize>,
    /// Dotted path of the key, as `raster.sweeps`.
    pub key: Option<String>,
    /// One sentence that says what is wrong.
    pub title: String,
    /// What was found there, for people.
    pub found: Option<String>,
    /// What was expected there, for people.
    pub expected: Option<String>,
    /// Advice: what the user can do.
    pub help: Option<String>,
}

/// Collects problems, and notes about what was read otherwise than it may be meant. Readers share it by `&`, so tables can be
/// read side by side.
///
/// It keeps as many problems as [`Limit::Faults`] allows and counts the others, so that a file with a fault in every line takes no more
/// memory than its text.
#[derive(Debug, Default)]
pub struct Problems {
    list: RefCell<Vec<Problem>>,
    more: RefCell<usize>,
    notes: RefCell<Vec<String>>,
}

impl Problems {
    /// Makes a collector that holds no problem yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a problem to the list.
    pub fn push(&self, problem: Problem) {
        let mut list = self.list.borrow_mut();
        if Limit::Faults.allows(list.len() as u64 + 1) {
            list.push(problem);
        } else {
            *self.more.borrow_mut() += 1;
        }
    }

    /// Adds a sentence that the user should know although nothing is wrong.
    pub fn note(&self, note: String) {
        self.notes.borrow_mut().push(note);
    }

    /// Takes the notes so far, in the order in which they were made.
    pub fn take_notes(&self) -> Vec<String> {
        self.notes.take()
    }

    /// True while nothing is wrong.
    pub fn is_empty(&self) -> bool {
        self.list.borrow().is_empty()
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.list.borrow().len() + *self.more.borrow()
    }

    /// The list as an error when it is not empty: file by file in the order they were met, each from top
    /// to bottom, and what has no place behind it.
    pub fn into_result(self) -> Result<(), ProblemList> {
        let mut list = self.list.into_inner();
        if list.is_empty() {
            return Ok(());
        }
        let files: Vec<String> = list.iter().map(|problem| problem.file.clone()).collect();
        list.sort_by_cached_key(|problem| {
            let file = files.iter().position(|file| *file == problem.file);
            let start = problem.place.as_ref().map(|place| place.span.start);
            (file, start.is_none(), start)
        });
        let more = self.more.into_inner();
        if more > 0 {
            let file = list.last().map_or_else(String::new, |last| last.file.clone());
            let title = format!("{more} more faults are not listed");
            list.push(Problem::of_file(file, title).help(Limit::Faults.to_string()));
        }
        Err(ProblemList { list })
    }

    /// What was read, or the list of all problems.
    ///
    /// # Panics
    /// When a caller gives up (`None`) without having recorded why.
    pub fn resolve<T>(self, value: Option<T>) -> Result<T, ProblemList> {
        self.into_result()?;
        Ok(value.expect("whoever returns nothing has recorded a problem"))
    }
}

/// One or more problems; prints like a compiler's list of errors.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProblemList {
    list: Vec<Problem>,
}

impl ProblemList {
    /// All problems as text, with colour codes of the terminal or without.
    pub fn render(&self, colour: bool) -> String {
        render(&self.list, colour)
    }

    /// One after the other, in the order of the files.
    pub fn iter(&self) -> impl Iterator<Item = &Problem> {
        self.list.iter()
    }

    /// The same problems, each as `change` makes it; their order stays.
    pub fn map(self, change: impl FnMut(Problem) -> Problem) -> Self {
        Self { list: self.list.into_iter().map(change).collect() }
    }

    /// All problems as plain fields, for JSON; one walk through each file.
    pub fn records(&self) -> Vec<ProblemRecord> {
        let positions = positions(&self.list);
        let record = |(problem, at): (&Problem, Option<Cursor<'_>>)| {
            problem.record_at(at.map(|at| (at.line, at.column)))
        };
        self.list.iter().zip(positions).map(record).collect()
    }

    /// How many there are; never 0.
    #[expect(clippy::len_without_is_empty, reason = "an empty list is never an error")]
    pub fn len(&self) -> usize {
        self.list.len()
    }
}

/// Where each problem begins, where it has a place; linear in the files if each file's problems ascend.
pub(crate) fn positions(list: &[Problem]) -> Vec<Option<Cursor<'_>>> {
    let mut at: Option<(&Place, Cursor<'_>)> = None;
    let mut found = Vec::with_capacity(list.len());
    for problem in list {
        let Some(place) = &problem.place else {
            found.push(None);
            continue;
        };
        let before = at.filter(|(before, _)| Arc::ptr_eq(&before.source, &place.source));
        let cursor = before.map_or_else(|| Cursor::new(&place.source), |(_, cursor)| cursor);
        let cursor = cursor.to(place.span.start);
        at = Some((place, cursor));
        found.push(Some(cursor));
    }
    found
}

impl From<Problem> for ProblemList {
    fn from(problem: Problem) -> Self {
        Self { list: vec![problem] }
    }
}

impl fmt::Display for ProblemList {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.render(false).trim_end())
    }
}

impl std::error::Error for ProblemList {}
