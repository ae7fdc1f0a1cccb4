//! The row of the registry.

use std::sync::Arc;

use diagnostics::Reader;
use generator::{Against, DetailWay, ErrorLadder, Gear, Generator, Role, Row};

use crate::faults::FAULTS;
use crate::name::NAME;
use crate::signals::SIGNALS;
use crate::time::{FILE, SHIPPED, TABLES};
use crate::{Hardware, LodMesh, Parameters};

/// Table of its run parameters.
const TABLE: &str = "lod";

/// The generator in the registry.
pub static ROW: Row = Row {
    name: NAME,
    about: "tiles of ground at levels of detail that morph into one another (a thesis on tests of navigation)",
    role: Role::Guest,
    signals: &SIGNALS,
    timed: true,
    parameters: Some(TABLE),
    gear: Some(Gear { tables: &TABLES, file: FILE, text: SHIPPED, faults: &FAULTS }),
    ladders: &LADDERS,
    details: &DETAILS,
    lamps: &[],
    configure,
};

/// The curves of chapter 6: the finest ground alone, levels that switch, levels that morph.
const DETAILS: [DetailWay; 3] = [
    DetailWay { name: "finest", sets: &[("lod.levels", "1")] },
    DetailWay { name: "switching", sets: &[("lod.transition", "switch")] },
    DetailWay { name: "morphing", sets: &[("lod.transition", "morph")] },
];

/// What levels, posts and sampling points do to a picture.
const LADDERS: [ErrorLadder; 3] = [
    ErrorLadder {
        name: "tolerance",
        what: "error of a level where its range begins, in pixels",
        key: "lod.tolerance_px",
        rungs: &[("16", 0.0625), ("8", 0.125), ("4", 0.25), ("2", 0.5), ("1", 1.0), ("0.5", 2.0)],
        fixed: &[("lod.ranges_m", "[]")],
        against: Against::Itself(&[("lod.levels", "1")]),
        order: None,
    },
    ErrorLadder {
        name: "posts",
        what: "distance of posts over the ground, in metres",
        key: "lod.spacing_m",
        rungs: &[("160", 1.0 / 160.0), ("80", 1.0 / 80.0), ("40", 1.0 / 40.0), ("20", 1.0 / 20.0)],
        fixed: &[("lod.levels", "1"), ("lod.pattern", "lattice32")],
        against: Against::Judge,
        order: None,
    },
    ErrorLadder {
        name: "sampling",
        what: "sampling points of a pixel",
        key: "lod.pattern",
        rungs: &[("\"1\"", 1.0), ("\"4\"", 4.0), ("\"8\"", 8.0), ("\"16\"", 16.0), ("lattice32", 32.0)],
        fixed: &[],
        against: Against::OwnFaces,
        order: Some((0.75, "an edge is off by the spacing of points, and misses partly cancel along it")),
    },
];

fn configure(root: &Reader) -> Option<Arc<dyn Generator>> {
    let parameters = Parameters::read(&root.table_or_empty(TABLE));
    let hardware = Hardware::read(root);
    Some(Arc::new(LodMesh { parameters: parameters?, hardware: hardware? }))
}
