//! A TOML file with places.

use std::sync::Arc;

use toml_edit::Document;

use crate::place::{Place, Source};
use crate::problem::{Problem, ProblemList, Problems};
use crate::reader::Reader;
use crate::tree::{self, Node};

/// A parsed TOML file with the place of every value.
#[derive(Debug)]
pub struct TomlFile {
    source: Arc<Source>,
    pub(crate) root: Node,
}

impl TomlFile {
    /// Parses `text`; `name` is the path as the user gave it. A fault of syntax becomes a problem.
    pub fn parse(name: &str, text: &str, problems: &Problems) -> Option<Self> {
        let source = Arc::new(Source { name: name.into(), text: text.into() });
        match Document::parse(text) {
            Ok(document) => {
                let root = tree::root(&source, document.as_table());
                Some(Self { source, root })
            }
            Err(error) => {
                let place = Place { source, span: error.span().unwrap_or(0..0) };
                problems.push(Problem::at(&place, format!("not valid TOML: {}", error.message())));
                None
            }
        }
    }

    /// Reads the whole of `text`, which the program carries under `name`.
    ///
    /// # Errors
    /// Every fault of it.
    pub fn read_text<T>(
        name: &str,
        text: &str,
        read: impl FnOnce(&Reader) -> Option<T>,
    ) -> Result<T, ProblemList> {
        let problems = Problems::new();
        let file = Self::parse(name, text, &problems);
        let value = file.and_then(|file| read(&file.root(&problems)));
        problems.resolve(value)
    }

    /// The same as [`parse`](Self::parse) from bytes, which must be UTF-8.
    pub fn parse_bytes(name: &str, bytes: &[u8], problems: &Problems) -> Option<Self> {
        match std::str::from_utf8(bytes) {
            Ok(text) => Self::parse(name, text, problems),
            Err(error) => {
                let title = format!("not text: byte {} is not UTF-8", error.valid_up_to());
                problems.push(Problem::of_file(name, title).help("save the file as UTF-8"));
                None
            }
        }
    }

    /// The table under `key` as a file of its own, whose values keep their places. Nothing, and a problem, where it is no
    /// table.
    pub fn below(self, key: &str, problems: &Problems) -> Option<Self> {
        let Self { source, mut root } = self;
        root.take(key)
            .filter(|node| node.as_table().is_some())
            .map(|root| Self { source: source.clone(), root })
            .or_else(|| {
                let place = Place { source, span: 0..0 };
                problems.push(Problem::at(&place, format!("expected a key below `{key}`")));
                None
            })
    }

    /// The path as the user gave it, and the text.
    pub fn source(&self) -> &Arc<Source> {
        &self.source
    }

    /// A reader of the outermost table.
    pub fn root<'a>(&'a self, problems: &'a Problems) -> Reader<'a> {
        Reader::root(&self.root, problems)
    }
}
