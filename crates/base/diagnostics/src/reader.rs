//! Reading one table, strictly.

use std::fs;
use std::path::{Path, PathBuf};

use crate::asked::{Shape, ShapeKind, note};
use crate::field::Field;
use crate::place::{Place, Placed};
use crate::problem::{Problem, Problems};
use crate::tree::{Node, Table, Value};

/// Reads the keys of one table. Asking for a key makes it a known key; [`Reader::finish`] reports the rest.
#[derive(Clone, Debug)]
pub struct Reader<'a> {
    table: Option<&'a Table>,
    place: Place,
    path: String,
    problems: &'a Problems,
}

/// A part that is either a word (`dac = "ideal"`) or a table of its figures (`[dac]`).
#[derive(Clone, Debug)]
pub enum PartTable<'a> {
    /// The word stands there.
    Word,
    /// A table stands there.
    Table(Reader<'a>),
}

impl<'a> Reader<'a> {
    pub(crate) fn root(node: &'a Node, problems: &'a Problems) -> Self {
        Self { table: node.as_table(), place: node.place.clone(), path: String::new(), problems }
    }

    fn of_node(node: &'a Node, path: String, problems: &'a Problems) -> Self {
        Self { table: node.as_table(), place: node.place.clone(), path, problems }
    }

    /// Dotted path of a key of this table.
    pub fn path(&self, key: &str) -> String {
        let key = if is_bare(key) { key.to_owned() } else { format!("{key:?}") };
        if self.path.is_empty() { key } else { format!("{}.{key}", self.path) }
    }

    /// Place of the value of `key`, or of this table where the key is missing.
    pub fn place(&self, key: &str) -> Place {
        self.table.and_then(|table| table.entries.get(key)).map_or(&self.place, |node| &node.place).clone()
    }

    /// Place of this table's header.
    pub fn table_place(&self) -> &Place {
        &self.place
    }

    /// True when the key stands in the table.
    pub fn has(&self, key: &str) -> bool {
        self.table.is_some_and(|table| table.entries.contains_key(key))
    }

    /// Names of all keys that stand in the table, sorted: for tables whose keys are names the user chose.
    pub fn keys(&self) -> Vec<&'a str> {
        note(&self.path, false, || Shape::of(ShapeKind::OpenTable));
        self.table.map_or(Vec::new(), |table| table.entries.keys().map(String::as_str).collect())
    }

    /// Starts a problem that points at the value of `key`, or at the table where the key is missing.
    pub fn problem(&self, key: &str, title: impl Into<String>) -> Problem {
        Problem::at(&self.place(key), title).key(self.path(key))
    }

    /// Adds a problem to those of the file.
    pub fn report(&self, problem: Problem) {
        self.problems.push(problem);
    }

    /// Makes a key known that is not read here: a message about an unknown key then names it.
    pub fn know(&self, key: &str) {
        self.node(key);
    }

    /// The value itself, marked as asked for.
    fn node(&self, key: &str) -> Option<&'a Node> {
        let table = self.table?;
        table.asked.borrow_mut().insert(key.to_owned());
        table.entries.get(key)
    }

    pub(crate) fn field<T: 'a>(
        &self,
        key: &str,
        (expected, kind): (impl Into<String>, ShapeKind),
        convert: impl Fn(&Node) -> Result<T, crate::field::Fault> + 'a,
    ) -> Field<'a, T> {
        let at = Placed { value: self.node(key), place: self.place(key), key: self.path(key) };
        Field::new(at, self.problems, (expected.into(), kind), Box::new(convert))
    }

    /// The table under `key`, which must be there.
    pub fn table(&self, key: &str) -> Option<Reader<'a>> {
        let found = self.table_there(key, true);
        if !self.has(key) {
            let title = format!("missing table `{}`", self.path(key));
            self.report(self.problem(key, title).expected(format!("a table [{}]", self.path(key))));
        }
        found
    }

    /// The table under `key`, or nothing where it is missing.
    pub fn optional_table(&self, key: &str) -> Option<Reader<'a>> {
        self.table_there(key, false)
    }

    fn table_there(&self, key: &str, is_required: bool) -> Option<Reader<'a>> {
        note(&self.path(key), is_required, || Shape::of(ShapeKind::Table));
        let node = self.node(key)?;
        self.reader_of(node, self.path(key))
    }

    /// The table under `key`, or one without any key where it is missing: all its defaults then hold.
    pub fn table_or_empty(&self, key: &str) -> Reader<'a> {
        let empty = || Reader { table: None, place: self.place(key), path: self.path(key), ..*self };
        self.optional_table(key).unwrap_or_else(empty)
    }

    /// The tables of an array: `[[loader.delay]]`, or `delay = [{...}, {...}]`. Missing means none.
    pub fn tables(&self, key: &str) -> Vec<Reader<'a>> {
        note(&self.path(key), false, || Shape::of(ShapeKind::Tables));
        let Some(node) = self.node(key) else { return Vec::new() };
        let path = self.path(key);
        let Value::Array(elements) = &node.value else {
            self.report_type(node, &path, "an array of tables");
            return Vec::new();
        };
        let numbered = elements.iter().enumerate();
        numbered.filter_map(|(index, element)| self.reader_of(element, format!("{path}[{index}]"))).collect()
    }

    /// A part: the word (such as `"ideal"`) or a table. Nothing where the key is missing or is neither.
    pub fn table_or_word(&self, key: &str, word: &str) -> Option<PartTable<'a>> {
        note(&self.path(key), false, || Shape {
            or_words: vec![word.to_owned()],
            ..Shape::of(ShapeKind::Table)
        });
        let node = self.node(key)?;
        match &node.value {
            Value::Table(_) => self.reader_of(node, self.path(key)).map(PartTable::Table),
            Value::String(text) if text == word => Some(PartTable::Word),
            _ => {
                self.report_type(node, &self.path(key), &format!("a table, or the word {word:?}"));
                None
            }
        }
    }

    fn reader_of(&self, node: &'a Node, path: String) -> Option<Reader<'a>> {
        if node.as_table().is_none() {
            self.report_type(node, &path, "a table");
            return None;
        }
        Some(Reader::of_node(node, path, self.problems))
    }

    fn report_type(&self, node: &Node, path: &str, expected: &str) {
        let found = node.found();
        let title = format!("`{path}` must be {expected}, not {found}");
        self.report(Problem::at(&node.place, title).key(path).found(found).expected(expected));
    }

    /// Checks `format = N`; false when the file is of another format, whose keys it is no use to judge.
    pub fn format_version(&self, expected: u64) -> bool {
        let help_missing = format!("write `format = {expected}` above all tables");
        let field = self.u64("format").help(help_missing).only_noted(expected);
        let Some(found) = field.required() else { return false };
        let (what, help) = match found.cmp(&expected) {
            std::cmp::Ordering::Equal => return true,
            std::cmp::Ordering::Greater => ("newer than", "a newer version of the program reads this file"),
            std::cmp::Ordering::Less => ("older than", "this version no longer reads it: write it anew"),
        };
        let title = format!("format {found} is {what} the format {expected} that this program reads");
        let problem = self.problem("format", title).found(found.to_string());
        self.report(problem.expected(format!("format {expected}")).help(help));
        false
    }

    /// Leaves the keys of this table unjudged: for a table of a kind that is not known.
    pub fn ignore_rest(&self) {
        note(&self.path, false, || Shape::of(ShapeKind::OpenTable));
        if let Some(table) = self.table {
            table.unjudged.set(true);
        }
    }

    /// Reports every key that nobody asked for, here and in all tables below, with the nearest known key.
    /// One call on the root is enough, after everything has been read.
    pub fn finish(&self) {
        let Some(table) = self.table else { return };
        if table.unjudged.get() || table.finished.replace(true) {
            return;
        }
        for (key, node) in &table.entries {
            if table.asked.borrow().contains(key) {
                self.finish_below(node, self.path(key));
            } else {
                self.report_unknown(key, node, table);
            }
        }
    }

    fn finish_below(&self, node: &'a Node, path: String) {
        match &node.value {
            Value::Table(_) => Reader::of_node(node, path, self.problems).finish(),
            Value::Array(elements) => {
                for (index, element) in elements.iter().enumerate() {
                    Reader::of_node(element, format!("{path}[{index}]"), self.problems).finish();
                }
            }
            _ => {}
        }
    }

    fn report_unknown(&self, key: &str, node: &Node, table: &Table) {
        let asked = table.asked.borrow();
        let known: Vec<&str> = asked.iter().map(String::as_str).collect();
        let help = nearest(key, &known).map(|nearest| format!("did you mean `{nearest}`?"));
        for place in node.lower_keys.iter().chain([&node.key_place]) {
            let problem = Problem::at(place, format!("unknown key `{}`", self.path(key)))
                .key(self.path(key))
                .found(key)
                .expected(list_of_keys(&known));
            self.report(Problem { help: help.clone(), ..problem });
        }
    }
}

fn is_bare(key: &str) -> bool {
    !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-')
}

fn list_of_keys(known: &[&str]) -> String {
    match known {
        [] => "no key in this table".into(),
        [only] => format!("only {only}"),
        _ => format!("one of {}", known.join(", ")),
    }
}

/// The likeness from which clap, too, offers a suggestion.
const ALIKE: f64 = 0.7;

fn is_alike(word: &str, known: &str) -> bool {
    strsim::jaro(word, known) > ALIKE
}

/// The known word most like `word`, where one is alike at all.
pub fn nearest<'k>(word: &str, known: &[&'k str]) -> Option<&'k str> {
    let alike = known.iter().filter(|known| is_alike(word, known));
    let scored = alike.map(|known| (strsim::jaro(word, known), *known));
    scored.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, known)| known)
}

/// The file beside a path that nobody finds whose name is most like it, if one is alike at all. Endings count only where the names are alike
/// without them.
pub fn similar_file(path: &Path) -> Option<PathBuf> {
    let folder = path.parent()?;
    let listed = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let entries = fs::read_dir(listed).ok()?.filter_map(Result::ok);
    let mut names: Vec<String> = entries.filter_map(|entry| entry.file_name().into_string().ok()).collect();
    names.sort();
    let stem = |name: &str| name.split('.').next().unwrap_or_default().to_owned();
    let wanted = path.file_name()?.to_str()?;
    let known: Vec<&str> =
        names.iter().map(String::as_str).filter(|name| is_alike(&stem(wanted), &stem(name))).collect();
    nearest(wanted, &known).map(|name| folder.join(name))
}
