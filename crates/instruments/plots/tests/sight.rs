//! Maps of what an observer sees, and lines of sight over their ground.

use plots::{
    Drawing, PlotError, SightLayer, SightLook, SightMap, SightProfile, sight_picture, sight_profile,
};

fn look() -> SightLook {
    SightLook { title: "a wall".into(), facts: vec!["eye 2 m".into()], longest: 200 }
}

fn map<'a>(heights: &'a [f64], layer: SightLayer<'a>) -> SightMap<'a> {
    SightMap { size: [2, 2], corner: [100.0, 0.0], spacing: 100.0, heights, layer, observer: [500.0, 0.0] }
}

fn pixel(drawing: &Drawing, column: u32, line: u32) -> [u8; 3] {
    let place = 3 * (line * drawing.columns() + column) as usize;
    [0, 1, 2].map(|channel| drawing.rgb()[place + channel])
}

/// Colour in the middle of each quarter of the map, whose lower left corner is `(86, bottom)`.
fn quarters(drawing: &Drawing) -> [[u8; 3]; 4] {
    let top = drawing.lines() - 58 - 200;
    [(136, top + 50), (236, top + 50), (136, top + 150), (236, top + 150)].map(|(x, y)| pixel(drawing, x, y))
}

#[test]
fn seen_hidden_and_unknown_cells_differ_and_stand_where_they_are() {
    let cells = [Some(true), Some(false), None, Some(true)];
    let drawing = sight_picture(&map(&[0.0; 4], SightLayer::Seen(&cells)), &look()).unwrap();
    let [seen, hidden, unknown, again] = quarters(&drawing);
    assert_eq!(seen, again);
    assert!(seen[0] > hidden[0] + 80 && seen[0] > seen[2], "{seen:?} {hidden:?}");
    assert!(unknown[0] == unknown[1] && unknown[1] == unknown[2], "{unknown:?}");
}

#[test]
fn slopes_to_the_north_west_are_lighter() {
    let cells = [Some(true); 4];
    // The north-western cell is the lowest: all ground faces the sun.
    let facing = sight_picture(&map(&[0.0, 50.0, 50.0, 100.0], SightLayer::Seen(&cells)), &look()).unwrap();
    let averted = sight_picture(&map(&[100.0, 50.0, 50.0, 0.0], SightLayer::Seen(&cells)), &look()).unwrap();
    assert!(quarters(&facing)[0][0] > quarters(&averted)[0][0] + 60);
}

#[test]
fn the_observer_is_marked_where_it_stands() {
    let cells = [Some(true); 4];
    let standing = SightMap { observer: [50.0, 50.0], ..map(&[0.0; 4], SightLayer::Seen(&cells)) };
    let drawing = sight_picture(&standing, &look()).unwrap();
    let middle = pixel(&drawing, 186, drawing.lines() - 58 - 100);
    assert!(middle[0] > 150 && middle[1] < 90, "{middle:?}");
}

#[test]
fn least_heights_have_a_scale() {
    let cells = [0.0, 10.0, f64::NAN, 0.0];
    let drawing = sight_picture(&map(&[0.0; 4], SightLayer::LeastHeight(&cells)), &look()).unwrap();
    let [low, high, unknown, again] = quarters(&drawing);
    assert_eq!(low, again);
    assert_ne!(low, high);
    assert!(unknown[0] == unknown[1] && unknown[1] == unknown[2], "{unknown:?}");
}

#[test]
fn the_line_stands_over_its_ground() {
    let places: Vec<[f64; 3]> =
        (0..=100).map(f64::from).map(|at| [at, if at < 50.0 { 0.0 } else { f64::NAN }, 10.0]).collect();
    let profile = SightProfile { places: &places, blocker: Some(75.0), title: "a line", facts: &[] };
    let drawing = sight_profile(&profile).unwrap();
    let bottom = drawing.lines() - 58;
    assert_eq!(pixel(&drawing, 86 + 200, bottom - 10), [190, 182, 168]);
    assert_ne!(pixel(&drawing, 86 + 500, bottom - 10), [190, 182, 168]);
    let column = (bottom - 320..bottom).map(|line| pixel(&drawing, 86 + 600, line));
    let red = column.filter(|&[red, green, _]| red > 150 && green < 100).count();
    assert!(red > 100, "{red}");
}

#[test]
fn maps_and_profiles_that_cannot_be_drawn_are_refused() {
    let cells = [Some(true); 4];
    let few = sight_picture(&map(&[0.0; 3], SightLayer::Seen(&cells)), &look());
    assert!(matches!(few, Err(PlotError::Count { found: 3, expected: 4, .. })));
    let few = sight_picture(&map(&[0.0; 4], SightLayer::LeastHeight(&[0.0; 5])), &look());
    assert!(matches!(few, Err(PlotError::Count { found: 5, expected: 4, .. })));
    let flat = SightMap { spacing: 0.0, ..map(&[0.0; 4], SightLayer::Seen(&cells)) };
    assert!(matches!(sight_picture(&flat, &look()), Err(PlotError::Value { .. })));
    let small = SightLook { longest: 5, ..look() };
    assert!(matches!(
        sight_picture(&map(&[0.0; 4], SightLayer::Seen(&cells)), &small),
        Err(PlotError::PanelSize { .. })
    ));
    for places in [&[[0.0, 0.0, 0.0]][..], &[[0.0, 0.0, 0.0], [1.0, 0.0, f64::NAN]]] {
        assert!(sight_profile(&SightProfile { places, blocker: None, title: "", facts: &[] }).is_err());
    }
}
