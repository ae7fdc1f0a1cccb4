//! Models of which no machine can be built, and parts so slow that a frame of them never ends.

use diagnostics::{Problem, ProblemList, Problems};
use hardware_model::{EffectiveValue, Finding, LoadedModel};

/// Least bandwidth of a part (MHz). A sweep takes tens of microseconds, and a slower part is followed for many time constants
/// before it: at a millionth of this, for days.
const LEAST_MHZ: f64 = 1e-4;

/// Refuses a model that cannot be drawn.
///
/// # Errors
/// Every bandwidth below the least, and everything for which no machine can be built, with their places.
pub fn expect_drawable(loaded: &LoadedModel) -> Result<(), ProblemList> {
    expect_followable(&loaded.values)?;
    let problems = Problems::new();
    let refusals = loaded.model.refusals();
    refusals.map(|refusal| not_built(&loaded.values, &refusal)).for_each(|problem| problems.push(problem));
    problems.into_result()
}

/// Refuses parts that nobody can follow.
///
/// # Errors
/// Every bandwidth below the least, with its place.
pub fn expect_followable(values: &[EffectiveValue]) -> Result<(), ProblemList> {
    let problems = Problems::new();
    slow_parts(values).for_each(|problem| problems.push(problem));
    problems.into_result()
}

fn slow_parts(values: &[EffectiveValue]) -> impl Iterator<Item = Problem> {
    let slow =
        values.iter().filter_map(|value| Some((value, value.value.replace('_', "").parse::<f64>().ok()?)));
    let slow = slow.filter(|(value, number)| is_bandwidth(&value.key) && *number < LEAST_MHZ);
    slow.map(|(EffectiveValue { key, origin, .. }, number)| {
        let title = format!("`{key}` is {number} MHz, so slow that a frame would not end");
        let problem = Problem::of_file(origin, title).key(key).found(number.to_string());
        problem.expected(format!("at least {LEAST_MHZ} MHz, the least bandwidth that can be drawn"))
    })
}

/// A refusal, at the place of its first key that is written somewhere.
fn not_built(values: &[EffectiveValue], Finding { keys, message, .. }: &Finding) -> Problem {
    let of = |key: &&str| values.iter().find(|value| value.key == **key);
    let origin = keys.iter().find_map(of).map_or("hardware model", |value| value.origin.as_str());
    let found: Vec<String> =
        keys.iter().filter_map(of).map(|value| format!("{} = {}", value.key, value.value)).collect();
    let problem = Problem::of_file(origin, format!("no machine can be built: {message}"));
    problem
        .key(keys.join(", "))
        .found(found.join(", "))
        .expected("keys that hold together; `lunoid model check` tells all that do not")
}

/// Whether the key is the bandwidth of a part. A clock is none.
fn is_bandwidth(key: &str) -> bool {
    ["bandwidth_mhz", "filter_mhz", "deflection_mhz"].iter().any(|end| key.ends_with(end))
}

#[cfg(test)]
mod tests {
    use hardware_model::{EffectiveValue, HardwareModel, ModelSource};

    use super::{expect_drawable, expect_followable};

    #[test]
    fn bandwidths_below_the_least_are_refused_with_their_place() {
        let values = [
            ("a.gain_bandwidth_mhz", "1e-9"),
            ("b.filter_mhz", "0.0001"),
            ("c.clock_mhz", "1e-9"),
            ("d.bandwidth_mhz", "\"unlimited\""),
        ];
        let values = values.map(|(key, value)| EffectiveValue {
            key: key.into(),
            value: value.into(),
            origin: "m.toml:7".into(),
        });
        let said = expect_followable(&values).expect_err("one is too slow");
        assert_eq!(said.len(), 1);
        let said = said.to_string();
        for word in ["m.toml:7", "`a.gain_bandwidth_mhz` is 0.000000001 MHz", "at least 0.0001 MHz"] {
            assert!(said.contains(word), "{said}");
        }
    }

    /// Banks that are too small for one record, and drums that do not turn: by key and place, with the figure that would do.
    #[test]
    fn a_model_of_which_no_machine_can_be_built_is_refused() {
        let drum = ("drum.rotation_ms", "17");
        let apart = ("feature_bank.drums", "\"apart\"");
        for (sets, words) in [
            (
                vec![drum, ("buffer.words", "575")],
                ["575 words", "one record of 576", "buffer.words = 576 would do"],
            ),
            (
                vec![drum, apart, ("feature_bank.buffer_words", "9"), ("feature_bank.record_words", "96")],
                ["9 words", "one record of 96", "buffer_words = 96 would do"],
            ),
            (vec![apart], ["[feature_bank]", "there are none", "drum.rotation_ms is 0"]),
        ] {
            let sets: Vec<_> = sets.iter().map(|(key, value)| (key.to_string(), value.to_string())).collect();
            let loaded = HardwareModel::load(&ModelSource::BuiltIn("ideal".into()), &[], &sets)
                .expect("keys that are known");
            let said = expect_drawable(&loaded).expect_err("no machine").to_string();
            words.iter().for_each(|word| assert!(said.contains(word), "{word}: {said}"));
        }
    }
}
