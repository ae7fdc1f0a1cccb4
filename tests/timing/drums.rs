//! Drums of a view that turns (hardware sections 4.7 and 8, number 10).

use control_plane::{ControlPlane, DataKind, DigitalUnit, EventWord, MachineStage};
use generator::Planes;
use hardware_model::{Channels, DataBanks, Drum, DrumQueue};
use landscape::Attitude;
use lunoid_tests::ComparedScene;
use machine::Prepare;
use quantities::{SweepTime, radians};
use scenario::Pose;
use signal::Probe;
use sweep_program::{Event, NO_CORNER};
use timing::{Deadline, FrameTiming};

use crate::timing::rig::{RANGE, busy, flat, frame, on_course};

const SIZE: f64 = 200.0;
const MASTER: u64 = 1_000_000;
const FRAMES: u64 = 150;
/// One revolution, in ticks of a microsecond: a view is looked ahead for as long as the drum takes to come round once and a
/// half, and that is one frame here, so that a corner is asked for in the frame before it is seen.
const ROTATION: u64 = 22_300;
/// A word so long that the next corner along the edge of the view, a row of the level farther on the track, lies half a
/// revolution away: the mean case, which the formula is for.
const WORD: f64 = 22.1;

fn scene() -> ComparedScene {
    let mut scene = flat(SIZE);
    (scene.sweeps, scene.master_hz) = (25, MASTER);
    scene
}

/// A course that turns at `degrees` a second, 30 frames a second.
fn course(scene: &ComparedScene, degrees: f64) -> Vec<Pose> {
    let heading = |frame: u64| radians(7.0 + degrees * frame as f64 / 30.0);
    let attitude = |frame| Attitude { roll: 0.0, pitch: 0.0, heading: heading(frame) };
    let pose =
        |frame: u64| Pose { time: frame as f64 / 30.0, eye: scene.eye, attitude: attitude(frame), yoke: 0.0 };
    (0..FRAMES).map(pose).collect()
}

/// A turn at `degrees` a second behind one drum.
fn turning(degrees: f64) -> (ControlPlane, Vec<Pose>) {
    let (stage, course) = turning_stage(degrees);
    (ControlPlane::new(stage), course)
}

fn turning_stage(degrees: f64) -> (MachineStage, Vec<Pose>) {
    let scene = scene();
    let course = course(&scene, degrees);
    let mut stage = on_course(&scene, course.clone());
    let drum = Drum { rotation: ROTATION, word: WORD, record_words: 9, queue: DrumQueue::Fifo, count: 1 };
    stage.settings.data_banks =
        DataBanks { drum: Some(drum), channels: Channels::default(), buffer_words: Some(9 * 900) };
    (stage, course)
}

/// The last two thirds of the turn: before them the buffer lives on what it was filled with.
fn turned(degrees: f64) -> Vec<FrameTiming> {
    let (control, course) = turning(degrees);
    (FRAMES / 3..FRAMES).map(|number| frame(&control, number, &course[number as usize])).collect()
}

fn utilisation(frames: &[FrameTiming]) -> f64 {
    let busy: u64 = frames.iter().map(|frame| busy(frame, "drum.fine.0")).sum();
    busy as f64 / frames.iter().map(|frame| frame.ticks).sum::<u64>() as f64
}

/// Corners asked for and not there, a frame.
fn missing(frames: &[FrameTiming]) -> f64 {
    let misses = frames.iter().flat_map(|frame| &frame.misses);
    misses.filter(|missed| missed.deadline == Deadline::CORNER).count() as f64 / frames.len() as f64
}

/// `rate x (latency + record)` with single corners, first come first served.
fn formula(degrees: f64) -> f64 {
    let rate = RANGE * RANGE * radians(degrees) / (2.0 * SIZE * SIZE);
    rate * (0.5 * ROTATION as f64 + 9.0 * WORD) / MASTER as f64
}

/// Slower and faster than the turn at which the drum is at work all the time: 16 degrees/s by formula.
const SLOWER: [f64; 7] = [2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 14.0];
const FASTER: [f64; 4] = [20.0, 24.0, 30.0, 40.0];

/// Latencies of single corners depend on how they lie on the track, so the formula holds for many turns together.
#[test]
fn the_drum_is_at_work_as_the_formula_says() {
    let [found, expected] = SLOWER.iter().fold([0.0; 2], |[found, expected], &degrees| {
        let one = utilisation(&turned(degrees));
        println!("{degrees} degrees/s: {one:.3}, {:.3} by formula", formula(degrees));
        assert!(one < 0.9, "{degrees} degrees/s: {one}");
        [found + one, expected + formula(degrees)]
    });
    assert!((found / expected - 1.0).abs() < 0.1, "{found}, not {expected}");
}

/// Below, a few are missing that came in a burst; from there on they pile up, as the artefact A5 says.
#[test]
fn corners_are_missing_when_its_utilisation_reaches_one() {
    let most = SLOWER.iter().map(|&degrees| missing(&turned(degrees))).fold(0.0, f64::max);
    assert!(most < 10.0, "{most} a frame while the drum has time left");
    let mut before = 20.0 * most;
    for degrees in FASTER {
        let frames = turned(degrees);
        let (found, used) = (missing(&frames), utilisation(&frames));
        println!("{degrees} degrees/s: {found:.0} a frame");
        assert!((used - 1.0).abs() < 0.01, "{degrees} degrees/s: {used}");
        assert!(found > 1.2 * before, "{degrees} degrees/s: {found} after {before}");
        before = found;
    }
}

/// A view that turns about from frame to frame asks for all that is around: what it sees is in the buffer or missing, as often
/// as of a view that turns so far that it hardly can be.
#[test]
fn a_view_that_turns_about_misses_what_it_sees() {
    let [little, about] = [100.0, 30.0 * 160.0].map(|degrees| missing(&turned(degrees)));
    assert!(about > 0.5 * little, "{about} a frame, {little} at 100 degrees/s");
}

/// Each time that a register asks for a corner is a deadline, met or missed: a set a load, and twelve home registers a sweep.
/// The programs of the very sweeps have words of no corner where the record has a miss.
#[test]
fn every_corner_that_is_asked_for_is_a_deadline() {
    let (control, course) = turning(30.0);
    let pose = &course[80];
    let frame = frame(&control, 80, pose);
    let slack = &frame.deadlines[&Deadline::CORNER];
    assert_eq!(slack.count, frame.sets.loaded + 12 * 25);
    let misses: Vec<_> = frame.misses.iter().filter(|missed| missed.deadline == Deadline::CORNER).collect();
    assert_eq!(slack.missed as usize, misses.len());
    let came = misses.iter().filter(|missed| missed.came.is_some()).count();
    assert!(came > 0 && came < misses.len(), "{came} of {}", misses.len());
    assert!(misses.iter().filter_map(|missed| missed.lateness()).all(|late| late > 0.0));
    for sweep in 0..25 {
        let programs = control.programs(80, pose, sweep).expect("a pose over flat ground");
        let [program] = &programs[..] else { panic!("one level") };
        let home = program.registers.iter().flat_map(|set| [set.hold, set.x_first, set.y_first]);
        let loads = program.events().filter_map(|step| match step.kind {
            Event::Load(load) => Some(load.corner),
            _ => None,
        });
        let blank = home.chain(loads).filter(|&corner| corner == NO_CORNER).count();
        assert_eq!(blank, misses.iter().filter(|missed| missed.sweep == sweep).count(), "sweep {sweep}");
    }
}

/// The wires of a drum over all sweeps of a frame: it comes round once a revolution, brings what the list of events says, and what
/// the frame waits for becomes less by each record.
#[test]
fn wires_of_a_drum_tell_what_it_brings() {
    let (stage, course) = turning_stage(50.0);
    let (control, session) = (ControlPlane::new(stage.clone()), stage.clone().prepare());
    let (number, pose) = (80, &course[80]);
    let mut probe = Probe::new(vec!["drum.*".into()], 0..stage.settings.raster.sweeps);
    session.frame(number, pose, &mut Planes::new(0, 0, &[]), &mut probe).unwrap();
    let wire = |name: &str| -> Vec<(u64, f64)> {
        let of_wire = probe.waveforms.iter().filter(|wave| wave.signal.name == name);
        let ticks = of_wire.flat_map(|wave| {
            let clock = stage.settings.timebase.sweep_clock(number, wave.sweep);
            let tick = move |time: &f64| clock.tick_at_or_after(SweepTime(*time)).0;
            wave.times.iter().map(tick).zip(wave.values.iter().copied()).collect::<Vec<_>>()
        });
        ticks.collect()
    };
    let turns = wire("drum.0.index");
    let rotation = control.drums(DataKind::Fine)[0].rotation;
    assert!(!turns.is_empty());
    for pair in turns.windows(2) {
        assert_eq!((pair[1].0 - pair[0].0, pair[1].1 - pair[0].1), (rotation, 1.0));
    }
    let columns = stage.landscape.level().corners()[1] as i64;
    let events = control.sweeps(number, pose).unwrap().frame_events();
    let brought = events.iter().filter(|event| event.event == EventWord::Record);
    let brought: Vec<(u64, f64)> = brought
        .map(|event| {
            assert_eq!(event.unit, DigitalUnit::Drum(DataKind::Fine, 0));
            let [north, east] = event.corner.unwrap();
            (event.tick.0, (north * columns + east) as f64)
        })
        .collect();
    assert_eq!(wire("drum.0.record"), brought);
    assert!(brought.len() > 1 && wire("drum.1.record").is_empty());
    let waiting = wire("drum.0.waiting");
    let (first, last) = (waiting[0].1, waiting[waiting.len() - 1].1);
    assert_eq!(first - last, brought.len() as f64, "{waiting:?}");
    assert!(waiting.windows(2).all(|pair| pair[1].1 <= pair[0].1));
}
