//! The processor's time (hardware section 4.6, number 11 of section 8).

use control_plane::{ControlPlane, MachineStage};
use dpu::{CpuLoad, CrossingTime, cpu_frame};
use hardware_model::{Cpu, CrossingServer, GroundScale, HardwareModel, ModelSource};
use lunoid_tests::{ComparedScene, Dice};
use timing::{Deadline, FrameTiming};

use crate::timing::rig::{SIZE, busy, flat, frame, loader, pose};

const SWEEPS: u32 = 21;

fn timed(cpu: Cpu, server: CrossingServer) -> FrameTiming {
    let mut scene: ComparedScene = flat(SIZE);
    scene.sweeps = SWEEPS;
    scene.loader = loader(server, 9, [1, 2, 1]);
    let mut stage: MachineStage = scene.stage();
    stage.settings.cpu = cpu;
    frame(&ControlPlane::new(stage), 0, &pose(&scene, 0.4, [0.1, 0.2]))
}

#[test]
fn its_tasks_add_up() {
    let (sweep_setup, frame_tables) = (300, 100_000);
    let wired = CrossingServer::WiredPointers;
    let set_ups = timed(Cpu { sweep_setup, ..Cpu::default() }, wired);
    let tables = timed(Cpu { frame_tables, ..Cpu::default() }, wired);
    let both = timed(Cpu { sweep_setup, frame_tables, ..Cpu::default() }, wired);
    assert_eq!(busy(&set_ups, "cpu"), sweep_setup * u64::from(SWEEPS));
    assert_eq!(busy(&tables, "cpu"), frame_tables);
    assert_eq!(busy(&both, "cpu"), busy(&set_ups, "cpu") + busy(&tables, "cpu"));
    // Tables fill what set-ups leave, so the frame's slack is what is left of all but the first set-up, which was made
    // before the frame began.
    let slack = both.deadlines[&Deadline::FRAME_TASKS].least.unwrap();
    assert!(slack > 0 && slack as u64 <= both.ticks - frame_tables, "{slack}");
}

/// Every fold is one interrupt, with its instructions and multiplications; every set that comes is three ticks of words.
#[test]
fn crossings_by_interrupt_cost_their_instructions() {
    let cpu = Cpu {
        sweep_setup: 300,
        frame_tables: 100_000,
        interrupt: 8,
        longest_instruction: 8,
        memory_cycle: 2,
        multiply: 5,
        crossing_instructions: 4,
        instruction_cycles: 3,
        crossing_multiplications: 2,
        ..Cpu::default()
    };
    let without = timed(cpu, CrossingServer::WiredPointers);
    let with = timed(cpu, CrossingServer::CpuInterrupt);
    assert_eq!(busy(&with, "cpu.interrupts"), (8 + 4 * 3 * 2 + 2 * 5) * with.folds);
    assert_eq!(busy(&with, "cpu.words"), with.sets.loaded * 3);
    let crossings = busy(&with, "cpu") - busy(&without, "cpu");
    assert_eq!(crossings, busy(&with, "cpu.interrupts") + busy(&with, "cpu.words"));
    assert!(with.units.iter().all(|unit| !unit.unit.starts_with("loader")), "{:?}", with.units);
}

/// Words that others bring through the processor's memory: 36 a crossing, a memory cycle each (hardware section 4.6).
#[test]
fn words_through_its_memory_steal_its_cycles() {
    let cpu = Cpu { sweep_setup: 300, memory_cycle: 17, ..Cpu::default() };
    let own_memory = timed(cpu, CrossingServer::IoProcessor);
    let through = timed(Cpu { dma_cycles_per_word: 1, ..cpu }, CrossingServer::IoProcessor);
    assert_eq!(busy(&own_memory, "cpu.words"), 0);
    assert_eq!(busy(&through, "cpu.words"), 9 * 17 * through.sets.loaded);
    // But for those that the sweep ends before, four sets a crossing.
    assert!(through.sets.loaded > 4 * through.folds - 8 * u64::from(SWEEPS));
    let stolen = busy(&through, "cpu") - busy(&own_memory, "cpu");
    assert_eq!(stolen, busy(&through, "cpu.words"));
    // What is stolen is missing for what waits for the processor.
    let least = |frame: &FrameTiming| frame.deadlines[&Deadline::SWEEP_SET_UP].least.unwrap();
    assert!(least(&through) < least(&own_memory));
}

/// Interleaved banks: what others bring meets the processor in one cycle of four (hardware section 2.1), and the sum over a
/// frame is that to a tick a sweep.
#[test]
fn interleaved_banks_leave_the_processor_most_of_its_cycles() {
    let cpu = Cpu { sweep_setup: 300, memory_cycle: 17, dma_cycles_per_word: 1, ..Cpu::default() };
    let server = CrossingServer::IoProcessor;
    let one = timed(cpu, server);
    let four = timed(Cpu { memory_banks: 4, ..cpu }, server);
    assert_eq!(one.sets, four.sets);
    let [all, quarter] = [&one, &four].map(|frame| busy(frame, "cpu.words"));
    assert_eq!(all, 9 * 17 * one.sets.loaded);
    assert!(4 * quarter >= all && 4 * quarter < all + 4 * u64::from(SWEEPS), "{quarter} of {all}");
    // Without cycles for a word the number of banks is nothing to it.
    let none = Cpu { dma_cycles_per_word: 0, ..cpu };
    assert_eq!(timed(Cpu { memory_banks: 8, ..none }, server), timed(none, server));
    assert_eq!(
        [Cpu { memory_banks: 4, ..cpu }.stolen(8), Cpu { memory_banks: 4, ..cpu }.stolen(9)],
        [34, 39]
    );
}

/// The row of hardware section 4.6: 25 to 35 µs a crossing, and 31 µs of words.
#[test]
fn a_crossing_by_interrupt_takes_25_to_35_microseconds() {
    for (name, most) in [("pra-nominal", 35e-6), ("pra-frugal", 35e-6), ("pra-overloaded", 50e-6)] {
        let source = ModelSource::BuiltIn(name.into());
        let model = HardwareModel::load(&source, &[], &[]).unwrap_or_else(|list| panic!("{list}")).model;
        let crossing = model.budget(model.usual_ground()).cpu.crossing;
        assert!((25e-6..=most).contains(&crossing), "{name}: {crossing}");
    }
    let set = [("cpu.dma_cycles_per_word", "1"), ("cpu.memory_banks", "1")]
        .map(|(key, value)| (key.to_owned(), value.to_owned()));
    let nominal = ModelSource::BuiltIn("pra-nominal".into());
    let model = HardwareModel::load(&nominal, &[], &set).unwrap_or_else(|list| panic!("{list}")).model;
    let budget = model.budget(GroundScale { region_size: 500.0, range: 5000.0 });
    let words = budget.cpu.loads * budget.sweep.period / budget.crossings.mean;
    assert!((words - 36.0 * 0.85e-6).abs() < 1e-9, "{words}");
}

/// With one level a crossing waits until the set-up is done, and the set-up is never late for it; with more it is the other
/// way round.
#[test]
fn with_several_levels_crossings_interrupt_set_ups() {
    let timed = |levels| {
        let cpu = Cpu { sweep_setup: 20_000, interrupt: 50, priority_levels: levels, ..Cpu::default() };
        timed(cpu, CrossingServer::CpuInterrupt)
    };
    let [one, many] = [Some(1), Some(2)].map(timed);
    assert_eq!(many, timed(None));
    let least = |frame: &FrameTiming, deadline| frame.deadlines[&deadline].least.unwrap();
    let period = (one.ticks / u64::from(SWEEPS)) as i64;
    // Nothing is before a set-up with one level, but for the rounding of a period.
    assert!((least(&one, Deadline::SWEEP_SET_UP) - (period - 20_000)).abs() <= 1);
    assert!(least(&many, Deadline::SWEEP_SET_UP) < least(&one, Deadline::SWEEP_SET_UP) - 1000);
    assert!(one.sets.late > 2 * many.sets.late, "{} with one, {} with two", one.sets.late, many.sets.late);
    // Nothing comes before the set-up is done.
    let samples = one.misses.iter().filter(|missed| missed.deadline == Deadline::TRANSFER);
    let per_sample = period as f64 / 1000.0;
    let came = samples.filter_map(|missed| missed.came).fold(f64::INFINITY, f64::min);
    assert!(came * per_sample > 20_000.0, "{came}");
}

#[test]
fn set_ups_that_take_longer_than_a_sweep_repeat_sweeps() {
    let quick = timed(Cpu { sweep_setup: 300, ..Cpu::default() }, CrossingServer::WiredPointers);
    assert_eq!(quick.deadlines[&Deadline::SWEEP_SET_UP].missed, 0);
    let period = quick.ticks / u64::from(SWEEPS);
    let slow = timed(Cpu { sweep_setup: 2 * period, ..Cpu::default() }, CrossingServer::WiredPointers);
    let late = slow.misses.iter().filter(|missed| missed.deadline == Deadline::SWEEP_SET_UP).count();
    // Every other set-up is made, and all of them late; the others are not made at all.
    assert_eq!(late, SWEEPS as usize, "{:?}", slow.deadlines[&Deadline::SWEEP_SET_UP]);
    assert_eq!(slow.deadlines[&Deadline::SWEEP_SET_UP].missed, u64::from(SWEEPS));
    // It is at work all the time, and no longer.
    assert_eq!(busy(&slow, "cpu"), slow.ticks);
}

#[test]
fn no_program_is_used_before_it_is_made() {
    let mut dice = Dice::new(8);
    let (mut repeated, mut own) = (0, 0);
    for _ in 0..2000 {
        let sweeps = dice.count(1, 60);
        let period = dice.count(50, 400) as u64;
        let starts: Vec<u64> = (0..=sweeps as u64).map(|sweep| sweep * period).collect();
        let interrupts: Vec<u64> = (0..sweeps).map(|_| dice.count(0, 300) as u64).collect();
        let (words, unbroken) = (dice.count(0, 40) as u64, dice.count(0, 1) == 1);
        let cpu = Cpu {
            sweep_setup: dice.count(1, 500) as u64,
            frame_tables: dice.count(0, 2000) as u64,
            ..Cpu::default()
        };
        let crossing = |&interrupts: &u64| CrossingTime { interrupts, words };
        let crossings: Vec<CrossingTime> = interrupts.iter().map(crossing).collect();
        let load = CpuLoad { starts: &starts, crossings: &crossings, unbroken, vertices: 0 };
        let found = cpu_frame(&cpu, load);
        assert!(found.time.busy() <= starts[sweeps], "{found:?}");
        let done = |sweep: u32| {
            let made = found.set_ups.iter().find(|&&(made, _)| made == sweep);
            made.map(|&(_, slack)| starts[sweep as usize] as i64 - slack)
        };
        for (sweep, &drawn) in found.drawn.iter().enumerate() {
            assert!(drawn as usize <= sweep);
            let in_time = done(drawn).is_some_and(|done| done <= starts[sweep] as i64);
            // Until the first set-up is made there is nothing else to draw with.
            assert!(in_time || drawn == 0, "sweep {sweep} is drawn with {drawn}: {found:?}");
            if drawn as usize == sweep { own += 1 } else { repeated += 1 }
        }
    }
    assert!(own > 1000 && repeated > 1000, "{own} {repeated}");
}
