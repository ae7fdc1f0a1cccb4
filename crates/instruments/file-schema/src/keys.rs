//! What readings asked for, key by key.

use std::collections::{BTreeMap, BTreeSet};

use diagnostics::asked::{Asked, Shape, ShapeKind};

/// A table of one reading: number of the reading, path of the table.
type Instance = (usize, String);

/// Keys of a format, merged over many readings.
#[derive(Debug, Clone, Default)]
pub struct Keys {
    /// By path, with `[]` for an element of an array.
    pub(crate) keys: BTreeMap<String, Key>,
    /// Tables that were read, by path.
    tables: BTreeMap<String, BTreeSet<Instance>>,
    readings: usize,
}

/// One key of a format.
#[derive(Debug, Clone, Default)]
pub(crate) struct Key {
    /// What may stand there: one shape for each type.
    pub shapes: Vec<Shape>,
    /// Tables that must have it.
    required_in: BTreeSet<Instance>,
}

impl Keys {
    /// Adds what one reading asked for, in any order.
    pub fn add(&mut self, asked: &[Asked]) {
        self.readings += 1;
        for Asked { path, shape, is_required } in asked {
            let table = path.rsplit_once('.').map_or("", |(table, _)| table);
            let instance = (self.readings, table.to_owned());
            self.tables.entry(without_indices(table)).or_default().insert(instance.clone());
            let key = self.keys.entry(without_indices(path)).or_default();
            add_shape(&mut key.shapes, shape);
            if *is_required {
                key.required_in.insert(instance);
            }
        }
    }

    /// Whether every table of its kind must have the key.
    pub(crate) fn is_required(&self, path: &str) -> bool {
        let table = path.rsplit_once('.').map_or("", |(table, _)| table);
        let Some(key) = self.keys.get(path) else { return false };
        self.tables.get(table).is_some_and(|tables| *tables == key.required_in)
    }

    /// Paths of all keys, ascending.
    pub fn paths(&self) -> impl Iterator<Item = &str> {
        self.keys.keys().map(String::as_str).filter(|path| !path.is_empty())
    }

    /// Paths of the keys of a table.
    pub(crate) fn below<'a>(&'a self, table: &'a str) -> impl Iterator<Item = &'a str> {
        let prefix = if table.is_empty() { String::new() } else { format!("{table}.") };
        self.paths().filter(move |path| {
            path.strip_prefix(&prefix)
                .is_some_and(|key| !key.is_empty() && !key.contains('.') && !key.ends_with(']'))
        })
    }
}

/// Widens the shape of the same type, or adds one more.
fn add_shape(shapes: &mut Vec<Shape>, shape: &Shape) {
    let Some(known) = shapes.iter_mut().find(|known| is_alike(&known.kind, &shape.kind)) else {
        shapes.push(shape.clone());
        return;
    };
    let wider = |known: Option<(f64, bool)>, other: Option<(f64, bool)>, is_beyond: fn(f64, f64) -> bool| {
        let ((a, a_in), (b, b_in)) = known.zip(other)?;
        if a == b {
            Some((a, a_in || b_in))
        } else {
            Some(if is_beyond(a, b) { (a, a_in) } else { (b, b_in) })
        }
    };
    known.low = wider(known.low, shape.low, |a, b| a < b);
    known.high = wider(known.high, shape.high, |a, b| a > b);
    if let (ShapeKind::Words(all), ShapeKind::Words(more)) = (&mut known.kind, &shape.kind) {
        add_new(all, more);
    }
    if known.kind == ShapeKind::OpenTable {
        known.kind = shape.kind.clone();
    }
    add_new(&mut known.or_words, &shape.or_words);
    // A rule holds everywhere or is none of the schema.
    known.rules.retain(|rule| shape.rules.contains(rule));
}

fn add_new(all: &mut Vec<String>, more: &[String]) {
    all.extend(more.iter().filter(|word| !all.contains(word)).cloned().collect::<Vec<_>>());
}

/// Whether two shapes are of one type. Of a table whose keys somebody knows, these keys count.
fn is_alike(a: &ShapeKind, b: &ShapeKind) -> bool {
    let is_table = |kind: &ShapeKind| matches!(kind, ShapeKind::Table | ShapeKind::OpenTable);
    match (a, b) {
        (ShapeKind::Words(_), ShapeKind::Words(_)) => true,
        _ if is_table(a) => is_table(b),
        _ => a == b,
    }
}

/// A path with `[]` for every `[3]`.
fn without_indices(path: &str) -> String {
    let mut pieces = path.split('[');
    let first = pieces.next().unwrap_or_default().to_owned();
    pieces.fold(first, |path, piece| match piece.split_once(']') {
        Some((index, rest)) if index.parse::<usize>().is_ok() => format!("{path}[]{rest}"),
        _ => format!("{path}[{piece}"),
    })
}
