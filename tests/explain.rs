//! From a pixel to its wires: what is told is what the machine did, and where `exact` sees it.

use control_plane::{ControlPlane, MachineStage};
use exact::Columns;
use explain::{Explanation, Inquiry, InquiryError, Writer};
use generator::{PlaneKind, Session};
use hardware_model::{Economy, HardwareModel, ModelSource};
use lunoid_tests::{Dice, Shipped, shipped};
use machine::Prepare;
use signal::Probe;

fn told(stage: &MachineStage, scene: &Shipped, frame: u64, pixels: &[[usize; 2]]) -> Vec<Explanation> {
    told_by(&*stage.clone().prepare(), stage, scene, frame, pixels)
}

/// What a machine that is ready tells of pixels.
fn told_by(
    session: &dyn Session,
    stage: &MachineStage,
    scene: &Shipped,
    frame: u64,
    pixels: &[[usize; 2]],
) -> Vec<Explanation> {
    let (control, exact) = (ControlPlane::new(stage.clone()), Columns::new(stage.stage()));
    let inquiry = Inquiry::new(stage, session, &control, Some(&exact));
    let pose = scene.pose(frame).pose;
    pixels.iter().map(|&pixel| inquiry.explain(frame, &pose, pixel).unwrap()).collect()
}

fn pixels(scene: &Shipped, seed: u64, count: usize) -> Vec<[usize; 2]> {
    let raster = scene.settings.raster;
    let mut dice = Dice::new(seed);
    (0..count)
        .map(|_| [dice.count(0, raster.columns as usize - 1), dice.count(0, raster.lines as usize - 1)])
        .collect()
}

#[test]
fn ground_is_where_exact_sees_it() {
    let (mut same, mut seen) = (0, 0);
    for (name, frame) in [("first-light", 60), ("craters", 10), ("descent", 20)] {
        let scene = Shipped::read(name, Some(96));
        for told in told(&scene.stage(), &scene, frame, &pixels(&scene, 11, 12)) {
            let exact = told.exact.as_ref().unwrap();
            let (Some(ground), Some(range)) = (&told.ground, exact.range_m) else { continue };
            if told.writer != Writer::Ground {
                continue;
            }
            seen += 1;
            // Within two samples of the programme: the stroke ends at the next sample.
            same += usize::from((ground.range_m / range - 1.0).abs() < 0.03);
            assert!(ground.colours.iter().all(|colour| !colour.stale), "{name}: {told:?}");
            assert!(told.late.is_empty() && told.place.sweep == told.place.drawn_with);
            let sum: f64 = ground.colours.iter().map(|colour| colour.height_m).sum();
            assert!(
                (sum - ground.terrain_height_m).abs() < 1e-2,
                "{name}: {sum} {}",
                ground.terrain_height_m
            );
            let height = ground.terrain_height_m + ground.feature_height_m;
            assert!((height - ground.height_m).abs() < 1e-2, "{name}: {told:?}");
            assert_eq!(ground.video, ground.reflectivity, "{name}: the beam is on where the stroke is");
            assert_eq!(ground.elevation_change, None, "{name}: occlusion is by peak-hold");
        }
    }
    assert!(seen >= 15, "{seen} pixels show ground");
    assert!(same * 10 >= seen * 9, "{same} of {seen}: edges may fall between samples");
}

/// The tour's single word of 400 ns: it comes after the stroke that draws the pixel, and a transfer puts the register right within that stroke.
#[test]
fn a_word_is_in_force_in_the_stroke_that_draws() {
    let scene = Shipped::read("first-light", None);
    let folder = tempfile::tempdir().unwrap();
    let overlay = folder.path().join("late-word.toml");
    let late = |ticks: u32| {
        let delay = format!(
            "format = 1\n[[loader.delay]]\nsweep = 500\ncrossing = 152\ncolour = \"yellow\"\nregister = \"y-first\"\nword = [0, 0]\nticks = {ticks}\n"
        );
        std::fs::write(&overlay, delay).unwrap();
        let ideal = ModelSource::BuiltIn("ideal".into());
        let model = HardwareModel::load(&ideal, std::slice::from_ref(&overlay), &[]).unwrap().model;
        let settings = front_door::settings(&scene.scenario, &model).unwrap();
        let stage = front_door::build(&scene.scenario, settings).unwrap();
        let told = told(&stage, &scene, 60, &[[500, 191]]).remove(0);
        let stale = told.ground.as_ref().unwrap().colours.iter().filter(|colour| colour.stale).count();
        (told.late.iter().map(|late| late.in_force).collect::<Vec<_>>(), stale)
    };
    assert_eq!([late(100), late(180), late(400)], [(vec![false], 0), (vec![true], 1), (vec![true], 1)]);
}

#[test]
fn sky_and_bodies_are_told_as_such() {
    let scene = Shipped::read("landing-site", Some(120));
    let [columns, lines] = [scene.settings.raster.columns as usize, scene.settings.raster.lines as usize];
    let grid: Vec<[usize; 2]> =
        (0..columns).step_by(23).flat_map(|x| (lines / 3..lines).step_by(17).map(move |y| [x, y])).collect();
    let mut told = told(&scene.stage(), &scene, 0, &[&[[60, 0]], &grid[..]].concat());
    let top = told.remove(0);
    assert_eq!((top.writer, top.intensity), (Writer::Sky, 0.0));
    assert!(top.because[0].starts_with("sky"), "{:?}", top.because);
    let body = told.iter().find(|told| told.writer == Writer::Body).expect("a body is in sight");
    assert!(body.because.iter().any(|reason| reason.contains("pg.present is on")), "{:?}", body.because);
    assert!(told.iter().all(|told| told.body.is_some() == (told.writer == Writer::Body)));
    assert!(body.because[0].starts_with("a body covers it"));
    let agree = |told: &&Explanation| {
        let label = told.exact.as_ref().unwrap().label;
        (told.writer == Writer::Body) == (label == "rock" || label == "man-made thing" || label == "culture")
    };
    assert!(told.iter().filter(agree).count() * 20 >= told.len() * 19, "bodies are where exact has them");
}

fn with_fault(scene: &Shipped, fault: &str) -> MachineStage {
    let overlay = shipped::folder().join(format!("../hardware-models/faults/{fault}.toml"));
    let source = ModelSource::BuiltIn("ideal".into());
    let model = HardwareModel::load(&source, &[overlay], &[]).unwrap().model;
    let settings = front_door::settings(&scene.scenario, &model).unwrap();
    front_door::build(&scene.scenario, settings).unwrap()
}

#[test]
fn stale_registers_and_late_words_are_named() {
    let scene = Shipped::read("craters", Some(200));
    let stage = with_fault(&scene, "stale");
    let (mut stale, mut in_force, mut over) = (0, 0, 0);
    for told in told(&stage, &scene, 10, &pixels(&scene, 12, 60)) {
        let Some(ground) = &told.ground else { continue };
        let late: Vec<_> = told.late.iter().filter(|late| late.in_force).collect();
        let wrong: Vec<_> = ground.colours.iter().filter(|colour| colour.stale).collect();
        stale += wrong.len();
        in_force += late.len();
        for read in &told.read {
            let was_late = read.late.iter().any(|late| !late.in_force);
            let place = format!("words of sweep {} that were late before it", read.sweep);
            assert_eq!(told.because.iter().any(|reason| reason.starts_with(&place)), was_late, "{told:?}");
            over += usize::from(was_late);
        }
        for colour in wrong {
            let named = told.late.iter().any(|late| late.colour == colour.colour);
            assert!(named, "a register is stale, so words of it were late: {told:?}");
            assert!(told.because.iter().any(|reason| reason.contains(&format!("tg.{}.hold", colour.colour))));
        }
    }
    assert!(stale > 0 && in_force > 0 && over > 0, "{stale} stale, {in_force} in force, {over} over");
}

#[test]
fn a_pixel_outside_is_refused() {
    let scene = Shipped::read("first-light", Some(64));
    let stage = scene.stage();
    let session = stage.clone().prepare();
    let control = ControlPlane::new(stage.clone());
    let inquiry = Inquiry::new(&stage, session.as_ref(), &control, None);
    let refused = inquiry.explain(0, &scene.pose(0).pose, [64, 0]).unwrap_err();
    assert!(matches!(refused, InquiryError::Pixel { x: 64, columns: 64, .. }), "{refused}");
}

/// Two pixels of a frame are told as by two inquiries, and so is a third of another frame.
#[test]
fn the_picture_that_is_kept_is_the_right_one() {
    let scene = Shipped::read("first-light", Some(64));
    let stage = scene.stage();
    let session = stage.clone().prepare();
    let control = ControlPlane::new(stage.clone());
    let new = || Inquiry::new(&stage, session.as_ref(), &control, None);
    let kept = new();
    let ask = |inquiry: &Inquiry<'_>, frame: u64, pixel| {
        inquiry.explain(frame, &scene.pose(frame).pose, pixel).unwrap()
    };
    let asked = [(0, [10, 30]), (0, [50, 25]), (70, [10, 30]), (0, [10, 30])];
    let told = asked.map(|(frame, pixel)| (ask(&kept, frame, pixel), ask(&new(), frame, pixel)));
    assert!(told.iter().all(|(kept, new)| kept == new));
    assert!(told[0].0.intensity != told[2].0.intensity, "the frames differ there");
}

/// No more of the picture is drawn than the pixel needs: what is told stands in the whole picture, and in the whole frame's signals.
#[test]
fn a_pixel_is_told_as_the_whole_frame_has_it() {
    for (name, frame, sweeps) in [("craters", 10, 200), ("long-shadows", 30, 150), ("showpiece", 5, 48)] {
        let scene = Shipped::read(name, Some(sweeps));
        let mut probe = Probe::new(vec!["sm.write".into()], 0..sweeps);
        let (stage, session) = (scene.stage(), scene.stage().prepare());
        let whole = scene.draw(&*session, frame, &mut probe).planes;
        let light = whole.get(PlaneKind::Intensity).unwrap();
        for told in told_by(&*session, &stage, &scene, frame, &pixels(&scene, 13, 6)) {
            let [x, y] = told.pixel;
            assert_eq!(told.intensity, f64::from(light[y * whole.columns() + x]), "{name}, {x},{y}");
            let wave = probe.waveforms.iter().find(|wave| wave.sweep == told.place.sweep).unwrap();
            assert_eq!(told.left, wave.values[told.place.cell], "{name}, {x},{y}");
        }
    }
}

/// Beside a pixel between instants, `explain` has the value of the whole machine. It is the value that `fine` draws.
#[test]
fn the_whole_machine_is_told_beside_a_picture_between_instants() {
    let scene = Shipped::read("craters", Some(200));
    let by = |economy| {
        let mut stage = scene.stage();
        stage.settings.economy = economy;
        told(&stage, &scene, 10, &pixels(&scene, 17, 24))
    };
    let mut off = 0;
    for (normal, fine) in by(Economy::Normal).iter().zip(&by(Economy::Bounded)) {
        assert_eq!(fine.between, None);
        let between = normal.between.expect("craters are drawn at five instants");
        assert_eq!(between.instants, 5);
        let cell_is_pixel = (normal.place.between_cells - normal.place.between_cells.round()).abs() < 1e-9;
        assert!(cell_is_pixel && (between.whole - fine.intensity).abs() < 1e-6, "{normal:?} {fine:?}");
        off += usize::from((normal.intensity - fine.intensity).abs() > 1e-4);
    }
    assert!(off > 3, "{off} pixels tell both apart");
}
