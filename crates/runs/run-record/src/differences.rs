//! What differs between two documents, key by key.

use serde_json::Value;

/// Differences that are told.
const TOLD: usize = 12;

/// Tables whose differences are told first, in this order.
const FIRST: [&str; 3] = ["program", "scenario", "model"];
/// Tables whose differences are told last: they follow from the scenario and its ground.
const LAST: [&str; 1] = ["ground"];

/// Every key whose value in `then` is not that in `now`, in words, as "view.sweeps (40 there, 20 now)"; nothing if none differs.
/// The first dozen are named, the others counted.
pub fn differences(then: &Value, now: &Value) -> Option<String> {
    differences_of([then, now], ["there", "now"])
}

/// The same of any two documents; `words` stand behind the values of the first and of the second.
pub fn differences_of([first, second]: [&Value; 2], words: [&str; 2]) -> Option<String> {
    let mut found = Found { words, list: Vec::new() };
    // A record has been read back: what is compared with it is read back as well.
    let second = serde_json::from_str(&second.to_string()).unwrap_or(Value::Null);
    found.compare(String::new(), Some(first), Some(&second));
    found.list.sort_by_key(|difference| rank(difference));
    let more = found.list.len().saturating_sub(TOLD);
    found.list.truncate(TOLD);
    let others = if more > 0 { format!("; and {more} others") } else { String::new() };
    (!found.list.is_empty()).then(|| found.list.join("; ") + &others)
}

/// Tables of a record that people know by name come first, and those that follow from others last.
fn rank(difference: &str) -> usize {
    let table = difference.split(['.', ' ']).next().unwrap_or_default();
    let named = FIRST.iter().position(|first| *first == table);
    named.unwrap_or(FIRST.len() + usize::from(LAST.contains(&table)))
}

/// Differences that were found so far.
struct Found<'a> {
    /// Words behind the values of the first and of the second document.
    words: [&'a str; 2],
    list: Vec<String>,
}

impl Found<'_> {
    fn compare(&mut self, path: String, first: Option<&Value>, second: Option<&Value>) {
        let below = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
        match (first, second) {
            (first, second) if first == second => {}
            (Some(Value::Object(first)), Some(Value::Object(second))) => {
                let mut keys: Vec<_> = first.keys().chain(second.keys()).collect();
                keys.sort();
                keys.dedup();
                keys.into_iter().for_each(|key| self.compare(below(key), first.get(key), second.get(key)));
            }
            (Some(Value::Array(first)), Some(Value::Array(second))) if first.len() == second.len() => {
                let pairs = first.iter().zip(second).enumerate();
                pairs.for_each(|(at, (first, second))| {
                    self.compare(below(&at.to_string()), Some(first), Some(second));
                });
            }
            (Some(Value::String(_)), Some(Value::String(_))) if path.ends_with("blake3") => {
                self.list.push(format!("{path} (other content)"));
            }
            (first, second) => {
                let [one, other] = self.words;
                self.list.push(format!("{path} ({} {one}, {} {other})", shown(first), shown(second)));
            }
        }
    }
}

fn shown(value: Option<&Value>) -> String {
    /// Characters of a value that are told.
    const MOST: usize = 40;
    match value {
        None => "nothing".into(),
        Some(Value::Array(items)) => format!("{} entries", items.len()),
        Some(Value::Object(_)) => "a table".into(),
        Some(value) => {
            let text = value.to_string();
            if text.chars().count() <= MOST {
                text
            } else {
                text.chars().take(MOST).collect::<String>() + "..."
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::{TOLD, differences};

    #[test]
    fn each_key_that_differs_is_named() {
        let then =
            json!({ "view": { "sweeps": 40, "ranges_m": [2.0, 300.0] }, "a_blake3": "x", "rocks": [1] });
        let now = json!({
            "view": { "sweeps": 20, "ranges_m": [2.0, 310.5] }, "a_blake3": "y", "sun": 3, "rocks": []
        });
        assert_eq!(
            differences(&then, &now).expect("some differ"),
            "a_blake3 (other content); rocks (1 entries there, 0 entries now); sun (nothing there, 3 now); \
             view.ranges_m.1 (300.0 there, 310.5 now); view.sweeps (40 there, 20 now)"
        );
        assert_eq!(differences(&then, &then), None);
        let of = |sun: u32| json!({ "ground": { "seed": sun }, "model": { "name": sun }, "scenario": { "file": sun }, "sun": sun });
        assert_eq!(
            differences(&of(1), &of(2)).expect("all differ"),
            "scenario.file (1 there, 2 now); model.name (1 there, 2 now); sun (1 there, 2 now); ground.seed (1 there, 2 now)"
        );
        let many = |value: u32| -> Value { (0..100).map(|at| (format!("k{at}"), json!(value))).collect() };
        let said = differences(&many(1), &many(2)).expect("all differ");
        assert!(said.matches("there").count() == TOLD && said.ends_with("and 88 others"), "{said}");
    }
}
