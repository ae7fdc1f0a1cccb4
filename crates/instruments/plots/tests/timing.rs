//! Timelines and bars, pixel by pixel.

use plots::{
    Axis, Bars, Drawing, EventLane, Panel, PlotError, Span, Stops, Stretch, Timeline, Trace, TraceLook,
    bar_picture, timeline_picture, trace_picture,
};

const LATE: [u8; 3] = [196, 40, 40];
const ON_ITS_WAY: [u8; 3] = [63, 125, 88];
const MET: [u8; 3] = [31, 78, 121];

fn look() -> TraceLook {
    TraceLook { width: 200, height: 120, ..TraceLook::titled("t") }
}

fn pixel(drawing: &Drawing, column: u32, line: u32) -> [u8; 3] {
    let place = 3 * (line * drawing.columns() + column) as usize;
    [0, 1, 2].map(|channel| drawing.rgb()[place + channel])
}

/// Columns of `colour` in the lowest line that has any of it.
fn columns_of(drawing: &Drawing, colour: [u8; 3]) -> Vec<u32> {
    let of_line =
        |line| (0..drawing.columns()).filter(|&column| pixel(drawing, column, line) == colour).collect();
    let lines = (0..drawing.lines()).rev().map(of_line);
    lines.into_iter().find(|columns: &Vec<u32>| !columns.is_empty()).unwrap_or_default()
}

fn timeline(spans: Vec<Span>) -> Timeline<'static> {
    let traces = vec![Trace { name: "sweep.x", x: &[0.0, 100.0], y: &[0.0, 1.0] }];
    Timeline {
        x: Axis::new("range (m)").over([0.0, 100.0]),
        panels: vec![Panel { axis: Axis::new("ramp"), traces }],
        stops: vec![Stops { name: "X stop".into(), at: vec![25.0, 150.0] }],
        lanes: vec![EventLane { name: "red x-first".into(), spans }],
    }
}

fn span(from: f64, to: f64, stretch: Stretch) -> Span {
    Span { from, to, stretch }
}

#[test]
fn stretches_lie_where_they_are_and_late_ones_on_top() {
    let spans = vec![span(60.0, 80.0, Stretch::Late), span(50.0, 70.0, Stretch::OnItsWay)];
    let drawing = timeline_picture(&timeline(spans), &look()).unwrap();
    let (way, late) = (columns_of(&drawing, ON_ITS_WAY), columns_of(&drawing, LATE));
    // 200 pixels for 100 m.
    assert_eq!((way.len(), late.len()), (20, 40));
    assert_eq!(way[19] + 1, late[0]);
}

#[test]
fn what_is_short_is_seen_and_what_is_outside_is_not() {
    let drawing = timeline_picture(&timeline(vec![span(40.0, 40.001, Stretch::Late)]), &look()).unwrap();
    let narrow = columns_of(&drawing, LATE);
    assert!((1..=2).contains(&narrow.len()), "{narrow:?}");
    let beside = timeline(vec![span(120.0, 140.0, Stretch::Late), span(-9.0, -2.0, Stretch::Late)]);
    let clean = timeline_picture(&timeline(vec![]), &look()).unwrap();
    assert_eq!(timeline_picture(&beside, &look()).unwrap(), clean);
}

fn bars(counts: &[f64], edges: &[&str]) -> Bars {
    let edges = edges.iter().map(|&edge| edge.to_owned()).collect();
    Bars { name: "transfer".into(), counts: counts.into(), edges, wrong: 1, kinds: ["missed", "met"] }
}

#[test]
fn bars_are_as_high_as_their_counts_and_red_where_something_was_missed() {
    let drawing = bar_picture("ticks", "deadlines", &[bars(&[10.0, 1000.0], &["0"])], &look()).unwrap();
    let column_height = |column: u32, colour| {
        (0..drawing.lines()).filter(|&line| pixel(&drawing, column, line) == colour).count() as f64
    };
    let (missed, met) = (column_height(86 + 50, LATE), column_height(86 + 150, MET));
    // From half a deadline on, decades evenly: 1.3 of them against 3.3, of 3.6 that there are.
    assert!(missed < met && met < 120.0, "{missed} {met}");
    assert!((missed / met - 1.301 / 3.301).abs() < 0.03, "{missed} {met}");
}

#[test]
fn bars_say_in_the_legend_what_they_are() {
    let kinds = ["touch no pixel", "all others"];
    let samples = Bars { kinds, ..bars(&[10.0, 1000.0], &["these | others"]) };
    let svg = bar_picture("fate", "samples", &[samples], &look()).unwrap().svg();
    assert!(kinds.iter().all(|kind| svg.contains(kind)) && !svg.contains("missed"), "{svg}");
}

/// Left ends of the texts of a picture.
fn left_ends(svg: &str) -> Vec<(f32, &str)> {
    let place = |rest: &str| rest.split_once("translate(")?.1.split(' ').next()?.parse().ok();
    let texts = svg.split("aria-label=\"").skip(1).filter_map(|piece| piece.split_once('"'));
    texts.filter_map(|(text, rest)| Some((place(rest)?, text))).collect()
}

#[test]
fn a_long_legend_stays_in_the_picture_and_no_two_lines_are_alike() {
    let names: Vec<String> = (0..14).map(|number| format!("channel.coarse.{number}")).collect();
    let y: Vec<[f64; 2]> = (0..14).map(|number| [f64::from(number); 2]).collect();
    let traces = names.iter().zip(&y).map(|(name, y)| Trace { name, x: &[0.0, 3.0], y }).collect();
    let panel = Panel { axis: Axis::new("channels (%)").over([0.0, 20.0]), traces };
    let svg = trace_picture(&Axis::new("frame").whole(), &[panel], &[], &look()).unwrap().svg();
    let found = left_ends(&svg);
    for name in &names {
        let left = found.iter().find(|(_, text)| text == name).map(|(left, _)| *left);
        assert!(left.is_some_and(|left| left > 86.0), "{name}: {left:?}");
    }
    // Only whole frames have a tick.
    assert!(!found.iter().any(|(_, text)| *text == "0.5"), "{svg}");
    let style = |line: &str| {
        let word =
            |key: &str| line.split(key).nth(1).and_then(|rest| rest.split('"').next().map(str::to_owned));
        Some((word(" stroke=\"")?, word("dasharray=\"")))
    };
    let styles: std::collections::BTreeSet<_> =
        svg.lines().filter(|line| line.contains("stroke-width=\"2.4\"")).filter_map(style).collect();
    assert_eq!(styles.len(), names.len(), "{styles:?}");
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let wrong = bar_picture("ticks", "deadlines", &[bars(&[1.0, 2.0], &[])], &look());
    assert!(matches!(wrong, Err(PlotError::Count { found: 0, expected: 1, .. })));
    assert!(matches!(bar_picture("ticks", "deadlines", &[], &look()), Err(PlotError::Empty { .. })));
    let small = TraceLook { width: 10, ..look() };
    assert!(matches!(timeline_picture(&timeline(vec![]), &small), Err(PlotError::PanelSize { .. })));
}
