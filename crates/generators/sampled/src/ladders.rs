//! The ladders of the generator: what its triangles, its sampling points, its limits and its laws do to a picture.

use generator::{Against, ErrorLadder};

/// Without limits: what is left is what the ladder is about.
const UNLIMITED: [(&str, &str); 3] =
    [("sampled.translucent", "-1"), ("sampled.lights", "-1"), ("sampled.beam_layer", "\"raster\"")];

/// Ladders of `lunoid study error`.
pub const LADDERS: [ErrorLadder; 6] = [
    ErrorLadder {
        name: "triangles",
        what: "cells along half the side of a square of ground",
        key: "sampled.ground_cells",
        rungs: &[("16", 16.0), ("32", 32.0), ("64", 64.0), ("128", 128.0), ("256", 256.0)],
        fixed: &[("sampled.pattern", "\"lattice32\""), UNLIMITED[0], UNLIMITED[1]],
        against: Against::Judge,
        order: None,
    },
    ErrorLadder {
        name: "sampling",
        what: "sampling points of a pixel",
        key: "sampled.pattern",
        rungs: &[("\"1\"", 1.0), ("\"4\"", 4.0), ("\"8\"", 8.0), ("\"16\"", 16.0), ("\"lattice32\"", 32.0)],
        fixed: &UNLIMITED,
        against: Against::OwnFaces,
        order: Some((0.75, "an edge is off by the spacing of points, and misses partly cancel along it")),
    },
    ErrorLadder {
        name: "stack",
        what: "translucent surfaces that a sampling point keeps",
        key: "sampled.translucent",
        rungs: &[("0", 1.0), ("1", 2.0), ("2", 3.0), ("4", 5.0), ("8", 9.0)],
        fixed: &[],
        against: Against::Itself(&[("sampled.translucent", "-1")]),
        order: None,
    },
    ErrorLadder {
        name: "lights",
        what: "light points that a sampling point keeps",
        key: "sampled.lights",
        rungs: &[("0", 1.0), ("1", 2.0), ("2", 3.0), ("4", 5.0), ("8", 9.0)],
        fixed: &[],
        against: Against::Itself(&[("sampled.lights", "-1")]),
        order: None,
    },
    ErrorLadder {
        name: "lists",
        what: "triangles that the list of a sub-area holds",
        key: "memory.list_depth",
        rungs: &[("8", 8.0), ("16", 16.0), ("32", 32.0), ("64", 64.0), ("128", 128.0)],
        fixed: &[],
        against: Against::Itself(&[("memory.list_depth", "0")]),
        order: None,
    },
    ErrorLadder {
        name: "blending",
        what: "whether light points hide what is behind them",
        key: "sampled.blending",
        rungs: &[("\"hiding\"", 1.0), ("\"additive\"", 2.0)],
        fixed: &[],
        against: Against::Itself(&[("sampled.blending", "\"additive\"")]),
        order: None,
    },
];
