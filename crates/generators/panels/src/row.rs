//! The row of the registry.

use std::sync::Arc;

use diagnostics::Reader;
use generator::{Against, ErrorLadder, Gear, Generator, Role, Row};

use crate::faults::FAULTS;
use crate::name::NAME;
use crate::signals::SIGNALS;
use crate::time::SHIPPED;
use crate::{Hardware, Panels, Parameters};

/// Table of its run parameters.
const TABLE: &str = "panels";

/// The generator in the registry.
pub static ROW: Row = Row {
    name: NAME,
    about: "photographs over panels of ground, seen from anywhere (a thesis of the Naval Postgraduate School, repaired)",
    role: Role::Guest,
    signals: &SIGNALS,
    timed: true,
    parameters: Some(TABLE),
    gear: Some(Gear {
        tables: &["minicomputer"],
        file: "built-in programs/panels.toml",
        text: SHIPPED,
        faults: &FAULTS,
    }),
    ladders: &LADDERS,
    details: &[],
    lamps: &[],
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
    let parameters = Parameters::read(&root.table_or_empty(TABLE));
    let hardware = Hardware::read(root);
    Some(Arc::new(Panels { parameters: parameters?, hardware: hardware? }))
}
