//! Displaced edges against the crossing of displaced lines.

use hardware_model::{AnalogParts, ShadowParts};
use parts::{GateEdge, Spread};
use proptest::prelude::{prop_assert, proptest};
use remote_shadow::Outlines;

use super::PartsLines;
use crate::{Gate, ShadowController};

/// The side of the square.
const FULL_SCALE: f64 = 120.0;
const ONE: ShadowParts = ShadowParts::Digital { line_generators: Some(1) };

fn lines(error: f64, hysteresis: f64) -> PartsLines {
    let mut parts = AnalogParts::ideal();
    (parts.shadow_line.error, parts.comparator.hysteresis) = (error, hysteresis);
    PartsLines::new(&ONE, &parts, 1970).unwrap()
}

/// Toggles of a sweep over a square of shadow, turned by `turn`, with its middle at `middle`.
fn gate(middle: [f64; 2], turn: f64, azimuth: f64) -> Gate {
    let (c, s) = (libm::cos(turn), libm::sin(turn));
    let corner = |[a, b]: [f64; 2]| [middle[0] + 60.0 * (a * c - b * s), middle[1] + 60.0 * (a * s + b * c)];
    let corners = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].map(corner);
    // Shadow to the right of each segment.
    let square = Outlines::closed(&corners);
    let controller = ShadowController {
        parts: ShadowParts::default(),
        map_centre: [0.0; 2],
        map_side: 1e4,
        tells_lines: true,
    };
    let mut out = Vec::new();
    let direction = [libm::cos(azimuth), libm::sin(azimuth)];
    controller.gates([0.0; 2], &[direction], 4000.0, &[&square], &mut out);
    out.remove(0)
}

proptest! {
    /// The reference: both lines displaced by the error in y (or in x, where they are nearer to y), met anew.
    #[test]
    fn an_edge_moves_to_where_the_displaced_line_is_met(
        turn in 0.1..1.4_f64, azimuth in -0.02..0.02_f64, seed_error in 0.0005..0.003_f64,
    ) {
        let middle = [1000.0, 0.0];
        let gate = gate(middle, turn, azimuth);
        let lines = lines(seed_error, 0.0);
        let error = FULL_SCALE * Spread::new(1970).error("sc.line-generator", 0, seed_error);
        let mut found = Vec::new();
        lines.displace(&gate, &mut found);
        prop_assert!(gate.toggles.len() == 2 && found.len() == 2);
        let direction = [libm::cos(azimuth), libm::sin(azimuth)];
        for (index, &range) in gate.toggles.iter().enumerate() {
            // The side of the square that is met, by its normal.
            let place = [range * direction[0] - middle[0], range * direction[1] - middle[1]];
            let normals = [0.0, 0.5, 1.0, 1.5].map(|quarter| {
                let angle = turn + quarter * std::f64::consts::PI;
                [libm::cos(angle), libm::sin(angle)]
            });
            let on = |n: &&[f64; 2]| (place[0] * n[0] + place[1] * n[1] - 60.0).abs() < 1e-6;
            let n = normals.iter().find(on).unwrap();
            // Along a line n.p is constant; it is nearer to y where n points along x: then x is displaced, else y.
            let rate = n[0] * direction[0] + n[1] * direction[1];
            let out = if n[0].abs() > n[1].abs() { n[0] } else { n[1] };
            prop_assert!(rate.abs() < 0.1 * out.abs() || {
                let expected = range + error * out / rate;
                found.iter().any(|found| (found.range - expected).abs() < 1e-6)
            }, "{index}: {found:?}");
        }
    }
}

/// A13: hysteresis moves both edges outwards alike, and a shadow keeps its width.
#[test]
fn hysteresis_moves_both_edges_away_from_the_viewer() {
    let (gate, mut found) = (gate([1000.0, 0.0], 0.0, 0.0), Vec::new());
    lines(0.0, 0.001).displace(&gate, &mut found);
    assert_eq!(found.len(), 2);
    for (found, edge) in found.iter().zip([940.0, 1060.0]) {
        assert!((found.range - edge - 0.06).abs() < 1e-9, "{found:?}");
    }
}

/// On the ramp that a comparator sees an offset V is `V / s`, either way: here against the same line displaced.
#[test]
fn an_offset_moves_an_edge_by_itself_over_the_slope() {
    let (gate, mut found) = (gate([1000.0, 0.0], 0.3, 0.01), Vec::new());
    let mut parts = AnalogParts::ideal();
    (parts.full_scale, parts.comparator.offset) = (10.0, 5e-3);
    PartsLines::new(&ONE, &parts, 1970).unwrap().displace(&gate, &mut found);
    let offset = Spread::new(1970).error("sc.comparator.offset", 0, 5e-4);
    assert!(offset.abs() > 1e-5 && found.len() == 2);
    for (edge, right) in found.iter().zip(gate.edges()) {
        // Square of 120 m turned by 0.3: its sides part from a sweep by cos 0.29 / cos 0.3 a metre, of 120 m.
        let slope = libm::cos(0.29) / libm::cos(0.3) / FULL_SCALE;
        assert!((edge.slope - slope).abs() < 1e-12, "{edge:?} {slope}");
        // Both sides part from the sweep the same way.
        let moved = gate.swings[0].signum() * offset / slope;
        assert!((edge.range - right.range - moved).abs() < 1e-9, "{edge:?} {right:?} {moved}");
    }
    // One comparator, two parallel sides: the shadow is moved and keeps its width.
    let width = |edges: &[GateEdge]| edges[1].range - edges[0].range;
    assert!((width(&found) - width(&gate.edges().collect::<Vec<_>>())).abs() < 1e-9);
}

#[test]
fn edges_that_pass_each_other_stay_in_order_and_none_is_lost() {
    let gate =
        Gate { toggles: vec![100.0, 100.5, 101.0], swings: vec![100.0, -100.0, 1000.0], ..Gate::default() };
    let mut found = vec![GateEdge { range: 7.0, slope: 1.0 }];
    lines(0.003, 0.0).displace(&gate, &mut found);
    assert!(found.len() == 3 && found.windows(2).all(|pair| pair[0].range <= pair[1].range));
    lines(0.0, 0.0).displace(&gate, &mut found);
    assert_eq!(found, gate.edges().collect::<Vec<_>>());
}

#[test]
fn a_scan_converter_has_no_line_generators() {
    let tube = ShadowParts::ScanConverter { offset: [0.0; 2], gain: 0.0 };
    assert_eq!(PartsLines::new(&tube, &AnalogParts::ideal(), 0), None);
}

/// A sweep that meets no line, in shadow all the way to the reach: the edge there is no line generator's, and it is an edge.
#[test]
fn a_dark_sweep_ends_at_the_reach() {
    let mut gate = Gate { dark_at_start: true, ..Gate::default() };
    gate.end_at(300.0);
    let mut edges = Vec::new();
    lines(0.01, 0.01).displace(&gate, &mut edges);
    assert_eq!(edges, gate.edges().collect::<Vec<_>>());
    assert_eq!(edges.iter().map(|edge| edge.range).collect::<Vec<_>>(), [300.0]);
}
