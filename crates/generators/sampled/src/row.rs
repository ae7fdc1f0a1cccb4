//! The row of the registry.

use std::sync::Arc;

use diagnostics::Reader;
use generator::{Generator, Role, Row};

use crate::{Parameters, Sampled};

/// Name of the generator.
pub(crate) const NAME: &str = "sampled";

/// The sampled generator in the registry.
pub static ROW: Row = Row {
    name: NAME,
    about: "triangles by sampling points, with translucency and light points (EP-0611021)",
    role: Role::Guest,
    signals: &[],
    timed: false,
    parameters: Some(NAME),
    gear: None,
    ladder: None,
    configure,
};

fn configure(root: &Reader) -> Option<Arc<dyn Generator>> {
    let parameters = Parameters::read(&root.table_or_empty(NAME))?;
    Some(Arc::new(Sampled { parameters }))
}
