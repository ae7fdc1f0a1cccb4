//! A file with differences to another: the later wins, and every value knows where it came from.

use std::mem;
use std::sync::Arc;

use crate::place::{Place, Source};
use crate::problem::Problems;
use crate::reader::Reader;
use crate::toml_file::TomlFile;
use crate::tree::{Node, Table, Value};

/// Several files read as one, from the base to the last overlay. Tables are merged key by key, arrays
/// (of tables too) are replaced whole.
///
/// ```
/// use diagnostics::{Layers, Problems, TomlFile};
/// let problems = Problems::new();
/// let base = TomlFile::parse("ideal.toml", "[loader]\nbanks = 4\naccess_ns = 0\n", &problems);
/// let mine = TomlFile::parse("mine.toml", "[loader]\naccess_ns = 950\n", &problems);
/// let layers = Layers::new([base, mine].into_iter().flatten());
/// let loader = layers.root(&problems).table("loader").expect("it is there");
/// assert_eq!(loader.f64("access_ns").required(), Some(950.0));
/// assert_eq!(loader.u64("banks").required(), Some(4));
/// let origin = layers.origin("loader.access_ns").expect("it is there");
/// assert_eq!((origin.file.as_str(), origin.line), ("mine.toml", 2));
/// assert_eq!(layers.origin("loader.banks").map(|origin| origin.to_string()), Some("ideal.toml:2".into()));
/// ```
#[derive(Debug)]
pub struct Layers {
    root: Node,
}

/// File and line of a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Origin {
    /// The file, as the user named it.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
    /// The value as written; the header of a table.
    pub text: String,
}

impl std::fmt::Display for Origin {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}:{}", self.file, self.line)
    }
}

impl Layers {
    /// Puts the files over one another, the base first. No file at all reads as an empty one.
    pub fn new(files: impl IntoIterator<Item = TomlFile>) -> Self {
        let mut roots = files.into_iter().map(|file| file.root);
        let base = roots.next().unwrap_or_else(empty_root);
        Self { root: roots.fold(base, lay_over) }
    }

    /// A reader of the merged outermost table.
    pub fn root<'a>(&'a self, problems: &'a Problems) -> Reader<'a> {
        Reader::root(&self.root, problems)
    }

    /// Where the value of a dotted key path came from. Elements of arrays have no path of their own.
    pub fn origin(&self, path: &str) -> Option<Origin> {
        let node = path.split('.').try_fold(&self.root, |node, key| node.as_table()?.entries.get(key))?;
        Some(origin_of(node))
    }

    /// Dotted path and origin of every value, in alphabetical order: the effective model.
    pub fn origins(&self) -> Vec<(String, Origin)> {
        let mut found = Vec::new();
        collect(&self.root, "", &mut found);
        found
    }
}

fn origin_of(node: &Node) -> Origin {
    let file = node.place.source.name.clone();
    Origin { file, line: node.place.line(), text: node.place.text().to_owned() }
}

fn collect(node: &Node, path: &str, found: &mut Vec<(String, Origin)>) {
    let Some(table) = node.as_table() else {
        found.push((path.to_owned(), origin_of(node)));
        return;
    };
    for (key, entry) in &table.entries {
        let dot = if path.is_empty() { "" } else { "." };
        collect(entry, &format!("{path}{dot}{key}"), found);
    }
}

fn empty_root() -> Node {
    let source = Arc::new(Source { name: String::new(), text: String::new() });
    let place = Place { source, span: 0..0 };
    Node::without_key(place, Value::Table(Table::default()))
}

fn lay_over(lower: Node, mut upper: Node) -> Node {
    upper.lower_keys = lower.lower_keys;
    upper.lower_keys.push(lower.key_place);

    if let (Value::Table(base), Value::Table(over)) = (lower.value, &mut upper.value) {
        merge(base, over);
    }
    upper
}

fn merge(base: Table, over: &mut Table) {
    over.asked.borrow_mut().extend(base.asked.into_inner());
    let mut entries = base.entries;
    for (key, upper) in mem::take(&mut over.entries) {
        let merged = match entries.remove(&key) {
            Some(lower) => lay_over(lower, upper),
            None => upper,
        };
        entries.insert(key, merged);
    }
    over.entries = entries;
}
