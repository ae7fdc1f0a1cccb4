//! Tiles at levels of detail on their scenarios.

use generator::Session;
use lunoid_tests::Shipped;
use lunoid_tests::shipped::Shown;
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

/// RMSE over displayed grey, 0 to 1.
fn rmse(a: &Shown, b: &Shown) -> f64 {
    compare::compare(&a.picture, &b.picture, None, &[]).unwrap().rmse
}

/// One landscape of features: coefficients, craters and bodies on the machine, posts on the mesh.
#[test]
fn built_ground_has_its_features_on_every_generator() {
    let shipped = Shipped::changed("built-ground", Some(250), |_| ());
    let judged = shipped.exact(0);
    let mesh = shipped.draw(&*session(&shipped, &[]), 0, &mut Probe::off());
    let bare = Shipped::changed("built-ground", Some(250), |scenario| scenario.features.list = None);
    let [machine, mesh, bare] =
        [shipped.machine(0), mesh, bare.machine(0)].map(|shown| rmse(&shown, &judged));
    println!("from exact: machine {machine}, mesh {mesh}, machine without the list of craters {bare}");
    for (found, table) in [(machine, 0.0095), (mesh, 0.099), (bare, 0.226)] {
        assert!((found - table).abs() <= 0.0005, "found {found}, the table says {table}");
    }
}
