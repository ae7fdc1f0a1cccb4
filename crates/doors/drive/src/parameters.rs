//! The values that decide how a generator draws, with what their reader asked for.

use std::collections::BTreeMap;

use diagnostics::asked::{Asked, Shape, ShapeKind};
use front_door::Opened;
use hardware_model::EffectiveValue;
use serde_json::Value;
use toml::Table;

/// One value of the hardware model or of a generator.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// Dotted key, as `--set` takes it.
    pub key: String,
    /// Value as it is now; null where no file sets it, so that the generator has its own.
    pub value: Value,
    /// Type of value: number, whole, boolean, text, word, list or table.
    pub kind: &'static str,
    /// Unit of the number, where the reader names one.
    pub unit: Option<String>,
    /// Least number, where the reader has one.
    pub low: Option<f64>,
    /// Largest number, where the reader has one.
    pub high: Option<f64>,
    /// Words that may stand there.
    pub words: Vec<String>,
    /// File and line that the value comes from, as `hardware-models/ideal.toml:8`; the name of the generator where no file sets it.
    pub source: String,
}

/// The values of `opened` with the shapes that their readers `asked` for, and what else the reader of its generator asked for.
pub(crate) fn parameters(opened: &Opened, asked: &[Asked]) -> Vec<Parameter> {
    // The model is read after the scenario, which may have a key of the same name.
    let shapes: BTreeMap<&str, &Shape> =
        asked.iter().map(|asked| (asked.path.as_str(), &asked.shape)).collect();
    let is_own = |key: &str| opened.row.is_some_and(|row| row.owns(key)) && !key.contains('[');
    let may_be_set = shapes.iter().filter(|(key, shape)| is_own(key) && is_value(&shape.kind));
    let mut all: BTreeMap<&str, Option<&EffectiveValue>> = may_be_set.map(|(key, _)| (*key, None)).collect();
    all.extend(opened.values.iter().map(|value| (value.key.as_str(), Some(value))));
    let all = all.into_iter();
    all.map(|(key, value)| parameter(key, value, shapes.get(key).copied(), opened.drawn_by())).collect()
}

/// Whether something of this kind is one value, not a table of values.
fn is_value(kind: &ShapeKind) -> bool {
    !matches!(kind, ShapeKind::Table | ShapeKind::Tables | ShapeKind::OpenTable)
}

fn parameter(
    key: &str,
    effective: Option<&EffectiveValue>,
    shape: Option<&Shape>,
    drawn_by: &str,
) -> Parameter {
    let value = effective.map_or(Value::Null, |effective| read(&effective.value));
    let end = |end: fn(&Shape) -> Option<(f64, bool)>| shape.and_then(end).map(|(number, _)| number);
    let mut words = shape.map_or_else(Vec::new, |shape| shape.or_words.clone());
    if let Some(ShapeKind::Words(more)) = shape.map(|shape| &shape.kind) {
        words.extend(more.iter().cloned());
    }
    Parameter {
        key: key.into(),
        kind: shape.map_or_else(|| kind_of(&value), |shape| kind(&shape.kind)),
        value,
        unit: shape.and_then(|shape| shape.unit.clone()),
        low: end(|shape| shape.low),
        high: end(|shape| shape.high),
        words,
        source: effective.map_or(drawn_by, |effective| &effective.origin).into(),
    }
}

/// The value that a text of TOML means; the text itself if it means none.
fn read(text: &str) -> Value {
    let table = format!("value = {text}").parse::<Table>().ok();
    let value = table.and_then(|mut table| table.remove("value"));
    let value = value.and_then(|value| serde_json::to_value(value).ok());
    value.unwrap_or_else(|| text.into())
}

fn kind(kind: &ShapeKind) -> &'static str {
    match kind {
        ShapeKind::Number | ShapeKind::NumberOrArray(_) => "number",
        ShapeKind::Whole | ShapeKind::Count => "whole",
        ShapeKind::Boolean => "boolean",
        ShapeKind::Text => "text",
        ShapeKind::Words(_) => "word",
        ShapeKind::Array(..) => "list",
        ShapeKind::Table | ShapeKind::Tables | ShapeKind::OpenTable => "table",
    }
}

fn kind_of(value: &Value) -> &'static str {
    match value {
        Value::Number(number) if number.is_f64() => "number",
        Value::Number(_) => "whole",
        Value::Bool(_) => "boolean",
        Value::Array(_) => "list",
        Value::Object(_) => "table",
        Value::String(_) | Value::Null => "text",
    }
}
