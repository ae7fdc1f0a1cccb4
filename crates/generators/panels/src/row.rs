//! The row of the registry.

use std::sync::Arc;

use diagnostics::Reader;
use generator::{Against, ErrorLadder, Generator, Role, Row};

use crate::name::NAME;
use crate::{Panels, Parameters};

/// Table of its run parameters.
const TABLE: &str = "panels";

/// The generator in the registry.
pub static ROW: Row = Row {
    name: NAME,
    about: "photographs over panels of ground, seen from anywhere (a thesis of the Naval Postgraduate School, repaired)",
    role: Role::Guest,
    signals: &[],
    timed: false,
    parameters: Some(TABLE),
    gear: None,
    ladders: &LADDERS,
    details: &[],
    configure,
};

/// What the size of panels does to a picture.
const LADDERS: [ErrorLadder; 1] = [ErrorLadder {
    name: "subdivide",
    what: "cells along each side of a cell, each panel of one light",
    key: "panels.subdivide",
    rungs: &[("1", 1.0), ("2", 2.0), ("4", 4.0), ("8", 8.0)],
    fixed: &[("panels.drape", "panel")],
    against: Against::Itself(&[("panels.drape", "texture")]),
    order: None,
}];

fn configure(root: &Reader) -> Option<Arc<dyn Generator>> {
    let parameters = Parameters::read(&root.table_or_empty(TABLE))?;
    Some(Arc::new(Panels { parameters }))
}
