//! Late words as a person names them: by their place, or by the line of the listing that tells them.

use std::str::FromStr;

use machine::EventWord;
use serde_json::Value;

use crate::filter::LEVELS;
use crate::listing::CSV;

/// Which late words of a frame are meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LatePlace {
    /// Number of the sweep, from 0.
    pub sweep: u32,
    /// Level of terrain, from 0; `None` if only sweep and crossing are given.
    pub level: Option<usize>,
    /// Fold that found the words missing, from 0 in the sweep.
    pub crossing: u32,
}

impl FromStr for LatePlace {
    type Err = String;

    /// `SWEEP:CROSSING`, or a line of the listing as text, as CSV or as JSON.
    fn from_str(text: &str) -> Result<Self, String> {
        let line = text.trim();
        let cells: Vec<&str> = line.split(',').collect();
        if line.starts_with('{') {
            return of_json(line.trim_end_matches(','));
        }
        match cells.len() == CSV.split(',').count() {
            true => of_words([cells[2], cells[4], cells[5], cells[6]]),
            false if line.contains(' ') => of_text(line),
            false => of_place(line),
        }
    }
}

fn of_place(text: &str) -> Result<LatePlace, String> {
    let place = text
        .split_once(':')
        .and_then(|(sweep, crossing)| Some((sweep.parse().ok()?, crossing.parse().ok()?)));
    let (sweep, crossing) = place.ok_or_else(|| {
        format!("expected sweep and crossing, as 260:60, or the line of a late event from `lunoid trace`, not `{text}`")
    })?;
    Ok(LatePlace { sweep, level: None, crossing })
}

fn of_text(line: &str) -> Result<LatePlace, String> {
    let words: Vec<&str> = line.split_whitespace().collect();
    // Tick, time, sweep, unit, event; then the level, if it is not the fine one, and further on the crossing.
    let [_, _, sweep, _, event, details @ ..] = words.as_slice() else { return Err(not_a_line(line)) };
    let level = details.first().map(|word| word.trim_end_matches(',')).filter(|word| LEVELS.contains(word));
    let place = details.iter().position(|word| *word == "crossing").and_then(|at| details.get(at + 1));
    let crossing = place.map_or("", |number| number.trim_end_matches(','));
    of_words([sweep, event, level.unwrap_or(LEVELS[0]), crossing])
}

fn of_json(line: &str) -> Result<LatePlace, String> {
    let event: Value = serde_json::from_str(line).map_err(|error| format!("{error} in `{line}`"))?;
    let word = |key: &str| match &event[key] {
        Value::String(word) => word.clone(),
        other => other.to_string(),
    };
    let [sweep, name, level, crossing] = ["sweep", "event", "level", "crossing"].map(word);
    of_words([&sweep, &name, &level, &crossing])
}

/// From the words of a line: sweep, event, level, crossing.
fn of_words([sweep, event, level, crossing]: [&str; 4]) -> Result<LatePlace, String> {
    if event != EventWord::Late.name() {
        return Err(format!("this is the line of the event `{event}`; expected one of `late`"));
    }
    let level = LEVELS.iter().position(|name| *name == level);
    match (sweep.parse(), crossing.parse()) {
        (Ok(sweep), Ok(crossing)) if level.is_some() => Ok(LatePlace { sweep, level, crossing }),
        _ => Err(not_a_line(&format!("{sweep} {event} {crossing}"))),
    }
}

fn not_a_line(found: &str) -> String {
    format!(
        "expected the line of a late event from `lunoid trace`, with its sweep and crossing, not `{found}`"
    )
}

#[cfg(test)]
mod tests {
    use super::LatePlace;

    #[test]
    fn a_place_and_the_three_forms_of_a_line() {
        let read = |text: &str| text.parse::<LatePlace>();
        assert_eq!(read("260:60"), Ok(LatePlace { sweep: 260, level: None, crossing: 60 }));
        let coarse = Ok(LatePlace { sweep: 3, level: Some(1), crossing: 7 });
        let text = "      120034     512.310     3  registers              late            coarse, green, y-first, corner 5 4, \
                    words 9, crossing 7, 6 ticks late, cause queue";
        assert_eq!(read(text), coarse);
        assert_eq!(
            read(&text.replace("coarse, ", "")),
            Ok(LatePlace { level: Some(0), ..coarse.clone().unwrap() })
        );
        assert_eq!(
            read("120034,512.310,3,registers,late,coarse,7,,,green,y-first,5,4,9,511,-6,queue,41.2,,,,"),
            coarse
        );
        let json = r#"    {"tick": 120034, "sweep": 3, "event": "late", "level": "coarse", "crossing": 7, "words": 9},"#;
        assert_eq!(read(json), coarse);
        for wrong in ["", "3", "3:", "a:b", "-1:2", "{", "1 2 3", &text.replace(", crossing 7", "")] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
        let stop = read(&text.replace(" late ", " stop ")).unwrap_err();
        assert!(stop.contains("`stop`; expected one of `late`"), "{stop}");
    }
}
