//! Timelines and bars, pixel by pixel.

use plots::{
    Axis, Bars, Drawing, EventLane, Panel, PlotError, Span, Stops, Stretch, Timeline, Trace, TraceLook,
    bar_picture, timeline_picture,
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
    Bars { name: "transfer".into(), counts: counts.into(), edges, wrong: 1 }
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
fn what_cannot_be_drawn_is_refused() {
    let wrong = bar_picture("ticks", "deadlines", &[bars(&[1.0, 2.0], &[])], &look());
    assert!(matches!(wrong, Err(PlotError::Count { found: 0, expected: 1, .. })));
    assert!(matches!(bar_picture("ticks", "deadlines", &[], &look()), Err(PlotError::Empty { .. })));
    let small = TraceLook { width: 10, ..look() };
    assert!(matches!(timeline_picture(&timeline(vec![]), &small), Err(PlotError::PanelSize { .. })));
}
