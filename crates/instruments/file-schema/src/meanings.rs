//! What pages of the docs say of each key.

use std::collections::BTreeMap;

/// Rows of tables whose first column is a key in backticks.
#[derive(Debug, Clone, Default)]
pub struct Meanings(BTreeMap<String, Row>);

#[derive(Debug, Clone)]
struct Row {
    /// Unit and range, as the page has them.
    unit: String,
    default: Option<String>,
    meaning: String,
}

impl Meanings {
    /// Those of a page in Markdown: rows of key, unit, default and meaning, or of key, unit and meaning.
    pub fn of_page(page: &str) -> Self {
        Self(page.lines().filter_map(row).collect())
    }

    /// Keys that have a row.
    pub fn keys(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }

    /// The sentence for a key of this path (`[]` for an element of an array); none if no row has it.
    pub fn of(&self, path: &str) -> Option<String> {
        let key = path.replace("[]", "");
        // The coarse ground has the keys of the fine one.
        let fine = key.replace("landscape.coarse.", "landscape.generated.");
        let Row { unit, default, meaning } = self.0.get(&key).or_else(|| self.0.get(&fine))?;
        let mut text = sentence(meaning);
        if !unit.is_empty() {
            text += &format!(" Value: {unit}.");
        }
        if let Some(default) = default.as_ref().filter(|default| !default.is_empty()) {
            text += &format!(" Default: {default}.");
        }
        Some(text)
    }
}

/// Stands for an escaped bar while cells are parted.
const ESCAPED: &str = "\u{1}";

fn row(line: &str) -> Option<(String, Row)> {
    let rest = line.strip_prefix("| `")?;
    let (key, rest) = rest.split_once("` |")?;
    let cells = rest.trim_end().trim_end_matches('|').replace("\\|", ESCAPED);
    let cells: Vec<String> = cells.split('|').map(|cell| plain(cell).replace(ESCAPED, "|")).collect();
    let row = match &cells[..] {
        [unit, meaning] => Row { unit: unit.clone(), default: None, meaning: meaning.clone() },
        [unit, default, meaning] => {
            Row { unit: unit.clone(), default: Some(default.clone()), meaning: meaning.clone() }
        }
        _ => return None,
    };
    Some((key.to_owned(), row))
}

/// Text without marks of Markdown: links are their words.
fn plain(cell: &str) -> String {
    let mut text = String::new();
    let mut rest = cell.trim();
    while let Some((before, (word, behind))) = link(rest) {
        text += before;
        text += word;
        rest = behind;
    }
    (text + rest).replace(['`', '*'], "").trim().to_owned()
}

/// The first link of a text: what is before it, its words, and what is behind.
fn link(text: &str) -> Option<(&str, (&str, &str))> {
    let middle = text.find("](")?;
    let begin = text[..middle].rfind('[')?;
    let end = middle + text[middle..].find(')')?;
    Some((&text[..begin], (&text[begin + 1..middle], &text[end + 1..])))
}

fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|first| first.to_uppercase().to_string()).unwrap_or_default();
    let text = format!("{first}{}", letters.as_str());
    if text.ends_with('.') { text } else { text + "." }
}
