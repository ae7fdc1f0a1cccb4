//! Keys that name an object.

use std::collections::HashMap;

use diagnostics::Reader;

use crate::Object;

/// Ids that a message lists; where there are more, it counts on its reader to know them.
const LISTED: usize = 40;

/// The objects by their ids.
pub(super) struct Ids<'o> {
    listed: Vec<(&'o str, usize)>,
    numbers: HashMap<&'o str, usize>,
}

impl<'o> Ids<'o> {
    pub(super) fn of(objects: &'o [Object]) -> Self {
        let ids = || objects.iter().enumerate().map(|(number, object)| (object.id.as_str(), number));
        Self { listed: ids().take(LISTED + 1).collect(), numbers: ids().collect() }
    }

    /// The object that `key` names; `none` is the message where the scenario has no object.
    pub(super) fn object(&self, table: &Reader, key: &str, none: &str) -> Option<usize> {
        let (title, expected) = match self.listed.len() {
            1..=LISTED => return table.one_of(key, &self.listed).required(),
            0 => (none.to_owned(), "an [[object]] with this id"),
            _ => {
                let id = table.string(key).required()?;
                if let Some(number) = self.numbers.get(id.as_str()) {
                    return Some(*number);
                }
                (format!("no object is called \"{id}\""), "the id of an [[object]]")
            }
        };
        table.report(table.problem(key, title).expected(expected));
        table.string(key).optional();
        None
    }
}
