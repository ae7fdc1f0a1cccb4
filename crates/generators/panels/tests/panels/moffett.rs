//! The shipped scenarios of the thesis's posts: panels that each observer loses.

use std::path::PathBuf;

use diagnostics::{Layers, Problems, TomlFile};
use generator::{Generator, PlaneKind, Planes, Session, Stage};
use panels::ROW;
use photograph::Photograph;
use scenario::Pose;
use signal::Probe;

use crate::shots::{landscape, pose, stage};

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../scenarios")
}

/// The generator that the table `[panels]` of a text asks for.
pub fn configured(text: &str) -> Result<std::sync::Arc<dyn Generator>, String> {
    let problems = Problems::new();
    let texts = [ROW.gear.unwrap().text, text];
    let layers = texts.map(|text| TomlFile::parse("moffett.toml", text, &problems).expect("TOML"));
    let layers = Layers::new(layers);
    let root = layers.root(&problems);
    let generator = (ROW.configure)(&root);
    root.table_or_empty("panels").finish();
    problems.resolve(generator).map_err(|problems| problems.to_string())
}

pub fn scenario(name: &str) -> String {
    std::fs::read_to_string(folder().join(format!("{name}.toml"))).unwrap()
}

/// A frame of the photograph, seen by the screen of the thesis.
pub fn frame_stage(photograph: &str) -> Stage {
    let [picture, camera] = ["png", "json"].map(|end| folder().join(format!("moffett/{photograph}.{end}")));
    let photograph = Photograph::read(&picture, &camera).unwrap();
    stage(landscape(0.0), vec![photograph], 512, 1600.0 / 15_000.0)
}

/// The scenario's generator over its photograph, seen by its screen.
pub fn session(text: &str, photograph: &str) -> Box<dyn Session> {
    configured(text).unwrap().prepare(frame_stage(photograph)).unwrap()
}

/// Poses of a path file.
pub fn poses(name: &str) -> Vec<Pose> {
    let text = std::fs::read_to_string(folder().join(format!("{name}.csv"))).unwrap();
    let rows = text.lines().skip(1).map(|line| {
        let of = |column: usize| line.split(',').nth(column).unwrap().parse::<f64>().unwrap();
        pose([of(1), of(2), of(3)], of(4), of(5))
    });
    rows.collect()
}

/// Panels, discarded panels and pixels that show ground.
fn seen(session: &dyn Session, pose: &Pose) -> [u64; 3] {
    let mut planes = Planes::new(512, 512, &[PlaneKind::Intensity, PlaneKind::Label]);
    let counts = session.frame(0, pose, &mut planes, &mut Probe::off()).unwrap();
    let ground = planes.get(PlaneKind::Label).unwrap().iter().filter(|label| **label > 0.0).count();
    let [panels, discarded] = ["panels", "discarded_panels"].map(|name| counts.get(name).unwrap());
    [panels, discarded, ground as u64]
}

#[test]
fn observers_lose_three_panels_none_and_all() {
    let session = session(&scenario("moffett"), "frame");
    // The path begins at observer 2 and goes on by observer 1 to observer 3.
    let found: Vec<[u64; 3]> = poses("moffett").iter().map(|pose| seen(&*session, pose)).collect();
    assert_eq!(
        found.iter().map(|seen| [seen[0], seen[1]]).collect::<Vec<_>>(),
        [[176, 0], [176, 3], [176, 176]]
    );
    assert!(found[1][2] > 10_000 && found[0][2] > 1000 && found[2][2] == 0, "{found:?}");
}

#[test]
fn the_moved_block_has_lost_panels_at_the_border() {
    let text = scenario("moffett-moved");
    let [pose, _] = poses("moffett-moved")[..] else { panic!("two rows") };
    assert_eq!(seen(&*session(&text, "moved"), &pose)[..2], [176, 67]);
    let kept = text.replace("restrictions = true", "restrictions = true\ndiscard_partial = false");
    assert_eq!(seen(&*session(&kept, "moved"), &pose)[1], 0);
}

#[test]
fn faults_of_the_tables_are_named() {
    let refused = |from: &str, to: &str| {
        let text = scenario("moffett").replace(from, to);
        configured(&text).err().unwrap_or_else(|| panic!("{to} was read"))
    };
    assert!(refused("restrictions = true", "quadrants = true").contains("quadrants"));
    assert!(refused("restrictions = true", "fill = \"spam\"").contains("edge-buffer"));
    assert!(refused("latitude = \"37:22:47 N\"", "latitude = \"-37:22:47 N\"").contains("-37:22:47 N"));
    assert!(refused("rows = [71, 79]", "rows = [79, 71]").contains("at most 512 apart"));
    assert!(refused("height_m = 83", "height_m = \"viod\"").contains("void"));
}

#[test]
fn void_posts_are_filled_and_told() {
    let text = scenario("moffett").replace("height_m = 43", "height_m = \"void\"");
    let session = session(&text, "frame");
    let pose = poses("moffett")[1];
    let pixels =
        (60..200).step_by(20).flat_map(|line| (160..320).step_by(20).map(move |column| [column, line]));
    let facts = pixels.flat_map(|pixel| session.explain(0, &pose, pixel).unwrap());
    let told: Vec<String> = facts.filter(|fact| fact.what == "void").map(|fact| fact.value).collect();
    assert!(told.iter().any(|value| value == "a post of it was void"), "{told:?}");
}

#[test]
fn void_panels_are_marked_to_the_last_picture() {
    let text = scenario("moffett").replace("height_m = 83", "height_m = \"void\"");
    let marked = text.replace("restrictions = true", "restrictions = true\nvoids = \"mark\"\noutside = 1");
    let pose = poses("moffett")[1];
    let [(filled, usual), (shown, void)] = [text, marked].map(|text| {
        let mut planes = Planes::new(512, 512, &[PlaneKind::Intensity, PlaneKind::Label]);
        let mut probe = Probe::new(vec!["panels.void".into()], 0..512);
        session(&text, "frame").frame(0, &pose, &mut planes, &mut probe).unwrap();
        let gates: Vec<f64> = probe.waveforms.into_iter().flat_map(|wave| wave.values).collect();
        let void = f32::from(generator::Label::Void.code());
        let labels = planes.get(PlaneKind::Label).unwrap().iter();
        assert!(labels.zip(&gates).all(|(label, gate)| (*label == void) == (*gate == 1.0)));
        (planes.get(PlaneKind::Intensity).unwrap().to_vec(), gates)
    });
    assert_eq!(usual, void, "the mask does not depend on what is drawn");
    assert!(void.iter().filter(|gate| **gate == 1.0).count() > 500);
    for ((filled, shown), gate) in filled.iter().zip(&shown).zip(&void) {
        if *gate == 1.0 { assert_eq!(*shown, 1.0) } else { assert_eq!(shown, filled) }
    }
}

#[test]
fn the_mean_makes_cliffs_of_59_metres() {
    // From 2000 m above the middle between two voids, on the second of the three rows: metres of a second of arc by the specification.
    let above =
        pose([5500.0 + 75.0 * 30.828_509_790_897, -3900.0 + 177.5 * 24.595_947_522_007, 2000.0], 0.0, -90.0);
    let height = |text: &str| {
        let mut planes = Planes::new(512, 512, &[PlaneKind::Distance]);
        session(text, "frame").frame(0, &above, &mut planes, &mut Probe::off()).unwrap();
        2000.0 - f64::from(planes.get(PlaneKind::Distance).unwrap()[256 * 512 + 256])
    };
    let written = scenario("moffett-void");
    let harmonic = written.replace("mean_void = true", "mean_void = false");
    // The mean of 102 known posts is 24.96 m, cut to 24; posts beside the voids are 83 m high.
    assert!((height(&written) - 24.0).abs() < 0.1, "{}", height(&written));
    // At equilibrium 3 a = 43 + 83 + b and 3 b = 83 + 2 a, by symmetry: a = 65.86 in the outer rows, b = 71.57 in the middle one.
    assert!((height(&harmonic) - 71.57).abs() < 0.3, "{}", height(&harmonic));
}
