//! The processor's time (hardware section 4.6, number 11 of section 8).

use dpu::{CpuLoad, cpu_frame};
use generator::Stage;
use hardware_model::{Cpu, CrossingServer};
use lunoid_tests::{Dice, Scene};
use machine::ControlPlane;
use timing::{Deadline, FrameTiming};

use crate::rig::{SIZE, busy, flat, frame, loader, pose};

const SWEEPS: u32 = 21;

fn timed(cpu: Cpu, server: CrossingServer) -> FrameTiming {
    let mut scene: Scene = flat(SIZE);
    scene.sweeps = SWEEPS;
    scene.loader = loader(server, 9, [1, 2, 1]);
    let mut stage: Stage = scene.stage();
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
    let slack = both.deadlines[&Deadline::FrameTasks].least.unwrap();
    assert!(slack > 0 && slack as u64 <= both.ticks - frame_tables, "{slack}");
}

#[test]
fn crossings_by_interrupt_come_on_top() {
    let cpu = Cpu {
        sweep_setup: 300,
        frame_tables: 100_000,
        interrupt: 8,
        longest_instruction: 8,
        ..Cpu::default()
    };
    let without = timed(cpu, CrossingServer::WiredPointers);
    let with = timed(cpu, CrossingServer::CpuInterrupt);
    let crossings = busy(&with, "cpu") - busy(&without, "cpu");
    // Four sets of three ticks, one interrupt of 8 ticks and up to 8 to wait for the instruction.
    let sets = with.sets.loaded * 3;
    assert!(crossings >= sets + 8 * with.folds && crossings <= sets + 16 * with.folds, "{crossings}");
    assert!(with.units.iter().all(|unit| !unit.unit.starts_with("loader")), "{:?}", with.units);
}

#[test]
fn set_ups_that_take_longer_than_a_sweep_repeat_sweeps() {
    let quick = timed(Cpu { sweep_setup: 300, ..Cpu::default() }, CrossingServer::WiredPointers);
    assert_eq!(quick.deadlines[&Deadline::SweepSetUp].missed, 0);
    let period = quick.ticks / u64::from(SWEEPS);
    let slow = timed(Cpu { sweep_setup: 2 * period, ..Cpu::default() }, CrossingServer::WiredPointers);
    let late = slow.misses.iter().filter(|missed| missed.deadline == Deadline::SweepSetUp).count();
    // Every other set-up is made, and all of them late; the others are not made at all.
    assert_eq!(late, SWEEPS as usize, "{:?}", slow.deadlines[&Deadline::SweepSetUp]);
    assert_eq!(busy(&slow, "cpu") / period, u64::from(SWEEPS) + 1);
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
        let cpu = Cpu {
            sweep_setup: dice.count(1, 500) as u64,
            frame_tables: dice.count(0, 2000) as u64,
            ..Cpu::default()
        };
        let found = cpu_frame(&cpu, CpuLoad { starts: &starts, interrupts: &interrupts, vertices: 0 });
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
