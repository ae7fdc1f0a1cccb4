//! What differs between two documents, key by key.

use serde_json::Value;

/// Differences that are told.
const TOLD: usize = 12;

/// Every key whose value in `then` is not that in `now`, in words, as "view.sweeps (40 there, 20 now)"; nothing if none differs.
/// The first dozen are named, the others counted.
pub fn differences(then: &Value, now: &Value) -> Option<String> {
    let mut found = Vec::new();
    // A record has been read back: what is compared with it is read back as well.
    let now = serde_json::from_str(&now.to_string()).unwrap_or(Value::Null);
    compare(String::new(), Some(then), Some(&now), &mut found);
    let more = found.len().saturating_sub(TOLD);
    found.truncate(TOLD);
    let others = if more > 0 { format!("; and {more} others") } else { String::new() };
    (!found.is_empty()).then(|| found.join("; ") + &others)
}

fn compare(path: String, then: Option<&Value>, now: Option<&Value>, found: &mut Vec<String>) {
    let below = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
    match (then, now) {
        (then, now) if then == now => {}
        (Some(Value::Object(then)), Some(Value::Object(now))) => {
            let mut keys: Vec<_> = then.keys().chain(now.keys()).collect();
            keys.sort();
            keys.dedup();
            keys.into_iter().for_each(|key| compare(below(key), then.get(key), now.get(key), found));
        }
        (Some(Value::Array(then)), Some(Value::Array(now))) if then.len() == now.len() => {
            let pairs = then.iter().zip(now).enumerate();
            pairs.for_each(|(at, (then, now))| compare(below(&at.to_string()), Some(then), Some(now), found));
        }
        (Some(Value::String(_)), Some(Value::String(_))) if path.ends_with("blake3") => {
            found.push(format!("{path} (other content)"));
        }
        (then, now) => found.push(format!("{path} ({} there, {} now)", shown(then), shown(now))),
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
        let many = |value: u32| -> Value { (0..100).map(|at| (format!("k{at}"), json!(value))).collect() };
        let said = differences(&many(1), &many(2)).expect("all differ");
        assert!(said.matches("there").count() == TOLD && said.ends_with("and 88 others"), "{said}");
    }
}
