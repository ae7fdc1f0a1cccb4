//! The third video switch: order, cutting by the ground, mixing into lines.

use polyhedron_generator::{Hold, NearTable, NoHold, Overlay, Run, SIGNALS, Span, SpanTable};
use proptest::collection::vec;
use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};
use scenario::{BodyVisibility, PixelRule};

/// A face across lines `top` to `bottom` at one range, of an object with its own foot point.
fn wall(lines: [f32; 2], range: f32, reflectivity: f32, object: u32, foot_range: f32) -> Span {
    let near = 1.0 / range;
    Span {
        top: lines[0],
        bottom: lines[1],
        reflectivity,
        ramp: 0.0,
        near: [near; 2],
        depth: [near; 2],
        body: object,
        object,
        foot_range,
    }
}

/// A face that leans from one range at the top to another at the bottom.
fn slope(lines: [f32; 2], ranges: [f32; 2], reflectivity: f32) -> Span {
    let near = ranges.map(|range| 1.0 / range);
    Span { near, depth: near, ..wall(lines, 1.0, reflectivity, 0, ranges[1]) }
}

/// No ground in front of anything.
const OPEN: Option<&NoHold> = None;

fn runs<L: Fn(usize) -> f32>(spans: &[Span], by: BodyVisibility, hold: Option<&Hold<L>>) -> Vec<Run> {
    Overlay::default().compose(SpanTable::of_sweep(spans).sweep(0), by, hold).to_vec()
}

fn ends(runs: &[Run]) -> Vec<[f32; 3]> {
    runs.iter().map(|run| [run.top, run.bottom, run.reflectivity]).collect()
}

#[test]
fn as_reported_the_nearer_foot_lies_on_top_and_parts_of_an_object_by_depth() {
    // The far object leans over the near one: its face there is nearer, its foot is not.
    let spans = [
        wall([10.0, 20.0], 4.0, 0.9, 7, 12.0),
        wall([15.0, 30.0], 6.0, 0.2, 3, 8.0),
        wall([25.0, 28.0], 5.0, 0.5, 3, 8.0),
    ];
    let reported = runs(&spans, BodyVisibility::AsReported, OPEN);
    assert_eq!(ends(&reported), [[10.0, 15.0, 0.9], [15.0, 25.0, 0.2], [25.0, 28.0, 0.5], [28.0, 30.0, 0.2]]);
    let depth = runs(&spans, BodyVisibility::Depth, OPEN);
    assert_eq!(ends(&depth), [[10.0, 20.0, 0.9], [20.0, 25.0, 0.2], [25.0, 28.0, 0.5], [28.0, 30.0, 0.2]]);
}

#[test]
fn what_lies_nearer_than_a_depth_ends_where_a_leaning_face_passes_it() {
    let spans = [slope([0.0, 40.0], [4.0, 12.0], 0.3), wall([50.0, 60.0], 6.0, 0.6, 1, 6.0)];
    let table = SpanTable::of_sweep(&spans);
    let mut overlay = Overlay::default();
    overlay.compose(table.sweep(0), BodyVisibility::Depth, OPEN);
    let nearer = |range: f32| overlay.nearer_than(table.sweep(0), 1.0 / range).collect::<Vec<_>>();
    // Inverse range 1/4 - s/6 is 1/7 at s = 9/14.
    let [leaning, upright] = nearer(7.0)[..] else { panic!("{:?}", nearer(7.0)) };
    assert!(leaning[0] == 0.0 && (leaning[1] - 40.0 * 9.0 / 14.0).abs() < 1e-4, "{leaning:?}");
    assert_eq!(upright, [50.0, 60.0]);
    assert_eq!(nearer(13.0), [[0.0, 40.0], [50.0, 60.0]]);
    assert!(nearer(3.0).is_empty());
}

#[test]
fn faces_that_cross_change_over_where_they_cross() {
    let spans = [slope([0.0, 40.0], [4.0, 12.0], 0.3), wall([0.0, 40.0], 6.0, 0.6, 1, 6.0)];
    // Inverse ranges 1/4 - s/6 and 1/6 meet at s = 1/2.
    let crossed = runs(&spans, BodyVisibility::Depth, OPEN);
    assert_eq!(crossed.len(), 2);
    assert!((crossed[0].bottom - 20.0).abs() < 1e-4, "{crossed:?}");
    assert_eq!((crossed[0].reflectivity, crossed[1].reflectivity), (0.3, 0.6));
}

#[test]
fn lines_are_mixed_by_cover_or_set_at_their_centre() {
    let spans = [wall([1.25, 3.6], 4.0, 0.8, 0, 4.0), wall([3.6, 3.8], 4.0, 0.4, 0, 4.0)];
    let mut overlay = Overlay::default();
    let mut row = [0.2f32; 5];
    overlay.overlay(
        SpanTable::of_sweep(&spans).sweep(0),
        BodyVisibility::Depth,
        OPEN,
        PixelRule::LineMean,
        &mut row,
    );
    let expected = [0.2, 0.25 * 0.2 + 0.75 * 0.8, 0.8, 0.6 * 0.8 + 0.2 * 0.4 + 0.2 * 0.2, 0.2];
    assert!(row.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6), "{row:?}");
    let mut gate = [0f32; 5];
    overlay.present(PixelRule::LineMean, &mut gate);
    assert!(gate.iter().zip([0.0, 0.75, 1.0, 0.8, 0.0]).all(|(a, b)| (a - b).abs() < 1e-6));
    let mut row = [0.2f32; 5];
    overlay.overlay(
        SpanTable::of_sweep(&spans).sweep(0),
        BodyVisibility::Depth,
        OPEN,
        PixelRule::Centre,
        &mut row,
    );
    assert_eq!(row, [0.2, 0.8, 0.8, 0.8, 0.2]);
}

#[test]
fn what_reaches_beyond_the_picture_is_cut_off() {
    let spans = [wall([-7.5, 2.5], 4.0, 0.8, 0, 4.0), wall([8.5, 1e6], 5.0, 0.4, 1, 5.0)];
    for rule in [PixelRule::LineMean, PixelRule::Centre] {
        let mut row = [0f32; 10];
        Overlay::default().overlay(
            SpanTable::of_sweep(&spans).sweep(0),
            BodyVisibility::Depth,
            OPEN,
            rule,
            &mut row,
        );
        assert_eq!((row[0], row[5], row[9]), (0.8, 0.0, 0.4));
    }
    let mut row = [0.5f32; 3];
    Overlay::default().overlay(
        SpanTable::default().sweep(0),
        BodyVisibility::Depth,
        OPEN,
        PixelRule::LineMean,
        &mut row,
    );
    assert_eq!(row, [0.5; 3]);
}

/// Level ground, eye 1.5 m above it, line `100 + 100 (1.5 / range) / 0.3`, with samples every 0.25 m from 2 m.
fn level(rise: impl Fn(f32) -> f32) -> (NearTable, Vec<f32>) {
    let ranges = (0..400).map(|sample| 2.0 + 0.25 * sample as f32);
    let line = |range: f32| 100.0 + 100.0 * (1.5 - rise(range)) / range / 0.3;
    let mut held = f32::INFINITY;
    let hold = |range: f32| {
        held = held.min(line(range));
        held
    };
    (NearTable::new(ranges.clone().map(|range| 1.0 / range)), ranges.map(hold).collect())
}

#[test]
fn level_ground_cuts_off_what_lies_below_it() {
    let (near, lines) = level(|_| 0.0);
    let hold = Hold { near: &near, lines: |sample: usize| lines[sample] };
    // A wall 9.1 m away from 0.5 m above to 0.4 m below ground.
    let line = |range: f32, up: f32| 100.0 + 100.0 * (1.5 - up) / range / 0.3;
    let buried = wall([line(9.1, 0.5), line(9.1, -0.4)], 9.1, 0.5, 0, 9.1);
    let cut = runs(&[buried], BodyVisibility::Depth, Some(&hold));
    assert_eq!(cut.len(), 1);
    assert!((cut[0].bottom - line(9.1, 0.0)).abs() < 1e-3, "{cut:?}");
    // A face that leans away, from 0.5 m up at 9.6 m to 0.5 m deep at 8.1 m: at ground in the middle, 8.85 m.
    let leaning = slope([line(9.6, 0.5), line(8.1, -0.5)], [9.6, 8.1], 0.5);
    let cut = runs(&[leaning], BodyVisibility::Depth, Some(&hold));
    assert!((cut[0].bottom - line(8.85, 0.0)).abs() < 2e-3, "{cut:?}, {}", line(8.85, 0.0));
    // As reported, bodies are seen as a whole.
    assert_eq!(runs(&[buried], BodyVisibility::AsReported, Some(&hold))[0].bottom, buried.bottom);
    // Ground that is not drawn hides nothing.
    let close = wall([line(1.9, 0.5), line(1.9, -0.4)], 1.9, 0.5, 0, 1.9);
    assert_eq!(runs(&[close], BodyVisibility::Depth, Some(&hold))[0].bottom, close.bottom);
}

#[test]
fn a_ridge_hides_what_stands_behind_it_and_not_what_stands_before() {
    let (near, lines) = level(|range| if (range - 10.0).abs() < 0.6 { 1.0 } else { 0.0 });
    let hold = Hold { near: &near, lines: |sample: usize| lines[sample] };
    let line = |range: f32, up: f32| 100.0 + 100.0 * (1.5 - up) / range / 0.3;
    let before = wall([line(8.0, 0.8), line(8.0, 0.0)], 8.0, 0.5, 0, 8.0);
    assert_eq!(ends(&runs(&[before], BodyVisibility::Depth, Some(&hold)))[0][0], before.top);
    let behind = wall([line(20.0, 2.0), line(20.0, 0.0)], 20.0, 0.5, 0, 20.0);
    let cut = runs(&[behind], BodyVisibility::Depth, Some(&hold));
    let crest = line(10.5, 1.0);
    assert!((cut[0].bottom - crest).abs() < 1e-3, "{cut:?}, {crest}");
    let low = wall([line(20.0, 0.4), line(20.0, 0.0)], 20.0, 0.5, 0, 20.0);
    assert_eq!(runs(&[low], BodyVisibility::Depth, Some(&hold)), []);
    assert_eq!(runs(&[low], BodyVisibility::AsReported, Some(&hold)).len(), 1);
}

#[test]
fn signals_are_on_the_display_axis() {
    assert!(
        SIGNALS.iter().all(|signal| signal.name.starts_with("pg.") && signal.axis == signal::Axis::Display)
    );
}

proptest! {
    #[test]
    fn every_line_position_shows_the_nearest(
        faces in vec(([0.0..100.0f32, 1.0..60.0], [2.0..20.0f32, 2.0..20.0]), 1..12),
    ) {
        let span = |(index, &([top, height], ranges)): (usize, &([f32; 2], [f32; 2]))| {
            Span { object: index as u32, reflectivity: index as f32, ..slope([top, top + height], ranges, 0.0) }
        };
        let spans: Vec<Span> = faces.iter().enumerate().map(span).collect();
        let shown = runs(&spans, BodyVisibility::Depth, OPEN);
        for number in 0..1600 {
            let place = 0.1 * number as f32 + 0.0437;
            let depth = |span: &&Span| span.depth_at((place - span.top) / (span.bottom - span.top));
            let covering = spans.iter().filter(|span| span.top <= place && place <= span.bottom);
            // Where two runs touch, both are there.
            let there = shown.iter().filter(|run| run.top <= place && place <= run.bottom);
            let seen = there.map(|run| &spans[run.reflectivity as usize]);
            let nearer = |a: &&Span, b: &&Span| depth(a).total_cmp(&depth(b));
            match (covering.max_by(nearer), seen.max_by(nearer)) {
                (Some(nearest), Some(found)) => {
                    prop_assert!(depth(&nearest) - depth(&found) < 1e-4, "at {place}: {found:?}, {nearest:?}");
                }
                (nearest, found) => {
                    prop_assert!(nearest.is_none() && found.is_none(), "at {place}: {nearest:?} {found:?}");
                }
            }
        }
    }

    /// Ends that coincide, faces that touch, nest and leave gaps, and faces of no height.
    #[test]
    fn runs_part_at_ends_only_and_cover_what_a_face_covers(
        faces in vec((0..30u8, 0..9u8, 2.0..20.0f32), 0..30),
    ) {
        let lines = |top: u8, height: u8| [f32::from(top) - 3.0, f32::from(top + height) - 3.0];
        let spans: Vec<Span> = faces.iter().map(|&(top, height, range)| wall(lines(top, height), range, 0.5, 0, range)).collect();
        let shown = runs(&spans, BodyVisibility::Depth, OPEN);
        let mut rest = &shown[..];
        for step in -4..50 {
            let (top, bottom) = (step as f32, (step + 1) as f32);
            let is_end = |line: f32| spans.iter().any(|span| span.top == line || span.bottom == line);
            let is_covered = spans.iter().any(|span| span.top <= top && bottom <= span.bottom);
            let run = rest.first().filter(|run| run.top <= top && bottom <= run.bottom);
            prop_assert_eq!(run.is_some(), is_covered, "lines {} to {} of {:?}", top, bottom, &shown);
            let Some(run) = run else { continue };
            prop_assert!(is_end(run.top), "{run:?}");
            if run.bottom == bottom {
                prop_assert!(is_end(bottom), "{run:?}");
                rest = &rest[1..];
            }
        }
        prop_assert_eq!(rest, &[]);
    }

    /// Spans that follow one another are laid as one stack, others one by one; the order in which they are given shows nothing else.
    #[test]
    fn stacks_show_what_their_spans_show_one_by_one(
        stacks in vec((0.0..60.0f32, vec((0.5..12.0f32, 2.0..20.0f32), 2..5)), 1..8), swap in any::<bool>(),
    ) {
        let (mut spans, mut lone) = (Vec::new(), Vec::new());
        for (object, (mut top, steps)) in (0..).zip(stacks) {
            for pair in steps.windows(2) {
                let [(height, range), (_, next)] = [pair[0], pair[1]];
                let reflectivity = spans.len() as f32;
                let foot_range = 4.0 + ((5 * object) % 7) as f32;
                spans.push(Span { object, foot_range, ..slope([top, top + height], [range, next], reflectivity) });
                top += height;
            }
        }
        // Neighbours in a list that do not touch are no stack.
        lone.extend(spans.iter().step_by(2).copied());
        lone.extend(spans.iter().skip(1).step_by(2).copied());
        let by = if swap { BodyVisibility::AsReported } else { BodyVisibility::Depth };
        let [together, alone] = [&spans, &lone].map(|spans| runs(spans, by, OPEN));
        for number in 0..1000 {
            let place = 0.1 * number as f32 + 0.0437;
            let shown = |runs: &[Run]| runs.iter().find(|run| run.top + 1e-3 < place && place < run.bottom - 1e-3).copied();
            if let (Some(one), Some(other)) = (shown(&together), shown(&alone)) {
                prop_assert_eq!(one.reflectivity, other.reflectivity, "at {}", place);
            }
        }
        let covered = |runs: &[Run]| runs.iter().map(|run| run.bottom - run.top).sum::<f32>();
        prop_assert!((covered(&together) - covered(&alone)).abs() < 1e-3);
    }

    /// Lines that a run covers as a whole are filled at once; nothing shows it.
    #[test]
    fn lines_are_covered_as_if_each_were_mixed_alone(
        faces in vec((-5.0..60.0f32, 0.0..30.0f32, 0..2u8), 0..12), before in 0.0..1.0f32, whole in any::<bool>(),
    ) {
        let (mut spans, mut top) = (Vec::new(), -4.0f32);
        for &(value, height, gap) in &faces {
            let height = if whole { height.round() } else { height };
            top += f32::from(gap) * 1.5;
            spans.push(wall([top, top + height], 4.0, value.abs(), 0, 4.0));
            top += height;
        }
        let mut overlay = Overlay::default();
        let shown = overlay.compose(SpanTable::of_sweep(&spans).sweep(0), BodyVisibility::Depth, OPEN).to_vec();
        let mut mean = [before; 64];
        overlay.write(PixelRule::LineMean, &mut mean);
        let mut centre = [before; 64];
        overlay.write(PixelRule::Centre, &mut centre);
        for line in 0..64 {
            let (from, to) = (line as f32, line as f32 + 1.0);
            let (mut cover, mut sum) = (0.0f32, 0.0f32);
            for run in shown.iter().filter(|run| run.top < to && run.bottom > from) {
                let share = run.bottom.min(to) - run.top.max(from);
                cover += share;
                sum += share * run.reflectivity;
            }
            let expected = if cover > 0.0 { before * (1.0 - cover).max(0.0) + sum } else { before };
            prop_assert_eq!(mean[line], expected, "line {} of {:?}", line, &shown);
            let middle = shown.iter().rfind(|run| run.top <= from + 0.5 && from + 0.5 < run.bottom);
            prop_assert_eq!(centre[line], middle.map_or(before, |run| run.reflectivity), "line {}", line);
        }
    }
}

/// A wall whose light runs from one reflectivity at the top to another at the bottom.
fn ramped(lines: [f32; 2], reflectivities: [f32; 2]) -> Span {
    let ramp = (reflectivities[1] - reflectivities[0]) / (lines[1] - lines[0]);
    Span { ramp, ..wall(lines, 5.0, reflectivities[0], 0, 5.0) }
}

#[test]
fn a_ramp_is_shown_by_its_mean_over_a_line_and_by_its_middle() {
    // 0.2 at line 2.5 to 0.6 at line 6.5: a tenth a line.
    let table = SpanTable::of_sweep(&[ramped([2.5, 6.5], [0.2, 0.6])]);
    let shown = |rule: PixelRule| {
        let mut row = vec![0.0; 8];
        Overlay::default().overlay(table.sweep(0), BodyVisibility::Depth, OPEN, rule, &mut row);
        row
    };
    let near = |found: Vec<f32>, expected: [f32; 8]| {
        assert!(
            found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-6),
            "{found:?}"
        );
    };
    // Half of line 2 has 0.2 to 0.25, half of line 6 0.55 to 0.6.
    near(shown(PixelRule::LineMean), [0.0, 0.0, 0.5 * 0.225, 0.3, 0.4, 0.5, 0.5 * 0.575, 0.0]);
    near(shown(PixelRule::Centre), [0.0, 0.0, 0.2, 0.3, 0.4, 0.5, 0.0, 0.0]);
}

#[test]
fn a_ramp_opens_a_self_keyed_switch_where_it_exceeds_the_threshold() {
    let keyed = |reflectivities: [f32; 2], threshold: f32| {
        let mut overlay = Overlay::default();
        let table = SpanTable::of_sweep(&[ramped([2.0, 6.0], reflectivities)]);
        overlay.compose(table.sweep(0), BodyVisibility::Depth, OPEN);
        overlay.key(threshold);
        ends(overlay.runs())
    };
    let near = |found: &[[f32; 3]], expected: [f32; 3]| {
        assert!(found.len() == 1 && (0..3).all(|k| (found[0][k] - expected[k]).abs() < 1e-6), "{found:?}");
    };
    near(&keyed([0.0, 0.4], 0.1), [3.0, 6.0, 0.1]);
    near(&keyed([0.4, 0.0], 0.1), [2.0, 5.0, 0.4]);
    near(&keyed([0.2, 0.4], 0.1), [2.0, 6.0, 0.2]);
    assert!(keyed([0.0, 0.1], 0.1).is_empty() && keyed([0.1, 0.1], 0.1).is_empty());
}

#[test]
fn what_a_nearer_face_hides_of_a_ramp_takes_nothing_from_the_rest() {
    let spans = [ramped([2.0, 6.0], [0.2, 0.6]), wall([4.0, 8.0], 2.0, 0.9, 1, 2.0)];
    let shown = runs(&spans, BodyVisibility::Depth, OPEN);
    assert_eq!(ends(&shown), [[2.0, 4.0, 0.2], [4.0, 8.0, 0.9]]);
    let spans = [ramped([2.0, 6.0], [0.2, 0.6]), wall([0.0, 4.0], 2.0, 0.9, 1, 2.0)];
    let below = ends(&runs(&spans, BodyVisibility::Depth, OPEN))[1];
    assert!(below[0] == 4.0 && (below[2] - 0.4).abs() < 1e-6, "{below:?}");
}
