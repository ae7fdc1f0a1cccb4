//! The statements of a label that describe the image: decided name by name, and read with their units.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::parse::{Block, Statement, Value, parse};
use crate::error::SurveyError;
use crate::read::refusal::field;
use crate::read::unit;
use crate::read::words::{Decider, Fate, Met, Vocabulary, seen};

/// Statements outside of the objects that have tables of their own.
pub const FILE: &str = "";

/// The tables of a kind of label.
pub struct Dialect {
    /// Objects and groups of the label.
    pub objects: &'static Vocabulary,
    /// Keywords of the objects that count, by the name of the object in capitals. A label has one of each.
    pub counting: &'static [(&'static str, &'static Vocabulary)],
    /// Keywords outside of those objects.
    pub rest: &'static Vocabulary,
}

impl Dialect {
    /// Name of the innermost object of a statement, if it is one of those that count.
    fn object_of(&self, statement: &Statement) -> &'static str {
        let innermost = statement.blocks.last().map(|block| block.name.as_str());
        let found = self.counting.iter().find(|(name, _)| innermost == Some(name));
        found.map_or(FILE, |(name, _)| name)
    }

    /// The table that decides about a statement.
    pub fn table_of(&self, statement: &Statement) -> &'static Vocabulary {
        let object = self.object_of(statement);
        self.counting.iter().find(|(name, _)| *name == object).map_or(self.rest, |(_, table)| table)
    }
}

/// Words for "no value".
const NOTHING: [&str; 6] = ["N/A", "NULL", "UNK", "UNKNOWN", "NONE", ""];

/// A label with the file it came from, for messages. It holds the statements that count: those of objects that are not
/// the image are decided and left out.
pub struct Label<'a> {
    /// Path of the file with the label.
    pub path: &'a Path,
    /// Tables that decide about it.
    pub dialect: &'static Dialect,
    /// Statements about the file, the image and its place.
    pub statements: Vec<Statement>,
}

impl<'a> Label<'a> {
    /// Reads a label at the beginning of a file, and decides every object and every keyword.
    ///
    /// # Errors
    /// If the label is damaged, or one of its names is refused or unknown, or stands there twice.
    pub fn of(
        path: &'a Path,
        dialect: &'static Dialect,
        bytes: &[u8],
        decider: &mut Decider,
    ) -> Result<Self, SurveyError> {
        let statements = parse(bytes).map_err(|fault| {
            let advice = "the label is damaged: correct it or fetch it again";
            field(path, format!("label line {}", fault.line), fault.found, fault.expected, advice)
        })?;
        let mut label = Self { path, dialect, statements: Vec::new() };
        let (mut met, mut left_out) = (BTreeSet::new(), BTreeSet::new());
        for statement in statements {
            for block in &statement.blocks {
                if met.insert((block.line, block.name.clone())) && !label.is_read(decider, block)? {
                    left_out.insert(block.line);
                }
            }
            let is_left_out = statement.blocks.iter().any(|block| left_out.contains(&block.line));
            if !is_left_out && label.decide(decider, &statement)? {
                label.statements.push(statement);
            }
        }
        label.expect_one_of_each()?;
        Ok(label)
    }

    /// Whether a keyword counts.
    fn decide(&self, decider: &mut Decider, statement: &Statement) -> Result<bool, SurveyError> {
        let of = self.dialect.table_of(statement);
        let value = match &statement.value {
            Value::Plain { text, .. } => text.clone(),
            list => list.text(),
        };
        let (word, place) = (of.of_name(&statement.keyword), place(statement));
        let met = Met { of, word, place: &place, name: &statement.keyword, value: &value };
        Ok(matches!(decider.decide(met)?, Some(Fate::Used(_) | Fate::Void(_))))
    }

    /// Refuses a label with two objects of one name that count, and an object with two values of one keyword.
    fn expect_one_of_each(&self) -> Result<(), SurveyError> {
        let object_of = |statement: &Statement| self.dialect.object_of(statement);
        let mut begins: BTreeMap<&str, Option<usize>> = BTreeMap::new();
        let mut values: BTreeMap<(&str, &str), &Value> = BTreeMap::new();
        for statement in self.statements.iter().filter(|statement| object_of(statement) != FILE) {
            let object = object_of(statement);
            let block = statement.blocks.last().map(|block| block.line);
            if *begins.entry(object).or_insert(block) != block {
                let word = statement.blocks.last().map_or("OBJECT", |block| block.word);
                return Err(self.wrong(statement, &format!("one {word} {object} in a label")));
            }
            let first = values.entry((object, &statement.keyword)).or_insert(&statement.value);
            if **first != statement.value {
                return Err(self.wrong(statement, &format!("one {} in {object}", statement.keyword)));
            }
        }
        Ok(())
    }

    /// Whether the statements of an object count.
    fn is_read(&self, decider: &mut Decider, block: &Block) -> Result<bool, SurveyError> {
        let Block { word, name, line } = block;
        let (of, place) = (self.dialect.objects, format!("label line {line}, {word}"));
        let met = Met { of, word: of.of_name(name), place: &place, name, value: name };
        Ok(matches!(decider.decide(met)?, Some(Fate::Used(_))))
    }

    /// The statement for `keyword` in `object`.
    pub fn find(&self, object: &str, keyword: &str) -> Option<&Statement> {
        self.statements.iter().find(|s| s.keyword == keyword && self.dialect.object_of(s) == object)
    }

    /// The statement for `keyword` in the nearest object around `inner`, or at the top.
    pub fn around(&self, inner: &Statement, keyword: &str) -> Option<&Statement> {
        let is_around = |s: &&Statement| s.keyword == keyword && inner.blocks.starts_with(&s.blocks);
        self.statements.iter().filter(is_around).max_by_key(|statement| statement.blocks.len())
    }

    /// Text of a statement; absent where the label says N/A or the like.
    pub fn text(&self, object: &str, keyword: &str) -> Result<Option<&str>, SurveyError> {
        let Some(statement) = self.find(object, keyword) else { return Ok(None) };
        match &statement.value {
            Value::Plain { text, .. } => Ok(Some(text.as_str()).filter(|text| !is_nothing(text))),
            Value::List(_) => Err(self.wrong(statement, "one value")),
        }
    }

    /// A number times its unit; absent where the label says N/A or the like. `unit` has the factor of a unit in capitals,
    /// which is empty where the label gives none.
    pub fn number(
        &self,
        object: &str,
        keyword: &str,
        unit: impl Fn(&str) -> Option<f64>,
    ) -> Result<Option<f64>, SurveyError> {
        let Some(statement) = self.find(object, keyword) else { return Ok(None) };
        self.number_of(statement, &statement.value, unit)
    }

    /// A number that may be a list with one number for each of `bands`, of which `band` counts.
    pub fn of_band(
        &self,
        object: &str,
        keyword: &str,
        [band, bands]: [usize; 2],
        unit: impl Fn(&str) -> Option<f64>,
    ) -> Result<Option<f64>, SurveyError> {
        let Some(statement) = self.find(object, keyword) else { return Ok(None) };
        match &statement.value {
            Value::List(values) if values.len() == bands => self.number_of(statement, &values[band], unit),
            Value::List(_) => Err(self.wrong(statement, "one number, or one for each band")),
            value => self.number_of(statement, value, unit),
        }
    }

    fn number_of(
        &self,
        statement: &Statement,
        value: &Value,
        factor: impl Fn(&str) -> Option<f64>,
    ) -> Result<Option<f64>, SurveyError> {
        let Value::Plain { text, unit } = value else { return Err(self.wrong(statement, "one number")) };
        if is_nothing(text) {
            return Ok(None);
        }
        let number = text.parse::<f64>().ok().filter(|number| number.is_finite());
        let number = number.ok_or_else(|| self.wrong(statement, "a finite number"))?;
        let unit = unit.as_deref().unwrap_or_default().to_ascii_uppercase();
        let factor = factor(&unit).ok_or_else(|| self.wrong(statement, "a unit that is known here"))?;
        Ok(Some(number * factor))
    }

    /// A number above 0, times its unit.
    pub fn positive(
        &self,
        object: &str,
        keyword: &str,
        unit: impl Fn(&str) -> Option<f64>,
    ) -> Result<Option<f64>, SurveyError> {
        let found = self.number(object, keyword, unit)?;
        match self.find(object, keyword).filter(|_| found.is_some_and(|number| number <= 0.0)) {
            Some(statement) => Err(self.wrong(statement, "above 0")),
            None => Ok(found),
        }
    }

    /// A whole number from 0 on, of bytes, bits, lines or samples.
    pub fn count(&self, object: &str, keyword: &str) -> Result<Option<u64>, SurveyError> {
        let Some(statement) = self.find(object, keyword) else { return Ok(None) };
        self.count_of(statement)
    }

    /// The whole number of a statement; absent where the label says N/A or the like.
    pub fn count_of(&self, statement: &Statement) -> Result<Option<u64>, SurveyError> {
        let Some(number) = self.number_of(statement, &statement.value, pieces)? else { return Ok(None) };
        match (0.0..=9e15).contains(&number) && number.fract() == 0.0 {
            true => Ok(Some(number as u64)),
            false => Err(self.wrong(statement, "a whole number, 0 or more")),
        }
    }

    /// The error for a value that cannot be used.
    pub fn wrong(&self, statement: &Statement, expected: &str) -> SurveyError {
        let found = seen(&statement.value.text());
        let advice = "the label is damaged or of a kind not read here";
        field(self.path, place(statement), found, expected, advice)
    }

    /// The error for a keyword that is not there.
    pub fn missing(&self, keyword: &str) -> SurveyError {
        let advice = "the label is incomplete or of a kind not read here";
        field(self.path, format!("label, {keyword}"), "nothing", "a value", advice)
    }
}

/// Where a statement stands, for messages.
pub fn place(statement: &Statement) -> String {
    format!("label line {}, {}", statement.line, seen(&statement.keyword))
}

/// Whether a value says that there is none.
pub fn is_nothing(text: &str) -> bool {
    NOTHING.iter().any(|nothing| text.trim().eq_ignore_ascii_case(nothing))
}

/// Units of what is counted: one piece each.
pub fn pieces(unit: &str) -> Option<f64> {
    let known =
        ["", "BYTE", "BYTES", "BIT", "BITS", "PIX", "PIXEL", "PIXELS", "LINE", "LINES", "SAMPLE", "SAMPLES"];
    known.contains(&unit).then_some(1.0)
}

/// Units of angles, in radians; degrees without a unit.
pub fn angles(unit: &str) -> Option<f64> {
    match unit {
        "" | "DEG" | "DEGREE" | "DEGREES" => Some(quantities::radians(1.0)),
        "RAD" | "RADIAN" | "RADIANS" => Some(1.0),
        _ => None,
    }
}

/// Units of long lengths, in metres; kilometres without a unit.
pub fn kilometres(unit: &str) -> Option<f64> {
    if unit.is_empty() { Some(1000.0) } else { unit::length(unit) }
}

/// Units of the length of a sample, in metres; kilometres a pixel without a unit (PDS data dictionary, MAP_SCALE).
pub fn length_of_sample(unit: &str) -> Option<f64> {
    let (length, sample) = unit.split_once('/').unwrap_or((unit, "PIXEL"));
    ["PIX", "PIXEL", "PIXELS"].contains(&sample.trim()).then(|| kilometres(length.trim())).flatten()
}

/// Units of samples an angle, in samples a radian; pixels a degree without a unit.
pub fn samples_of_angle(unit: &str) -> Option<f64> {
    let (sample, angle) = unit.split_once('/').unwrap_or(("PIXEL", ""));
    let known = ["PIX", "PIXEL", "PIXELS"].contains(&sample.trim()) || unit.is_empty();
    known.then(|| angles(angle.trim())).flatten().map(f64::recip)
}

/// Numbers without a unit.
pub fn plain(unit: &str) -> Option<f64> {
    unit.is_empty().then_some(1.0)
}
