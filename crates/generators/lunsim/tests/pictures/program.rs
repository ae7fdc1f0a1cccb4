//! How long a frame takes: pieces against counts of the same frame's signals and planes, times against the hardware.

use std::collections::BTreeMap;

use features::{Crater, Shape};
use generator::{PlaneKind, Planes};
use lunsim::{Hardware, Lunsim, POSITIONS, Parameters, Program};
use scenario::{Curvature, Laws, Pose};
use signal::Probe;
use timing::FrameTiming;

use crate::scenes::{Scene, bowl, plain, pose, prepare, settings, stage, sun};

const GRID: u32 = 96;
const POINTS: u64 = (GRID * GRID) as u64;

/// A crater of each type, one of them out of sight, under a sun in the west.
fn craters() -> Vec<Crater> {
    let rimmed = Shape::RimmedBowl { r1: 300.0, r2: 420.0 };
    let flat = Shape::FlatFloor { r1: 100.0, r2: 250.0, r3: 400.0 };
    vec![
        bowl([4000.0, 4000.0], 500.0, 150.0),
        Crater::new([4300.0, 4200.0], rimmed, 90.0, 20.0).unwrap(),
        Crater::new([3900.0, 3500.0], flat, 60.0, 10.0).unwrap(),
        bowl([7500.0, 500.0], 200.0, 40.0),
    ]
}

fn view() -> Pose {
    pose([2500.0, 4000.0, 900.0], -30.0, 0.0)
}

fn scene(curvature: Curvature) -> Scene {
    // A pixel a position, so that a plane is the film.
    let mut settings = settings(POSITIONS as u32, 30.0, GRID);
    settings.parameters = Parameters { intensity_codes: 16, ..settings.parameters };
    settings.view.laws = Laws { curvature, ..settings.view.laws };
    stage(&plain(8000.0, craters()), sun(270.0, 15.0), &settings)
}

fn timed(stage: Scene, pose: &Pose) -> FrameTiming {
    Program::new(stage.stage(), &stage.program()).unwrap().frame(3, pose).unwrap()
}

/// Returns the number of pieces of each task, by the name of the task.
fn pieces(frame: &FrameTiming) -> BTreeMap<&str, u64> {
    frame.tasks.iter().map(|task| (task.task.as_str(), task.pieces)).collect()
}

#[test]
fn pieces_are_those_of_the_picture() {
    let frame = timed(scene(Curvature::Parabolic), &view());
    let found = pieces(&frame);
    for (task, expected) in
        [("squares", 4), ("drops", POINTS), ("slopes", 2 * POINTS), ("light", POINTS), ("march", POINTS)]
    {
        assert_eq!(found[task], expected, "{task}");
    }
    assert!(!found.contains_key("march-between"), "the sun is on a cardinal point");

    let mut probe = Probe::new(vec!["lunsim.a*".into()], 0..GRID);
    let mut planes = Planes::new(POSITIONS, POSITIONS, &[PlaneKind::Intensity, PlaneKind::Range]);
    prepare(scene(Curvature::Parabolic)).unwrap().frame(3, &view(), &mut planes, &mut probe).unwrap();
    let places: Vec<[f64; 2]> = probe
        .waveforms
        .chunks(2)
        .flat_map(|row| row[0].values.iter().zip(&row[1].values))
        .map(|(along, across)| [2500.0 + along, 4000.0 + across])
        .collect();
    let count = |is_met: &dyn Fn(&Crater, [f64; 2]) -> bool, craters: &[Crater]| {
        let met =
            craters.iter().flat_map(|crater| places.iter().filter(move |place| is_met(crater, **place)));
        met.count() as u64
    };
    let off =
        |crater: &Crater, place: [f64; 2]| [0, 1].map(|axis| (place[axis] - crater.centre()[axis]).abs());
    let in_square =
        |crater: &Crater, place: [f64; 2]| off(crater, place).into_iter().all(|off| off <= crater.outer());
    let in_circle = |crater: &Crater, place: [f64; 2]| {
        let [dx, dy] = off(crater, place);
        (dx * dx + dy * dy).sqrt() < crater.outer()
    };
    let all = craters();
    assert_eq!(found["distances"], count(&in_square, &all));
    for (task, crater) in ["type-1", "type-2", "type-3"].into_iter().zip(&all) {
        assert_eq!(found[task], count(&in_circle, std::slice::from_ref(crater)), "{task}");
    }

    let ranges = planes.get(PlaneKind::Range).unwrap();
    assert_eq!(found["codes"], ranges.iter().filter(|range| range.is_finite()).count() as u64);
    let film = planes.get(PlaneKind::Intensity).unwrap();
    let exposed = film.iter().filter(|grey| **grey > 0.0).count() as u64;
    assert_eq!((found["instructions"], found["plotting"]), (exposed, exposed));
    let columns =
        (0..POSITIONS).filter(|column| film.iter().skip(*column).step_by(POSITIONS).any(|grey| *grey > 0.0));
    assert_eq!((found["blocks"], frame.events), (columns.clone().count() as u64, columns.count() as u64));
    // Every position is written at least once; the near rows go over far ones, so some are written again.
    assert!(found["codes"] < found["overwriting"] && found["projection"] == POINTS, "{found:?}");
    assert!(exposed < found["codes"], "some of it is dark");
}

#[test]
fn a_flat_moon_without_shadows_saves_its_steps() {
    let mut stage = scene(Curvature::None);
    stage.view.shadows = None;
    let frame = timed(stage, &view());
    assert!(["drops", "march"].iter().all(|task| !pieces(&frame).contains_key(task)));
    let mut turned = scene(Curvature::None);
    turned.parameters.restrictions = false;
    let frame = timed(turned, &pose([2500.0, 4000.0, 900.0], -30.0, 20.0));
    assert_eq!(pieces(&frame)["march-between"], POINTS);
}

#[test]
fn times_follow_from_pieces_and_hardware() {
    let (stage, hardware) = (scene(Curvature::None), Hardware::shipped().unwrap());
    let of = |hardware: Hardware| {
        let program = Lunsim { hardware, ..stage.program() };
        Program::new(stage.stage(), &program).unwrap().frame(3, &view()).unwrap()
    };
    let frame = of(hardware);
    let task =
        |frame: &FrameTiming, name: &str| frame.tasks.iter().find(|task| task.task == name).cloned().unwrap();
    // An addition, a multiplication, a store: 1.3 + 4.5 + 1 us.
    assert_eq!(task(&frame, "slopes").ticks, 2 * POINTS * 6800);
    // 10 000 points a second.
    assert_eq!(task(&frame, "plotting").ticks, 100_000 * task(&frame, "plotting").pieces);
    let [cpu, recorder] = [&frame.units[0], &frame.units[1]];
    assert_eq!((cpu.unit.as_str(), recorder.unit.as_str()), ("cpu", "recorder"));
    assert_eq!(recorder.busy, task(&frame, "plotting").ticks);
    assert_eq!(frame.ticks, frame.tasks.iter().map(|task| task.ticks).sum::<u64>());
    assert_eq!(frame.ticks, cpu.busy + recorder.busy);
    let slower = of(Hardware { point: 2 * hardware.point, ..hardware });
    assert_eq!((slower.units[0].busy, slower.units[1].busy), (cpu.busy, 2 * recorder.busy));
    let roots = of(Hardware { root: hardware.root + 1, ..hardware });
    let more = task(&frame, "distances").pieces + task(&frame, "light").pieces;
    assert_eq!(roots.ticks, frame.ticks + more);
    assert!(frame.deadlines.is_empty() && frame.misses.is_empty());
}

/// Light is in the events and nowhere else: they are the film.
#[test]
fn events_are_the_film_whatever_the_threads() {
    let of = |threads: usize, white: f64| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let mut stage = scene(Curvature::None);
        stage.view.display.white = white;
        pool.install(|| timed(stage, &view()))
    };
    let one = of(1, 1.0);
    assert_eq!(one, of(3, 1.0));
    // A code a step darker here and there.
    let darker = of(1, 1.001);
    assert_ne!(one.events_blake3, darker.events_blake3);
    assert_eq!(pieces(&one)["codes"], pieces(&darker)["codes"]);
}

#[test]
fn nothing_in_view_is_a_look_at_the_map() {
    let mut stage = scene(Curvature::None);
    stage.view.ranges[1] = 10.0;
    let frame = timed(stage, &view());
    assert_eq!(frame.tasks.iter().map(|task| task.task.as_str()).collect::<Vec<_>>(), ["squares"]);
    assert_eq!((frame.events, frame.units[1].busy), (0, 0));
}
