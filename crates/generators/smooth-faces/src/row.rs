//! The row of the registry.

use std::sync::Arc;

use diagnostics::Reader;
use generator::{Gear, Generator, Role, Row};

use crate::faults::FAULTS;
use crate::hardware::{FILE, Hardware, SHIPPED, TABLES};
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
    timed: true,
    parameters: Some(TABLE),
    gear: Some(Gear { tables: &TABLES, file: FILE, text: SHIPPED, faults: &FAULTS }),
    ladders: &[],
    details: &[],
    lamps: &[],
    configure,
};

fn configure(root: &Reader) -> Option<Arc<dyn Generator>> {
    let parameters = Parameters::read(&root.table_or_empty(TABLE));
    let hardware = Hardware::read(root);
    Some(Arc::new(SmoothFaces { parameters: parameters?, hardware: hardware? }))
}
