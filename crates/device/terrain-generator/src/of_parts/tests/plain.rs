//! The array part by part as its pages have it, one sweep and one wire at a time: what the fast form is held to.

use fearless_simd::{Level, dispatch};
use hardware_model::{AnalogParts, MultiplierParts};
use parts::LagStep;
use signal::{LANES, Lanes, Real};
use sweep_program::{RampAxis, Step, SweepProgram};

use super::{STEP, Scene, parts, weight};
use crate::of_parts::block::{BLOCK, Row};
use crate::of_parts::summer::SummerState;
use crate::of_parts::{ArrayState, PartsArray, Scale, Tap};
use crate::terms::{self, ALL, TERMS, sign, word_of};
use crate::{Profile, Registers};

/// A machine with every part of 1970 but noise.
fn of_1970(change: impl FnOnce(&mut AnalogParts)) -> AnalogParts {
    parts(|parts| {
        (parts.full_scale, parts.spread) = (10.0, true);
        let sweep = &mut parts.sweep;
        (sweep.dac_bits, sweep.settle, sweep.nonlinearity) = (Some(10), 150e-9, 5e-4);
        (sweep.glitch, sweep.smoother) = (20e-9, 40e-9);
        let function = &mut parts.function_generator;
        (function.segments, function.rounding) = (Some(20), 0.05);
        (function.error, function.bandwidth) = (1e-3, Some(5e6));
        let multiplier = &mut parts.multiplier;
        (multiplier.error, multiplier.scale_error) = (2.5e-3, 2e-3);
        (multiplier.feedthrough, multiplier.bandwidth) = (5e-3, Some(8e6));
        let converter = &mut parts.multiplying_dac;
        (converter.bits, converter.gain_error, converter.bandwidth) = (Some(12), 5e-4, Some(4e6));
        (converter.glitch, converter.switching, converter.feedthrough) = (150e-9, 80e-9, 3e-3);
        let amplifier = &mut parts.amplifier;
        (amplifier.gain_bandwidth, amplifier.slew) = (Some(80e6), Some(200e6));
        (amplifier.saturation, amplifier.recovery) = (Some(11.0), 1e-6);
        parts.summer_inputs = Some(6);
        change(parts);
    })
}

/// A word that a D/A takes: when (samples), its weight, and the area of its pulse.
type Word = (f64, f64, f64);

/// The words of every D/A over the sweep, the first from before all time.
fn words(array: &PartsArray<f64>, scene: &Scene, program: &SweepProgram) -> Vec<Vec<Word>> {
    let generator = scene.generator();
    let mut registers = Registers::at_start(program);
    let held = |registers: &Registers, index: usize| {
        let [colour, word] = word_of(index % TERMS);
        let words = registers.hold(generator.buffer)[colour];
        (weight(array, words, index), array.number(words, word).0)
    };
    let mut all: Vec<Vec<Word>> =
        (0..ALL).map(|index| vec![(f64::NEG_INFINITY, held(&registers, index).0, 0.0)]).collect();
    let mut at = f64::NEG_INFINITY;
    for step in &program.steps {
        let before: Vec<_> = (0..ALL).map(|index| held(&registers, index)).collect();
        registers.apply(step, generator.buffer);
        at = array.timing.of_words(step, &generator, program).max(at);
        for index in 0..ALL {
            let (weight, number) = held(&registers, index);
            if weight != before[index].0 {
                let carry = array.words.as_ref().map_or(0.0, |part| part.carry(before[index].1, number));
                all[index].push((at + array.timing.later(index), weight, array.glitch * carry));
            }
        }
    }
    all
}

/// Folds of an axis among the steps that are past.
fn folds(program: &SweepProgram, axis: RampAxis, mut is_past: impl FnMut(&Step) -> bool) -> u32 {
    let past = program.steps.iter().take_while(|step| is_past(step));
    let of_axis = |step: &&Step| step.kind.fold().is_some_and(|fold| fold.axis == axis);
    past.filter(of_axis).count() as u32
}

/// Height above the eye of one lane, sample by sample (m).
fn heights(array: &PartsArray<f64>, scene: &Scene, lane: usize) -> Vec<f64> {
    let (generator, program) = (scene.generator(), &scene.programs[lane]);
    let words = words(array, scene, program);
    let foot = -(1.0 + array.timing.lead / STEP).ceil() as i64;
    let has_steps = i64::from(array.ramps[0].has_steps());
    let at_range = |range: f64| {
        [RampAxis::X, RampAxis::Y].map(|axis| {
            let folds = folds(program, axis, |step| step.range <= range);
            Lanes::splat(program.start.ramps[axis as usize].at(folds, range / generator.region_size).0)
        })
    };
    let ramps = |sample: i64| at_range(array.timing.accumulated(&scene.ranges, sample as f64));
    let signs = |sample: i64| {
        [RampAxis::X, RampAxis::Y].map(|axis| {
            let past = |step: &Step| array.timing.of_polarity(step, &generator, program) <= sample as f64;
            let sign = if folds(program, axis, past) % 2 == 0 { 1.0 } else { -1.0 };
            sign * program.start.ramps[axis as usize].polarity
        })
    };
    let factors = |axes: &[_; 2], signs: [f64; 2]| {
        let axes: &[crate::of_parts::basis::AxisState<f64>; 2] = axes;
        [0, 1].map(|axis| {
            std::array::from_fn(|unit| axes[axis].output(unit) * Lanes::splat(sign(unit, signs[axis])))
        })
    };
    let cells = &array.grid.cells;
    let product = |index: usize, [x, y]: &[[Lanes<f64>; 12]; 2]| {
        let [a, b] = terms::factors(index / TERMS, index % TERMS);
        cells[index].parts.multiplier.product(x[a][0], y[b][0])
    };
    let partial = |leaky: &[f64]| -> Vec<Row<f64>> {
        let group = |group: &[f64]| [Lanes::splat(group.iter().fold(0.0, |sum, term| sum + term)); BLOCK];
        leaky[..TERMS].chunks(TERMS.div_ceil(array.grid.groups())).map(group).collect()
    };
    let Scale { datum, height, .. } = array.scale;
    // Everything at rest under ramps that stand, with the words that act by then.
    let at_rest = |start: [Lanes<f64>; 2], signs: [f64; 2], by: f64| {
        let ramp = [0, 1].map(|axis| array.ramps[axis].at_rest(start[axis]));
        let axes = [0, 1].map(|axis| {
            dispatch!(Level::new(), simd => {
                let part = &array.generators[axis];
                part.at_rest(simd, &part.feed(simd, ramp[axis].output()))
            })
        });
        let before = factors(&axes, signs);
        let raw: Vec<f64> = (0..ALL).map(|index| product(index, &before)).collect();
        let held = |index: usize| words[index].partition_point(|word| word.0 <= by) - 1;
        let terms: Vec<f64> = (0..ALL).map(|index| raw[index] * words[index][held(index)].1).collect();
        let mut summer = SummerState::default();
        let sum = array.summers[0].at_rest(&mut partial(&terms), &mut summer)[0];
        (ramp, axes, before, raw, terms, summer, sum)
    };
    let trim = {
        let foot = program.start.ramps.map(|ramp| ramp.start);
        let registers = Registers::at_start(program);
        let (.., sum) = at_rest(at_range(0.0), registers.polarity(), f64::NEG_INFINITY);
        crate::array(registers.hold(generator.buffer), registers.polarity(), foot)[0] - (sum * height + datum)
    };
    let (mut ramp, mut axes, mut before, mut raw, mut terms, mut summer, mut sum) =
        at_rest(ramps(foot), signs(foot), foot as f64);
    let (mut products, mut leaky) = (raw.clone(), terms.clone());
    let mut out = Vec::new();
    for sample in foot..scene.ranges.len() as i64 {
        if sample > foot {
            let now = ramps(sample - has_steps);
            for axis in 0..2 {
                dispatch!(Level::new(), simd => {
                    let mut value = [now[axis]];
                    array.ramps[axis].pass(simd, &mut ramp[axis], &mut value);
                    let fed = array.generators[axis].feed(simd, value[0]);
                    array.generators[axis].step(simd, &mut axes[axis], &fed);
                });
            }
            let now = factors(&axes, signs(sample));
            for index in 0..ALL {
                let [a, _] = terms::factors(index / TERMS, index % TERMS);
                let fed = product(index, &now) + cells[index].parts.leak.leak(before[0][a][0], now[0][a][0]);
                let from = products[index];
                products[index] = cells[index].parts.lag.step(from, raw[index], fed);
                raw[index] = fed;
                let signal = [from, products[index]];
                terms[index] = converted(terms[index], &words[index], sample, signal, cells[index].tau);
                leaky[index] = terms[index] + cells[index].parts.past.leak(from, products[index]);
            }
            before = now;
            sum = dispatch!(Level::new(), simd => {
                array.summers[0].run(simd, &mut partial(&leaky), 1, &mut summer)[0][0]
            });
        }
        if sample >= 0 {
            out.push(sum * height + datum + trim - generator.datum);
        }
    }
    out
}

/// Output of a D/A at `sample` from its output a sample before: the step is divided where a word changes.
fn converted(mut output: f64, words: &[Word], sample: i64, [from, to]: [f64; 2], tau: f64) -> f64 {
    let signal = |share: f64| from + share * (to - from);
    let start = (sample - 1) as f64;
    let mut held = words.partition_point(|word| word.0 <= start) - 1;
    let mut at = 0.0;
    while let Some(&(time, _, pulse)) = words.get(held + 1).filter(|word| word.0 <= sample as f64) {
        let share = time - start;
        let lag = LagStep::<f64>::new(STEP * (share - at), tau);
        output = lag.step(output, signal(at) * words[held].1, signal(share) * words[held].1);
        output += if tau > 0.0 { pulse * signal(share) / tau } else { 0.0 };
        (at, held) = (share, held + 1);
    }
    let lag = LagStep::<f64>::new(STEP * (1.0 - at), tau);
    lag.step(output, signal(at) * words[held].1, to * words[held].1)
}

/// The same, but that D/As of one array have the same speed, switch together and leak nothing.
fn with_alike(change: impl FnOnce(&mut AnalogParts)) -> AnalogParts {
    of_1970(|parts| {
        parts.spread = false;
        (parts.multiplying_dac.glitch, parts.multiplying_dac.feedthrough) = (0.0, 0.0);
        change(parts);
    })
}

/// Multipliers that are slow, and have no other fault.
fn as_products(parts: &mut AnalogParts) {
    parts.multiplier = MultiplierParts { bandwidth: parts.multiplier.bandwidth, ..MultiplierParts::IDEAL };
}

#[test]
fn the_array_is_its_parts_one_by_one() {
    let scene = Scene::new();
    let apart = [Some(6), Some(5), None].map(|inputs| of_1970(|parts| parts.summer_inputs = inputs));
    let alike = [Some(6), Some(12), None].map(|inputs| with_alike(|parts| parts.summer_inputs = inputs));
    let made = [&apart[..], &alike, &[with_alike(as_products)]].concat();
    for (number, made) in made.iter().enumerate() {
        let array = PartsArray::new(STEP, &scene.level, made, 3, "tg");
        assert_eq!(array.grid.alike.is_some(), number >= apart.len());
        let mut profile = Profile::default();
        profile.resize(scene.ranges.len());
        let state = &mut ArrayState::default();
        let generator = scene.generator();
        array.trace(&generator, &scene.programs, 0..scene.ranges.len(), 0, state, &mut profile, &mut ());
        for lane in [0, 3, LANES - 1] {
            let plain = heights(&array, &scene, lane);
            let last = scene.ranges.partition_point(|&range| range <= scene.programs[lane].end_range);
            for sample in 0..last {
                let found = profile.height[sample][lane];
                assert!(
                    (found - plain[sample]).abs() < 1e-10 * array.scale.height,
                    "{number}, lane {lane}, sample {sample}: {found}, {}",
                    plain[sample]
                );
            }
        }
    }
}

#[test]
fn vectors_of_any_width_have_the_same_bits() {
    fn traced<S: Real>(scene: &Scene, made: &AnalogParts, vectors: Option<Level>) -> Profile<S> {
        let mut array = PartsArray::<S>::new(STEP, &scene.level, made, 3, "tg");
        array.vectors = vectors.unwrap_or(array.vectors);
        let (mut profile, state) = (Profile::default(), &mut ArrayState::default());
        profile.resize(scene.ranges.len());
        let span = 0..scene.ranges.len();
        array.trace(&scene.generator(), &scene.programs, span, 40, state, &mut profile, &mut ());
        profile
    }
    fn compare<S: Real>(scene: &Scene, made: &AnalogParts) {
        let [narrow, wide] = [Some(Level::baseline()), None].map(|vectors| traced::<S>(scene, made, vectors));
        assert_eq!(narrow.height, wide.height);
        assert_eq!(narrow.along, wide.along);
        assert_eq!(narrow.across, wide.across);
    }
    let scene = Scene::new();
    let noisy = |parts: &mut AnalogParts| parts.amplifier.noise = 5e-4;
    for made in [of_1970(noisy), with_alike(noisy), with_alike(as_products)] {
        compare::<f32>(&scene, &made);
        compare::<f64>(&scene, &made);
    }
}

/// Who looks at every sample: they go through the array one by one.
struct Watcher;

impl Tap<f32> for Watcher {
    const WIRES: bool = false;
    fn see(&mut self, _: &PartsArray<f32>, _: &ArrayState<f32>) {}
}

#[test]
fn samples_one_by_one_have_the_bits_of_blocks() {
    let scene = Scene::new();
    // Amplifiers that slew and clip, words that take long and apart from one another.
    let hurried = |parts: &mut AnalogParts| {
        (parts.amplifier.slew, parts.amplifier.saturation) = (Some(20e6), Some(6.0));
        (parts.amplifier.noise, parts.multiplying_dac.switching) = (5e-4, 200e-9);
    };
    let (generator, samples) = (scene.generator(), scene.ranges.len());
    let made = [of_1970(hurried), with_alike(hurried)];
    for (made, from) in made.iter().flat_map(|made| [(made, 0), (made, 501)]) {
        let array = PartsArray::<f32>::new(STEP, &scene.level, made, 3, "tg");
        let [mut blocks, mut alone] = [Profile::default(), Profile::default()];
        for profile in [&mut blocks, &mut alone] {
            profile.resize(samples);
        }
        let state = &mut ArrayState::default();
        array.trace(&generator, &scene.programs, from..samples, 40, state, &mut blocks, &mut ());
        array.trace(&generator, &scene.programs, from..samples, 40, state, &mut alone, &mut Watcher);
        assert_eq!(blocks.height, alone.height);
        assert_eq!(blocks.along, alone.along);
        assert_eq!(blocks.across, alone.across);
    }
}

/// An array that starts late has forgotten that it was at rest: its samples are those of a whole sweep.
#[test]
fn a_late_start_leaves_no_trace() {
    let scene = Scene::new();
    for made in [of_1970(|_| ()), with_alike(as_products)] {
        leaves_no_trace(&scene, &PartsArray::new(STEP, &scene.level, &made, 3, "tg"));
    }
}

fn leaves_no_trace(scene: &Scene, array: &PartsArray<f64>) {
    assert!((50..300).contains(&array.warm_up), "{}", array.warm_up);
    let generator = scene.generator();
    let traced = |from: usize| {
        let (mut profile, state) = (Profile::default(), &mut ArrayState::default());
        profile.resize(scene.ranges.len());
        array.trace(&generator, &scene.programs, from..scene.ranges.len(), 0, state, &mut profile, &mut ());
        profile
    };
    let whole = traced(0);
    for from in [1, 400, 401, 733, 999] {
        let late = traced(from);
        for sample in from..scene.ranges.len() {
            for lane in 0..LANES {
                let off = (late.height[sample][lane] - whole.height[sample][lane]).abs();
                assert!(off < 1e-12 * array.scale.height, "from {from}, {sample}, {lane}: {off}");
            }
        }
        assert_eq!(late.height[from - 1], Lanes::default(), "nothing else is touched");
    }
}
