//! When folds are found, and when words act.

use hardware_model::{AnalogParts, FoldDetect};
use parts::{Spread, Tolerance, relative_sigma};
use signal::LANES;
use sweep_program::{Event, RampAxis, Step, StepKind, Stop, Target};

use super::{STEP, Scene, parts, weight};
use crate::of_parts::{ArrayState, Logic, PartsArray, Tap};
use crate::terms::{ALL, TERMS, side_by_side, word_of};
use crate::{Profile, Registers};

fn array(scene: &Scene, parts: &AnalogParts) -> PartsArray<f64> {
    PartsArray::new(STEP, &scene.level, parts, 3, "tg")
}

fn found_on_the_ramp(change: impl FnOnce(&mut AnalogParts)) -> AnalogParts {
    parts(|parts| {
        (parts.full_scale, parts.sweep.fold_detect) = (10.0, FoldDetect::Comparator);
        parts.comparator.delay = 40e-9;
        change(parts);
    })
}

/// Slope of the ramp that folds (full scales a second), and the number of its stop.
fn slope(scene: &Scene, lane: usize, step: &Step) -> (f64, u64) {
    let fold = step.kind.fold().expect("folds alone");
    let axis = usize::from(fold.axis == RampAxis::Y);
    // 1.5 m a sample, regions of 200 m.
    let slope = scene.programs[lane].start.direction[axis].abs() * 1.5 / 200.0 / STEP;
    (slope, 2 * axis as u64 + u64::from(fold.stop == Stop::One))
}

/// On a ramp of slope s a comparator at the stop is off by `o / s`, and an overdrive of `k` costs `sqrt(2 k / s)`.
#[test]
fn a_stop_is_found_by_its_offset_over_the_slope_later() {
    let scene = Scene::new();
    let clean = array(&scene, &found_on_the_ramp(|_| ()));
    let off = array(&scene, &found_on_the_ramp(|parts| parts.comparator.offset = 5e-3));
    let slow = array(&scene, &found_on_the_ramp(|parts| parts.comparator.overdrive = 150e-12));
    let mut largest = 0.0_f64;
    for lane in 0..LANES {
        let is_fold = |step: &&Step| step.kind.fold().is_some();
        for step in scene.programs[lane].steps.iter().filter(is_fold) {
            let (slope, stop) = slope(&scene, lane, step);
            let at = |array: &PartsArray<f64>| {
                let (generator, program) = (scene.generator(), &scene.programs[lane]);
                [
                    array.timing.of_words(step, &generator, program),
                    array.timing.of_polarity(step, &generator, program),
                ]
            };
            let offset = Spread::new(3).error("tg.stop.offset", stop, 5e-4);
            // The upper stop is met from below, the lower from above.
            let later = if stop % 2 == 1 { offset } else { -offset } / slope / STEP;
            let waits = (2.0 * 15e-12 / slope).sqrt() / STEP;
            for (k, right) in at(&clean).into_iter().enumerate() {
                assert!((right - step.time.0 - 0.8).abs() < 1e-9);
                assert!((at(&off)[k] - right - later).abs() < 1e-9, "{lane} {step:?}");
                assert!((at(&slow)[k] - right - waits).abs() < 1e-9, "{lane} {step:?}");
            }
            largest = largest.max(later.abs());
        }
    }
    assert!(largest > 0.05, "{largest}");
}

/// Stops, flip-flops and registers are told where their wires are: a digital fold as far ahead of the beam as the accumulators run, one
/// that a comparator finds by its delay later, a register by its switching time before its D/As have the word.
#[test]
fn logic_is_told_where_its_wires_are() {
    let scene = Scene::new();
    // A bandwidth whose time constant is a sample and a half.
    let digital = parts(|parts| {
        parts.multiplier.bandwidth = Some(1.0 / (std::f64::consts::TAU * 75e-9));
        parts.sweep.strobe_offset = 10e-9;
    });
    let comparator = found_on_the_ramp(|parts| {
        (parts.multiplying_dac.switching, parts.sweep.strobe_offset) = (100e-9, 25e-9);
    });
    // Samples by which stops, polarity and registers are later than in the program.
    for (parts, later) in [(digital, [-1.5, -1.3, 0.2]), (comparator, [0.8, 1.3, 1.3])] {
        let array = array(&scene, &parts);
        for program in &scene.programs {
            for (logic, later) in [Logic::Stops, Logic::Polarity, Logic::Registers].into_iter().zip(later) {
                let told = array.on_wires(logic, &scene.generator(), program);
                assert_eq!(told.steps.len(), program.steps.len());
                let mut passed = 0;
                for (step, told) in program.steps.iter().zip(&told.steps) {
                    assert_eq!(step.kind, told.kind);
                    let in_retrace = parts.sweep.preset && step.time.0 <= 0.0;
                    let right = if in_retrace { step.time.0 } else { step.time.0 + later };
                    assert!((told.time.0 - right).abs() < 1e-9, "{logic:?}: {} {right}", told.time.0);
                    passed += usize::from(!in_retrace);
                }
                assert!(passed > 5, "{passed} steps behind the first range");
            }
        }
    }
}

/// The weights of a lane, sample by sample.
struct Weights(Vec<Vec<f64>>);

impl Tap<f64> for Weights {
    fn see(&mut self, _: &PartsArray<f64>, state: &ArrayState<f64>) {
        let weight = |index| {
            let [pair, end] = side_by_side(index);
            state.wires.pairs[pair].weight.wire(end)[2]
        };
        self.0.push((0..ALL).map(weight).collect());
    }
}

/// Each D/A has its word from its own switching time on: the nine of a corner do not settle as one.
#[test]
fn each_word_acts_after_its_own_switching_time() {
    let scene = Scene::new();
    let (nominal, samples) = (600e-9, scene.ranges.len());
    for spread in [false, true] {
        let array = array(
            &scene,
            &parts(|parts| {
                (parts.spread, parts.multiplying_dac.switching) = (spread, nominal);
            }),
        );
        let (generator, program) = (scene.generator(), &scene.programs[2]);
        let (mut weights, mut profile) = (Weights(Vec::new()), Profile::default());
        profile.resize(samples);
        let state = &mut ArrayState::default();
        array.trace(&generator, &scene.programs, 0..samples, 0, state, &mut profile, &mut weights);
        let sigma = if spread { relative_sigma::SWITCH_DELAY } else { 0.0 };
        let mut together = 0;
        for index in 0..ALL {
            let time =
                Spread::new(3).figure("tg.mdac.switching", index as u64, &Tolerance { nominal, sigma });
            let mut registers = Registers::at_start(program);
            let mut steps = program.steps.iter().peekable();
            for (sample, weights) in weights.0.iter().enumerate() {
                while steps.next_if(|step| step.time.0 + time / STEP <= sample as f64).is_some_and(|step| {
                    registers.apply(step, generator.buffer);
                    true
                }) {}
                let [colour, _] = word_of(index % TERMS);
                assert_eq!(
                    weights[index],
                    weight(&array, registers.hold(generator.buffer)[colour], index),
                    "{index} {sample}"
                );
            }
            together += usize::from(time == nominal);
        }
        assert_eq!(together, if spread { 0 } else { ALL });
    }
}

/// Polarities and weights of a lane, sample by sample.
struct Switched(usize, Vec<([f64; 2], Vec<f64>)>);

impl Tap<f64> for Switched {
    fn see(&mut self, _: &PartsArray<f64>, state: &ArrayState<f64>) {
        let weight = |index| {
            let [pair, end] = side_by_side(index);
            state.wires.pairs[pair].weight.wire(end)[self.0]
        };
        self.1.push((state.lanes[self.0].polarity, (0..ALL).map(weight).collect()));
    }
}

/// Stops that are found out of turn: a polarity turns when its own stop is found, and words wait for those that are in hold before
/// them alone. Words on their way to a preload register hold nobody up.
#[test]
fn what_is_found_out_of_turn_waits_for_nothing_but_words_in_hold() {
    let mut scene = Scene::new();
    // Words come to the preload register of the fold before them, and to hold with the next fold of its axis.
    for program in &mut scene.programs {
        let mut register = RampAxis::X.register();
        for step in &mut program.steps {
            match &mut step.kind {
                StepKind::Event(Event::Fold(fold)) => register = fold.axis.register(),
                StepKind::Event(Event::Load(load)) => load.target = Target::Preload(register),
                other => panic!("{other:?} in a program of folds and loads"),
            }
        }
    }
    let parts = found_on_the_ramp(|parts| {
        (parts.comparator.offset, parts.sweep.preset, parts.spread) = (0.5, false, true);
    });
    let mut counts = [0; 3];
    // Some draws have stops that are found early, others late.
    for seed in 3..33 {
        let array = PartsArray::new(STEP, &scene.level, &parts, seed, "tg");
        for lane in 0..LANES {
            hold_to_own_instants(&scene, &array, lane, &mut counts);
        }
    }
    assert!(counts.iter().all(|&count| count > 3), "{counts:?}");
}

/// Holds polarities and weights of a lane, sample by sample, to the instants of its own steps. It counts turns and words that are found
/// before those of an earlier fold, and words that act before others are in their preload register.
fn hold_to_own_instants(scene: &Scene, array: &PartsArray<f64>, lane: usize, counts: &mut [usize; 3]) {
    let (generator, program) = (scene.generator(), &scene.programs[lane]);
    let (mut seen, mut profile) = (Switched(lane, Vec::new()), Profile::default());
    profile.resize(scene.ranges.len());
    let state = &mut ArrayState::default();
    array.trace(&generator, &scene.programs, 0..scene.ranges.len(), 0, state, &mut profile, &mut seen);
    let (mut turns, mut strobes) = (Vec::new(), Vec::new());
    let [mut turned, mut held, mut preloaded] = [f64::NEG_INFINITY; 3];
    for step in &program.steps {
        let own = array.timing.of_words(step, &generator, program);
        if let Some(fold) = step.kind.fold() {
            let at = array.timing.of_polarity(step, &generator, program);
            turns.push((at, usize::from(fold.axis == RampAxis::Y)));
            counts[0] += usize::from(at < turned);
            counts[1] += usize::from(own < held);
            (turned, held) = (at, own.max(held));
            counts[2] += usize::from(held < preloaded);
        } else {
            preloaded = own;
        }
        strobes.push((held, step));
    }
    for (sample, (polarity, weights)) in seen.1.iter().enumerate() {
        let mut right = program.start.ramps.map(|ramp| ramp.polarity);
        for (_, axis) in turns.iter().filter(|(at, _)| *at <= sample as f64) {
            right[*axis] = -right[*axis];
        }
        assert_eq!(*polarity, right, "lane {lane}, sample {sample}");
        let mut registers = Registers::at_start(program);
        let by_now = strobes.iter().filter(|(at, _)| *at <= sample as f64);
        by_now.for_each(|(_, step)| registers.apply(step, generator.buffer));
        for (index, &found) in weights.iter().enumerate() {
            let [colour, _] = word_of(index % TERMS);
            let right = weight(array, registers.hold(generator.buffer)[colour], index);
            assert_eq!(found, right, "lane {lane}, sample {sample}, D/A {index}");
        }
    }
}

#[test]
fn the_converters_of_the_two_ramps_settle_apart() {
    let scene = Scene::new();
    let delays = |spread: bool| {
        let made = array(
            &scene,
            &parts(|parts| {
                (parts.spread, parts.sweep.dac_bits, parts.sweep.settle) = (spread, Some(10), 150e-9);
            }),
        );
        [0, 1].map(|axis| made.ramps[axis].delay())
    };
    let [[x, y], [drawn_x, drawn_y]] = [false, true].map(delays);
    assert!(
        x == y && drawn_x != drawn_y && (0.3..3.0).contains(&(drawn_x / drawn_y)),
        "{x} {drawn_x} {drawn_y}"
    );
}
