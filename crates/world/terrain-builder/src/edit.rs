//! Adding features to the text of a landscape and removing them. Comments and the order of the other features stay.

use std::str::FromStr;

use toml_edit::{DocumentMut, Item, Table, value};

/// Why a text cannot be edited.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum EditError {
    /// Text that is no TOML.
    #[error("{what} is not valid TOML: {message}; correct it first")]
    Syntax {
        /// Which of the texts it is.
        what: &'static str,
        /// What the parser says.
        message: String,
    },
    /// A block that is not one or more `[[feature]]` tables with names.
    #[error("the block is {found}: expected `[[feature]]` tables, each with an `id`, and nothing else")]
    Block {
        /// What it is instead.
        found: String,
    },
    /// Features of the landscape written as an array in one value.
    #[error(
        "`feature` is a value: expected `[[feature]]` tables, which can be added and removed one by one; write them so"
    )]
    Inline,
    /// A name that a feature has already.
    #[error(
        "a feature {0:?} is there already: expected another `id`; remove that feature first, or rename this one"
    )]
    Taken(String),
    /// A name that no feature has.
    #[error("no feature {id:?}: expected one of {known}")]
    Missing {
        /// Name that was asked for.
        id: String,
        /// Names that there are, in words.
        known: String,
    },
}

/// The text with a block of features behind it.
///
/// # Errors
/// If a text is no TOML, the block is not made of features, or a name is taken.
pub fn add(text: &str, block: &str) -> Result<String, EditError> {
    let there = names(&parsed(text, "the landscape")?)?;
    let added = parsed(block, "the block")?;
    let is_features = added.iter().all(|(key, item)| key == "feature" && item.is_array_of_tables());
    let names = names(&added)?;
    if !is_features || names.is_empty() || names.iter().any(String::is_empty) {
        let keys: Vec<_> = added.iter().map(|(key, _)| format!("`{key}`")).collect();
        let found = if keys.is_empty() { "empty".into() } else { format!("made of {}", keys.join(", ")) };
        return Err(EditError::Block { found });
    }
    for (index, name) in names.iter().enumerate() {
        if there.contains(name) || names[..index].contains(name) {
            return Err(EditError::Taken(name.clone()));
        }
    }
    let gap = if text.is_empty() || text.ends_with("\n\n") {
        ""
    } else if text.ends_with('\n') {
        "\n"
    } else {
        "\n\n"
    };
    let end = if block.ends_with('\n') { "" } else { "\n" };
    Ok(format!("{text}{gap}{block}{end}"))
}

/// The text without a feature; the comments above its header go with it.
///
/// # Errors
/// If the text is no TOML, or no feature has the name.
pub fn remove(text: &str, id: &str) -> Result<String, EditError> {
    let mut document = parsed(text, "the landscape")?;
    let names = names(&document)?;
    let Some(index) = names.iter().position(|name| name == id) else {
        let known = if names.is_empty() { "none".into() } else { names.join(", ") };
        return Err(EditError::Missing { id: id.into(), known });
    };
    if let Some(features) = document.get_mut("feature").and_then(Item::as_array_of_tables_mut) {
        features.remove(index);
        if features.is_empty() {
            document.remove("feature");
        }
    }
    Ok(document.to_string())
}

/// The text with an elevation file as its base. `file` is the path from the folder of the landscape.
///
/// # Errors
/// If the text is no TOML.
pub fn import(text: &str, file: &str, band: Option<usize>) -> Result<String, EditError> {
    let mut document = parsed(text, "the landscape")?;
    let mut base = Table::new();
    base.insert("file", value(file));
    if let Some(band) = band {
        base.insert("band", value(band as i64));
    }
    match document.get_mut("base") {
        Some(there) => *there = Item::Table(base),
        None => {
            document.insert("base", Item::Table(base));
        }
    }
    Ok(document.to_string())
}

fn parsed(text: &str, what: &'static str) -> Result<DocumentMut, EditError> {
    let said = |error: toml_edit::TomlError| EditError::Syntax { what, message: error.message().into() };
    DocumentMut::from_str(text).map_err(said)
}

/// Names of all features in the order of the text; an empty one where a feature has none.
fn names(document: &DocumentMut) -> Result<Vec<String>, EditError> {
    let name = |table: &Table| table.get("id").and_then(Item::as_str).unwrap_or_default().to_owned();
    match document.get("feature") {
        None => Ok(Vec::new()),
        Some(Item::ArrayOfTables(tables)) => Ok(tables.iter().map(name).collect()),
        Some(_) => Err(EditError::Inline),
    }
}
