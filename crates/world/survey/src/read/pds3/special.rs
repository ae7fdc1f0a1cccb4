//! Stored numbers that are no heights: nulls, saturations, numbers beyond the valid ones.

use crate::error::SurveyError;
use crate::read::kind::{Kind, in_base};
use crate::read::label::{Label, Statement, Value, is_nothing, place};
use crate::read::words::Fate;

/// Ranges of stored numbers that mark voids, by every keyword of the table that does. A note tells of a mark that no sample
/// can hold.
pub fn voids(label: &Label, kind: Kind, notes: &mut Vec<String>) -> Result<Vec<[f64; 2]>, SurveyError> {
    let mut ranges = Vec::new();
    for statement in &label.statements {
        let word = label.dialect.table_of(statement).of_name(&statement.keyword);
        if !word.is_some_and(|word| matches!(word.fate, Fate::Void(_))) {
            continue;
        }
        for range in marks(label, statement, &statement.value, kind)? {
            if !range.iter().all(|end| kind.can_hold(*end)) {
                let value = statement.value.text();
                notes.push(format!("{}: no sample can hold {value}", place(statement)));
            }
            ranges.push(range);
        }
    }
    Ok(ranges)
}

fn marks(
    label: &Label,
    statement: &Statement,
    value: &Value,
    kind: Kind,
) -> Result<Vec<[f64; 2]>, SurveyError> {
    match value {
        Value::List(values) => {
            let each = values.iter().map(|value| marks(label, statement, value, kind));
            Ok(each.collect::<Result<Vec<_>, _>>()?.concat())
        }
        Value::Plain { unit: Some(_), .. } => Err(label.wrong(statement, "stored numbers without a unit")),
        Value::Plain { text, .. } if is_nothing(text) => Ok(Vec::new()),
        Value::Plain { text, .. } => {
            let (low, high) = text.split_once("..").unwrap_or((text, text));
            let ends = stored(low, kind).zip(stored(high, kind)).filter(|(low, high)| low <= high);
            let expected = "a number, 16#DIGITS#, a range, or a list of them";
            ends.map(|(low, high)| vec![[low, high]]).ok_or_else(|| label.wrong(statement, expected))
        }
    }
}

/// A stored number: as a number, or by its bits.
fn stored(text: &str, kind: Kind) -> Option<f64> {
    let bits = in_base(text).map(|bits| kind.number_of_bits(bits));
    bits.or_else(|| text.trim().parse().ok()).filter(|number: &f64| !number.is_nan())
}
