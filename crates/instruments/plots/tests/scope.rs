//! Pages of the scope: what they show, pixel by pixel and stroke by stroke.

use plots::{
    Along, Clock, Crossing, Curve, Curves, Drawing, Line, Logic, LogicLane, PictureColumn, Place, PlotError,
    RegisterColour, Scope, ScopeLook, Theme, Upright, Volts, scope_picture, scope_svg,
};

const CURSOR: [u8; 3] = [176, 0, 96];
const BLUE: [u8; 3] = [0, 60, 140];

/// Left and right edge of the panels of a page without voltages and column, 600 pixels wide.
const EDGES: [f64; 2] = [96.0, 578.0];

fn pixel(drawing: &Drawing, column: u32, line: u32) -> [u8; 3] {
    let place = 3 * (line * drawing.columns() + column) as usize;
    [0, 1, 2].map(|channel| drawing.rgb()[place + channel])
}

/// Columns in which at least `least` pixels are of `colour`.
fn columns_of(drawing: &Drawing, colour: [u8; 3], least: usize) -> Vec<u32> {
    let count = |column| (0..drawing.lines()).filter(|&line| pixel(drawing, column, line) == colour).count();
    (0..drawing.columns()).filter(|&column| count(column) >= least).collect()
}

fn labels(drawing: &Drawing) -> Vec<String> {
    let svg = drawing.svg();
    let texts = svg.split("aria-label=\"").skip(1);
    texts.map(|text| text.split('"').next().unwrap().to_owned()).collect()
}

fn look() -> ScopeLook {
    ScopeLook { width: 600, height: 120, ..ScopeLook::titled("a sweep") }
}

/// A panel over a clock of one microsecond a sample.
fn scope<'a>(ranges: &'a [f64], values: &'a [f64]) -> Scope<'a> {
    let curves = vec![Curve { name: "tg.height", values }];
    let (label, unit) = ("height (m)".to_owned(), "m".to_owned());
    Scope {
        clock: Clock { ranges, period: 1.0, line: Line::Sweep },
        panels: vec![Curves { label, unit, upright: Upright::Values, volts: None, curves }],
        lanes: vec![],
        crossings: vec![],
        coarse: vec![],
        blanked: vec![],
        column: None,
    }
}

/// A row of a grid lies across the line of sight: it has places on both sides, points, and neither time nor voltage.
#[test]
fn a_row_has_places_on_both_sides() {
    let ranges: Vec<f64> = (0..=100).map(|point| -50.0 + f64::from(point)).collect();
    let values: Vec<f64> = ranges.iter().map(|place| place * place).collect();
    let row =
        Scope { clock: Clock { ranges: &ranges, period: 1.0, line: Line::Row }, ..scope(&ranges, &values) };
    let cursors = vec![Place::Range(-40.0), Place::Range(30.0)];
    let look = ScopeLook { along: Along::Range, cursors, ..look() };
    let texts = labels(&scope_picture(&row, &look).unwrap());
    for word in ["across the line of sight (m)", "point", "-40.000 m", "1600.0 m", "900.00 m", "80.000"] {
        assert!(texts.iter().any(|text| text.replace('−', "-") == word), "{word}: {texts:?}");
    }
    assert!(texts.iter().all(|text| !text.contains("time") && text != "(V)"), "{texts:?}");
    let outside = ScopeLook { from: Some(Place::Range(-51.0)), ..look };
    let message = scope_picture(&row, &outside).unwrap_err().to_string();
    assert!(message.contains("across the line of sight (m)"), "{message}");
}

/// Places of a scan line are counted: no metres, no decades, no time.
#[test]
fn scan_lines_have_neither_metres_nor_time() {
    let (places, values): (Vec<f64>, Vec<f64>) =
        (0..50).map(|at| (f64::from(at), f64::from(at) * 0.02)).unzip();
    let clock = Clock { ranges: &places, period: 1.0, line: Line::ScanLine };
    let line = Scope { clock, ..scope(&places, &values) };
    let cursors = vec![Place::Range(10.0), Place::Range(30.0)];
    let look = ScopeLook { along: Along::Range, cursors, ..look() };
    let texts = labels(&scope_picture(&line, &look).unwrap());
    for word in ["place on the scan line", "sample", "slope, a sample", "10.000", "20.000"] {
        assert!(texts.iter().any(|text| text == word), "{word}: {texts:?}");
    }
    let metres = |text: &&String| text.contains("(m)") && !text.contains("height");
    assert!(!texts.iter().any(|text| metres(&text) || text.contains("time")), "{texts:?}");
}

/// Everything that a page can have.
fn full<'a>(ranges: &'a [f64], waves: &'a [Vec<f64>; 3], grey: &'a [f64]) -> Scope<'a> {
    let [height, light, line] = waves;
    let panel = |label: &str, upright, volts, name, values| Curves {
        label: label.into(),
        unit: String::new(),
        upright,
        volts,
        curves: vec![Curve { name, values }],
    };
    let volts = Some(Volts { full_scale: 20.0, volts: 10.0, datum: 0.0 });
    let lane = |name, logic| LogicLane { name, logic };
    let words = vec![(0.0, Some("512".into())), (40.0, None), (60.0, Some("514".into()))];
    let crossing = |at, a, b| Crossing { at, loads: [a, b] };
    use RegisterColour::{Black, Green, Red, Yellow};
    Scope {
        clock: Clock { ranges, period: 0.05, line: Line::Sweep },
        panels: vec![
            panel("height (m)", Upright::Values, volts, "tg.height", height),
            panel("reflectivity", Upright::Values, None, "tg.reflectivity", light),
            panel("display line", Upright::Lines(100), None, "dpp.y", line),
        ],
        lanes: vec![
            lane("sc.gate", Logic::Levels(vec![(0.0, false), (30.0, true), (55.0, false)])),
            lane("tg.yellow.hold", Logic::Words(words, Some(Yellow))),
            lane("fg.centre", Logic::Pulses(vec![(20.0, "7".into()), (70.0, "9".into())])),
        ],
        crossings: vec![
            crossing(25.0, Yellow, Black),
            crossing(50.0, Red, Green),
            crossing(80.0, Green, Yellow),
        ],
        coarse: vec![],
        blanked: vec![[62.0, 75.0]],
        column: Some(PictureColumn { grey, line: Some(line) }),
    }
}

fn waves() -> (Vec<f64>, [Vec<f64>; 3], Vec<f64>) {
    let ranges: Vec<f64> = (0..=100).map(|k| 2.0 + 0.2 * f64::from(k * k) / 10.0).collect();
    let wave = |scale: f64, base: f64| {
        (0..=100).map(|k| base + scale * (f64::from((k * 37) % 101) / 101.0 - 0.5)).collect::<Vec<f64>>()
    };
    let line = (0..=100).map(|k| 95.0 - 0.6 * f64::from(k)).collect();
    let grey = (0..100).map(|k| f64::from(k) / 99.0).collect();
    (ranges, [wave(4.0, 3.0), wave(0.6, 0.4), line], grey)
}

fn full_look() -> ScopeLook {
    let cursors = vec![Place::Range(40.0), Place::Time(4.5)];
    let facts = vec!["frame 0, sweep 1 of 2".into()];
    ScopeLook { facts, cursors, width: 900, height: 140, ..ScopeLook::titled("everything & <more>") }
}

#[test]
fn cursors_stand_where_they_are_asked_for() {
    // 482 pixels for 100 m: metre r at column 96 + 4.82 r.
    let ranges: Vec<f64> = (0..=100).map(f64::from).collect();
    let values: Vec<f64> = ranges.iter().map(|range| 0.25 * range + 3.0).collect();
    let cursors = vec![Place::Range(20.5), Place::Time(80.0)];
    let look = ScopeLook { cursors, along: Along::Range, ..look() };
    let page = scope_picture(&scope(&ranges, &values), &look).unwrap();
    let found = columns_of(&page, CURSOR, 15);
    for (column, places) in [(20.5, "A"), (80.0, "B")] {
        let expected = EDGES[0] + (EDGES[1] - EDGES[0]) / 100.0 * column;
        let near = found.iter().any(|&found| (f64::from(found) + 0.5 - expected).abs() <= 8.0);
        assert!(near, "{places}: {expected}, found {found:?}");
    }
    // A straight line reads straight: values, difference, a quarter a metre.
    let labels = labels(&page);
    for text in ["20.500 m", "80.000 m", "8.1250 m", "23.000 m", "14.875 m", "0.25000", "20.500 µs"] {
        assert!(labels.iter().any(|label| label == text), "{text} in {labels:?}");
    }
}

#[test]
fn ticks_lie_at_round_places_of_both_axes() {
    let ranges: Vec<f64> = (0..=100).map(f64::from).collect();
    let page = scope_picture(&scope(&ranges, &ranges), &ScopeLook { along: Along::Range, ..look() }).unwrap();
    let svg = page.svg();
    // Ticks below the panel: a pixel wide, five high, every 20 m of 482 pixels.
    for index in 0..=5 {
        let column = (EDGES[0] + f64::from(index) * (EDGES[1] - EDGES[0]) / 5.0).floor();
        let tick = format!("M{column} ");
        let is_tick = |line: &&str| line.contains(&tick) && line.contains(&format!("H{}V", column + 1.0));
        assert!(svg.lines().filter(is_tick).count() >= 2, "{column}");
    }
    let labels = labels(&page);
    for text in ["0", "20", "100", "time (µs)", "ground range (m)", "height (m)"] {
        assert!(labels.iter().any(|label| label == text), "{text} in {labels:?}");
    }
}

#[test]
fn a_picture_column_is_black_where_it_is_black() {
    let ranges = [1.0, 2.0, 3.0];
    let values = [0.0, 1.0, 0.5];
    let grey = [0.0, 0.0, 1.0, 1.0];
    let column = Some(PictureColumn { grey: &grey, line: None });
    let page = scope_picture(&Scope { column, ..scope(&ranges, &values) }, &look()).unwrap();
    // Its strip ends 66 pixels before the edge of 22: 30 wide, 120 high.
    let middle = page.columns() - 22 - 66 - 15;
    let black = (0..page.lines()).filter(|&line| pixel(&page, middle, line) == [0; 3]).count();
    assert_eq!(black, 60);
}

#[test]
fn extremes_are_drawn() {
    let long: Vec<f64> = (1..=1000).map(f64::from).collect();
    let crossing = |at| Crossing { at, loads: [RegisterColour::Yellow, RegisterColour::Black] };
    let cases: [(&[f64], Vec<f64>); 7] = [
        (&[5.0], vec![1.0]),
        (&[1.0, 2.0, 3.0], vec![7.0; 3]),
        (&[1.0, 2.0, 3.0], vec![1e-300, -1e-300, 0.0]),
        (&[1.0, 2.0, 3.0], vec![1e300, -1e300, 0.0]),
        (&[1.0, 2.0, 3.0], vec![1e300; 3]),
        (&[1e-300, 1.0, 1e300], vec![f64::NAN, 1.0, f64::INFINITY]),
        (&long, long.iter().map(|k| k % 2.0).collect()),
    ];
    for (ranges, values) in &cases {
        for along in [Along::LogRange, Along::Range, Along::Time] {
            let mut scope = scope(ranges, values);
            scope.panels[0].volts = Some(Volts { full_scale: 1e-300, volts: 10.0, datum: 0.0 });
            scope.lanes = vec![
                LogicLane { name: "none", logic: Logic::Levels(vec![]) },
                LogicLane { name: "words", logic: Logic::Words(vec![], None) },
                LogicLane { name: "pulses", logic: Logic::Pulses(vec![]) },
                LogicLane { name: "late", logic: Logic::Levels(vec![(1e300, true), (2e300, false)]) },
            ];
            scope.crossings = (0..1000).map(|k| crossing(f64::from(k))).collect();
            scope.blanked = vec![[-1e300, 0.5], [f64::NAN, 1.0], [0.0, 1e300]];
            let cursors = vec![Place::Time(0.0), Place::Time(0.0)];
            let page = scope_picture(&scope, &ScopeLook { along, cursors, ..look() }).unwrap();
            let svg = page.svg();
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{along:?} {ranges:?}");
            assert!(svg.len() < 400_000 && page.lines() < 2000, "{} bytes", svg.len());
            assert_eq!(page.rgb().len(), 3 * (page.columns() * page.lines()) as usize);
        }
    }
}

#[test]
fn a_spike_of_one_sample_among_many_is_drawn() {
    let ranges: Vec<f64> = (1..=20_000).map(f64::from).collect();
    let mut values = vec![0.0; ranges.len()];
    values[12_345] = 1.0;
    let page = scope_picture(&scope(&ranges, &values), &ScopeLook { along: Along::Time, ..look() }).unwrap();
    let at = EDGES[0] + (EDGES[1] - EDGES[0]) * 12_345.0 / 19_999.0;
    let found = columns_of(&page, BLUE, 60);
    assert!(found.iter().any(|&column| (f64::from(column) - at).abs() < 2.0), "{at} in {found:?}");
    assert!(page.svg().len() < 100_000);
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let ranges = [1.0, 2.0, 3.0];
    let refused = |scope: &Scope<'_>, look: &ScopeLook| scope_picture(scope, look).unwrap_err().to_string();
    let good = scope(&ranges, &ranges);
    assert_eq!(refused(&scope(&ranges, &[1.0]), &look()), "tg.height: 1 values, expected 3");
    assert_eq!(
        refused(&scope(&ranges, &[f64::NAN; 3]), &look()),
        "height (m): no finite value, expected at least one"
    );
    assert!(matches!(
        scope_picture(&good, &ScopeLook { width: 100, ..look() }),
        Err(PlotError::PanelSize { found: 100, .. })
    ));
    let cursors = vec![Place::Range(7.0)];
    let outside = refused(&good, &ScopeLook { cursors, ..look() });
    assert!(outside.contains("ground range (m) = 7"), "{outside}");
    let (from, cursors) = (Some(Place::Range(2.0)), vec![Place::Range(1.5)]);
    assert!(refused(&good, &ScopeLook { from, cursors, ..look() }).contains("cursor = 1.5"));
    let cursors = vec![Place::Range(1.0); 3];
    assert_eq!(refused(&good, &ScopeLook { cursors, ..look() }), "cursors: 3 values, expected 2");
    for ranges in [&[][..], &[1.0, 1.0], &[1.0, f64::NAN]] {
        let values = vec![0.0; ranges.len()];
        assert!(scope_picture(&scope(ranges, &values), &look()).is_err(), "{ranges:?}");
    }
    let nothing = Scope { panels: vec![], ..good.clone() };
    assert!(matches!(scope_picture(&nothing, &look()), Err(PlotError::Empty { .. })));
    let stopped = Scope { clock: Clock { ranges: &ranges, period: 0.0, line: Line::Sweep }, ..good };
    assert!(refused(&stopped, &look()).contains("sample period = 0"));
}

#[test]
fn svg_is_whole_and_has_both_texts_and_pixels() {
    let (ranges, waves, grey) = waves();
    let svg = scope_picture(&full(&ranges, &waves, &grey), &full_look()).unwrap().svg();
    assert!(svg.contains("<title>everything &amp; &lt;more&gt;</title>"));
    assert!(svg.contains("href=\"data:image/png;base64,iVBORw0KGgo"));
    let count = |word: &str| svg.matches(word).count();
    assert_eq!(count("<g "), count("</g>"));
    // Every glyph that is used is defined once.
    let used = svg.split("<use href=\"#").skip(1).map(|rest| rest.split('"').next().unwrap());
    let used: std::collections::BTreeSet<&str> = used.collect();
    for id in &used {
        assert_eq!(count(&format!("<path id=\"{id}\" ")), 1, "{id}");
    }
    assert_eq!(count("<path id=\"hack"), used.len());
}

/// The dark half of the file, taken apart: with its rules applied the light page is the dark one.
#[test]
fn one_svg_is_light_and_dark() {
    let (ranges, waves, grey) = waves();
    let (scope, look) = (full(&ranges, &waves, &grey), full_look());
    let both = scope_svg(&scope, &look).unwrap();
    let page = |theme| scope_picture(&scope, &ScopeLook { theme, ..look.clone() }).unwrap().svg();
    let (start, rest) = both.split_once("<style>@media (prefers-color-scheme:dark){").unwrap();
    let (rules, end) = rest.split_once("}</style>\n").unwrap();
    assert_eq!(format!("{start}{end}"), page(Theme::Light));
    assert!(rules.len() < 5000, "{} bytes of rules", rules.len());
    let mut dark = format!("{start}{end}").replace('"', "\u{1}");
    for rule in rules.split_terminator('}') {
        let (selector, value) = rule.split_once("]{").unwrap();
        let (what, colour) = selector.strip_prefix('[').unwrap().split_once('=').unwrap();
        let value = value.split_once(':').unwrap().1;
        // Marked as done, so that no colour is turned twice.
        let (colour, quoted) = (colour.trim_matches('"'), format!("\"{value}\""));
        dark = dark.replace(&format!("{what}=\u{1}{colour}\u{1}"), &format!("{what}={quoted}"));
    }
    assert_eq!(dark.replace('\u{1}', "\""), page(Theme::Dark));
}

/// Bytes that must be the same on every machine; a change of design changes them too.
#[test]
fn bytes_do_not_depend_on_the_machine() {
    let (ranges, waves, grey) = waves();
    let of = |theme, along| {
        let look = ScopeLook { theme, along, ..full_look() };
        let page = scope_picture(&full(&ranges, &waves, &grey), &look).unwrap();
        assert_eq!(page, scope_picture(&full(&ranges, &waves, &grey), &look).unwrap());
        [page.svg().as_bytes(), page.rgb()].map(|bytes| blake3::hash(bytes).to_hex()[..16].to_owned())
    };
    let found = [of(Theme::Light, Along::LogRange), of(Theme::Dark, Along::Time)];
    assert_eq!(found, [["846a5787e9701306", "57cd5a7d2122b28f"], ["87a370b32d4258a0", "7df170c8e2ed32fd"]]);
}

/// A narrow page puts the entries of its key into more rows, and nothing into its right margin.
#[test]
fn the_key_of_a_narrow_page_has_more_rows() {
    use RegisterColour::{Black, Green, Red, Yellow};
    let (ranges, waves, grey) = waves();
    let mut scope = full(&ranges, &waves, &grey);
    let crossing = |at: u32, loads| Crossing { at: f64::from(at), loads };
    scope.crossings = (0..60).map(|at| crossing(at, [Yellow, Red])).collect();
    scope.coarse = (0..10).map(|at| crossing(9 * at, [Green, Black])).collect();
    let look = |width| ScopeLook { width, cursors: vec![], ..full_look() };
    let (narrow, wide) =
        (scope_picture(&scope, &look(600)).unwrap(), scope_picture(&scope, &look(1600)).unwrap());
    let (columns, rgb) = (narrow.columns() as usize, narrow.rgb());
    let margin = |line: usize| 3 * (line * columns + columns - 16)..3 * (line + 1) * columns;
    let is_paper = |line| rgb[margin(line)].iter().all(|part| *part == 255);
    let inked: Vec<usize> = (0..narrow.lines() as usize).filter(|line| !is_paper(*line)).collect();
    assert!(inked.is_empty(), "lines {inked:?} run into the right margin");
    assert!(narrow.lines() >= wide.lines() + 20, "{} lines against {}", narrow.lines(), wide.lines());
    let fine = Scope { coarse: vec![], ..scope.clone() };
    let fine = scope_picture(&fine, &look(1600)).unwrap();
    assert_eq!(wide.lines() - fine.lines(), 22, "coarse crossings have a row of their own");
}
