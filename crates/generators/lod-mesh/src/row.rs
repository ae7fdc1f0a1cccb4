//! The row of the registry.

use std::sync::Arc;

use diagnostics::Reader;
use generator::{Generator, Role, Row};

use crate::{LodMesh, Parameters};

/// Name of the generator.
pub(crate) const NAME: &str = "lod-mesh";

/// Table of its run parameters.
const TABLE: &str = "lod";

/// The generator in the registry.
pub static ROW: Row = Row {
    name: NAME,
    about: "tiles of ground at levels of detail that morph into one another (a thesis on tests of navigation)",
    role: Role::Guest,
    signals: &[],
    timed: false,
    parameters: Some(TABLE),
    gear: None,
    ladders: &[],
    configure,
};

fn configure(root: &Reader) -> Option<Arc<dyn Generator>> {
    let parameters = Parameters::read(&root.table_or_empty(TABLE))?;
    Some(Arc::new(LodMesh { parameters }))
}
