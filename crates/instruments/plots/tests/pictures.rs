//! What the pictures show, pixel by pixel.

use landscape::{Level, Sun};
use plots::{
    Axis, BankLook, Drawing, Lane, Panel, PlotError, Residuals, SurveyLook, Trace, TraceLook, bank_picture,
    survey_picture, trace_picture,
};

/// Low in the west.
const SUN: Sun = Sun { azimuth: 1.5 * std::f64::consts::PI, elevation: 0.3 };

/// A level of 5 x 5 corners, 100 m apart, of heights and slopes `[h, hx, hy]` at (x, y).
fn level(ground: fn(f64, f64) -> [f64; 3]) -> Level {
    let corner = |index: usize| {
        let [h, hx, hy] = ground(100.0 * (index / 5) as f64, 100.0 * (index % 5) as f64);
        [h, 100.0 * hy, 0.0, 100.0 * hx, 0.0, 0.0, 0.0, 0.0, 0.0]
    };
    Level::new(100.0, [0.0, 0.0], [5, 5], (0..25).map(corner).collect()).unwrap()
}

fn ramp() -> Level {
    level(|x, _| [0.1 * x, 0.1, 0.0])
}

fn look() -> BankLook {
    BankLook { longest: 200, contours: false, ..BankLook::titled("a ramp") }
}

fn pixel(drawing: &Drawing, column: u32, line: u32) -> [u8; 3] {
    let place = 3 * (line * drawing.columns() + column) as usize;
    [0, 1, 2].map(|channel| drawing.rgb()[place + channel])
}

fn brightness(colour: [u8; 3]) -> u32 {
    colour.iter().map(|&value| u32::from(value)).sum()
}

/// First line of the map's border: the topmost one of its left side.
fn map_top(drawing: &Drawing) -> u32 {
    let border = (0..drawing.lines()).filter(|&line| pixel(drawing, 86, line) == [96, 96, 96]);
    // Letters of the header may touch the column: the border is the first of a long run.
    let lines: Vec<u32> = border.collect();
    lines.windows(20).find(|run| run[19] - run[0] == 19).unwrap()[0]
}

#[test]
fn slopes_to_the_sun_are_bright() {
    let roof = level(|_, y| if y < 200.0 { [0.1 * y, 0.0, 0.1] } else { [40.0 - 0.1 * y, 0.0, -0.1] });
    let drawing = bank_picture(&roof, SUN, &look()).unwrap();
    let line = map_top(&drawing) + 100;
    let [west, east] = [86 + 50, 86 + 150].map(|column| brightness(pixel(&drawing, column, line)));
    assert!(east < west, "east {east}, west {west}");
}

#[test]
fn high_ground_is_in_the_north_and_light() {
    let drawing = bank_picture(&ramp(), SUN, &look()).unwrap();
    let top = map_top(&drawing);
    let [north, south] = [top + 10, top + 190].map(|line| brightness(pixel(&drawing, 186, line)));
    assert!(north > south + 60, "north {north}, south {south}");
}

#[test]
fn contours_lie_at_round_heights() {
    // 40 m over 200 pixels, a contour every 2 m: every 10 pixels, none on the flat.
    let with = bank_picture(&ramp(), SUN, &BankLook { contours: true, ..look() }).unwrap();
    let without = bank_picture(&ramp(), SUN, &look()).unwrap();
    let top = map_top(&with);
    assert_eq!(top, map_top(&without));
    for line in 5..195 {
        let inked = pixel(&with, 186, top + line) != pixel(&without, 186, top + line);
        assert_eq!(inked, matches!(line % 10, 0 | 9), "line {line} of the map");
    }
    let flat = level(|_, _| [0.0; 3]);
    let with = bank_picture(&flat, SUN, &BankLook { contours: true, ..look() }).unwrap();
    let without = bank_picture(&flat, SUN, &look()).unwrap();
    let top = map_top(&with);
    assert_eq!(pixel(&with, 186, top + 50), pixel(&without, 186, top + 50));
}

#[test]
fn residuals_have_their_sign_and_voids_are_grey() {
    // 4 x 4 samples from the north-west: +1 in the north, -1 in the south, void in the east.
    let value = |index: usize| match (index / 4, index % 4) {
        (_, 3) => f64::NAN,
        (0 | 1, _) => 1.0,
        _ => -1.0,
    };
    let values: Vec<f64> = (0..16).map(value).collect();
    let residuals =
        Residuals { first: [350.0, 50.0], spacing: [-100.0, 100.0], samples: [4, 4], values: &values };
    let look = SurveyLook { longest: 200, ..SurveyLook::titled("signs") };
    let drawing = survey_picture(&ramp(), SUN, &residuals, &look).unwrap();
    // A place may have no sample because it is void, or because it lies beyond the file: the picture cannot tell.
    let said = "residuals of 12 samples: RMS 1.00 m, largest 1.00 m; 4 places without a sample";
    assert!(drawing.svg().contains(said));
    let top = map_top(&drawing);
    let left = 86 + 86 + 200 + 120;
    let [red, _, blue] = pixel(&drawing, left + 60, top + 40);
    assert!(red > blue + 60, "sample above the fit: red");
    let [red, _, blue] = pixel(&drawing, left + 60, top + 160);
    assert!(blue > red + 60, "sample below the fit: blue");
    let [red, green, blue] = pixel(&drawing, left + 175, top + 100);
    assert!(red == green && green == blue && red < 220, "void: grey");
}

fn traces(x: &[f64], y: &[f64]) -> Result<Drawing, PlotError> {
    let axis = Axis::new("height (m)").over([0.0, 1.0]);
    let panels = [Panel { axis, traces: vec![Trace { name: "tg.height", x, y }] }];
    let high = vec![true; x.len().saturating_sub(1)];
    let lanes = [Lane { name: "gate", x, high: &high }];
    let look = TraceLook { width: 200, height: 120, ..TraceLook::titled("traces") };
    trace_picture(&Axis::new("ground range (m)"), &panels, &lanes, &look)
}

#[test]
fn a_trace_breaks_where_a_value_is_missing() {
    let x: Vec<f64> = (0..=20).map(f64::from).collect();
    let y: Vec<f64> = x.iter().map(|x| if (8.0..13.0).contains(x) { f64::NAN } else { 0.53 }).collect();
    let drawing = traces(&x, &y).unwrap();
    let top = map_top(&drawing);
    let blue = |column: u32| {
        (top..top + 120).filter(|&line| pixel(&drawing, 86 + column, line) == [31, 78, 121]).count()
    };
    assert!(blue(35) > 0 && blue(165) > 0);
    assert_eq!(blue(105), 0);
}

#[test]
fn what_does_not_fit_is_refused() {
    assert!(matches!(
        bank_picture(&ramp(), SUN, &BankLook { longest: 100, ..look() }),
        Err(PlotError::PanelSize { found: 100, .. })
    ));
    let error = traces(&[0.0, 1.0], &[0.0]).unwrap_err();
    assert_eq!(error.to_string(), "tg.height: 1 values, expected 2");
    let error = traces(&[f64::NAN, f64::NAN], &[0.0, 1.0]).unwrap_err();
    assert_eq!(error.to_string(), "ground range (m): no finite value, expected at least one");
    let short = Residuals { first: [0.0; 2], spacing: [1.0; 2], samples: [2, 2], values: &[0.0] };
    let error = survey_picture(&ramp(), SUN, &short, &SurveyLook::titled("short")).unwrap_err();
    assert_eq!(error.to_string(), "residuals: 1 values, expected 4");
}

#[test]
fn files_are_png_and_come_back() {
    let drawing = bank_picture(&ramp(), SUN, &look()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ramp.png");
    drawing.write(&path).unwrap();
    let file = std::io::BufReader::new(std::fs::File::open(&path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut rgb = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut rgb).unwrap();
    assert_eq!((info.width, info.height), (drawing.columns(), drawing.lines()));
    assert_eq!(rgb, drawing.rgb());
}

/// Pixels that must be the same on every machine; a change of design changes them too.
#[test]
fn pixels_do_not_depend_on_the_machine() {
    let hash = |drawing: Drawing| blake3::hash(drawing.rgb()).to_hex()[..16].to_owned();
    let x: Vec<f64> = (0..=20).map(f64::from).collect();
    let y: Vec<f64> = x.iter().map(|x| x / 20.0).collect();
    let found = [
        hash(bank_picture(&ramp(), SUN, &BankLook { contours: true, regions: true, ..look() }).unwrap()),
        hash(traces(&x, &y).unwrap()),
    ];
    assert_eq!(found, ["a1aaae53178adc8d", "da39f2c98e337074"]);
}
