//! Crossings of a sweep and what is asked for at each (hardware sections 4.2 and 4.4, numbers 1 and 2 of section 8).

use std::f64::consts::{PI, SQRT_2};

use control_plane::ControlPlane;
use dpu::CrossingService;
use hardware_model::CrossingServer;
use landscape::Level;
use lunoid_tests::{ComparedScene, Dice};
use quantities::radians;
use sweep_generator::{RangeTable, TimedFolds, set_up};
use sweep_program::{
    Colour, Event, Load, PreloadRegister, RampAxis, RegisterSet, SweepProgram, SweepStart, Target, WordMask,
};
use timing::{Deadline, FrameTiming};

use crate::timing::rig::{RANGE, SIZE, flat, frame, loader, pose, thrown};

/// One sweep straight ahead, of folds alone.
fn one_sweep(size: f64) -> ComparedScene {
    let mut scene = flat(size);
    scene.sweeps = 1;
    scene
}

#[test]
fn crossings_a_sweep_over_all_azimuths() {
    const SWEEPS: usize = 4000;
    for (size, expected) in [(200.0, 31.8), (300.0, 21.2), (500.0, 12.7)] {
        let (scene, mut dice) = (one_sweep(size), Dice::new(1));
        let control = ControlPlane::new(scene.stage());
        let folds = |index| frame(&control, 0, &thrown(&scene, &mut dice, [index, SWEEPS])).folds;
        let counts: Vec<u64> = (0..SWEEPS).map(folds).collect();
        let mean = counts.iter().sum::<u64>() as f64 / SWEEPS as f64;
        let formula = 4.0 * RANGE / (PI * size);
        assert!((formula - expected).abs() < 0.06, "the table of section 4.2: {formula}");
        assert!((mean / formula - 1.0).abs() < 0.01, "{size} m: {mean}, not {formula}");
        let (least, most) = (counts.iter().min(), counts.iter().max());
        // Each ramp may meet one stop more or less than its way has regions.
        assert!(*most.unwrap() as f64 <= SQRT_2 * RANGE / size + 2.0);
        assert!(*least.unwrap() as f64 >= RANGE / size - 2.0);
    }
}

#[test]
fn diagonals_cross_most() {
    let (scene, mut dice) = (one_sweep(SIZE), Dice::new(2));
    let control = ControlPlane::new(scene.stage());
    let mut mean = |degrees: f64| {
        let mut folds = || {
            let moved = [dice.between(-0.5, 0.5), dice.between(-0.5, 0.5)];
            frame(&control, 0, &pose(&scene, radians(degrees), moved)).folds as f64
        };
        (0..2000).map(|_| folds()).sum::<f64>() / 2000.0
    };
    let worst = SQRT_2 * RANGE / SIZE;
    for degrees in [45.0, 135.0, 225.0, 315.0] {
        let found = mean(degrees);
        assert!((found / worst - 1.0).abs() < 0.01, "{degrees} degrees: {found}, not {worst}");
    }
    for degrees in [0.0, 30.0, 60.0, 80.0] {
        assert!(mean(degrees) < 0.98 * worst, "{degrees} degrees");
    }
}

/// A loader that is done long before the next crossing.
fn unhurried(server: CrossingServer) -> FrameTiming {
    let (mut scene, mut dice) = (one_sweep(SIZE), Dice::new(3));
    scene.sweeps = 9;
    scene.loader = loader(server, 9, [1, 1, 1]);
    frame(&ControlPlane::new(scene.stage()), 0, &thrown(&scene, &mut dice, [7, 64]))
}

#[test]
fn four_sets_are_asked_for_at_a_crossing_and_half_of_them_are_used() {
    for server in [CrossingServer::WiredPointers, CrossingServer::IoProcessor] {
        let found = unhurried(server);
        let sets = found.sets;
        assert!(found.folds > 150);
        assert_eq!(
            (sets.wanted, sets.loaded, sets.late, sets.cancelled),
            (4 * found.folds, 4 * found.folds, 0, 0)
        );
        // Whatever a fold uses, it overwrites as many: 50 % exactly, but for those that the sweep's end leaves over.
        let transfers = found.deadlines[&Deadline::TRANSFER];
        assert_eq!((sets.wasted, transfers.missed), (transfers.count, 0));
        let left = sets.loaded - sets.wasted - transfers.count;
        assert!(left <= 8 * 9, "{left} sets of nine sweeps wait for a fold that does not come");
        // One event a stop, and one a set of nine words.
        assert_eq!(found.events, 5 * found.folds);
    }
}

/// Folds and arrivals of one sweep of an I/O processor that is done before the next fold.
fn program(level: &Level, foot: [f64; 2], direction: [f64; 2]) -> SweepProgram {
    let scene = one_sweep(SIZE);
    let settings = scene.settings();
    let loader = loader(CrossingServer::IoProcessor, 9, [0, 1, 0]);
    let service = CrossingService {
        level,
        loader: &loader,
        cpu: &settings.cpu,
        timebase: &settings.timebase,
        missing: &[],
        held: 0,
        seed: 0,
    };
    let start = set_up(foot, direction);
    let table = RangeTable::new(&settings.range, 1000);
    let folds = TimedFolds::new(&start, SIZE, &table, RANGE);
    let mut program = blank(start);
    service.write_program((0, 0), start, folds, RANGE, |time| table.range_at(time), &mut program, &mut ());
    program
}

fn blank(start: SweepStart) -> SweepProgram {
    let registers = [RegisterSet::default(); 4];
    SweepProgram { start, registers, steps: Vec::new(), end_range: 0.0, misses: Vec::new() }
}

/// The set of the two colours' corner that the very next stop of the other axis takes goes first; the other three have a
/// whole crossing more.
#[test]
fn one_of_the_four_sets_is_urgent_and_goes_first() {
    let (scene, mut dice) = (one_sweep(SIZE), Dice::new(4));
    let mut crossings = 0;
    for _ in 0..50 {
        let azimuth = dice.between(0.0, 2.0 * PI);
        let direction = [libm::cos(azimuth), libm::sin(azimuth)];
        let foot = [20.0 + dice.between(0.0, 1.0), 20.0 + dice.between(0.0, 1.0)];
        let program = program(&scene.level, foot, direction);
        let events: Vec<Event> = program.events().map(|step| step.kind).collect();
        let folds: Vec<(usize, RampAxis, Vec<Colour>)> = events
            .iter()
            .enumerate()
            .filter_map(|(index, event)| match event {
                Event::Fold(fold) => {
                    let taken = Colour::ALL.into_iter().filter(|&colour| fold.axis.takes(fold.stop, colour));
                    Some((index, fold.axis, taken.collect()))
                }
                _ => None,
            })
            .collect();
        for (number, (index, axis, colours)) in folds.iter().enumerate() {
            let Some((_, other, next)) = folds[number + 1..].iter().find(|(_, of, _)| of != axis) else {
                break;
            };
            let loads: Vec<Load> = events[index + 1..]
                .iter()
                .map_while(|event| match event {
                    Event::Load(load) => Some(*load),
                    _ => None,
                })
                .collect();
            if loads.len() != 4 {
                // The next fold came before the last of them: not this test's matter.
                continue;
            }
            assert!(loads.iter().all(|load| load.words == WordMask::ALL && colours.contains(&load.colour)));
            let urgent: Vec<&Colour> = next.iter().filter(|colour| colours.contains(colour)).collect();
            let register =
                if *other == RampAxis::X { PreloadRegister::XFirst } else { PreloadRegister::YFirst };
            assert_eq!((urgent.len(), loads[0].target), (1, Target::Preload(register)));
            assert_eq!(*urgent[0], loads[0].colour);
            crossings += 1;
        }
    }
    assert!(crossings > 500, "{crossings}");
}
