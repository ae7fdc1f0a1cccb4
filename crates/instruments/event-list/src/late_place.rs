//! Late words as a person names them: by their place, or by the line of the listing that tells them.

use std::str::FromStr;

use machine::{EventWord, LateOf};
use serde_json::Value;

use crate::filter::LEVELS;
use crate::listing::CSV;

/// Which late words of a frame are meant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LatePlace {
    /// Number of the sweep, from 0.
    pub sweep: u32,
    /// What waited for them.
    pub of: PlaceOf,
}

/// What waited for late words, as far as a person says it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlaceOf {
    /// A crossing whose level is not said, from 0 in the sweep.
    Crossing(u32),
    /// Said completely: crossing and level, crater, or shadow boundary.
    Said(LateOf),
    /// A shadow boundary, by the number of its line generator and the ground range of its crossing (m).
    LineGenerator(u32, f64),
}

impl PlaceOf {
    /// Whether the shadow gates of the frame tell it.
    pub fn needs_gates(self) -> bool {
        matches!(self, Self::Said(LateOf::Boundary(_)) | Self::LineGenerator(..))
    }
}

impl FromStr for LatePlace {
    type Err = String;

    /// `SWEEP:CROSSING`, `SWEEP:crater.N`, `SWEEP:boundary.N`, or a line of the listing as text, as CSV or as JSON.
    fn from_str(text: &str) -> Result<Self, String> {
        let line = text.trim();
        let cells: Vec<&str> = line.split(',').collect();
        if line.starts_with('{') {
            return of_json(line.trim_end_matches(','));
        }
        match cells.len() == CSV.split(',').count() {
            true => Words {
                sweep: cells[2],
                event: cells[4],
                level: cells[5],
                crossing: cells[6],
                part: cells[19],
                crater: cells[20],
                range: cells[21],
            }
            .place(),
            false if line.contains(' ') => of_text(line),
            false => of_place(line),
        }
    }
}

fn of_place(text: &str) -> Result<LatePlace, String> {
    let read = |of: &str| {
        Some(match of.split_once('.') {
            None => PlaceOf::Crossing(of.parse().ok()?),
            Some(("crater", number)) => PlaceOf::Said(LateOf::Crater(number.parse().ok()?)),
            Some(("boundary", number)) => PlaceOf::Said(LateOf::Boundary(number.parse().ok()?)),
            Some(_) => return None,
        })
    };
    let place = text
        .split_once(':')
        .and_then(|(sweep, of)| Some(LatePlace { sweep: sweep.parse().ok()?, of: read(of)? }));
    place.ok_or_else(|| {
        format!(
            "expected sweep and crossing, as 260:60, sweep and crater or shadow boundary, as 260:crater.7 or 260:boundary.3, or \
             the line of a late event from `lunoid trace`, not `{text}`"
        )
    })
}

fn of_text(line: &str) -> Result<LatePlace, String> {
    let words: Vec<&str> = line.split_whitespace().map(|word| word.trim_end_matches(',')).collect();
    // Tick, time, sweep, unit, event; then the level, if it is not the fine one, and further on the rest.
    let [_, _, sweep, _, event, details @ ..] = words.as_slice() else { return Err(not_a_line(line)) };
    let level = details.first().copied().filter(|word| LEVELS.contains(word)).unwrap_or(LEVELS[0]);
    let behind = |name: &str| {
        let at = details.iter().position(|word| *word == name);
        at.and_then(|at| details.get(at + 1)).copied().unwrap_or_default()
    };
    let part = details.iter().find(|word| word.starts_with(LINE_GENERATOR)).copied().unwrap_or_default();
    let [crossing, crater, range] = ["crossing", "crater", "at"].map(behind);
    // What found no part free has no part.
    let part = if details.iter().any(|word| word.starts_with(SUB_GENERATOR)) { SUB_GENERATOR } else { part };
    Words { sweep, event, level, crossing, part, crater, range }.place()
}

fn of_json(line: &str) -> Result<LatePlace, String> {
    let event: Value = serde_json::from_str(line).map_err(|error| format!("{error} in `{line}`"))?;
    let word = |key: &str| match &event[key] {
        Value::String(word) => word.clone(),
        Value::Null => String::new(),
        other => other.to_string(),
    };
    let keys = ["sweep", "event", "level", "crossing", "part", "crater", "range_m"];
    let [sweep, name, level, crossing, part, crater, range] = &keys.map(word);
    Words { sweep, event: name, level, crossing, part, crater, range }.place()
}

/// First words of the names of the parts that wait for loads.
const SUB_GENERATOR: &str = "sub-generator.";
const LINE_GENERATOR: &str = "line-generator.";

/// Words of a line that tell late words; those that it has not are empty.
#[derive(Debug, Clone, Copy)]
struct Words<'a> {
    sweep: &'a str,
    event: &'a str,
    level: &'a str,
    crossing: &'a str,
    part: &'a str,
    crater: &'a str,
    range: &'a str,
}

impl Words<'_> {
    fn place(self) -> Result<LatePlace, String> {
        let of = match EventWord::ALL.iter().find(|word| word.name() == self.event) {
            Some(EventWord::Late) => self.crossing(),
            Some(EventWord::CraterLate | EventWord::CraterDropped) => {
                self.expect_part("sub-generator")?;
                self.crater.parse().ok().map(|crater| PlaceOf::Said(LateOf::Crater(crater)))
            }
            Some(EventWord::SegmentLate | EventWord::SegmentDropped) => {
                self.expect_part("line generator")?;
                self.boundary()
            }
            _ => {
                return Err(format!(
                    "this is the line of the event `{}`; expected one of `late`, `crater-late`, `crater-dropped`, `segment-late`, \
                     `segment-dropped`",
                    self.event
                ));
            }
        };
        match (self.sweep.parse(), of) {
            (Ok(sweep), Some(of)) => Ok(LatePlace { sweep, of }),
            _ => Err(not_a_line(&format!("{} {} {}", self.sweep, self.event, self.crossing))),
        }
    }

    fn crossing(self) -> Option<PlaceOf> {
        let level = LEVELS.iter().position(|name| *name == self.level)?;
        Some(PlaceOf::Said(LateOf::Crossing { level, crossing: self.crossing.parse().ok()? }))
    }

    fn boundary(self) -> Option<PlaceOf> {
        let number = self.part.strip_prefix(LINE_GENERATOR)?.parse().ok()?;
        Some(PlaceOf::LineGenerator(number, self.range.parse().ok()?))
    }

    /// Refuses what found no part free: no word was late.
    fn expect_part(self, part: &str) -> Result<(), String> {
        match self.part.is_empty() {
            false => Ok(()),
            true => Err(format!(
                "this `{}` found no {part} free, so no word of it was late; expected a line that names its {part}",
                self.event
            )),
        }
    }
}

fn not_a_line(found: &str) -> String {
    format!(
        "expected the line of a late event from `lunoid trace`, with its sweep and what waited for the words, not `{found}`"
    )
}

#[cfg(test)]
mod tests {
    use machine::LateOf;

    use super::{LatePlace, PlaceOf};

    fn read(text: &str) -> Result<LatePlace, String> {
        text.parse()
    }

    fn said(sweep: u32, of: LateOf) -> Result<LatePlace, String> {
        Ok(LatePlace { sweep, of: PlaceOf::Said(of) })
    }

    #[test]
    fn a_place_and_the_three_forms_of_a_line() {
        assert_eq!(read("260:60"), Ok(LatePlace { sweep: 260, of: PlaceOf::Crossing(60) }));
        let coarse = said(3, LateOf::Crossing { level: 1, crossing: 7 });
        let text = "      120034     512.310     3  registers              late            coarse, green, y-first, corner 5 4, \
                    words 9, crossing 7, 6 ticks late, cause queue";
        assert_eq!(read(text), coarse);
        assert_eq!(read(&text.replace("coarse, ", "")), said(3, LateOf::Crossing { level: 0, crossing: 7 }));
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
        assert!(stop.contains("`stop`; expected one of `late`, `crater-late`"), "{stop}");
    }

    #[test]
    fn craters_and_boundaries_are_named_by_place_and_by_line() {
        assert_eq!(read("260:crater.7"), said(260, LateOf::Crater(7)));
        assert_eq!(read("260:boundary.3"), said(260, LateOf::Boundary(3)));
        assert!(read("260:rock.3").unwrap_err().contains("260:crater.7 or 260:boundary.3"));
        let crater = "  120034  512.310  3  feature-generator.load  crater-late  crater 71, sub-generator.2.0, at 41.20 m, words 8, \
                      6 ticks late, cause queue";
        let boundary = "  120034  512.310  3  shadow-controller.load  segment-dropped  line-generator.4, at 41.20 m, words 4, cause \
                        queue";
        let line = Ok(LatePlace { sweep: 3, of: PlaceOf::LineGenerator(4, 41.2) });
        assert_eq!(read(crater), said(3, LateOf::Crater(71)));
        assert_eq!(read(boundary), line);
        let csv = "120034,512.310,3,feature-generator.load,crater-late,,,,,,,,,8,255,-6,queue,,,sub-generator.2.0,71,41.25";
        assert_eq!(read(csv), said(3, LateOf::Crater(71)));
        let csv = "120034,512.310,3,shadow-controller.load,segment-late,,,,,,,,,4,15,-6,queue,,,line-generator.4,,41.2";
        assert_eq!(read(csv), line);
        let json = r#"{"sweep": 3, "event": "segment-late", "part": "line-generator.4", "range_m": 41.2}"#;
        assert_eq!(read(json), line);
        let occupied =
            read(&crater.replace("crater-late", "crater-dropped").replace("sub-generator.2.0, ", ""));
        assert!(occupied.unwrap_err().contains("no sub-generator free, so no word of it was late"));
        let occupied = read(&boundary.replace("line-generator.4, ", ""));
        assert!(occupied.unwrap_err().contains("no line generator free"));
        let record = read(&crater.replace("crater-late", "feature-record")).unwrap_err();
        assert!(record.contains("`feature-record`"), "{record}");
    }
}
