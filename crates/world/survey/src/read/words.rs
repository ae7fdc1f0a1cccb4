//! Names that files carry (tags, keys, keywords) and what becomes of each.
//!
//! Every format has one table of names. Its reader asks the table about each name that it meets: a name that is not in
//! the table is refused. The page `docs/elevation-words.md` is made from the same tables.

use std::path::Path;

use super::options::ReadOptions;
use super::refusal::{field, visible};
use crate::error::SurveyError;

/// What becomes of a name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fate {
    /// Its value decides heights or their place; the text says how.
    Used(&'static str),
    /// Its value marks stored numbers that are no heights; the text says how.
    Void(&'static str),
    /// Does not change heights or their place; the text says what it is.
    Harmless(&'static str),
    /// One of these values, which change nothing; any other is refused. The text says what it is.
    Only(&'static [&'static str], &'static str),
    /// Cannot be read here; the text says what it is.
    Refused(&'static str),
}

/// A name and what becomes of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Word {
    /// Number of a TIFF tag or geo key, or first byte of a field; 0 for what has a name only.
    pub number: u16,
    /// The name. A star at an end stands for any characters.
    pub name: &'static str,
    /// What becomes of it.
    pub fate: Fate,
}

/// A name without a number.
pub const fn named(name: &'static str, fate: Fate) -> Word {
    Word { number: 0, name, fate }
}

/// A tag or key with its number.
pub const fn numbered(number: u16, name: &'static str, fate: Fate) -> Word {
    Word { number, name, fate }
}

/// The names of one kind that a format has.
#[derive(Debug, Clone, Copy)]
pub struct Vocabulary {
    /// What one of them is, for messages and headings: `TIFF tag`.
    pub kind: &'static str,
    /// What stands before a name of this kind in `--ignore`: `tag:`; empty for keywords of labels.
    pub prefix: &'static str,
    /// All names that are known.
    pub words: &'static [Word],
}

impl Vocabulary {
    /// The row of a tag or key.
    pub fn of_number(&self, number: u16) -> Option<&'static Word> {
        self.words.iter().find(|word| word.number == number)
    }

    /// The row of a name; one without a star goes first. Capitals do not matter.
    pub fn of_name(&self, name: &str) -> Option<&'static Word> {
        let exact = self.words.iter().find(|word| word.name.eq_ignore_ascii_case(name));
        exact.or_else(|| self.words.iter().find(|word| fits(word.name, name)))
    }

    /// The table as Markdown, a row for each name.
    pub fn table(&self) -> String {
        let heading = [self.kind, "what becomes of it", "why"].map(str::to_owned).to_vec();
        let rows = self.words.iter().map(|word| {
            let name = match word.number {
                0 => format!("`{}`", word.name),
                number => format!("{number} `{}`", word.name),
            };
            let (fate, why) = match word.fate {
                Fate::Used(why) => ("used".to_owned(), why),
                Fate::Void(why) => ("used".to_owned(), why),
                Fate::Harmless(why) => ("harmless".to_owned(), why),
                Fate::Only(values, why) => (format!("only {}, else refused", values.join(" or ")), why),
                Fate::Refused(why) => ("refused".to_owned(), why),
            };
            vec![name, fate, why.to_owned()]
        });
        text::markdown(&[heading].into_iter().chain(rows).collect::<Vec<_>>())
    }
}

/// Whether a name fits a pattern with a star at one end or at both.
fn fits(pattern: &str, name: &str) -> bool {
    let (pattern, name) = (pattern.to_ascii_uppercase(), name.to_ascii_uppercase());
    let Some(end) = pattern.strip_prefix('*') else {
        return pattern.strip_suffix('*').is_some_and(|start| name.starts_with(start));
    };
    end.strip_suffix('*').map_or_else(|| name.ends_with(end), |middle| name.contains(middle))
}

/// A name as it was met in a file.
#[derive(Debug, Clone, Copy)]
pub struct Met<'a> {
    /// The table that decides about it.
    pub of: &'a Vocabulary,
    /// The row of the name, if the table has one.
    pub word: Option<&'static Word>,
    /// Where it stands, for messages: a tag, or a line with its keyword.
    pub place: &'a str,
    /// The name, or the number of an unknown tag or key.
    pub name: &'a str,
    /// Its value as text.
    pub value: &'a str,
}

/// Decides about names, and remembers which of those that the user wants ignored were met.
#[derive(Debug)]
pub struct Decider<'a> {
    path: &'a Path,
    ignore: &'a [String],
    ignored: Vec<String>,
}

impl<'a> Decider<'a> {
    /// For one file, with the names that the user wants ignored.
    pub fn new(path: &'a Path, options: &'a ReadOptions) -> Self {
        Self { path, ignore: &options.ignore, ignored: Vec::new() }
    }

    /// The fate of a name; an error if it is refused or unknown. `None`: unknown, and ignored as the user wants.
    pub fn decide(&mut self, met: Met) -> Result<Option<Fate>, SurveyError> {
        let Some(word) = met.word else { return self.unknown(met).map(|()| None) };
        match word.fate {
            Fate::Refused(what) => {
                let expected = format!("a file without {}", word.name);
                let advice = format!("this cannot be read here: {what}");
                Err(field(self.path, met.place, seen(met.value), expected, advice))
            }
            Fate::Only(values, what) if !values.iter().any(|value| same(value, met.value)) => {
                let expected = values.join(" or ");
                let advice = format!("other values cannot be read here: {what}");
                Err(field(self.path, met.place, seen(met.value), expected, advice))
            }
            fate => Ok(Some(fate)),
        }
    }

    fn unknown(&mut self, met: Met) -> Result<(), SurveyError> {
        let name = format!("{}{}", met.of.prefix, met.name);
        if self.ignore.iter().any(|ignored| ignored.eq_ignore_ascii_case(&name)) {
            self.ignored.push(name);
            return Ok(());
        }
        let expected = "a name that docs/elevation-words.md lists";
        let advice = format!("if it changes neither heights nor their place, give --ignore {name}");
        Err(field(self.path, met.place, seen(met.value), expected, advice))
    }

    /// Whether the user wants a check left out that has a name of its own.
    pub fn forgives(&mut self, name: &str) -> bool {
        let is_ignored = self.ignore.iter().any(|ignored| ignored.eq_ignore_ascii_case(name));
        self.ignored.extend(is_ignored.then(|| name.to_owned()));
        is_ignored
    }

    /// Notes about what was ignored; an error if a name that was to be ignored was not met.
    pub fn finish(self) -> Result<Vec<String>, SurveyError> {
        let was_met = |name: &&String| self.ignored.iter().any(|met| met.eq_ignore_ascii_case(name));
        if let Some(name) = self.ignore.iter().find(|name| !was_met(name)) {
            return Err(SurveyError::Option {
                option: "ignore",
                found: name.clone(),
                expected: "a name that stands in the file and is not known here".into(),
            });
        }
        Ok(self.ignored.iter().map(|name| format!("{name} of the file is ignored, as was asked")).collect())
    }
}

/// Whether two values are the same number, or the same text but for capitals.
fn same(a: &str, b: &str) -> bool {
    let equal = a.trim().eq_ignore_ascii_case(b.trim());
    let number = |text: &str| text.trim().parse::<f64>().ok();
    equal || number(a).zip(number(b)).is_some_and(|(a, b)| a == b)
}

/// A value for a message: short, and with control characters made visible.
pub fn seen(value: &str) -> String {
    const MOST: usize = 60;
    let shown = visible(&value.chars().take(MOST).collect::<String>());
    match value.chars().nth(MOST) {
        Some(_) => format!("{shown}..."),
        None if value.is_empty() => "nothing".into(),
        None => shown,
    }
}

#[cfg(test)]
mod tests {
    use super::{fits, same, seen};

    #[test]
    fn patterns_have_stars_at_their_ends() {
        assert!(fits("*_NAME", "target_name") && fits("STATISTICS_*", "STATISTICS_MEAN"));
        assert!(fits("*:*", "LRO:ORBIT") && !fits("*:*", "ORBIT"));
        assert!(!fits("*_NAME", "NAMES") && !fits("LINES", "LINES"));
    }

    #[test]
    fn values_are_compared_as_numbers_where_they_are() {
        assert!(same("0", "0.00") && same("Down", "DOWN") && !same("0", "1") && !same("N/A", "0"));
    }

    #[test]
    fn control_characters_are_seen() {
        assert_eq!(seen("a\0b\u{1b}"), "a\\0b\\u{1b}");
        assert!(seen(&"x".repeat(61)).ends_with("x..."));
    }
}
