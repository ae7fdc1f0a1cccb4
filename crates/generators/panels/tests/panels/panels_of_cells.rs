//! Which panel a pixel shows, and how cells are cut.

use generator::Fact;
use panels::{Diagonal, Fineness, Parameters, Shading};

use crate::shots::{draw, landscape, light, photograph, pose, run, session, stage};

/// The fact of a name that a pixel has.
fn fact(facts: &[Fact], name: &str) -> String {
    let found = facts.iter().find(|fact| fact.what == name);
    found.unwrap_or_else(|| panic!("{name}")).value.clone()
}

#[test]
fn a_flat_panel_has_the_light_that_explain_says() {
    let ramp = |x: f64, _: f64| x;
    for diagonal in [Diagonal::Shorter, Diagonal::Stated] {
        let run = Parameters { shading: Shading::Panel, diagonal, spacing: Some(20.0), ..run() };
        let session = session(stage(landscape(6.0), vec![photograph(800, 500.0, ramp)], 60, 0.25), run);
        let from_above = pose([200.0, 200.0, 300.0], 0.0, -90.0);
        let planes = draw(&*session, 60, &from_above);
        let mut inside = 0;
        for pixel in (0..60 * 60).step_by(37).map(|pixel| [pixel % 60, pixel / 60]) {
            let facts = session.explain(0, &from_above, pixel).unwrap();
            let told = fact(&facts, "light of the panel");
            assert!(told.contains(" pixels of photograph 1"), "{told}");
            let panel: f32 = told.split(',').next().unwrap().parse().unwrap();
            // At an edge of panels the pixel mixes two of them.
            inside += usize::from((panel - light(&planes)[pixel[1] * 60 + pixel[0]]).abs() < 1e-4);
        }
        assert!(inside * 10 > 98 * 7, "{diagonal:?}: {inside} of 98 pixels");
    }
}

#[test]
fn panels_are_as_small_as_pixels_ask_for() {
    let told = |fineness| {
        let run = Parameters { shading: Shading::Panel, spacing: Some(20.0), fineness, ..run() };
        let session = session(stage(landscape(0.0), vec![photograph(800, 500.0, |_, _| 0.5)], 60, 0.25), run);
        let facts = session.explain(0, &pose([203.0, 204.0, 300.0], 0.0, -90.0), [30, 30]).unwrap();
        let told = fact(&facts, "light of the panel");
        told.split_whitespace().find_map(|word| word.parse::<u32>().ok()).unwrap()
    };
    // 20 m of half a metre: 40 x 40 pixels a cell. Those with centres on the diagonal are all in one of its panels.
    assert!([780, 820].contains(&told(Fineness::Cells(1))));
    assert!([190, 210].contains(&told(Fineness::Cells(2))));
    assert!([45, 55].contains(&told(Fineness::Pixels(60.0))), "4 cells a side: 50 pixels in the mean");
}
