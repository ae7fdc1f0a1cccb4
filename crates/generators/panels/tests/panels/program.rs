//! The program of the thesis in place of the scene sampler.

use std::sync::Arc;

use generator::PlaneKind;
use panel_program::{Fill, Restrictions};
use panels::{Diagonal, Parameters, ProgramKeys, Shading};
use raster::Pattern;
use scene_sampler::Parameters as Sampling;

use crate::shots::{draw, landscape, light, panels, photograph, pose, run, session, stage, waves};

fn with(program: ProgramKeys) -> Parameters {
    let sampling = Sampling { pattern: Pattern::One, ..run().sampling };
    Parameters {
        shading: Shading::Panel,
        diagonal: Diagonal::Stated,
        spacing: Some(10.0),
        sampling,
        program,
        ..run()
    }
}

/// Pixels of two pictures that differ by more than a thousandth.
fn apart(a: &[f32], b: &[f32]) -> usize {
    a.iter().zip(b).filter(|(a, b)| (*a - *b).abs() > 1e-3).count()
}

#[test]
fn with_no_finding_it_draws_the_picture_of_the_scene_sampler() {
    let make = || stage(landscape(3.0), vec![photograph(800, 600.0, waves)], 96, 0.4);
    let fills = Fill::ALL.map(|(_, fill)| ProgramKeys { fill: Some(fill), ..ProgramKeys::default() });
    for pose in [pose([200.0, 200.0, 90.0], 30.0, -70.0), pose([60.0, 80.0, 30.0], 40.0, -20.0)] {
        let usual = draw(&*session(make(), with(ProgramKeys::default())), 96, &pose);
        let pictures = fills.clone().map(|keys| draw(&*session(make(), with(keys)), 96, &pose));
        assert!(light(&usual).iter().filter(|light| **light > 0.0).count() > 2000);
        let other = apart(light(&usual), light(&pictures[0]));
        assert!(other * 200 < 96 * 96, "{other} pixels");
        assert!(pictures.iter().all(|picture| picture == &pictures[0]), "one way to fill differs");
        let distances = [&usual, &pictures[0]].map(|planes| planes.get(PlaneKind::Distance).unwrap());
        let far = distances[0].iter().zip(distances[1]).filter(|(a, b)| (*a - *b).abs() > 1e-3 * a.abs());
        assert!(far.count() * 200 < 96 * 96);
    }
}

#[test]
fn each_finding_changes_a_picture_or_refuses() {
    let make = || stage(landscape(3.0), vec![photograph(800, 600.0, waves)], 96, 0.4);
    // Low over the middle: ground before and behind the eye, and beyond all borders.
    let pose = pose([150.0, 200.0, 12.0], 10.0, -25.0);
    let repaired = with(ProgramKeys { fill: Some(Fill::EdgeBuffer), ..ProgramKeys::default() });
    let usual = draw(&*session(make(), repaired), 96, &pose);
    for (key, _) in
        Restrictions::SWITCHES.into_iter().filter(|(key, _)| !["mean_void", "limits", "real4"].contains(key))
    {
        let restrictions = Restrictions::only(key).unwrap();
        let keys = ProgramKeys { restrictions, ..ProgramKeys::default() };
        let found = draw(&*session(make(), with(keys)), 96, &pose);
        assert!(found != usual, "{key}");
    }
}

#[test]
fn what_it_leaves_out_is_listed() {
    let two = || vec![photograph(800, 600.0, waves), photograph(800, 600.0, waves)];
    let make = || stage(landscape(3.0), two(), 96, 0.4);
    let keys = ProgramKeys { fill: Some(Fill::Span), ..ProgramKeys::default() };
    let omissions = session(make(), with(keys)).omissions();
    assert!(omissions.iter().any(|omission| omission.what.contains("all photographs but the first")));
    let limits = ProgramKeys { restrictions: Restrictions::as_written(), ..ProgramKeys::default() };
    let stage = generator::Stage { landscape: Arc::clone(&make().landscape), ..make() };
    let error = match generator::Generator::prepare(&panels(with(limits)), stage) {
        Err(error) => error.to_string(),
        Ok(_) => panic!("it was drawn"),
    };
    assert!(error.contains("panels: 3200; the program as listed holds 512"), "{error}");
    assert!(error.contains("panels.limits=false"), "{error}");
}
