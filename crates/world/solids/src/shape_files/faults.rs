//! The faults of one file, each with its place.

use std::sync::Arc;

use diagnostics::{LongList, Place, Problem, ProblemList, Problems, Source};

use super::mesh::At;

/// Faults whose place is looked up; further ones are only counted.
const PLACED: usize = 20;

/// How places of a file are told.
enum Form {
    /// By line of the text.
    Text(Arc<Source>),
    /// By the number of the face, as the format calls it.
    Numbered { name: String, face: &'static str },
}

/// What is wrong with a file.
pub(super) struct Faults {
    form: Form,
    list: LongList,
    count: usize,
}

impl Faults {
    /// No fault yet of a text.
    pub fn of_text(source: Arc<Source>) -> Self {
        let list = LongList::new(source.name.clone());
        Self { form: Form::Text(source), list, count: 0 }
    }

    /// No fault yet of a file whose places are numbers of faces; `face` is the format's word for one.
    pub fn of_numbers(name: &str, face: &'static str) -> Self {
        Self { form: Form::Numbered { name: name.into(), face }, list: LongList::new(name), count: 0 }
    }

    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    pub fn push(&mut self, problem: Problem) {
        self.count += 1;
        self.list.push(problem);
    }

    /// Adds what is wrong at a place.
    pub fn add(&mut self, at: &At, title: String, expected: &str) {
        let problem = self.problem(at, title, expected);
        self.push(problem);
    }

    /// What is wrong at a place, not added yet.
    pub fn problem(&self, at: &At, title: String, expected: &str) -> Problem {
        let problem = match &self.form {
            Form::Text(source) if self.count < PLACED => {
                let found = source.text[at.clone()].to_owned();
                Problem::at(&Place { source: source.clone(), span: at.clone() }, title).found(found)
            }
            Form::Text(source) => Problem::of_file(&source.name, title),
            Form::Numbered { name, face } => Problem::of_file(name, format!("{face} {}: {title}", at.start)),
        };
        problem.expected(expected)
    }

    /// The place of a face in a text; other files have none.
    pub fn place(&self, at: &At) -> Option<Place> {
        match &self.form {
            Form::Text(source) => Some(Place { source: source.clone(), span: at.clone() }),
            Form::Numbered { .. } => None,
        }
    }

    /// What is wrong with the whole file.
    pub fn of_file(&self, title: impl Into<String>) -> Problem {
        let name = match &self.form {
            Form::Text(source) => &source.name,
            Form::Numbered { name, .. } => name,
        };
        Problem::of_file(name, title)
    }

    /// The words for a vertex with this index.
    pub fn vertex(&self, index: usize, at: &At) -> String {
        match &self.form {
            Form::Text(source) if self.count < PLACED => {
                let line = Place { source: source.clone(), span: at.clone() }.line();
                format!("vertex {} (line {line})", index + 1)
            }
            _ => format!("vertex {}", index + 1),
        }
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
