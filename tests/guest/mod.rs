//! The example generator of `docs/adding-a-generator.md`, put to every use that a row of the registry has.

mod flat;

use std::fs;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use generator::{Generator, PlaneKind, Planes, PrepareError, Session, Stage, Weight};
use hardware_model::HardwareModel;
use picture::Depth;
use quantities::luminance;
use replay::{Control, Job, Pictures, RunFolder};
use report::write_side_by_side;
use run_record::{Inputs, Program};
use scenario::{Pose, PoseTable, Scenario};
use signal::Probe;

use flat::ROW;

const SCENARIO: &str = r#"format = 1
title = "A plain"
shows = "Level ground under a low sun."
frames = 2
[landscape]
albedo = 0.8
[landscape.generated]
seed = 1
extent_m = [600, 640]
region_size_m = 40
[sun]
azimuth_deg = 10
elevation_deg = 30
[path]
file = "plain.csv"
[raster]
sweeps = 48
columns = 48
lines = 32
[range]
programme = "geometric"
start_m = 1
end_m = 300
[laws]
curvature = "none"
pixel_rule = "centre"
"#;

const COLOUR: [f64; 3] = [0.9, 0.6, 0.3];

/// A file of this folder: its path is `plain.csv`.
fn here(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("guest").join(name).to_string_lossy().into_owned()
}

fn scenario(more: &str) -> Scenario {
    Scenario::parse(&here("plain.toml"), &format!("{SCENARIO}{more}"))
        .unwrap_or_else(|problems| panic!("{problems}"))
}

fn stage(scenario: &Scenario) -> Stage {
    let settings = front_door::settings(scenario, &HardwareModel::ideal()).unwrap();
    front_door::build(scenario, settings).unwrap_or_else(|error| panic!("{error}")).stage()
}

fn pose(scenario: &Scenario, stage: &Stage, frame: u64) -> Pose {
    let (update, landscape) = (stage.view.update, &stage.landscape);
    PoseTable::resolve(scenario, landscape, update, None, frame..frame + 1).unwrap().rows()[0].pose
}

/// The example with a colour, as the registry configures it.
fn flat() -> Arc<dyn Generator> {
    let [red, green, blue] = COLOUR;
    registry::configure_with(&ROW, &[("flat.colour", &format!("[{red}, {green}, {blue}]"))]).unwrap()
}

fn drawn(
    session: &dyn Session,
    stage: &Stage,
    pose: &Pose,
    kinds: &[PlaneKind],
    probe: &mut Probe,
) -> Planes {
    let mut planes = Planes::new(stage.view.columns as usize, stage.view.lines as usize, kinds);
    session.frame(1, pose, &mut planes, probe).unwrap();
    planes
}

#[test]
fn it_agrees_with_the_judge() {
    let scenario = scenario("");
    let stage = stage(&scenario);
    let pose = pose(&scenario, &stage, 1);
    let kinds = [PlaneKind::Intensity, PlaneKind::Range];
    // White ground, so that its luminance is the judge's intensity.
    let white = registry::configure_with(&ROW, &[("flat.colour", "[1, 1, 1]")]).unwrap();
    let [found, expected] = [white.prepare(stage.clone()), registry::judge_on(stage.clone())]
        .map(|session| drawn(&*session.unwrap(), &stage, &pose, &kinds, &mut Probe::off()));
    let ground = expected.get(PlaneKind::Range).unwrap().iter().filter(|range| range.is_finite()).count();
    assert!(ground > 300 && ground < 48 * 32, "{ground}");
    for (kind, near) in [(PlaneKind::Intensity, 1e-6), (PlaneKind::Range, 1e-4)] {
        let pairs = found.get(kind).unwrap().iter().zip(expected.get(kind).unwrap());
        assert!(pairs.into_iter().all(|(a, b)| a == b || (a - b).abs() <= near), "{kind:?}");
    }
}

#[test]
fn its_intensity_is_the_luminance_of_its_colour() {
    let scenario = scenario("");
    let stage = stage(&scenario);
    let session = flat().prepare(stage.clone()).unwrap();
    let pose = pose(&scenario, &stage, 0);
    let kinds = [PlaneKind::Intensity, PlaneKind::Red, PlaneKind::Green, PlaneKind::Blue];
    assert!(kinds.iter().all(|kind| flat().planes().contains(kind)));
    let planes = drawn(&*session, &stage, &pose, &kinds, &mut Probe::off());
    let [grey, red, green, blue] = kinds.map(|kind| planes.get(kind).unwrap());
    let lit = red.iter().position(|value| *value > 0.0).expect("ground in sight");
    // Albedo 0.8 under a sun at 30 degrees.
    let expected = COLOUR.map(|part| 0.4 * part);
    for (found, expected) in [red, green, blue].into_iter().zip(expected) {
        assert!((f64::from(found[lit]) - expected).abs() < 1e-7, "{} {expected}", found[lit]);
    }
    assert!((f64::from(grey[lit]) - luminance(expected)).abs() < 1e-7);
}

#[test]
fn it_is_timed_by_events_of_its_own() {
    let scenario = scenario("");
    let stage = stage(&scenario);
    let timed = flat().timed(stage.clone()).unwrap().expect("its row says that it is timed");
    let frame = timed.frame(1, &pose(&scenario, &stage, 1)).unwrap();
    assert_eq!((frame.ticks, frame.events, frame.tasks[0].pieces), (48 * 32, 32, 48 * 32));
    assert_eq!(
        (timed.master().to_string().as_str(), frame.units[0].unit.as_str()),
        ("1000000 Hz", "painter")
    );
    assert_eq!(timed.inputs(&scenario).len(), 64);
}

#[test]
fn its_lines_are_probed_and_its_pixels_explained() {
    let scenario = scenario("");
    let stage = stage(&scenario);
    let (generator, pose) = (flat(), pose(&scenario, &stage, 1));
    let scan = generator.scan(&stage.view).unwrap();
    assert_eq!((scan.line, scan.timebase.sweeps), ("line", 32));
    let session = generator.prepare(stage.clone()).unwrap();
    let mut probe = Probe::new(vec!["flat.*".into()], 30..31);
    let planes = drawn(&*session, &stage, &pose, &[PlaneKind::Range], &mut probe);
    let [range, light] = probe.waveforms.as_slice() else { panic!("{:?}", probe.waveforms.len()) };
    assert_eq!((range.signal.name, light.values.len(), range.sweep), ("flat.range", 48, 30));
    let line = &planes.get(PlaneKind::Range).unwrap()[30 * 48..31 * 48];
    assert!(line.iter().zip(&range.values).all(|(plane, wave)| f64::from(*plane) - wave < 1e-4));
    assert_eq!(session.wires().len(), generator.signals().len());
    let facts = session.explain(1, &pose, [20, 30]).unwrap();
    let words: Vec<&str> = facts.iter().map(|fact| fact.what.as_str()).collect();
    assert_eq!(words, ["ray", "range", "light"]);
    let above = session.explain(1, &pose, [20, 0]).unwrap();
    assert_eq!(above[1].what, "sky");
}

#[test]
fn what_it_cannot_draw_is_refused_or_listed() {
    let tilted = SCENARIO.replace("region_size_m = 40", "region_size_m = 40\ntilt_m_per_m = [0.1, 0]");
    let tilted =
        Scenario::parse(&here("tilted.toml"), &tilted).unwrap_or_else(|problems| panic!("{problems}"));
    let refused = flat().prepare(stage(&tilted)).err().expect("relief");
    let PrepareError::Unsupported { generator, what, .. } = &refused;
    assert_eq!((*generator, what.as_str()), ("flat", "ground with relief"));
    let rocks = "[shadows]\nfinest_m = 0.5\n";
    let omissions = flat().prepare(stage(&scenario(rocks))).unwrap().omissions();
    assert_eq!(
        omissions.iter().map(|omission| omission.what.as_str()).collect::<Vec<_>>(),
        ["remote shadow"]
    );
    assert!(omissions.iter().all(|omission| omission.weight == Weight::NotModelled));
    let wrong = registry::configure_with(&ROW, &[("flat.colour", "[1, 1]")]).err().expect("three numbers");
    assert!(wrong.to_string().contains("flat.colour"), "{wrong}");
}

/// A run of `generator` in the folder `name` of `at`.
fn run(at: &Path, name: &str, generator: Arc<dyn Generator>, colour: bool) {
    let scenario = scenario("");
    let [program, version, commit, result_family] = ["lunoid", "0", "c", "unfused"].map(str::to_owned);
    let job = Job {
        program: Program { name: program, version, commit, result_family },
        inputs: Inputs { model: "ideal".into(), ..Inputs::default() },
        scenario: &scenario,
        generator,
        stage: stage(&scenario),
        frames: 0..2,
        shard: None,
        pictures: Pictures { depth: Depth::Eight, colour, refresh: false, film: false },
        check: 0,
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
    let folder = RunFolder::claim(&at.join(name), false).unwrap();
    let cancel = AtomicBool::new(false);
    let control = Control { pool: &pool, cancel: &cancel, progress: &|_| () };
    replay::run(&job, &folder, &control, &mut replay::Phases::since(std::time::Instant::now())).unwrap();
}

#[test]
fn it_is_put_side_by_side_with_the_judge() {
    let judge = registry::judge();
    let put = |judge_in_colour: bool| {
        let at = tempfile::tempdir().unwrap();
        run(at.path(), "flat", flat(), true);
        run(at.path(), judge.name, registry::configure_with(judge, &[]).unwrap(), judge_in_colour);
        let names = ["flat", judge.name].map(str::to_owned);
        let (figures, page) = write_side_by_side(at.path(), &names, Some(judge.name)).unwrap();
        (
            serde_json::to_value(&figures).unwrap()["machines"][0].clone(),
            fs::read_to_string(page).unwrap(),
            at,
        )
    };
    let (machine, page, at) = put(false);
    assert_eq!(machine["generator"], "flat");
    assert!(machine["errors"].as_array().is_some_and(|errors| errors.len() == 2), "{machine}");
    // Both in colour: the ground of this scene is grey, so its luminance is what the grey judge has.
    let (coloured, page_in_colour, _) = put(true);
    assert_eq!(coloured["errors"], machine["errors"]);
    assert!(page_in_colour.contains("drawn whole"));
    assert!(page.contains(">flat<") && page.contains("drawn whole"));
    let record = fs::read_to_string(at.path().join("flat/run.json")).unwrap();
    assert!(record.contains("\"kind\": \"RGB PNG\"") && record.contains("\"line\": \"line\""));
}

#[test]
fn the_page_shows_this_very_code() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(here.join("../docs/adding-a-generator.md")).unwrap();
    let code = fs::read_to_string(here.join("guest/flat.rs")).unwrap();
    assert!(page.contains(&format!("```rust\n{code}```\n")), "docs/adding-a-generator.md shows other code");
    assert!(code.lines().count() < 300);
}
