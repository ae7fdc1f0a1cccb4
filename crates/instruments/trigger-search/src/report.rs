//! What was found, as text or JSON, made as it is found.

use serde_json::{Map, Value, json};

use text::table;

use crate::around::Row;
use crate::{Around, Ended, Finder, Found};

/// A report in the making; what it returns is to be written in that order.
pub struct Report<'a> {
    finder: &'a Finder<'a>,
    is_json: bool,
    added: u64,
}

impl<'a> Report<'a> {
    /// A report of what `finder` finds: text, or a document of schema `lunoid.trigger/1`.
    pub fn new(finder: &'a Finder<'a>, is_json: bool) -> Self {
        Self { finder, is_json, added: 0 }
    }

    /// What comes before the first place.
    pub fn begin(&self, condition: &str) -> String {
        match self.is_json {
            true => format!(
                "{{\n  \"schema\": \"lunoid.trigger/1\",\n  \"condition\": {},\n  \"places\": [",
                Value::from(condition)
            ),
            false => String::new(),
        }
    }

    /// A place, with the commands that go on from it.
    pub fn add(&mut self, found: &Found, around: Option<&Around>, next: &[String]) -> String {
        let comma = if self.added == 0 { "" } else { "," };
        self.added += 1;
        match self.is_json {
            true => format!("{comma}\n    {}", self.document(found, around, next)),
            false => self.head(found) + &self.details(found, around, next),
        }
    }

    /// What comes after the last.
    pub fn end(self, ended: &Ended) -> String {
        let Ended { met, shown, sweeps, interrupted_at } = ended;
        if self.is_json {
            let is_whole = interrupted_at.is_none();
            return format!(
                "\n  ],\n  \"met\": {met},\n  \"sweeps\": {sweeps},\n  \"is_whole\": {is_whole}\n}}\n"
            );
        }
        match (shown, met) {
            _ if interrupted_at.is_some() => format!("found {met} times in {sweeps} sweeps so far\n"),
            (0, 0) => format!("not found in {sweeps} sweeps\n"),
            (0, _) => format!("found {met} times in {sweeps} sweeps, not more\n"),
            (1, _) => String::new(),
            _ => format!("found {met} times in {sweeps} sweeps\n"),
        }
    }

    fn is_of_display(&self) -> bool {
        self.finder.is_of_display
    }

    fn head(&self, found: &Found) -> String {
        let Found { number, frame, pose, sweep, hit } = found;
        let sample = match self.is_of_display() {
            true => format!("line {}", hit.sample),
            false => format!("sample {:.3}, {:.3} µs", hit.time, hit.time * self.finder.sample_us()),
        };
        let range = hit.range.map_or_else(String::new, |range| format!(", {range:.2} m"));
        let values = hit.readings.iter().map(|reading| {
            let (name, unit) = (reading.signal.name, reading.signal.unit);
            format!("{name} {}{}", number_text(reading.value), unit_text(&unit.to_string()))
        });
        format!(
            "{number}: frame {frame} ({:.3} s), sweep {sweep}, {sample}{range}: {}\n",
            pose.time,
            values.collect::<Vec<_>>().join(", ")
        )
    }

    fn details(&self, found: &Found, around: Option<&Around>, next: &[String]) -> String {
        let Some(around) = around else { return String::new() };
        let blanked = if around.is_blanked { "; the beam is blanked here" } else { "" };
        let pixel = match around.pixel {
            Some([x, y]) => format!("   pixel {x},{y}{blanked}\n"),
            None => "   beyond the picture\n".into(),
        };
        let next: String = next.iter().map(|command| format!("   {command}\n")).collect();
        pixel + &self.rows_text(found, around) + "\n" + &next
    }

    fn rows_text(&self, found: &Found, around: &Around) -> String {
        if around.rows.is_empty() {
            return String::new();
        }
        let place = if self.is_of_display() { "line" } else { "sample" };
        let head = ["", "sweep", place, "range (m)"].into_iter().chain(around.columns());
        let row = |row: &Row| {
            let is_it = (row.sweep, row.sample) == (found.sweep, found.hit.sample);
            let values = row.values.iter().map(|value| value.map_or_else(|| "-".into(), number_text));
            [
                if is_it { "=>" } else { "" }.to_owned(),
                row.sweep.to_string(),
                row.sample.to_string(),
                row.range.map_or_else(|| "-".into(), |range| format!("{range:.2}")),
            ]
            .into_iter()
            .chain(values)
            .collect()
        };
        let head = head.map(String::from).collect();
        "\n".to_owned() + &table(&[head].into_iter().chain(around.rows.iter().map(row)).collect::<Vec<_>>())
    }

    fn document(&self, found: &Found, around: Option<&Around>, next: &[String]) -> Value {
        let Found { number, frame, pose, sweep, hit } = found;
        let values: Map<String, Value> = hit
            .readings
            .iter()
            .map(|reading| (reading.signal.name.to_owned(), reading.value.into()))
            .collect();
        let mut document = json!({
            "number": number,
            "frame": frame,
            "time_s": pose.time,
            "sweep": sweep,
            "sample": hit.sample,
            "instant": hit.time,
            "range_m": hit.range,
            "values": values,
        });
        if !self.is_of_display() {
            document["instant_us"] = (hit.time * self.finder.sample_us()).into();
        }
        if let Some(around) = around {
            document["pixel"] = json!(around.pixel);
            document["is_blanked"] = around.is_blanked.into();
            document["next"] = json!(next);
            document["around"] = around.rows.iter().map(|row| row_document(row, around)).collect();
        }
        document
    }
}

fn row_document(row: &Row, around: &Around) -> Value {
    let values = around.columns().zip(&row.values).map(|(name, value)| (name.to_owned(), json!(value)));
    json!({
        "sweep": row.sweep,
        "sample": row.sample,
        "range_m": row.range,
        "values": values.collect::<Map<String, Value>>(),
    })
}

/// Six digits, and whole numbers as they are.
fn number_text(value: f64) -> String {
    if value == value.trunc() && value.abs() < 1e15 { format!("{value}") } else { format!("{value:.6}") }
}

fn unit_text(symbol: &str) -> String {
    if symbol == "1" { String::new() } else { format!(" {symbol}") }
}

#[cfg(test)]
mod tests {
    use super::number_text;

    #[test]
    fn numbers_are_short() {
        assert_eq!(
            ["511", "0.333333", "-2"],
            [511.0, 1.0 / 3.0, -2.0].map(number_text).each_ref().map(String::as_str)
        );
    }
}
