//! What is told of a pixel, of a frame, and of levels.

use generator::PlaneKind;
use signal::Probe;

use crate::shots::{draw, pose, run, session, stage};

#[test]
fn a_pixel_tells_its_tile_and_its_heights() {
    let session = session(stage(64), run());
    // 500 m above the middle of a tile: a ninth of the second range is over, and nothing morphs yet.
    let facts = session.explain(0, &pose([760.0, 760.0, 560.0], 0.0, -90.0), [32, 32]).unwrap();
    let text = |name: &str| facts.iter().find(|fact| fact.what == name).unwrap().value.clone();
    assert!(text("tile").starts_with("column 9, row 9"), "{}", text("tile"));
    assert!(text("level").starts_with("1 (range to 900 m), 0.0000"), "{}", text("level"));
    let heights = text("height");
    let number = |word: &str| {
        let part = heights.split("; ").find(|part| part.contains(word)).unwrap();
        part.split(' ').next().unwrap().parse::<f64>().unwrap()
    };
    assert!((number("m as drawn") - number("m before morphing")).abs() < 1e-9, "{heights}");
    assert!((number("m by the finest") - number("m by the landscape")).abs() < 3.0, "{heights}");
}

#[test]
fn counters_are_of_the_tiles_in_view() {
    let session = session(stage(64), run());
    let mut planes = generator::Planes::new(64, 64, &[PlaneKind::Intensity]);
    let counts =
        session.frame(0, &pose([800.0, 800.0, 150.0], 0.0, -90.0), &mut planes, &mut Probe::off()).unwrap();
    // 150 m of ground in view: 2 or 3 tiles of 80 m each way, and those that its relief brings in.
    assert!((4..=25).contains(&counts["tiles"]), "{}", counts["tiles"]);
    assert_eq!(counts["vertices"], counts["tiles"] * 81);
    assert_eq!((counts["ground_triangles"], counts["morphing"]), (counts["tiles"] * 128, 0));
}

#[test]
fn a_zone_shorter_than_a_tile_is_warned_of_with_its_number() {
    let short = lod_mesh::Parameters { shares: vec![0.1], ..run() };
    let omissions = session(stage(32), short.clone()).omissions();
    let why = omissions.iter().map(|omission| omission.why.clone()).collect::<String>();
    assert!(why.contains("45 m is shorter than a tile of 80 m"), "{why}");
    let switched = lod_mesh::Parameters { transition: lod_mesh::Transition::Switch, ..short };
    assert!(session(stage(32), switched).omissions().is_empty(), "levels that switch have no zones");
    assert!(session(stage(32), run()).omissions().is_empty());
}

#[test]
fn distances_are_those_of_the_drawn_ground() {
    let session = session(stage(65), lod_mesh::Parameters { levels: Some(1), ranges: vec![450.0], ..run() });
    let eye = [803.0, 811.0, 300.0];
    let planes = draw(&*session, 65, &pose(eye, 0.0, -90.0));
    let middle = planes.get(PlaneKind::Distance).unwrap()[32 * 65 + 32];
    let stage = stage(65);
    let ground = stage.landscape.height(803.0, 811.0).unwrap();
    let slopes = stage.landscape.at(803.0, 811.0).unwrap().slopes;
    let light = 0.8 * stage.scenery.sun(0.0).reflectivity(slopes);
    let drawn = f64::from(planes.get(PlaneKind::Intensity).unwrap()[32 * 65 + 32]);
    assert!((drawn - light).abs() < 0.03, "{drawn} {light}");
    assert!((f64::from(middle) - (300.0 - ground)).abs() < 1.5, "{middle} {ground}");
}

/// Rows above the middle of a tile: level, fraction and distance are those of the tiles that pixels show.
#[test]
fn rows_tell_the_tiles_that_they_show() {
    let session = session(stage(64), run());
    let ground = stage(64).landscape.at_spacing(760.0, 760.0, 10.0).unwrap().height;
    let eye = pose([760.0, 760.0, ground + 400.0], 0.0, -90.0);
    let mut planes = generator::Planes::new(64, 64, &[PlaneKind::Intensity]);
    let mut probe = Probe::new(vec!["*".into()], 32..33);
    session.frame(0, &eye, &mut planes, &mut probe).unwrap();
    let wave = |name: &str| &probe.waveforms.iter().find(|wave| wave.signal.name == name).unwrap().values;
    assert_eq!(probe.waveforms.len(), session.wires().len());
    assert_eq!((wave("lod.column")[32], wave("lod.level")[32]), (32.0, 0.0));
    let (distance, fraction) = (wave("lod.distance")[32], wave("lod.fraction")[32]);
    assert!((distance - 400.0).abs() < 1e-9, "{distance}");
    // Of the zone from 270 to 450 m, 130 m are behind it.
    assert!((fraction - 130.0 / 180.0).abs() < 1e-9, "{fraction}");
    // A tile of 8 x 8 cells; a vertex has at most what the tile loses to the next level still to go.
    assert_eq!(wave("lod.triangles")[32], 128.0);
    let lost = 0.7 * wave("lod.delta")[32] / (1.0 - fraction);
    assert!(lost > 1.0 && lost < 60.0, "{lost}");
    // All of the row is ground, and levels are those of distances.
    for (level, distance) in wave("lod.level").iter().zip(wave("lod.distance")) {
        assert_eq!(*level, if *distance < 450.0 { 0.0 } else { 1.0 }, "{distance}");
    }
}

/// From straight above, an edge runs along every row of vertices: the picture has as many bright lines as the ground has.
#[test]
fn wires_are_the_edges_of_the_triangles() {
    let wires =
        lod_mesh::Parameters { show: lod_mesh::Show::Wires, levels: Some(1), ranges: vec![450.0], ..run() };
    let session = session(stage(200), wires);
    let planes = draw(&*session, 200, &pose([755.0, 755.0, 200.0], 0.0, -90.0));
    let light = planes.get(PlaneKind::Intensity).unwrap();
    let edges = light.iter().filter(|light| **light > 0.1).count();
    let fill = light.iter().filter(|light| (0.01..0.03).contains(*light)).count();
    assert_eq!(edges + fill, 200 * 200);
    // 200 m of ground in 200 pixels: in a row that crosses 20 cells, 20 upright edges and 20 slanting ones, and rows along edges.
    let share = edges as f64 / f64::from(200 * 200);
    assert!((0.22..0.40).contains(&share), "{share}");
}
