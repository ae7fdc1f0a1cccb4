//! The row of the registry.

use std::sync::Arc;

use diagnostics::Reader;
use generator::{Generator, Role, Row};

use crate::name::NAME;
use crate::signals::SIGNALS;
use crate::{Parameters, SmoothFaces};

/// Table of its run parameters.
const TABLE: &str = "faces";

/// The generator in the registry.
pub static ROW: Row = Row {
    name: NAME,
    about: "smooth-shaded faces on vertical scan lines, a sun for every list (Link's study of sea state for NASA Ames)",
    role: Role::Guest,
    signals: &SIGNALS,
    timed: false,
    parameters: Some(TABLE),
    gear: None,
    ladders: &[],
    details: &[],
    configure,
};

fn configure(root: &Reader) -> Option<Arc<dyn Generator>> {
    let parameters = Parameters::read(&root.table_or_empty(TABLE))?;
    Some(Arc::new(SmoothFaces { parameters }))
}
