//! Lines of a TOML file, each with the path of its key.

use serde_json::Value;

/// A line `key = value` whose value is a number, a truth or a word.
pub struct Line {
    /// Line of the file, from 0.
    pub index: usize,
    /// Path of the key, by the schema's names.
    pub path: Vec<String>,
    /// The value that it holds.
    pub value: Value,
}

/// The lines of `text` that hold one value each.
pub fn lines(text: &str) -> Vec<Line> {
    let mut table: Vec<String> = Vec::new();
    let mut found = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let line = line.trim();
        if let Some(header) = line.strip_prefix('[') {
            let header = header.split(']').next().unwrap_or_default().trim_start_matches('[');
            table = header.split('.').map(|word| word.trim().to_owned()).collect();
            continue;
        }
        let value = toml::from_str::<Value>(line).ok().and_then(|value| value.as_object().cloned());
        let Some((key, value)) = value.and_then(|value| value.into_iter().next()) else { continue };
        if value.is_number() || value.is_string() || value.is_boolean() {
            let path = table.iter().cloned().chain([key]).collect();
            found.push(Line { index, path, value });
        }
    }
    found
}

/// `text` with `value` in place of what `line` holds.
pub fn replaced(text: &str, line: &Line, value: &str) -> String {
    let key = line.path.last().expect("a key");
    let changed = |(index, old): (usize, &str)| {
        if index == line.index { format!("{key} = {value}\n") } else { format!("{old}\n") }
    };
    text.lines().enumerate().map(changed).collect()
}

/// What `schema` says of the key at `path`.
pub fn node<'s>(schema: &'s Value, path: &[String]) -> Option<&'s Value> {
    path.iter().try_fold(schema, |schema, key| {
        let table = if schema["type"] == "array" { &schema["items"] } else { schema };
        table.get("properties")?.get(key)
    })
}
