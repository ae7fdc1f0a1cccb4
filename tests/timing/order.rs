//! A frame's timing is its own: whatever was timed before it, by however many threads.

use std::sync::Arc;

use control_plane::{ControlPlane, MachineStage};
use hardware_model::{Channels, Cpu, CrossingServer, DataBanks, Drum, DrumQueue, HardwareModel};
use landscape::Attitude;
use quantities::radians;
use rayon::ThreadPoolBuilder;
use scenario::Pose;
use timing::FrameTiming;

use crate::timing::rig::{flat, frame, loader, on_course};

const LAST: u64 = 500;

/// A mission that turns, with drums that cannot follow and a processor that serves the crossings: everything that could
/// carry something over from one frame to the next.
pub fn mission() -> (MachineStage, Arc<[Pose]>) {
    let mut scene = flat(250.0);
    (scene.sweeps, scene.master_hz) = (5, 1_000_000);
    scene.loader = loader(CrossingServer::CpuInterrupt, 3, [1, 2, 1]);
    let turn = |frame: u64| 30.0 * libm::sin(frame as f64 / 9.0) + frame as f64;
    let pose = |frame: u64| {
        let attitude = Attitude { roll: 0.0, pitch: 0.0, heading: radians(turn(frame)) };
        Pose { time: frame as f64 / 30.0, eye: scene.eye, attitude, yoke: 0.0 }
    };
    let course: Vec<Pose> = (0..=LAST).map(pose).collect();
    let mut stage = on_course(&scene, course.clone());
    let drum =
        Drum { rotation: 17_400, word: 1.7, record_words: 36, queue: DrumQueue::ShortestLatency, count: 2 };
    stage.settings.data_banks =
        DataBanks { drum: Some(drum), channels: Channels::default(), buffer_words: Some(9 * 400) };
    stage.settings.cpu = Cpu { sweep_setup: 7_000, interrupt: 5, longest_instruction: 5, ..Cpu::default() };
    (stage, course.into())
}

/// A control plane that has followed no frame, as often as one is asked for, and the course.
fn machines() -> (impl Fn() -> ControlPlane, Arc<[Pose]>) {
    let (stage, course) = mission();
    (move || ControlPlane::new(stage.clone()), course)
}

fn timed(control: &ControlPlane, course: &[Pose], frames: impl IntoIterator<Item = u64>) -> Vec<FrameTiming> {
    frames.into_iter().map(|number| frame(control, number, &course[number as usize])).collect()
}

#[test]
fn a_replay_that_starts_at_frame_500_knows_what_was_before() {
    let (machine, course) = machines();
    let whole = timed(&machine(), &course, 0..=LAST);
    let from_the_end = timed(&machine(), &course, [LAST]);
    assert_eq!(from_the_end[0], whole[LAST as usize]);
    let backwards = timed(&machine(), &course, [LAST, 250, 3, 0, 499, 250]);
    let forwards = [LAST, 250, 3, 0, 499, 250].map(|number| whole[number as usize].clone());
    assert_eq!(backwards, forwards);
    // The mission is one in which something could go wrong.
    let busy =
        |frame: &FrameTiming| frame.units.iter().any(|unit| unit.unit.starts_with("drum") && unit.busy > 0);
    let turning = whole.iter().filter(|frame| busy(frame)).count();
    assert!(turning > 100, "{turning}");
    assert!(whole[LAST as usize] != whole[LAST as usize - 1] && !whole[LAST as usize].misses.is_empty());
}

#[test]
fn the_number_of_threads_does_not_matter() {
    let (machine, course) = machines();
    let frames = [0, 1, 2, 40, 41];
    let by = |threads: usize| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| timed(&machine(), &course, frames))
    };
    assert_eq!(by(1), by(2));
}

/// The programs that a frame is drawn with are those that its record is of: late sets, and late set-ups.
#[test]
fn programs_are_those_of_the_record() {
    let (machine, course) = machines();
    let control = machine();
    let pose = &course[40];
    let found = frame(&control, 40, pose);
    let sweeps = control.sweeps(40, pose).expect("a pose over flat ground");
    let all: Vec<_> = (0..5).flat_map(|sweep| sweeps.programs(sweep)).collect();
    assert_eq!(all.iter().map(|program| program.misses.len() as u64).sum::<u64>(), found.sets.late);
    assert!(found.sets.late > 0);
    for sweep in 0..5 {
        let one = control.programs(40, pose, sweep).expect("a pose over flat ground");
        assert_eq!(one, [all[sweep as usize].clone()]);
        let behind = control.sweeps_behind(sweeps.loader(), 40, pose).expect("a pose over flat ground");
        assert_eq!(behind.programs(sweep), one);
    }
    // Behind a loader that takes no time nothing is late.
    let wired = control.sweeps_behind(&HardwareModel::ideal().loader, 40, pose).expect("a pose");
    assert!((0..5).flat_map(|sweep| wired.programs(sweep)).all(|program| program.misses.is_empty()));
    // A sweep whose set-up is late runs in the direction of an earlier one.
    let directions: Vec<_> = all.iter().map(|program| program.start.direction).collect();
    let drawn = |sweep: u32| sweeps.set_up_of(sweep);
    let late: Vec<u32> =
        (0..5).filter(|&sweep| drawn(sweep) != sweep && drawn(drawn(sweep)) == drawn(sweep)).collect();
    assert!(!late.is_empty());
    for sweep in late {
        assert_eq!(directions[sweep as usize], directions[drawn(sweep) as usize]);
    }
}
