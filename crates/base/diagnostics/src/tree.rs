//! The values of a file as a tree in which every value knows its place.

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use toml_edit::{Item, TableLike, Value as TomlValue};

use crate::place::{Place, Source};

/// A value and its place.
#[derive(Debug)]
pub(crate) struct Node {
    pub place: Place,
    /// The key as written; the place itself where there is no key.
    pub key_place: Place,
    pub value: Value,
    /// The same key in lower layers.
    pub lower_keys: Vec<Place>,
}

#[derive(Debug)]
pub(crate) enum Value {
    Table(Table),
    Array(Vec<Node>),
    String(String),
    Integer(i64),
    Float(f64),
    Boolean(bool),
    Datetime,
}

/// A table and what readers have asked of it.
#[derive(Debug, Default)]
pub(crate) struct Table {
    pub entries: BTreeMap<String, Node>,
    pub asked: RefCell<BTreeSet<String>>,
    /// The reader could not make sense of the table, so its keys are not judged.
    pub unjudged: Cell<bool>,
    /// Its unknown keys have been reported.
    pub finished: Cell<bool>,
}

impl Node {
    pub fn without_key(place: Place, value: Value) -> Self {
        Self { key_place: place.clone(), place, value, lower_keys: Vec::new() }
    }

    pub fn as_table(&self) -> Option<&Table> {
        match &self.value {
            Value::Table(table) => Some(table),
            _ => None,
        }
    }

    /// The value under `key` of a table, taken out of it.
    pub fn take(&mut self, key: &str) -> Option<Self> {
        match &mut self.value {
            Value::Table(table) => table.entries.remove(key),
            _ => None,
        }
    }

    /// The value in words, for "not ..." at the end of a sentence.
    pub fn found(&self) -> String {
        match &self.value {
            Value::Table(_) => "a table".into(),
            Value::Array(_) => "an array".into(),
            Value::Datetime => "a date or time".into(),
            _ => shortened(self.place.text()),
        }
    }
}

fn shortened(text: &str) -> String {
    const LONGEST: usize = 40;
    let line = text.lines().next().unwrap_or_default();
    if line.chars().count() <= LONGEST && line.len() == text.len() {
        return line.into();
    }
    line.chars().take(LONGEST).chain("...".chars()).collect()
}

/// The tree of a parsed document.
pub(crate) fn root(source: &Arc<Source>, table: &dyn TableLike) -> Node {
    let place = Place { source: source.clone(), span: 0..0 };
    let value = Value::Table(read_table(&place, table));
    Node::without_key(place, value)
}

fn read_table(place: &Place, table: &dyn TableLike) -> Table {
    let keys = table.iter().filter(|(_, item)| !item.is_none());
    let entries = keys.map(|(key, item)| {
        let span = table.key(key).and_then(|key| key.span());
        let key_place = Place { span: span.unwrap_or(place.span.clone()), ..place.clone() };
        (key.to_owned(), read_item(&key_place, item))
    });
    Table { entries: entries.collect(), ..Table::default() }
}

fn read_item(key_place: &Place, item: &Item) -> Node {
    let place = Place { span: item.span().unwrap_or(key_place.span.clone()), ..key_place.clone() };
    let value = match item {
        Item::Value(value) => read_value(&place, value),
        Item::Table(table) => Value::Table(read_table(&place, table)),
        Item::ArrayOfTables(tables) => {
            Value::Array(tables.iter().map(|table| read_element(&place, table.span(), table)).collect())
        }
        Item::None => unreachable!("empty items are left out by read_table"),
    };
    Node { place, key_place: key_place.clone(), value, lower_keys: Vec::new() }
}

fn read_element(outer: &Place, span: Option<std::ops::Range<usize>>, table: &dyn TableLike) -> Node {
    let place = Place { span: span.unwrap_or(outer.span.clone()), ..outer.clone() };
    let value = Value::Table(read_table(&place, table));
    Node::without_key(place, value)
}

fn read_value(place: &Place, value: &TomlValue) -> Value {
    match value {
        TomlValue::String(text) => Value::String(text.value().clone()),
        TomlValue::Integer(number) => Value::Integer(*number.value()),
        TomlValue::Float(number) => Value::Float(*number.value()),
        TomlValue::Boolean(flag) => Value::Boolean(*flag.value()),
        TomlValue::Datetime(_) => Value::Datetime,
        TomlValue::InlineTable(table) => Value::Table(read_table(place, table)),
        TomlValue::Array(array) => Value::Array(
            array
                .iter()
                .map(|element| {
                    let span = element.span().unwrap_or(place.span.clone());
                    let place = Place { span, ..place.clone() };
                    let value = read_value(&place, element);
                    Node::without_key(place, value)
                })
                .collect(),
        ),
    }
}
