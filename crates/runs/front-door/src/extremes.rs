//! Parts so slow that a frame of them never ends.

use diagnostics::{Problem, ProblemList, Problems};
use hardware_model::EffectiveValue;

/// Least bandwidth of a part (MHz). A sweep takes tens of microseconds, and a slower part is followed for many time constants
/// before it: at a millionth of this, for days.
const LEAST_MHZ: f64 = 1e-4;

/// Refuses parts that cannot be drawn.
///
/// # Errors
/// Every bandwidth below the least, with its place.
pub fn expect_drawable(values: &[EffectiveValue]) -> Result<(), ProblemList> {
    let problems = Problems::new();
    let slow =
        values.iter().filter_map(|value| Some((value, value.value.replace('_', "").parse::<f64>().ok()?)));
    let slow = slow.filter(|(value, number)| is_bandwidth(&value.key) && *number < LEAST_MHZ);
    for (EffectiveValue { key, origin, .. }, number) in slow {
        let title = format!("`{key}` is {number} MHz, so slow that a frame would not end");
        let problem = Problem::of_file(origin, title).key(key).found(number.to_string());
        problems.push(
            problem.expected(format!("at least {LEAST_MHZ} MHz, the least bandwidth that can be drawn")),
        );
    }
    problems.into_result()
}

/// Whether the key is the bandwidth of a part. A clock is none.
fn is_bandwidth(key: &str) -> bool {
    ["bandwidth_mhz", "filter_mhz", "deflection_mhz"].iter().any(|end| key.ends_with(end))
}

#[cfg(test)]
mod tests {
    use hardware_model::EffectiveValue;

    use super::expect_drawable;

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
        let said = expect_drawable(&values).expect_err("one is too slow");
        assert_eq!(said.len(), 1);
        let said = said.to_string();
        for word in ["m.toml:7", "`a.gain_bandwidth_mhz` is 0.000000001 MHz", "at least 0.0001 MHz"] {
            assert!(said.contains(word), "{said}");
        }
    }
}
