//! What the columns of a table are called.

/// Names of the columns of a table, and what else may stand in its header.
#[derive(Debug, Clone, Copy)]
pub struct Form {
    /// What the table is, as messages call it: "path file".
    pub what: &'static str,
    /// Columns with a meaning; readers name a column by its index here.
    pub columns: &'static [Column],
    /// Names of columns that are harmless: they follow from others and are not read.
    pub harmless: &'static [&'static str],
}

/// A column with a meaning.
#[derive(Debug, Clone, Copy)]
pub struct Column {
    /// Its name in the header, with the unit behind it: `heading_deg`.
    pub name: &'static str,
    /// Its other names, each with the factor from their unit to that of `name`.
    pub also: &'static [(&'static str, f64)],
    /// Whether every table must have it, and every row a value in it.
    pub is_needed: bool,
}

impl Column {
    /// A column that every table must have.
    pub const fn needed(name: &'static str) -> Self {
        Self { name, also: &[], is_needed: true }
    }

    /// A column that a table may have.
    pub const fn optional(name: &'static str) -> Self {
        Self { name, also: &[], is_needed: false }
    }

    /// The same column in other units: names, and the factor from each unit to that of the first name.
    pub const fn also(self, also: &'static [(&'static str, f64)]) -> Self {
        Self { also, ..self }
    }

    /// The name that `text` is, whatever its capitals, and the factor of its unit.
    pub(crate) fn named(&self, text: &str) -> Option<(&'static str, f64)> {
        let names = std::iter::once((self.name, 1.0)).chain(self.also.iter().copied());
        names.into_iter().find(|(name, _)| name.eq_ignore_ascii_case(text))
    }
}

impl Form {
    /// The column that `text` names: index, name and factor.
    pub(crate) fn find(&self, text: &str) -> Option<(usize, &'static str, f64)> {
        let found = self.columns.iter().map(|column| column.named(text)).enumerate();
        found.into_iter().find_map(|(index, named)| named.map(|(name, factor)| (index, name, factor)))
    }

    /// Whether `text` names a column that is not read.
    pub(crate) fn is_harmless(&self, text: &str) -> bool {
        self.harmless.iter().any(|name| name.eq_ignore_ascii_case(text))
    }

    /// Names of all columns that are read, in the order of the form.
    pub(crate) fn names(&self) -> Vec<&'static str> {
        let names = |column: &Column| {
            let also = column.also.iter().map(|(name, _)| *name);
            std::iter::once(column.name).chain(also).collect::<Vec<_>>()
        };
        self.columns.iter().flat_map(names).collect()
    }
}
