//! Which record of which store.

/// A record of one of the stores that share the drums.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Key {
    /// Number of the store in its bank.
    pub(crate) store: u32,
    /// Number of the record in its store.
    pub(crate) record: u32,
}
