//! Faults of a feature say whose they are: its number in the file, kind and name.

use diagnostics::{Problem, ProblemList, Problems, TomlFile};

/// What stands before the number of a feature in the path of a key.
const FEATURE: &str = "feature[";

/// The faults of a landscape file, each of a feature with its number, kind and name.
pub fn named(faults: ProblemList, file: &TomlFile) -> ProblemList {
    let silent = Problems::new();
    let names: Vec<String> = file
        .root(&silent)
        .tables("feature")
        .iter()
        .map(|table| {
            let word = |key: &str| table.string(key).optional();
            let kind = word("kind").unwrap_or_else(|| "of no kind".into());
            word("id").map_or(kind.clone(), |id| format!("{kind} {id:?}"))
        })
        .collect();
    faults.map(|fault| {
        let number = fault.key.as_deref().and_then(number);
        match number.and_then(|number| Some((number, names.get(number)?))) {
            Some((number, name)) => {
                let title = format!("{} (feature {} of the file, {name})", fault.title, number + 1);
                Problem { title, ..fault }
            }
            None => fault,
        }
    })
}

/// Number of the feature, from 0, in the path of a key.
fn number(key: &str) -> Option<usize> {
    key.strip_prefix(FEATURE)?.split(']').next()?.parse().ok()
}
