//! The twelve pictures of the report's exhibits.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use generator::{Generator, PlaneKind, Planes};
use lunoid_tests::Shipped;
use quantities::degrees;
use signal::Probe;

use crate::lunsim::shared::distance;

/// The program as it ships, which is how the exhibits run it.
fn program() -> Arc<dyn Generator> {
    registry::configure_with(&lunsim::ROW, &[]).unwrap()
}

const EXHIBITS: [&str; 3] = ["lunsim-landing", "lunsim-roving", "lunsim-sun"];

#[test]
fn all_twelve_show_one_map_of_about_400_craters() {
    let maps = EXHIBITS.map(|name| Shipped::read(name, None).landscape);
    assert_eq!(maps[0].features().craters().len(), 406);
    assert_eq!(maps[0].level().extent(), [0.0, 0.0, 43_000.0, 43_000.0]);
    assert!(maps.iter().all(|map| map.features() == maps[0].features()));
}

/// A lands on a crater and ends straight above it, B looks 35 degrees down and goes on northwards, C turns sun and
/// observer.
#[test]
fn the_exhibits_look_as_the_appendix_says() {
    let poses = |name: &str| {
        let shipped = Shipped::read(name, None);
        let sun = |time: f64| degrees(shipped.stage().scenery.sun(time).azimuth).rem_euclid(360.0).round();
        [0, 1, 2, 3].map(|frame| {
            let pose = shipped.pose(frame).pose;
            let [pitch, heading] = [pose.attitude.pitch, pose.attitude.heading].map(|a| degrees(a).round());
            (pose.eye, pitch, heading, sun(pose.time))
        })
    };
    let [landing, roving, relations] = EXHIBITS.map(poses);
    assert!(landing.windows(2).all(|pair| pair[1].0[2] < pair[0].0[2]));
    assert_eq!(landing.map(|(_, pitch, ..)| pitch), [-60.0, -50.0, -50.0, -90.0]);
    assert!(roving.iter().all(|&(_, pitch, heading, sun)| [pitch, heading, sun] == [-35.0, 0.0, 270.0]));
    assert!(roving.windows(2).all(|pair| pair[1].0[0] - pair[0].0[0] == 1500.0));
    let turned = relations.map(|(_, _, heading, sun)| (sun - heading).rem_euclid(360.0));
    assert_eq!(turned, [270.0, 0.0, 180.0, 0.0]);
    let shipped = Shipped::read("lunsim-landing", None);
    let [x, y, _] = landing[3].0;
    let below = shipped
        .landscape
        .features()
        .craters()
        .iter()
        .find(|crater| (0..2).all(|axis| (crater.centre()[axis] - [x, y][axis]).abs() < 5.0));
    assert!(below.is_some_and(|crater| crater.foot() > 300.0), "{below:?}");
}

/// No sky, as restricted; the first and the last beside `exact`: reflectivity is off by the grid alone, intensity by half a code besides.
#[test]
fn every_frame_is_ground_from_edge_to_edge_and_near_exact() {
    for name in EXHIBITS {
        let shipped = Shipped::read(name, None);
        assert_eq!(shipped.frames(), 4);
        let (program, stage) = (program(), shipped.stage().stage());
        let session = program.prepare(stage.clone()).unwrap();
        for frame in 0..4 {
            let pose = shipped.pose(frame).pose;
            let mut planes = Planes::new(1024, 1024, &[PlaneKind::Range]);
            session.frame(frame, &pose, &mut planes, &mut Probe::off()).unwrap();
            let sky =
                planes.get(PlaneKind::Range).unwrap().iter().filter(|range| range.is_infinite()).count();
            assert_eq!(sky, 0, "{name} {frame}");
            if frame % 3 != 0 {
                continue;
            }
            let found = distance(&*program, &stage, frame, &pose, 64);
            println!("{name} {frame}: {found:?}");
            assert!(found.reflectivity < 0.01 && found.intensity < 0.02, "{name} {frame}: {found:?}");
            assert!(found.shade < 0.015 && found.missing == 0.0, "{name} {frame}: {found:?}");
        }
    }
}

/// Table 1 of the appendix: run parameters, and the viewed-area limits that the program printed. The page has what is found here.
#[test]
fn the_legend_of_the_charts_is_that_of_the_page() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/blocks/lunsim.md");
    let page = fs::read_to_string(page).unwrap();
    for (letter, name) in ["A", "B", "C"].into_iter().zip(EXHIBITS) {
        let shipped = Shipped::read(name, None);
        let stage = shipped.stage().stage();
        let session = program().prepare(stage.clone()).unwrap();
        for frame in 0..4 {
            let pose = shipped.pose(frame).pose;
            let facts = session.explain(frame, &pose, [512, 512]).unwrap();
            assert_eq!(
                facts.iter().map(|fact| fact.what.as_str()).collect::<Vec<_>>(),
                ["viewed area", "point", "ground", "light", "code"]
            );
            let sun = stage.scenery.sun(pose.time);
            let [heading, depression, azimuth, elevation] =
                [pose.attitude.heading, -pose.attitude.pitch, sun.azimuth, sun.elevation]
                    .map(|angle| degrees(angle).rem_euclid(360.0).round());
            let row = format!(
                "| {letter}{} | {:.0}, {:.0}, {:.0} | {heading}, {depression} | {azimuth}, {elevation} | {} |",
                frame + 1,
                pose.eye[0],
                pose.eye[1],
                pose.eye[2],
                facts[0].value
            );
            assert!(page.contains(&row), "the page has not: {row}");
        }
    }
}

/// The figures of `scenarios/README.md`.
#[test]
fn the_figures_of_the_scenarios() {
    let look = |name: &str, frame: u64| {
        let shipped = Shipped::read(name, None);
        let mut planes = Planes::new(1024, 1024, &[PlaneKind::Shadow]);
        let (program, stage) = (program(), shipped.stage().stage());
        let session = program.prepare(stage.clone()).unwrap();
        let counts = session.frame(frame, &shipped.pose(frame).pose, &mut planes, &mut Probe::off()).unwrap();
        let dark = planes.get(PlaneKind::Shadow).unwrap().iter().filter(|code| **code > 0.0).count();
        (counts["features"], (1000.0 * dark as f64 / (1024.0 * 1024.0)).round() / 10.0)
    };
    let landing = [0, 3].map(|frame| look("lunsim-landing", frame).0);
    let roving = [0, 1, 2, 3].map(|frame| look("lunsim-roving", frame).0);
    let relations = [0, 1, 2, 3].map(|frame| look("lunsim-sun", frame).1);
    assert_eq!(landing, [234, 3]);
    assert_eq!(roving, [15, 16, 14, 14]);
    assert_eq!(relations, [7.5, 8.9, 5.2, 14.3]);
}
