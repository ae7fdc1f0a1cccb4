//! Labels of ground without data and of ground that no photograph shows.

use generator::{Label, PlaneKind, Planes};
use landscape::Landscape;
use panels::{Parameters, ProgramKeys};

use crate::shots::{draw, landscape, photograph, pose, run, session, stage, waves};

/// Level ground whose region from 200 to 210 m north and east has no data.
fn with_void() -> Landscape {
    let level = landscape(0.0);
    Landscape::new(level.bank().clone().with_voids(vec![[20, 20]]).unwrap(), 0.5)
}

/// The label of each pixel: 100 x 100 of 3 m, from 50 to 350 m, under a photograph of the ground from 100 to 300 m.
fn labels(run: Parameters) -> Vec<f32> {
    let session = session(stage(with_void(), vec![photograph(400, 500.0, waves)], 100, 0.5), run);
    let planes: Planes = draw(&*session, 100, &pose([200.0, 200.0, 300.0], 0.0, -90.0));
    planes.get(PlaneKind::Label).unwrap().to_vec()
}

/// Pixels whose middles lie between two distances to the north and east of the eye (m).
fn between([low, high]: [f64; 2]) -> impl Fn(usize) -> bool {
    let inside = move |at: f64| (low..high).contains(&at);
    move |pixel| {
        let [east, south] = [pixel % 100, pixel / 100].map(|at| 3.0 * (at as f64 + 0.5) - 150.0);
        inside(east) && inside(-south)
    }
}

#[test]
fn pixels_say_what_their_ground_rests_on() {
    let (void, shown) = (between([0.0, 10.0]), between([-100.0, 100.0]));
    for (pixel, label) in labels(run()).into_iter().enumerate() {
        let expected = match (void(pixel), shown(pixel)) {
            (true, _) => Label::Void,
            (false, true) => Label::Terrain,
            (false, false) => Label::Inferred,
        };
        assert_eq!(label, f32::from(expected.code()), "pixel {pixel}");
    }
}

#[test]
fn the_program_labels_panels_that_touch_a_void() {
    let program = ProgramKeys { fill: Some(panel_program::Fill::Span), ..ProgramKeys::default() };
    let labels = labels(Parameters { spacing: Some(10.0), program, ..run() });
    // Of all posts that of 200 m north and east alone lies in the void: six panels touch it.
    let (around, beyond) = (between([-10.0, 10.0]), between([-12.0, 12.0]));
    for (pixel, label) in labels.into_iter().enumerate() {
        let is_void = label == f32::from(Label::Void.code());
        assert!(is_void || label == f32::from(Label::Terrain.code()));
        assert!(!is_void || beyond(pixel), "pixel {pixel}");
        let [column, line] = [pixel % 100, pixel / 100];
        // The corners to the south-west and to the north-east belong to panels that do not touch it.
        let is_cut = (column < 50) == (line >= 50);
        assert!(is_void || !around(pixel) || is_cut, "pixel {pixel}");
    }
}
