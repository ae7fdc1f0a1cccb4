//! What a machine has to do before frame 0 (hardware sections 4.4, 4.6 and 4.7).

use std::collections::BTreeMap;

use control_plane::{ControlPlane, MachineStage};
use data_bank::{Contents, DataBank, StoreDesign};
use dpu::HOME_SETS;
use hardware_model::{Channels, Cpu, CrossingServer, DataBanks, Drum, DrumQueue, IoProcessor, Loader};
use lunoid_tests::ComparedScene;
use quantities::radians;
use scenario::{Pose, Yoke};
use timing::{Task, TimingRecord};

use crate::timing::rig::{SIZE, flat, frame, loader, on_course, pose};

const SWEEPS: u32 = 21;
const MASTER: u64 = 1_000_000;

fn scene() -> ComparedScene {
    let mut scene = flat(SIZE);
    (scene.sweeps, scene.master_hz) = (SWEEPS, MASTER);
    scene
}

fn drums(channels: Channels) -> DataBanks {
    let drum =
        Drum { rotation: 17_400, word: 1.7, record_words: 36, queue: DrumQueue::ShortestLatency, count: 2 };
    DataBanks { drum: Some(drum), channels, buffer_words: Some(9 * 800) }
}

/// A machine whose mission begins at the pose told.
fn machine(change: impl FnOnce(&mut MachineStage)) -> (ControlPlane, Pose) {
    let scene = scene();
    let first = pose(&scene, 0.4, [0.1, 0.2]);
    let mut stage = on_course(&scene, vec![first; 4]);
    change(&mut stage);
    (ControlPlane::new(stage), first)
}

fn tasks((control, first): &(ControlPlane, Pose)) -> Vec<Task> {
    control.before_mission(first).expect("a pose over flat ground")
}

fn ticks(tasks: &[Task], unit: &str, name: &str) -> u64 {
    let found = tasks.iter().find(|task| (task.unit.as_str(), task.task.as_str()) == (unit, name));
    found.unwrap_or_else(|| panic!("no {name} of {unit} in {tasks:?}")).ticks
}

#[test]
fn a_machine_that_takes_no_time_is_ready_at_once() {
    assert_eq!(tasks(&machine(|_| {})), []);
}

#[test]
fn the_processors_tasks_are_its_instructions() {
    let cpu = Cpu {
        memory_cycle: 3,
        multiply: 7,
        instruction_cycles: 2,
        sweep_setup: 40,
        frame_tables: 900,
        ..Cpu::default()
    };
    let found = tasks(&machine(|stage| stage.settings.cpu = cpu));
    // An entry a sweep: 18 instructions of two cycles, four multiplications.
    assert_eq!(ticks(&found, "cpu", "sine-table"), u64::from(SWEEPS) * (18 * 2 * 3 + 4 * 7));
    let all: Vec<_> = found.iter().map(|task| (task.task.as_str(), task.pieces)).collect();
    assert_eq!(all, [("sine-table", SWEEPS.into()), ("tables", 1), ("set-up", 1)]);
    assert_eq!((ticks(&found, "cpu", "tables"), ticks(&found, "cpu", "set-up")), (900, 40));
}

#[test]
fn home_registers_come_from_the_server_of_the_crossings() {
    let io_processor = IoProcessor { order: 6, chain: 1, edit: 1 };
    let slow = Loader { io_processor, ..loader(CrossingServer::IoProcessor, 1, [2, 5, 1]) };
    let found = tasks(&machine(|stage| stage.settings.loader = slow));
    let set = 1 + 2 + 9 * (5 + 1);
    assert_eq!(ticks(&found, "io-processor", "home-registers"), 6 + u64::from(HOME_SETS) * set + 1);
}

/// The drums of the mission bring its first sector, by their queue and channels: no record faster than its channel carries it,
/// and none later than a turn after the one before.
#[test]
fn the_first_sector_comes_from_the_drums_of_the_mission() {
    let mut shared = Vec::new();
    for channels in [Channels::default(), Channels { count: Some(1), word: 30.0 }] {
        let (control, first) = machine(|stage| stage.settings.data_banks = drums(channels));
        let found = tasks(&(control, first));
        let task = found.iter().find(|task| task.task == "first-sector").expect("drums");
        assert_eq!(task.unit, "drum.fine");
        shared.push(task.ticks);
        // Every record of the sector is read by one of two drums, and each needs its place under the heads.
        let level = scene().level;
        let drum = drums(channels).drum.unwrap();
        let contents = Contents::Corners(level.corners());
        let record_words = drum.record_words;
        let store = StoreDesign { contents, record_words, buffer_words: Some(9 * 800), edit: 0.0 };
        let units: Vec<_> = DataBank::new(drum, channels, &[store], 0).drums(0).collect();
        let transfer = units.iter().map(|unit| unit.transfer).min().unwrap();
        let at_once = channels.count.map_or(2, u64::from);
        assert!(task.pieces > 20 && task.ticks > task.pieces / at_once * transfer, "{task:?}");
        let slowest = units.iter().map(|unit| unit.rotation + unit.transfer).max().unwrap();
        assert!(task.ticks < task.pieces * slowest, "{task:?}");
    }
    // Two drums on one slow channel are in one another's way.
    assert!(shared[1] > shared[0], "{shared:?}");
}

#[test]
fn the_yoke_goes_to_its_first_angle() {
    let (control, mut first) = machine(|stage| {
        let ideal = hardware_model::HardwareModel::ideal().yoke;
        stage.settings.yoke = Some(Yoke { step: radians(0.5), rate: radians(10.0), ..ideal });
    });
    assert_eq!(tasks(&(control, first)), []);
    let (control, _) = machine(|stage| {
        let ideal = hardware_model::HardwareModel::ideal().yoke;
        stage.settings.yoke = Some(Yoke { step: radians(0.5), rate: radians(10.0), ..ideal });
    });
    first.yoke = radians(-4.0);
    let found = tasks(&(control, first));
    // Eight pulses, 20 a second.
    assert_eq!((found.len(), found[0].pieces), (1, 8));
    assert_eq!(ticks(&found, "yoke", "first-angle"), 400_000);
}

/// Ready after the sum of all tasks; the frames are none the wiser, wherever a replay begins.
#[test]
fn the_sum_is_when_it_is_ready() {
    let cpu =
        Cpu { memory_cycle: 1, instruction_cycles: 2, sweep_setup: 40, frame_tables: 900, ..Cpu::default() };
    let with = || {
        machine(|stage| {
            stage.settings.cpu = cpu;
            stage.settings.loader = loader(CrossingServer::WiredPointers, 9, [1, 2, 1]);
            stage.settings.data_banks = drums(Channels::default());
        })
    };
    let (control, first) = with();
    let before = frame(&control, 3, &first);
    let before_mission = control.before_mission(&first).expect("a pose over flat ground");
    let names: Vec<&str> = before_mission.iter().map(|task| task.task.as_str()).collect();
    assert_eq!(names, ["sine-table", "tables", "first-sector", "home-registers", "set-up"]);
    let sum = before_mission.iter().map(|task| task.ticks).sum::<u64>();
    let drum = ticks(&before_mission, "drum.fine", "first-sector");
    assert_eq!(sum, u64::from(SWEEPS) * 36 + 900 + drum + (3 * 3 + 1) + 40);
    assert_eq!(frame(&control, 3, &first), before);
    assert_eq!(frame(&with().0, 3, &first), before);
    let record = TimingRecord {
        format: timing::FORMAT,
        scenario: "flat".into(),
        machine: "none".into(),
        inputs: "0".into(),
        keys: BTreeMap::new(),
        master: String::new(),
        before_mission,
        frames: vec![before],
    };
    assert_eq!((record.ready_after(), record.check()), (sum, Ok(())));
    assert!(record.text().contains("ready after"));
}
