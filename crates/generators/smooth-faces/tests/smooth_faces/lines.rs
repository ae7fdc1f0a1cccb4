//! Scan lines: directions, uncut faces, slots, threads.

use faces::{Cut, Face, Group, Interpolation, Mesh, Pattern, Scan, SeaState, SunProgramme, Vertex};
use generator::PlaneKind;
use glam::DVec3;
use scenario::{Carrier, FaceKind, FaceList};
use smooth_faces::{Hardware, Parameters};

use crate::shots::{
    PIXELS, apart, draw, from_above, gear, light, pose, run, sea, sea_list, session, session_on, stage,
};

/// A diamond on the map whose corners are dark to the west and east, bright to the north and south, under a sun from straight above.
pub fn diamond() -> FaceList {
    let corner = |north: f64, east: f64, up: f64| Vertex {
        place: DVec3::new(150.0 + north, 100.0 + east, 0.0),
        normal: Some(DVec3::new(1.0 - up, 0.0, up).normalize()),
    };
    // A normal that lies has brightness 0, one that stands has 1.
    let vertices = vec![
        corner(30.0, 0.0, 1.0),
        corner(0.0, -30.0, 0.0),
        corner(-30.0, 0.0, 1.0),
        corner(0.0, 30.0, 0.0),
    ];
    let mesh = Mesh::load("diamond", vertices, vec![Face::smooth(vec![0, 1, 2, 3], [1.0; 3])]).unwrap().mesh;
    let zenith = faces::TurningSun::new(std::f64::consts::FRAC_PI_2, 0.0, faces::Turn::STILL).unwrap();
    let group = Group::new("diamond", mesh, 1).under(SunProgramme::Turning(zenith));
    FaceList::new(group, FaceKind::Effect, Carrier::Map(0.0))
}

#[test]
fn an_uncut_diamond_depends_on_the_direction_of_the_scan() {
    let middle = |scan, cut| {
        let run = Parameters { scan, cut, ..run() };
        let session = session(stage(vec![diamond()]), run);
        let picture = light(&*session, 0, &from_above());
        picture[PIXELS / 2 * PIXELS + PIXELS / 2]
    };
    let uncut = [Scan::Horizontal, Scan::Vertical].map(|scan| middle(scan, Cut::Uncut));
    assert!(uncut[0] < 0.05 && uncut[1] > 0.95, "0 against 1: {uncut:?}");
    let cut = [Scan::Horizontal, Scan::Vertical].map(|scan| middle(scan, Cut::Fan));
    assert!((cut[0] - cut[1]).abs() < 1e-6, "{cut:?}");
}

#[test]
fn cut_faces_are_the_same_in_both_directions() {
    for interpolation in [Interpolation::Screen, Interpolation::Perspective] {
        let [vertical, horizontal] = [Scan::Vertical, Scan::Horizontal].map(|scan| {
            let run = Parameters { scan, interpolation, ..run() };
            let sea = sea(SeaState::High, Pattern::Random { seed: 2 });
            light(&*session(stage(vec![sea_list(&sea)]), run), 9, &pose([100.0, 100.0, 20.0], 10.0, -40.0))
        });
        let apart = apart(&vertical, &horizontal);
        assert!(apart < 1e-5, "{interpolation:?}: {apart}");
    }
}

#[test]
fn screen_and_space_differ_where_depths_do() {
    let [screen, space] = [Interpolation::Screen, Interpolation::Perspective].map(|interpolation| {
        let sea = sea(SeaState::High, Pattern::Random { seed: 2 });
        let session = session(stage(vec![sea_list(&sea)]), Parameters { interpolation, ..run() });
        let slant = light(&*session, 0, &pose([100.0, 100.0, 4.0], 0.0, -30.0));
        (slant, light(&*session, 0, &from_above()))
    });
    assert!(apart(&screen.0, &space.0) > 0.01, "{}", apart(&screen.0, &space.0));
    assert!(apart(&screen.1, &space.1) < 1e-6, "from above all depths are one");
}

#[test]
fn pieces_without_a_slot_are_missed_and_are_the_last_ones() {
    let sea = sea(SeaState::High, Pattern::Random { seed: 1 });
    let with = |edges_line| {
        let session = session_on(stage(vec![sea_list(&sea)]), run(), Hardware { edges_line, ..gear() });
        draw(&*session, 0, &pose([10.0, 100.0, 30.0], 0.0, -20.0))
    };
    let (all, counts) = with(None);
    let asked = counts["crossings"];
    assert!(counts["missed"] == 0 && counts["most_crossings"] > 24);
    let (streaked, counts) = with(Some(24));
    // Every line asks for more than 24.
    assert_eq!(counts["missed"], asked - 24 * PIXELS as u64);
    let sky = f32::from(generator::Label::Sky.code());
    let [whole, holes] = [&all, &streaked]
        .map(|planes| planes.get(PlaneKind::Label).unwrap().iter().filter(|label| **label == sky).count());
    assert!(holes > whole, "{holes} {whole}");
}

#[test]
fn threads_change_no_bit() {
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let sea = sea(SeaState::High, Pattern::Random { seed: 1 });
            let run = Parameters { ground: Parameters::default().ground, ..run() };
            light(&*session(stage(vec![sea_list(&sea)]), run), 5, &pose([100.0, 100.0, 6.0], 20.0, -10.0))
        })
    };
    assert_eq!(with(1), with(3));
}
