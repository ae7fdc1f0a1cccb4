//! Shipped scenarios on the ideal and on the nominal machine, held to the baselines of `tests/timing-baselines/`.
//!
//! Each file is what `lunoid timing record` wrote (docs/timing.md has the command); its name is scenario and model.

use std::path::{Path, PathBuf};

use control_plane::ControlPlane;
use front_door::Wishes;
use hardware_model::{HardwareModel, ModelSource};
use lunoid_tests::shipped::{FULL_LANDSCAPE, TERRAIN, folder};
use scenario::{PoseTable, Scenario};
use timing::{Comparison, TimingRecord, Tolerance, compare};

/// The scenario that was made for the nominal machine, buffers and all.
const NOMINAL: &str = "nominal-drive";
/// Sweeps of a frame of every baseline.
const SWEEPS: u32 = 21;
const MODELS: [&str; 2] = ["ideal", "pra-nominal"];
/// Regions of most scenarios are finer than those that the nominal machine was laid out for: with its buffers, a baseline
/// would be a list of corners that are not there. Drums have tests of their own.
const BUFFER: (&str, &str) = ("buffer.words", "unlimited");

pub fn path(name: &str, model: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("timing-baselines").join(format!("{name}.{model}.json"))
}

/// The frames of `baseline`, timed anew on a model with one key changed, or none.
fn again(name: &str, baseline: &TimingRecord, set: Option<(&str, &str)>) -> TimingRecord {
    let mut scenario =
        Scenario::read(folder().join(format!("{name}.toml"))).unwrap_or_else(|e| panic!("{e}"));
    scenario.raster.sweeps = Some(SWEEPS);
    let source = ModelSource::find(&baseline.machine, Path::new("")).unwrap_or_else(|e| panic!("{e}"));
    let sets: Vec<(String, String)> = (name != NOMINAL)
        .then_some(BUFFER)
        .into_iter()
        .chain(set)
        .map(|(key, value)| (key.into(), value.into()))
        .collect();
    let model = HardwareModel::load(&source, &[], &sets).unwrap_or_else(|e| panic!("{e}")).model;
    let settings = front_door::settings(&scenario, &model).expect("settings of a shipped scenario");
    let stage = front_door::build(&scenario, settings).unwrap_or_else(|e| panic!("{name}: {e}"));
    let (update, yoke) = (stage.settings.timebase.update, stage.settings.yoke);
    let frames = baseline.frames.iter().map(|frame| frame.frame);
    let end = frames.clone().max().map_or(0, |last| last + 1);
    let poses = PoseTable::resolve(&scenario, &stage.landscape, update, yoke, 0..end)
        .unwrap_or_else(|e| panic!("{e}"));
    let master = stage.settings.timebase.master.to_string();
    let control = ControlPlane::of_timing(stage);
    let before_mission = control.before_mission(&poses.rows()[0].pose).expect("a shipped frame");
    let timed =
        |frame: u64| control.frame(frame, &poses.rows()[frame as usize].pose).expect("a shipped frame");
    TimingRecord {
        scenario: scenario.title,
        machine: model.name,
        master,
        // The hash of the inputs is the command's, which `crates/doors/lunoid/tests` holds to a baseline of its own.
        inputs: baseline.inputs.clone(),
        keys: baseline.keys.clone(),
        before_mission,
        frames: frames.map(timed).collect(),
        ..*baseline
    }
}

fn held(name: &str, model: &str, set: Option<(&str, &str)>) -> Comparison {
    let path = path(name, model);
    let baseline = timing::read(&path).unwrap_or_else(|e| panic!("{e}"));
    compare(&baseline, &again(name, &baseline, set), &Tolerance::default())
}

/// Scenarios whose remote shadows take the nominal machine's processor long before the mission, and so this test.
const MANY_SHADOWS: [&str; 4] = ["long-shadows", "regolith", "rough-ride", "showpiece"];

fn expect_baselines_held(is_asked: impl Fn(&str, &str) -> bool) {
    let mut failed = Vec::new();
    for name in TERRAIN.into_iter().chain(FULL_LANDSCAPE).chain([NOMINAL]) {
        for model in MODELS.into_iter().filter(|model| is_asked(name, model)) {
            let comparison = held(name, model, None);
            if !comparison.is_met() {
                failed.push(comparison.text(12));
            }
        }
    }
    assert!(failed.is_empty(), "{}", failed.concat());
}

fn takes_long(name: &str, model: &str) -> bool {
    model != "ideal" && MANY_SHADOWS.contains(&name)
}

#[test]
fn shipped_scenarios_hold_their_baselines() {
    expect_baselines_held(|name, model| !takes_long(name, model));
}

#[test]
#[ignore = "long: .ci/long runs it"]
fn shipped_scenarios_with_many_shadows_hold_their_baselines() {
    expect_baselines_held(takes_long);
}

/// Scenarios of the sampled generator.
const SAMPLED: [&str; 5] = ["night-landing", "stars", "dust-curtain", "lamp-row", "overloaded-night"];

/// The frames of `baseline` on the generator that the scenario names, timed anew with keys set or none.
pub fn of_generator(name: &str, baseline: &TimingRecord, sets: &[(&str, &str)]) -> TimingRecord {
    let set = sets.iter().map(|(key, value)| ((*key).into(), (*value).into())).collect();
    let wishes = Wishes { set, ..Wishes::default() };
    let path = folder().join(format!("{name}.toml"));
    let opened = front_door::open(&path, &wishes).unwrap_or_else(|e| panic!("{name}: {e}"));
    let stage = opened.stage().unwrap_or_else(|e| panic!("{name}: {e}"));
    let timed = opened.generator.timed(stage.clone()).unwrap_or_else(|e| panic!("{e}")).expect("deadlines");
    let end = baseline.frames.last().map_or(0, |last| last.frame + 1);
    let poses = opened.poses(&stage, 0..end).unwrap_or_else(|e| panic!("{e}"));
    let pose = |frame: u64| &poses.rows()[frame as usize].pose;
    let frames = baseline.frames.iter().map(|frame| frame.frame);
    TimingRecord {
        scenario: opened.scenario.title.clone(),
        machine: opened.drawn_by().to_owned(),
        master: timed.master().to_string(),
        inputs: timed.inputs(&opened.scenario),
        keys: baseline.keys.clone(),
        before_mission: timed.before_mission(pose(0)).expect("a shipped frame"),
        frames: frames.map(|frame| timed.frame(frame, pose(frame)).expect("a shipped frame")).collect(),
        ..*baseline
    }
}

/// Scenarios of smooth-shaded faces.
const AT_SEA: [&str; 3] = ["sea-wakes", "ship-landing", "ship-windows"];

#[test]
fn scenarios_of_generators_hold_their_baselines() {
    let mut failed = Vec::new();
    let sampled = SAMPLED.map(|name| (name, "sampled"));
    let at_sea = AT_SEA.map(|name| (name, "smooth-faces"));
    for (name, generator) in sampled.into_iter().chain(at_sea).chain([("lod-descent", "lod-mesh")]) {
        let baseline = timing::read(path(name, generator)).unwrap_or_else(|e| panic!("{e}"));
        let comparison = compare(&baseline, &of_generator(name, &baseline, &[]), &Tolerance::default());
        if !comparison.is_met() {
            failed.push(comparison.text(12));
        }
    }
    assert!(failed.is_empty(), "{}", failed.concat());
}

/// A slower word of the real-time computer is told as such: its sun vectors take longer.
#[test]
fn a_slower_word_of_smooth_faces_is_named() {
    let baseline = timing::read(path("sea-wakes", "smooth-faces")).unwrap_or_else(|e| panic!("{e}"));
    let slower = of_generator("sea-wakes", &baseline, &[("rt.word_us", "4.001")]);
    let text = compare(&baseline, &slower, &Tolerance::default()).text(1000);
    assert!(text.contains("sun-vectors") && text.contains("inputs"), "{text}");
}

/// A vertex more a second of the board changes the time of a frame, and no level.
#[test]
fn a_quicker_board_of_tiles_is_named() {
    let baseline = timing::read(path("lod-descent", "lod-mesh")).unwrap_or_else(|e| panic!("{e}"));
    assert!(baseline.level_changes().count() > 0, "tiles take other levels");
    let quicker = of_generator("lod-descent", &baseline, &[("board.triangles_s", "182e6")]);
    let text = compare(&baseline, &quicker, &Tolerance::default()).text(1000);
    assert!(
        text.contains("gpu.triangle") && text.contains("inputs") && !text.contains("level_changes"),
        "{text}"
    );
}

/// One tick more for a corner is told as such, and as other inputs.
#[test]
fn a_slower_corner_of_the_sampled_generator_is_named() {
    let baseline = timing::read(path("night-landing", "sampled")).unwrap_or_else(|e| panic!("{e}"));
    let slower = of_generator("night-landing", &baseline, &[("sampler.corner_ticks", "2")]);
    let text = compare(&baseline, &slower, &Tolerance::default()).text(1000);
    assert!(text.contains("geometry") && text.contains("inputs"), "{text}");
}

/// One tick of a slower buffer, or of a slower processor, is not let pass, and the diff says what it changed.
#[test]
fn a_part_that_is_a_tick_slower_is_named() {
    let one_tick = [
        ("loader.access_ns", "170", "loader.red.busy"),
        ("loader.strobe_ns", "80", "deadlines.transfer"),
        ("cpu.sweep_setup_us", "16.05", "deadlines.sweep-set-up.least"),
    ];
    for (key, value, named) in one_tick {
        let comparison = held("ridge-crossing", "pra-nominal", Some((key, value)));
        let text = comparison.text(1000);
        assert!(!comparison.is_met() && text.contains(named), "{key}: {text}");
        assert!(comparison.head.is_empty(), "{text}");
    }
}
