//! Ground from a terrain database.

use std::sync::Arc;

use generator::{Generator, PlaneKind, Stage};
use landscape::Posts;
use lod_mesh::{GroundLight, Parameters};

use crate::shots::{draw, generator, pose, run, session, stage};

/// The stage with posts whose heights rise by 0.2 m a metre to the north and 0.3 to the east.
fn stored(places: [Vec<f64>; 2], ranges: Vec<[f64; 2]>) -> Stage {
    let row = |north: f64| places[1].iter().map(move |east| 0.2 * north + 0.3 * east).collect::<Vec<_>>();
    let heights: Vec<f64> = places[0].iter().flat_map(|north| row(*north)).collect();
    let posts = Posts { order: 2, places, heights: heights.into(), ranges, light: None, albedo: None };
    over(posts)
}

fn over(posts: Posts) -> Stage {
    let stage = stage(32);
    let landscape = Arc::new((*stage.landscape).clone().with_posts(Some(posts)));
    Stage { landscape, ..stage }
}

fn every(step: f64, count: u32) -> Vec<f64> {
    (0..count).map(|post| step * f64::from(post)).collect()
}

#[test]
fn the_posts_of_a_database_are_drawn_and_not_the_bank() {
    let session = session(stored([every(100.0, 17), every(100.0, 9)], Vec::new()), Parameters::default());
    let eye = [700.0, 310.0, 900.0];
    let camera = pose(eye, 0.0, -90.0);
    let distance = session.sounding(0, &camera, [&camera; 2]).unwrap().unwrap();
    assert!((distance - (900.0 - 0.2 * 700.0 - 0.3 * 310.0)).abs() < 1e-9, "{distance}");
    // Lit as a plane of its slope.
    let light = 0.8 * stage(32).scenery.sun(0.0).reflectivity([0.2, 0.3]);
    let drawn = f64::from(draw(&*session, 32, &camera).get(PlaneKind::Intensity).unwrap()[16 * 32 + 16]);
    assert!((drawn - light).abs() < 1e-6, "{drawn} {light}");
    let facts = session.explain(0, &camera, [16, 16]).unwrap();
    let tile = facts.iter().find(|fact| fact.what == "tile").unwrap();
    assert!(tile.value.starts_with("column 0, row 1"), "{}", tile.value);
}

#[test]
fn ranges_of_a_database_hold_where_the_scenario_gives_none() {
    let ranges = vec![[500.0, 0.5], [900.0, 0.5], [2000.0, 0.5]];
    let told = |run: Parameters| {
        let session = session(stored([every(100.0, 17), every(100.0, 9)], ranges.clone()), run);
        let facts = session.explain(0, &pose([700.0, 310.0, 900.0], 0.0, -90.0), [16, 16]).unwrap();
        facts.into_iter().find(|fact| fact.what == "levels").unwrap().value
    };
    assert!(told(Parameters::default()).contains("0 to 500 m"));
    assert!(told(Parameters { ranges: vec![450.0, 900.0, 1350.0], ..run() }).contains("0 to 450 m"));
}

#[test]
fn a_last_tile_may_be_narrower_and_other_posts_are_refused() {
    let mut narrow = every(100.0, 5);
    narrow.extend([450.0, 500.0, 550.0, 600.0]);
    let of =
        |east: Vec<f64>| generator(Parameters::default()).prepare(stored([every(100.0, 9), east], vec![]));
    assert!(of(narrow.clone()).is_ok());
    narrow[6] = 490.0;
    let error = of(narrow).err().unwrap().to_string();
    assert!(error.contains("uneven distances"), "{error}");
}

/// A light map that falls from all to none to the east is drawn as it is, whatever the sun; where there is none it is refused.
#[test]
fn stored_light_is_drawn_with_stored_albedo() {
    let stored = |light: Option<Vec<f32>>, albedo: Option<Vec<f32>>| {
        let (places, heights) = ([every(100.0, 17), every(100.0, 9)], vec![0.0; 17 * 9]);
        over(Posts { order: 2, places, heights: heights.into(), ranges: Vec::new(), light, albedo })
    };
    let run = Parameters { light: GroundLight::Stored, ..Parameters::default() };
    let light: Vec<f32> = (0..17 * 9).map(|post| 1.0 - (post % 9) as f32 / 8.0).collect();
    let shown = |albedo: Option<Vec<f32>>| {
        let session = session(stored(Some(light.clone()), albedo), run.clone());
        let planes = draw(&*session, 32, &pose([700.0, 310.0, 900.0], 0.0, -90.0));
        f64::from(planes.get(PlaneKind::Intensity).unwrap()[16 * 32 + 16])
    };
    // The middle of the pixel lies half a pixel of 28 m to the east.
    let share = 1.0 - (310.0 + 900.0 / 32.0 / 2.0) / 800.0;
    assert!((shown(None) - 0.8 * share).abs() < 1e-4, "{} {share}", shown(None));
    assert!((shown(Some(vec![0.5; 17 * 9])) - 0.5 * share).abs() < 1e-4);
    for (stage, told) in
        [(stored(None, None), "database that has none"), (stage(32), "without a terrain database")]
    {
        let error = generator(run.clone()).prepare(stage).err().unwrap().to_string();
        assert!(error.contains(told) && error.contains("lod.light"), "{error}");
    }
    // What is stored and not drawn is told.
    let omissions = session(stored(None, Some(vec![0.5; 17 * 9])), Parameters::default()).omissions();
    assert!(omissions.iter().any(|omission| omission.what.contains("albedo of the terrain database")));
}
