//! Where the eye may stand.

use generator::{Generator, PlaneKind, Planes};
use signal::Probe;

use crate::shots::{SIDE, draw, generator, pose, run, session, sky, stage};

#[test]
fn beside_the_ground_there_is_nothing_and_the_rest_is_drawn() {
    let session = session(stage(32), run());
    // Looks north from south of the ground: ground begins ahead.
    let planes = draw(&*session, 32, &pose([-400.0, SIDE / 2.0, 300.0], 0.0, -30.0));
    let seen = 32 * 32 - sky(&planes);
    assert!(seen > 100 && sky(&planes) > 100, "{seen}");
}

#[test]
fn an_eye_in_the_ground_is_refused() {
    let session = session(stage(32), run());
    let mut planes = Planes::new(32, 32, &[PlaneKind::Intensity]);
    let inside = pose([800.0, 800.0, -500.0], 0.0, 0.0);
    let error = session.frame(3, &inside, &mut planes, &mut Probe::off()).unwrap_err().to_string();
    assert!(error.contains("frame 3") && error.contains("under the ground"), "{error}");
    let nowhere = pose([f64::NAN, 0.0, 10.0], 0.0, 0.0);
    assert!(session.check(0, &nowhere).is_err());
}

#[test]
fn an_eye_above_the_landscape_and_under_its_triangles_is_refused() {
    let coarse = lod_mesh::Parameters {
        spacing: Some(200.0),
        order: 1,
        levels: Some(1),
        ranges: vec![450.0],
        ..run()
    };
    let stage = stage(32);
    let landscape = stage.landscape.clone();
    let session = session(stage, coarse);
    let refused = (0..400).find_map(|step| {
        let [x, y] = [f64::from(step % 20), f64::from(step / 20)].map(|at| 10.0 + 79.0 * at);
        let eye = [x, y, landscape.height(x, y).unwrap() + 0.5];
        session.check(7, &pose(eye, 0.0, 0.0)).err()
    });
    let told = refused.unwrap().to_string();
    assert!(told.contains("frame 7") && told.contains("posts 200.0 m apart"), "{told}");
}

#[test]
fn too_many_posts_are_refused_with_their_number() {
    let run = lod_mesh::Parameters { spacing: Some(0.1), ..run() };
    let error = generator(run).prepare(stage(32)).err().unwrap().to_string();
    assert!(error.contains("256032001 posts") && error.contains("lod.spacing_m"), "{error}");
}
