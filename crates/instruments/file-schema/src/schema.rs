//! Keys as a JSON Schema.

use diagnostics::asked::{Shape, ShapeKind};
use serde_json::{Map, Value, json};

use crate::{Keys, Meanings};

/// What stands at the head of a schema.
#[derive(Debug, Clone, Copy)]
pub struct Told<'a> {
    /// Name of the format.
    pub title: &'a str,
    /// One sentence about it.
    pub description: &'a str,
    /// Keys of the root that a file must have; none of its tables. All that readers must have, if `None`.
    pub required: Option<&'a [&'a str]>,
}

impl Keys {
    /// The schema of these keys (JSON Schema, draft 2020-12), with the meanings of a page.
    pub fn schema(&self, told: &Told<'_>, meanings: &Meanings) -> Value {
        let whole = Writer { keys: self, meanings, is_partial: told.required.is_some() };
        let mut root = Map::new();
        root.insert("$schema".into(), json!("https://json-schema.org/draft/2020-12/schema"));
        root.insert("title".into(), json!(told.title));
        root.insert("description".into(), json!(told.description));
        let Value::Object(mut table) = whole.table("") else { return Value::Null };
        if let Some(required) = told.required {
            table.insert("required".into(), json!(required));
        }
        root.extend(table);
        Value::Object(root)
    }
}

struct Writer<'a> {
    keys: &'a Keys,
    meanings: &'a Meanings,
    /// Whether a table may leave out what another file has.
    is_partial: bool,
}

impl Writer<'_> {
    fn table(&self, path: &str) -> Value {
        let mut properties = Map::new();
        let mut required: Vec<&str> = Vec::new();
        for key in self.keys.below(path) {
            let name = key.rsplit('.').next().unwrap_or(key);
            properties.insert(name.to_owned(), self.key(key));
            if !self.is_partial && self.keys.is_required(key) {
                required.push(name);
            }
        }
        let mut table = json!({ "type": "object", "properties": properties, "additionalProperties": false });
        if !required.is_empty() {
            table["required"] = json!(required);
        }
        table
    }

    fn key(&self, path: &str) -> Value {
        let shapes = &self.keys.keys[path].shapes;
        let mut all: Vec<Value> = shapes.iter().map(|shape| self.value(path, shape)).collect();
        let words: Vec<&String> = shapes.iter().flat_map(|shape| &shape.or_words).collect();
        if !words.is_empty() {
            all.push(json!({ "type": "string", "enum": words }));
        }
        let mut value = if all.len() == 1 { all.remove(0) } else { json!({ "anyOf": all }) };
        if let Some(description) = self.description(path, shapes) {
            value["description"] = json!(description);
        }
        value
    }

    /// What the page says; of a key without a row its unit and rules.
    fn description(&self, path: &str, shapes: &[Shape]) -> Option<String> {
        let told = |shape: &Shape| {
            let unit = shape.unit.iter().map(|unit| format!("In {unit}."));
            unit.chain(shape.rules.iter().map(|rule| format!("Rule: {rule}."))).collect::<Vec<_>>().join(" ")
        };
        self.meanings.of(path).or_else(|| {
            let told: Vec<String> = shapes.iter().map(told).filter(|text| !text.is_empty()).collect();
            (!told.is_empty()).then(|| told.join(" "))
        })
    }

    fn value(&self, path: &str, shape: &Shape) -> Value {
        match &shape.kind {
            ShapeKind::Table => self.table(path),
            ShapeKind::OpenTable => json!({ "type": "object" }),
            ShapeKind::Tables => json!({ "type": "array", "items": self.table(&format!("{path}[]")) }),
            kind => simple(kind, shape),
        }
    }
}

/// A value that is no table. Bounds are those of every number in it.
fn simple(kind: &ShapeKind, shape: &Shape) -> Value {
    match kind {
        ShapeKind::Number => bounded("number", shape),
        ShapeKind::Whole => bounded("integer", shape),
        ShapeKind::Count => {
            bounded("integer", &Shape { low: shape.low.or(Some((0.0, true))), ..shape.clone() })
        }
        ShapeKind::NumberOrArray(count) => {
            let array = ShapeKind::Array(Box::new(ShapeKind::Number), Some(*count));
            json!({ "anyOf": [bounded("number", shape), simple(&array, shape)] })
        }
        ShapeKind::Boolean => json!({ "type": "boolean" }),
        ShapeKind::Words(words) => json!({ "type": "string", "enum": words }),
        ShapeKind::Array(of, count) => {
            let mut array = json!({ "type": "array", "items": simple(of, shape) });
            if let Some(count) = count {
                array["minItems"] = json!(count);
                array["maxItems"] = json!(count);
            }
            array
        }
        _ => json!({ "type": "string" }),
    }
}

fn bounded(kind: &str, shape: &Shape) -> Value {
    let mut value = json!({ "type": kind });
    let words = [(shape.low, "minimum", "exclusiveMinimum"), (shape.high, "maximum", "exclusiveMaximum")];
    for (bound, inclusive, exclusive) in words {
        if let Some((number, is_allowed)) = bound {
            value[if is_allowed { inclusive } else { exclusive }] = as_written(number);
        }
    }
    value
}

/// A whole number without a fraction.
fn as_written(number: f64) -> Value {
    if number.fract() == 0.0 && number.abs() < 9e15 { json!(number as i64) } else { json!(number) }
}
