//! A machine that is written down, read and gone on from is the machine that nobody stopped.

use std::sync::{Arc, LazyLock};

use control_plane::{ControlPlane, MachineStage};
use generator::{PlaneKind, Planes, Session};
use hardware_model::{HardwareModel, ModelSource};
use lunoid_tests::{Dice, Shipped};
use machine::Prepare;
use run_record::Program;
use signal::Probe;
use state::{Bench, Block, BlockKind, Gone, Mission, Place, State, StateError, Unit};

const SWEEPS: u32 = 48;
const FILE: &str = "there.state";
const UNITS: [Unit; 5] = [Unit::Tick, Unit::Event, Unit::Sample, Unit::Sweep, Unit::Frame];

/// A scenario on a machine, with a frame near which it is stopped.
struct Machine {
    scene: Shipped,
    name: &'static str,
    stage: MachineStage,
    control: ControlPlane,
    frame: u64,
}

/// Made once: their ground takes longer than their pictures.
static IDEAL: LazyLock<Machine> = LazyLock::new(|| Machine::new("first-light", "ideal", 60));
static NOMINAL: LazyLock<Machine> = LazyLock::new(|| Machine::new("nominal-drive", "pra-nominal", 40));
/// Residue, two fields and a slow phosphor.
static OVERLOADED: LazyLock<Machine> = LazyLock::new(|| Machine::new("nominal-drive", "pra-overloaded", 17));

fn all() -> [&'static Machine; 3] {
    [&IDEAL, &NOMINAL, &OVERLOADED]
}

impl Machine {
    fn new(scenario: &str, name: &'static str, frame: u64) -> Self {
        let scene = Shipped::read(scenario, Some(SWEEPS));
        let model = HardwareModel::load(&ModelSource::BuiltIn(name.into()), &[], &[]).unwrap().model;
        let mut settings = front_door::settings(&scene.scenario, &model).unwrap();
        settings.shadow_cache = scene.settings.shadow_cache.clone();
        let stage = front_door::build(&scene.scenario, settings).unwrap();
        let control = ControlPlane::new(stage.clone());
        Self { scene, name, stage, control, frame }
    }

    /// A machine that remembers nothing yet.
    fn bench(&self) -> Bench<'_> {
        self.bench_by("1")
    }

    fn bench_by(&self, version: &str) -> Bench<'_> {
        let [name, commit, family] = ["lunoid", "of a test", "unfused"].map(str::to_owned);
        Bench::new(Mission {
            program: Program { name, version: version.into(), commit, result_family: family },
            machine: self.name,
            words: vec!["a.toml".into()],
            scenario: &self.scene.scenario,
            stage: &self.stage,
            control: &self.control,
        })
    }

    /// Pictures of frames by the ordinary session.
    fn pictures(&self, frames: std::ops::Range<u64>) -> Vec<Vec<f32>> {
        let session = self.stage.clone().prepare();
        frames.map(|frame| self.picture(&*session, frame)).collect()
    }

    fn picture(&self, session: &dyn Session, frame: u64) -> Vec<f32> {
        let raster = self.stage.settings.raster;
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &[PlaneKind::Intensity]);
        let pose = self.bench().row(frame).unwrap().pose;
        session.frame(frame, &pose, &mut planes, &mut Probe::off()).unwrap();
        light(&planes)
    }

    /// A random start of a sweep near the frame.
    fn place(&self, dice: &mut Dice) -> Place {
        Place::start(self.frame + dice.count(0, 2) as u64, dice.count(1, SWEEPS as usize - 1) as u32)
    }
}

fn light(planes: &Planes) -> Vec<f32> {
    planes.get(PlaneKind::Intensity).unwrap().to_vec()
}

/// Bits, because -0 is not 0.
fn bits(picture: &[f32]) -> Vec<u32> {
    picture.iter().map(|value| value.to_bits()).collect()
}

/// The state of a file, in a machine that remembers nothing else.
fn restored<'a>(machine: &'a Machine, bytes: &[u8]) -> (Bench<'a>, State) {
    let (bench, state) = (machine.bench(), State::parse(bytes).unwrap());
    bench.restore(&state, FILE.as_ref()).unwrap();
    (bench, state)
}

#[test]
fn a_restored_machine_goes_on_with_the_same_bits() {
    let mut dice = Dice::new(33);
    for machine in all() {
        let whole = machine.pictures(machine.frame..machine.frame + 4);
        for _ in 0..2 {
            let place = machine.place(&mut dice);
            let bytes = machine.bench().save(place).unwrap().bytes();
            let (bench, state) = restored(machine, &bytes);
            let expected = (place.frame - machine.frame) as usize;
            let picture = light(&bench.go_on(&state).unwrap());
            assert!(picture.iter().any(|value| *value > 0.0));
            assert_eq!(bits(&picture), bits(&whole[expected]), "{}: {place}", machine.name);
            let next = light(&bench.frame(place.frame + 1).unwrap());
            assert_eq!(bits(&next), bits(&whole[expected + 1]), "{}: behind {place}", machine.name);
        }
    }
}

/// Every fifth value of a block brightened: what a file holds is what is shown.
#[test]
fn what_a_file_holds_is_used() {
    for (machine, blocks) in all().into_iter().zip([
        &[(BlockKind::Rows, 0)][..],
        // Of two tubes in turn the frame before last lies in the same tube.
        &[(BlockKind::Rows, 0), (BlockKind::Store, 2)],
        &[(BlockKind::Rows, 0), (BlockKind::Store, 1), (BlockKind::Picture, 1)],
    ]) {
        let state = machine.bench().save(Place::start(machine.frame, SWEEPS / 2)).unwrap();
        let expected = light(&machine.bench().go_on(&state).unwrap());
        for (kind, age) in blocks {
            let mut changed = state.clone();
            let is_meant = |block: &&mut Block| (block.kind, block.frame) == (*kind, machine.frame - age);
            let block = changed.blocks.iter_mut().find(is_meant).unwrap();
            Arc::make_mut(&mut block.values).iter_mut().step_by(5).for_each(|value| *value += 0.5);
            let (bench, changed) = restored(machine, &changed.bytes());
            let picture = light(&bench.go_on(&changed).unwrap());
            assert_ne!(bits(&picture), bits(&expected), "{}: {kind:?}", machine.name);
        }
    }
}

#[test]
fn n_steps_and_n_back_write_the_same_file() {
    let mut dice = Dice::new(7);
    for machine in all() {
        let place = machine.place(&mut dice);
        let bytes = machine.bench().save(place).unwrap().bytes();
        for unit in UNITS {
            let count = dice.count(2, if unit == Unit::Frame { 3 } else { 60 }) as i64;
            let count = if dice.count(0, 1) == 0 { count } else { -count };
            let (bench, state) = restored(machine, &bytes);
            let there = bench.step(place, unit, count).unwrap();
            let moved = bench.moved(&state, there).unwrap().bytes();
            assert_ne!(moved, bytes);
            // The way back begins with the file alone.
            let (bench, state) = restored(machine, &moved);
            assert_eq!(bench.step(there, unit, -count).unwrap(), place, "{}: {unit:?} {count}", machine.name);
            let back = bench.moved(&state, place).unwrap().bytes();
            assert!(back == bytes, "{}: {unit:?} {count} from {place}", machine.name);
        }
    }
}

#[test]
fn one_step_n_times_writes_what_n_steps_write() {
    let mut dice = Dice::new(11);
    for machine in all() {
        let place = machine.place(&mut dice);
        let first = machine.bench().save(place).unwrap();
        for unit in UNITS {
            let bench = machine.bench();
            bench.restore(&first, FILE.as_ref()).unwrap();
            let there = bench.moved(&first, bench.step(place, unit, 2).unwrap()).unwrap();
            let mut bytes = first.bytes();
            for _ in 0..2 {
                let (bench, state) = restored(machine, &bytes);
                let next = bench.step(state.head.place, unit, 1).unwrap();
                bytes = bench.moved(&state, next).unwrap().bytes();
            }
            assert!(there.bytes() == bytes, "{}: {unit:?} from {place}", machine.name);
            if unit == Unit::Frame {
                let alone = machine.bench().save(there.head.place).unwrap().bytes();
                assert!(alone == bytes, "{}: {unit:?} from {place}", machine.name);
            }
        }
    }
}

/// What is changed in a file goes along with every step, and shows.
#[test]
fn steps_take_along_what_a_file_holds() {
    let machine = &*OVERLOADED;
    let mut state = machine.bench().save(Place::start(17, 20)).unwrap();
    Arc::make_mut(&mut state.blocks[0].values).iter_mut().step_by(5).for_each(|value| *value += 0.5);
    let (bench, state) = restored(machine, &state.bytes());
    let later = bench.moved(&state, Place::start(18, 5)).unwrap();
    let store = later.blocks.iter().rfind(|block| block.kind == BlockKind::Store).unwrap();
    assert_eq!(store.frame, 17);
    assert!(store.values.starts_with(&state.blocks[0].values));
    let expected = machine.pictures(18..19).remove(0);
    let (bench, later) = restored(machine, &later.bytes());
    assert_ne!(bits(&light(&bench.go_on(&later).unwrap())), bits(&expected));
    let back = bench.moved(&later, Place::start(17, 12)).unwrap();
    assert!(state.blocks[0].values.starts_with(&back.blocks[0].values));
}

#[test]
fn steps_by_event_lead_to_events_and_to_no_other_tick() {
    let machine = &*OVERLOADED;
    let bench = machine.bench();
    let frame = machine.control.sweeps_with_gates(17, &bench.row(17).unwrap().pose).unwrap();
    let mut ticks: Vec<u64> =
        (0..SWEEPS).flat_map(|sweep| frame.events(sweep)).map(|event| event.tick.0).collect();
    ticks.extend(frame.frame_events().iter().map(|event| event.tick.0));
    ticks.extend((0..SWEEPS).map(|sweep| bench.clock().tick(Place::start(17, sweep)).0));
    ticks.sort_unstable();
    ticks.dedup();
    let from = Place::start(17, 10);
    let first = ticks.binary_search(&bench.clock().tick(from).0).unwrap();
    for count in [1, 2, 3, 40, -1, -7, -40] {
        let there = bench.step(from, Unit::Event, count).unwrap();
        assert_eq!(bench.clock().tick(there).0, ticks[(first as i64 + count) as usize], "{count}");
        let told = bench.look(there, Unit::Event).unwrap().json();
        let events = told["events"].as_array().unwrap();
        let is_start = there.gone == Gone::Nothing;
        assert!(is_start || !events.is_empty(), "{there}");
        assert!(events.iter().all(|event| event["tick"] == told["tick"]), "{told}");
    }
}

#[test]
fn a_state_of_something_else_is_refused_by_name() {
    let machine = &*NOMINAL;
    let state = machine.bench().save(Place::start(40, 5)).unwrap();
    let refusal = |bench: &Bench<'_>, state: &State| {
        let said = bench.restore(state, FILE.as_ref()).unwrap_err().to_string();
        assert!(said.starts_with("there.state: "), "{said}");
        said
    };
    let said = refusal(&OVERLOADED.bench(), &state);
    assert!(
        said.contains("of the settings of the machine (pra-nominal), expected")
            && said.contains("(pra-overloaded)"),
        "{said}"
    );
    assert!(said.contains("`lunoid state save a.toml`"), "{said}");
    let said = refusal(&IDEAL.bench(), &state);
    assert!(said.contains("another machine or mission"), "{said}");
    let said = refusal(&machine.bench_by("2"), &state);
    assert!(said.contains("lunoid 1 (commit of a test") && said.contains("this is lunoid 2"), "{said}");
    let mut beyond = state.clone();
    beyond.head.place.frame = 1 << 60;
    let said = refusal(&machine.bench(), &beyond);
    assert!(said.contains("the mission has frames 0..90"), "{said}");
    let mut moved = state.clone();
    moved.head.tick += 1;
    assert!(refusal(&machine.bench(), &moved).contains("header, tick and time_s"));
    let mut short = state.clone();
    short.blocks.pop();
    assert!(refusal(&machine.bench(), &short).contains("found no more blocks, expected"));
    let mut words = state.clone();
    words.digital = state.digital.replacen("\"stale\": 0", "\"stale\": 1", 1);
    let said = refusal(&machine.bench(), &words);
    assert!(said.contains("digital side, line ") && said.contains("found `\"stale\": 1"), "{said}");
    let found = machine.bench().save(Place::start(40, SWEEPS));
    assert!(matches!(found, Err(StateError::Place(_))));
}
