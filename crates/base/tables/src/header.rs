//! Where the columns of a table stand.

use std::ops::Range;

use crate::form::Form;

/// Where a column stands, and under which of its names.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    /// Index of its cell in a row.
    pub cell: usize,
    /// Name that the header has for it, in small letters.
    pub name: &'static str,
    /// Factor from the unit of that name to the unit of the form.
    pub factor: f64,
}

/// The columns of one table.
#[derive(Debug, Clone, Default)]
pub(crate) struct Header {
    /// For each column of the form, where it stands.
    pub places: Vec<Option<Place>>,
    /// Cells that have no name; they must be empty.
    pub nameless: Vec<usize>,
    /// Number of cells in every row.
    pub width: usize,
}

/// A fault of a header: which bytes, what is wrong, what was expected, what to do.
pub(crate) struct HeaderFault {
    pub at: Range<usize>,
    pub title: String,
    pub expected: String,
    pub help: Option<String>,
}

impl Header {
    /// Columns in the order of `form`, for tables without a header.
    pub fn in_order(form: &Form) -> Self {
        let place =
            |(cell, column): (usize, &crate::Column)| Some(Place { cell, name: column.name, factor: 1.0 });
        let places = form.columns.iter().enumerate().map(place).collect();
        Self { places, nameless: Vec::new(), width: form.columns.len() }
    }

    /// Columns by the names in a header; `cells` are what it says and where.
    pub fn by_name(form: &Form, cells: &[(String, Range<usize>)], faults: &mut Vec<HeaderFault>) -> Self {
        let mut header =
            Self { places: vec![None; form.columns.len()], nameless: Vec::new(), width: cells.len() };
        for (cell, (text, at)) in cells.iter().enumerate() {
            match form.find(text) {
                Some((column, name, factor)) => {
                    let place = Place { cell, name, factor };
                    if let Some(first) = header.places[column].replace(place) {
                        let title = match first.name == name {
                            true => format!("column `{name}` stands twice"),
                            false => format!("columns `{}` and `{name}` say the same", first.name),
                        };
                        faults.push(HeaderFault {
                            at: at.clone(),
                            title,
                            expected: "each column once".into(),
                            help: None,
                        });
                    }
                }
                None if text.is_empty() => header.nameless.push(cell),
                None if form.is_harmless(text) => {}
                None => faults.push(unknown(form, text, at)),
            }
        }
        let all = cells.first().map_or(0..0, |first| first.1.start..cells[cells.len() - 1].1.end);
        for (column, _) in form
            .columns
            .iter()
            .zip(&header.places)
            .filter(|(column, place)| column.is_needed && place.is_none())
        {
            faults.push(missing(form, column.name, all.clone()));
        }
        header
    }
}

/// The fault of a header that lacks a column.
pub(crate) fn missing(form: &Form, name: &str, at: Range<usize>) -> HeaderFault {
    let names: Vec<&str> = form.columns.iter().map(|column| column.name).collect();
    let expected = format!("a header such as {}", names.join(","));
    HeaderFault { at, title: format!("missing column `{name}`"), expected, help: None }
}

fn unknown(form: &Form, text: &str, at: &Range<usize>) -> HeaderFault {
    let names = form.names();
    let nearest = diagnostics::nearest(&text.to_ascii_lowercase(), &names);
    let help = nearest.map(|name| format!("did you mean `{name}`?"));
    let title = format!("unknown column `{}`", crate::row::short(text));
    HeaderFault { at: at.clone(), title, expected: format!("one of {}", names.join(", ")), help }
}
