//! Tiles at levels of detail on their scenarios.

use generator::Session;
use lunoid_tests::Shipped;
use signal::Probe;

fn session(shipped: &Shipped, sets: &[(&str, &str)]) -> Box<dyn Session> {
    let generator =
        registry::configure_with(&lod_mesh::ROW, sets).unwrap_or_else(|problems| panic!("{problems}"));
    generator.prepare(shipped.stage().stage()).unwrap()
}

/// What the ground on the view axis of frame `frame` changes by for a camera that stands, when levels go on to that frame.
fn pop(shipped: &Shipped, session: &dyn Session, frame: u64) -> f64 {
    let [before, now] = [frame - 1, frame].map(|frame| shipped.pose(frame).pose);
    let sounding = |levels| session.sounding(frame, &now, levels).unwrap().unwrap();
    (sounding([&before, &now]) - sounding([&now, &before])).abs()
}

#[test]
fn the_descent_pops_where_it_switches_and_not_where_it_morphs() {
    let shipped = Shipped::changed("lod-descent", None, |_| ());
    let spacing = ("lod.spacing_m", "30");
    let switching = session(&shipped, &[spacing, ("lod.transition", "switch")]);
    assert!((pop(&shipped, &*switching, 880) - 0.590).abs() < 0.0005);
    assert!(pop(&shipped, &*session(&shipped, &[spacing]), 880) < 1e-9);
}

#[test]
#[ignore = "long: .ci/long runs it"]
fn levels_save_triangles_of_the_landing() {
    let shipped = Shipped::changed("lod-landing", None, |_| ());
    let triangles = |sets: &[(&str, &str)]| {
        shipped.draw(&*session(&shipped, sets), 200, &mut Probe::off()).counts["ground_triangles"]
    };
    let spacing = ("lod.spacing_m", "2");
    assert_eq!(triangles(&[spacing]), 1_696_488);
    assert_eq!(triangles(&[spacing, ("lod.levels", "1")]), 7_862_272);
}
