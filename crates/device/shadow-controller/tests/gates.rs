//! Gates against point-in-polygon, and in cases worked by hand.

use hardware_model::ShadowParts;
use proptest::prelude::*;
use quantities::{Rate, SweepTime, Timebase, radians, sin_cos, unit_interval};
use remote_shadow::{Outlines, Segment};
use shadow_controller::{Gate, SEGMENT_WORDS, ShadowController};
use sweep_program::{LoadLine, LoadTiming, MissCause};

const IDEAL: ShadowParts = ShadowParts::Digital { line_generators: None };

fn controller(parts: ShadowParts) -> ShadowController {
    ShadowController { parts, map_centre: [100.0, 50.0], map_side: 400.0, tells_lines: true }
}

fn direction(azimuth: f64) -> [f64; 2] {
    let (sin, cos) = sin_cos(azimuth);
    [cos, sin]
}

/// `count` sweeps over 50 degrees, evenly in `tan`, as the machine has them.
fn fan(heading: f64, count: usize) -> Vec<[f64; 2]> {
    let tan = libm::tan(radians(25.0));
    (0..count)
        .map(|n| direction(heading + libm::atan(tan * (2.0 * n as f64 / (count - 1) as f64 - 1.0))))
        .collect()
}

fn gates(parts: ShadowParts, eye: [f64; 2], directions: &[[f64; 2]], segments: &[Segment]) -> Vec<Gate> {
    let mut out = vec![Gate { toggles: vec![1.0; 3], ..Gate::default() }];
    controller(parts).gates(eye, directions, 1000.0, &[&Outlines::joined(segments)], &mut out);
    out
}

/// The gate of a sweep to the north that passes a metre a sample, with loads that take as long as `metres`.
fn in_time(slabs: &[Segment], line_generators: Option<u32>, metres: f64, strobes_through: bool) -> Gate {
    in_time_but(slabs, line_generators, (metres, strobes_through), None)
}

/// The same, with the load of a number on time.
fn in_time_but(
    slabs: &[Segment],
    line_generators: Option<u32>,
    (metres, strobes_through): (f64, bool),
    on_time: Option<u32>,
) -> Gate {
    let rate = |hertz| Rate::new(hertz, 1).unwrap();
    let timebase = Timebase::new(rate(10_000), rate(1), 1, 1000, 0).unwrap();
    let words_a_second = f64::from(SEGMENT_WORDS) * 1000.0 / metres;
    let timing = |sweep| {
        Some(LoadTiming {
            line: LoadLine::new(&timebase, (0, sweep), SEGMENT_WORDS, words_a_second),
            strobes_through,
            time_of: SweepTime,
            range_at: |SweepTime(time)| time,
            on_time,
        })
    };
    let mut out = Vec::new();
    let parts = ShadowParts::Digital { line_generators };
    controller(parts).gates_by(
        [0.0; 2],
        &[[1.0, 0.0]],
        1000.0,
        &[&Outlines::joined(slabs)],
        timing,
        &mut out,
    );
    out.remove(0)
}

/// More sweeps than are worked on together: each has the gate that it has alone, to the bit.
#[test]
fn a_sweep_among_many_is_the_sweep_alone() {
    let boxes = (0..40).map(|n| {
        let (ahead, across) = (10.0 + 7.0 * f64::from(n), 60.0 * f64::from(n % 7) / 7.0 - 30.0);
        rectangle([ahead, across], [ahead + 5.0, across + 9.0])
    });
    let segments: Vec<Segment> = boxes.flatten().collect();
    let directions = fan(0.1, 150);
    let together = gates(IDEAL, [0.0; 2], &directions, &segments);
    assert!(together.iter().filter(|gate| !gate.toggles.is_empty()).count() > 100);
    for (gate, direction) in together.iter().zip(&directions) {
        assert_eq!(*gate, gates(IDEAL, [0.0; 2], &[*direction], &segments)[0]);
    }
}

#[test]
fn a_late_boundary_changes_the_gate_when_its_words_come() {
    // Sides along y: all four are wanted from the beginning of the sweep on.
    let slabs = [rectangle([20.0, -1.0], [35.0, 1.0]), rectangle([36.0, -1.0], [60.0, 1.0])].concat();
    let toggles = |metres, strobes| in_time(&slabs, None, metres, strobes).toggles;
    assert_eq!(toggles(9.0, true), [20.0, 35.0, 36.0, 60.0]);
    // Words at 15, 30, 45, 60 m: the third is nine metres late.
    assert_eq!(toggles(15.0, true), [20.0, 35.0, 45.0, 60.0]);
    assert_eq!(toggles(15.0, false), [20.0, 35.0, 60.0]);
    let gate = in_time(&slabs, None, 15.0, true);
    let miss = gate.misses[0];
    assert_eq!((miss.range, miss.due, miss.arrival), (36.0, Some(SweepTime(36.0)), Some(SweepTime(45.0))));
    let slacks: Vec<i64> = gate.loads.iter().map(|load| load.load.slack).collect();
    assert_eq!((gate.misses.len(), slacks, gate.load_ticks), (1, vec![50, 50, -90, 0], 600));
    assert_eq!((miss.line_generator, miss.cause), (Some(2), Some(MissCause::Queue)));
    // On time it acts where it is crossed, and the line is as busy as it was.
    for strobes in [true, false] {
        let on_time = in_time_but(&slabs, None, (15.0, strobes), Some(2));
        assert_eq!(on_time.toggles, [20.0, 35.0, 36.0, 60.0]);
        assert_eq!((on_time.misses.len(), on_time.load_ticks), (0, 600));
        assert_eq!(in_time_but(&slabs, None, (15.0, strobes), Some(3)), in_time(&slabs, None, 15.0, strobes));
    }
    // The fourth finds no generator free, and is no load.
    let three = in_time(&slabs, Some(3), 9.0, true);
    assert_eq!((three.toggles.clone(), three.dropped, three.loads.len()), (vec![20.0, 35.0, 36.0], 1, 3));
    assert_eq!((three.misses[0].range, three.misses[0].cause), (60.0, None));
}

#[test]
fn loads_in_time_change_nothing() {
    let corners = star(5, [60.0, 0.0], 50.0);
    let outline = outline(&corners);
    let quick = in_time(&outline, None, 0.001, false);
    let untimed = gates(IDEAL, [0.0; 2], &[[1.0, 0.0]], &outline).remove(0);
    assert!(!untimed.toggles.is_empty());
    assert_eq!((quick.toggles, quick.dark_at_start), (untimed.toggles, untimed.dark_at_start));
    assert_eq!(quick.most_in_use, untimed.most_in_use);
}

fn one(direction: [f64; 2], segments: &[Segment]) -> Gate {
    gates(IDEAL, [0.0; 2], &[direction], segments).remove(0)
}

fn is_dark(gate: &Gate, range: f64) -> bool {
    gate.dark_at_start ^ (gate.toggles.iter().filter(|&&toggle| toggle <= range).count() % 2 == 1)
}

/// A clockwise star around `centre`, its corners from 0.3 to 1 of `radius` away.
fn star(seed: u64, centre: [f64; 2], radius: f64) -> Vec<[f64; 2]> {
    let corner = |k: u64| {
        let (sin, cos) = sin_cos(radians(30.0) * k as f64);
        let away = radius * (0.3 + 0.7 * unit_interval(seed, &[k]));
        [centre[0] + away * cos, centre[1] + away * sin]
    };
    (0..12).map(corner).collect()
}

fn inside(corners: &[[f64; 2]], place: [f64; 2]) -> bool {
    let pairs = corners.iter().zip(corners.iter().cycle().skip(1));
    let crossed = pairs.filter(|(a, b)| {
        (a[0] > place[0]) != (b[0] > place[0])
            && place[1] < a[1] + (place[0] - a[0]) / (b[0] - a[0]) * (b[1] - a[1])
    });
    crossed.count() % 2 == 1
}

/// The closed outline through `corners`.
fn outline(corners: &[[f64; 2]]) -> Vec<Segment> {
    Outlines::closed(corners).segments().collect()
}

/// A rectangle from `low` to `high` (north, east), clockwise.
fn rectangle(low: [f64; 2], high: [f64; 2]) -> Vec<Segment> {
    outline(&[low, [high[0], low[1]], high, [low[0], high[1]]])
}

proptest! {
    #[test]
    fn the_gate_is_the_union_of_all_outlines(
        stars in prop::collection::vec((0u64..1000, -60.0f64..60.0, -60.0f64..60.0, 1.0f64..40.0), 1..20),
        heading in 0.0f64..6.3,
        ranges in prop::collection::vec(0.01f64..120.0, 20),
    ) {
        let stars: Vec<_> = stars.iter().map(|&(seed, x, y, radius)| star(seed, [x, y], radius)).collect();
        let outlines: Vec<_> = stars.iter().map(|corners| Outlines::closed(corners)).collect();
        let lists: Vec<&Outlines> = outlines.iter().collect();
        let directions = fan(heading, 41);
        let mut out = Vec::new();
        controller(IDEAL).gates([1.5, -2.5], &directions, 1000.0, &lists, &mut out);
        // Who does not ask for line generators has the same changes, however far it looks.
        let (quiet, mut known, mut bare) =
            (ShadowController { tells_lines: false, ..controller(IDEAL) }, Vec::new(), Vec::new());
        for reach in [1000.0, ranges[0]] {
            controller(IDEAL).gates([1.5, -2.5], &directions, reach, &lists, &mut known);
            quiet.gates([1.5, -2.5], &directions, reach, &lists, &mut bare);
            for (gate, bare) in known.iter().zip(&bare) {
                prop_assert_eq!((&gate.toggles, gate.dark_at_start), (&bare.toggles, bare.dark_at_start));
                prop_assert_eq!((gate.united, bare.swings.len(), bare.most_in_use), (bare.united, 0, 0));
            }
        }
        for (gate, d) in out.iter().zip(&directions) {
            prop_assert!(gate.toggles.is_sorted());
            prop_assert!(!is_dark(gate, 1000.0));
            for range in ranges.iter().filter(|&r| gate.toggles.iter().all(|t| (t - r).abs() > 1e-5)) {
                let place = [1.5 + range * d[0], -2.5 + range * d[1]];
                let dark = stars.iter().any(|corners| inside(corners, place));
                prop_assert_eq!(is_dark(gate, *range), dark, "range {}", range);
            }
        }
    }
}

#[test]
fn a_corner_on_the_sweep_counts_once() {
    // A diamond with two corners on the sweep, and one that touches it from either side.
    let diamond = |north: f64, east: f64| {
        outline(&[[north - 1.0, east], [north, east - 1.0], [north + 1.0, east], [north, east + 1.0]])
    };
    assert_eq!(one([1.0, 0.0], &diamond(5.0, 0.0)).toggles, [4.0, 6.0]);
    for side in [-1.0, 1.0] {
        let gate = one([1.0, 0.0], &diamond(5.0, side));
        assert!(!gate.dark_at_start && gate.toggles.is_empty(), "{side}: {gate:?}");
    }
}

#[test]
fn a_sweep_along_an_edge_is_not_crossed_by_it() {
    let left = one([1.0, 0.0], &rectangle([2.0, -3.0], [6.0, 0.0]));
    let right = one([1.0, 0.0], &rectangle([2.0, 0.0], [6.0, 3.0]));
    let dark = |gate: &Gate| gate.toggles == [2.0, 6.0];
    assert!(dark(&left) != dark(&right), "the edge belongs to one side: {left:?} {right:?}");
    let both = [rectangle([2.0, -3.0], [6.0, 0.0]), rectangle([2.0, 0.0], [6.0, 3.0])].concat();
    assert_eq!(one([1.0, 0.0], &both).toggles, [2.0, 6.0]);
}

#[test]
fn overlapping_shadows_unite() {
    let all = [
        rectangle([2.0, -1.0], [6.0, 1.0]),
        rectangle([4.0, -1.0], [9.0, 1.0]),
        rectangle([5.0, -1.0], [5.5, 1.0]),
        rectangle([9.0, -1.0], [12.0, 1.0]),
    ];
    assert_eq!(one([1.0, 0.0], &all.concat()).toggles, [2.0, 12.0], "tiles that touch leave no slit");
}

#[test]
fn an_eye_in_shadow_starts_dark() {
    let gate = one([1.0, 0.0], &rectangle([-4.0, -1.0], [3.0, 1.0]));
    assert!(gate.dark_at_start);
    assert_eq!(gate.toggles, [3.0]);
    let behind = one([1.0, 0.0], &rectangle([-4.0, -1.0], [-3.0, 1.0]));
    assert_eq!(behind, Gate { most_in_use: 0, ..Gate::default() });
}

#[test]
fn nothing_beyond_the_reach() {
    let mut out = Vec::new();
    let far = [rectangle([2.0, -1.0], [60.0, 1.0]), rectangle([70.0, -1.0], [80.0, 1.0])].concat();
    controller(IDEAL).gates([0.0; 2], &[[1.0, 0.0]], 50.0, &[&Outlines::joined(&far)], &mut out);
    assert_eq!(out[0].toggles, [2.0]);
    assert!(!out[0].dark_at_start);
}

#[test]
fn a_boundary_without_a_line_generator_inverts_the_gate() {
    // Each side of these slabs is a segment along y: its y extent is swept at once, since the sweep keeps its y.
    let slabs = [rectangle([2.0, -1.0], [3.0, 1.0]), rectangle([5.0, -1.0], [6.0, 1.0])].concat();
    let with = |count| {
        gates(ShadowParts::Digital { line_generators: count }, [0.0; 2], &[[1.0, 0.0]], &slabs).remove(0)
    };
    let found = |gate: &Gate| (gate.dark_at_start, gate.toggles.clone(), gate.dropped, gate.most_in_use);
    assert_eq!(found(&with(None)), (false, vec![2.0, 3.0, 5.0, 6.0], 0, 4));
    let three = with(Some(3));
    assert_eq!(found(&three), (false, vec![2.0, 3.0, 5.0], 1, 3));
    assert!(is_dark(&three, 500.0), "dark to the end of the sweep");
    assert!(with(Some(0)).toggles.is_empty());
}

#[test]
fn line_generators_that_become_free_serve_again() {
    // Boundaries nearer to x than to y hold one only over their extent along x; two at a time here.
    let slanted =
        |north: f64| outline(&[[north - 2.0, -1.0], [north, -1.0], [north + 4.0, 1.0], [north + 2.0, 1.0]]);
    let all: Vec<Segment> = (0..3).flat_map(|n| slanted(10.0 + 20.0 * f64::from(n))).collect();
    let gate =
        gates(ShadowParts::Digital { line_generators: Some(2) }, [0.0; 2], &[[1.0, 0.0]], &all).remove(0);
    assert_eq!((gate.dropped, gate.toggles.len()), (0, 6), "{gate:?}");
}

#[test]
fn the_scan_converter_shifts_edges_as_its_errors_say() {
    let (offset, gain) = ([0.01, -0.005], 0.02);
    let shadow = rectangle([120.0, 20.0], [150.0, 90.0]);
    let parts = ShadowParts::ScanConverter { offset, gain };
    let gate = gates(parts, [60.0, 50.0], &[[1.0, 0.0]], &shadow).remove(0);
    // About the centre at 100: 120 -> 100 + 20 x 1.02 + 0.01 x 400.
    for (found, expected) in gate.toggles.iter().zip([124.4 - 60.0, 155.0 - 60.0]) {
        assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    }
    assert_eq!((gate.dropped, gate.most_in_use), (0, 0));
    let perfect = ShadowParts::ScanConverter { offset: [0.0; 2], gain: 0.0 };
    let exact = gates(IDEAL, [60.0, 50.0], &[[1.0, 0.0]], &shadow).remove(0);
    assert_eq!(gates(perfect, [60.0, 50.0], &[[1.0, 0.0]], &shadow)[0].toggles, exact.toggles);
}

#[test]
fn two_thousand_segments_in_one_sweep() {
    let slabs: Vec<Segment> = (0..1000)
        .flat_map(|n| rectangle([f64::from(n) * 0.9 + 1.0, -1.0], [f64::from(n) * 0.9 + 1.4, 1.0]))
        .collect();
    let gate = one([1.0, 0.0], &slabs);
    assert_eq!((gate.toggles.len(), gate.dropped, gate.most_in_use), (2000, 0, 2000));
    let sixteen = ShadowParts::Digital { line_generators: Some(16) };
    let gate = gates(sixteen, [0.0; 2], &[[1.0, 0.0]], &slabs).remove(0);
    assert_eq!((gate.toggles.len(), gate.dropped, gate.most_in_use), (16, 1984, 16));
}

#[test]
fn no_sweep_or_no_segment_is_no_fault() {
    assert!(gates(IDEAL, [0.0; 2], &[], &rectangle([1.0, -1.0], [2.0, 1.0])).is_empty());
    assert_eq!(gates(IDEAL, [0.0; 2], &fan(0.0, 2), &[]), vec![Gate::default(); 2]);
    // Opposite directions have no side that is ahead: nothing is crossed.
    assert_eq!(
        gates(IDEAL, [0.0; 2], &[[1.0, 0.0], [-1.0, 0.0]], &rectangle([1.0, -1.0], [2.0, 1.0]))[0],
        Gate::default()
    );
}
