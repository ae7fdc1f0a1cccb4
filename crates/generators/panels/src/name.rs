//! What the generator is called.

/// Name of the generator, as `--machine` says it.
pub(crate) const NAME: &str = "panels";
