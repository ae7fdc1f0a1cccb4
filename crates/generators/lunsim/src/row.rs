//! The row of the registry.

use std::sync::Arc;

use diagnostics::Reader;
use generator::{Against, ErrorLadder, Gear, Generator, Role, Row};

use crate::hardware::SHIPPED;
use crate::rows::SIGNALS;
use crate::{Hardware, Lunsim, Parameters};

/// LUNSIM in the registry.
pub static ROW: Row = Row {
    name: "lunsim",
    about: "the report's program: a ground grid onto the positions of a film recorder",
    role: Role::Guest,
    signals: &SIGNALS,
    timed: true,
    parameters: Some("lunsim"),
    gear: Some(Gear {
        tables: &["computer", "recorder"],
        file: "built-in programs/lunsim.toml",
        text: SHIPPED,
        faults: &[],
    }),
    ladders: &[ErrorLadder {
        name: "grid",
        what: "points a side of LUNSIM's grid, 256 codes",
        key: "lunsim.grid",
        rungs: &[("64", 64.0), ("128", 128.0), ("256", 256.0), ("512", 512.0), ("1024", 1024.0)],
        // So many that the steps of the recorder's codes do not hide those of the grid.
        fixed: &[("lunsim.intensity_codes", "256")],
        against: Against::Judge,
        order: Some((1.0, "a position shows a point up to one step away")),
    }],
    details: &[],
    lamps: &[],
    configure,
};

fn configure(root: &Reader) -> Option<Arc<dyn Generator>> {
    let parameters = Parameters::read(&root.table_or_empty(ROW.name));
    let hardware = Hardware::read(root);
    Some(Arc::new(Lunsim { parameters: parameters?, hardware: hardware? }))
}
