//! The inner wires: what the colours add is the height, of the algebra and of the array of parts.

use hardware_model::{AnalogParts, SweepParts};
use signal::LANES;

use super::{DATUM, SIZE, STEP, Scene, level};
use crate::of_parts::{ArrayState, PartsArray, PartsTerrain, Scale};
use crate::programs::program;
use crate::terms::{TERMS, word_of};
use crate::{FINE, InnerWire, Inside, OUT_OF_SIGHT, Profile, TerrainGenerator, held_words};

/// Value of a wire at a sample.
fn at(inside: &Inside, wire: InnerWire, sample: usize) -> f64 {
    let place = FINE.wires.iter().position(|(known, _)| *known == wire).unwrap();
    inside[place][sample]
}

/// What the four colours add to the height at a sample.
fn sum(inside: &Inside, sample: usize) -> f64 {
    (0..4).map(|colour| at(inside, InnerWire::Colour(colour), sample)).sum()
}

fn every_wire() -> Vec<InnerWire> {
    FINE.wires.iter().map(|(wire, _)| *wire).collect()
}

#[test]
fn what_the_wires_of_the_algebra_carry_is_the_ground() {
    let (scene, wires) = (Scene::new(), every_wire());
    let profile = scene.ideal();
    for lane in 0..LANES {
        let inside = scene.generator().inside::<f64>(&scene.programs, lane, &wires);
        let direction = scene.programs[lane].start.direction;
        assert!(inside.iter().all(|values| values.len() == 1000));
        for sample in 0..1000 {
            let height = profile.height[sample][lane] + DATUM;
            assert!((sum(&inside, sample) - height).abs() < 1e-11, "lane {lane}, sample {sample}");
            assert_eq!(at(&inside, InnerWire::Sum(0), sample), height);
            let [along, across] = [profile.along[sample][lane], profile.across[sample][lane]];
            let north = direction[0] * along - direction[1] * across;
            let east = direction[1] * along + direction[0] * across;
            for (slope, expected) in [(1, north), (2, east)] {
                let terms = (0..TERMS).map(|term| InnerWire::Converter { sum: slope, term });
                let met: f64 = terms.map(|wire| at(&inside, wire, sample)).sum();
                let told = at(&inside, InnerWire::Sum(slope), sample);
                assert!((met - expected).abs() < 1e-12, "lane {lane}, sample {sample}: {met}, {expected}");
                assert!((told - expected).abs() < 1e-15, "lane {lane}, sample {sample}: {told}, {expected}");
            }
            // What g0 of X has not, g0 of 1 - X has; and its slope is the other's.
            for near in [0, 2] {
                let of = |fed| {
                    [
                        at(&inside, InnerWire::Function { fed, order: 0 }, sample),
                        at(&inside, InnerWire::Derivative { fed, order: 0 }, sample),
                    ]
                };
                let [near, far] = [of(near), of(near + 1)];
                assert!((near[0] + far[0] - 1.0).abs() < 1e-14, "lane {lane}, sample {sample}");
                assert!((near[1] - far[1]).abs() < 1e-13, "lane {lane}, sample {sample}");
            }
        }
    }
}

/// Words of the hold registers, through the products, are what the D/As put out.
#[test]
fn a_word_times_its_product_is_what_its_converter_sends() {
    let (scene, wires) = (Scene::new(), every_wire());
    let generator = scene.generator();
    let inside = generator.inside::<f64>(&scene.programs, 3, &wires);
    let held = held_words(&scene.programs[3], generator.buffer);
    assert!(held.len() > 5 && held.is_sorted_by(|a, b| a.0 <= b.0));
    for sample in 0..1000 {
        let [.., (_, words)] = &held[..held.partition_point(|(time, _)| *time <= sample as f64).max(1)]
        else {
            panic!("nothing is held");
        };
        for term in 0..TERMS {
            let [colour, word] = word_of(term);
            let product = at(&inside, InnerWire::Product { sum: 0, term }, sample);
            let sent = at(&inside, InnerWire::Converter { sum: 0, term }, sample);
            assert_eq!(product * words[colour][word], sent, "sample {sample}, term {term}");
        }
    }
}

#[test]
fn an_array_of_ideal_parts_has_the_same_wires() {
    let (scene, wires) = (Scene::new(), every_wire());
    let array = PartsArray::<f64>::new(STEP, &scene.level, &AnalogParts::ideal(), 3, "tg");
    let mut state = ArrayState::default();
    for lane in [0, 5] {
        let mut of_parts = PartsTerrain { array: &array, state: &mut state, address: 0 };
        let found = of_parts.inside(&scene.generator(), &scene.programs, lane, &wires);
        let algebra = scene.generator().inside::<f64>(&scene.programs, lane, &wires);
        // The array works above the middle of the stored heights: the D/As of the first words have that much less.
        let datum = Scale::of(&scene.level).datum;
        for sample in 0..1000 {
            for (place, wire) in wires.iter().enumerate() {
                let middle = match wire {
                    InnerWire::Converter { sum, term } if word_of(*term)[1] == 0 => {
                        let product = at(&algebra, InnerWire::Product { sum: *sum, term: *term }, sample);
                        datum * product * if *sum == 0 { 1.0 } else { 1.0 / SIZE }
                    }
                    InnerWire::Colour(colour) => {
                        let products = (0..TERMS).filter(|&term| word_of(term) == [*colour, 0]);
                        let product = |term| at(&algebra, InnerWire::Product { sum: 0, term }, sample);
                        datum * products.map(product).sum::<f64>()
                    }
                    _ => 0.0,
                };
                let apart = found[place][sample] + middle - algebra[place][sample];
                assert!(apart.abs() < 1e-9, "{wire:?}, lane {lane}, sample {sample}: {apart}");
            }
        }
    }
}

/// Ramps lag behind their accumulators, which run ahead of the beam; each is what its parts make of the one before.
#[test]
fn a_smoother_stands_between_accumulator_and_ramp() {
    let scene = Scene::new();
    let parts = AnalogParts {
        sweep: SweepParts { smoother: 300e-9, ..AnalogParts::ideal().sweep },
        ..AnalogParts::ideal()
    };
    let array = PartsArray::<f64>::new(STEP, &scene.level, &parts, 3, "tg");
    let mut state = ArrayState::default();
    let mut of_parts = PartsTerrain { array: &array, state: &mut state, address: 0 };
    let wires = [InnerWire::Accumulator(0), InnerWire::Ramp(0)];
    let inside = of_parts.inside(&scene.generator(), &scene.programs, 2, &wires);
    let ideal = &scene.generator().inside::<f64>(&scene.programs, 2, &wires)[0];
    let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    // Between folds the ramp is where the beam is, and the accumulator is ahead of it by the delay.
    let (late, ahead) = (apart(&inside[1], ideal), apart(&inside[0], ideal));
    assert!(late > 1e-4 && ahead > 1e-3, "{late}, {ahead}");
    let peak = inside[1].iter().copied().fold(0.0, f64::max);
    assert!(peak < 1.0, "a smoothed triangle does not reach its stop: {peak}");
}

/// A D/A of few bits takes whole numbers alone, and its register holds no other.
#[test]
fn registers_hold_numbers_of_their_converters() {
    let scene = Scene::new();
    let mut parts = AnalogParts::ideal();
    parts.multiplying_dac.bits = Some(6);
    let coarse = PartsArray::<f64>::new(STEP, &scene.level, &parts, 3, "tg");
    let exact = PartsArray::<f64>::new(STEP, &scene.level, &AnalogParts::ideal(), 3, "tg");
    let words = &scene.level.words()[7];
    assert_eq!(exact.as_held(words), *words);
    let held = coarse.as_held(words);
    assert_ne!(held, *words);
    let scale = Scale::of(&scene.level);
    for (number, word) in held.iter().enumerate() {
        let steps = scale.share(&held, number) * 32.0;
        assert!((steps - steps.round()).abs() < 1e-9, "word {number}: {word} is {steps} steps");
    }
}

/// However few samples a region has: a constant for one, a straight line for two, a polynomial for more.
#[test]
fn stretches_of_any_number_of_samples_are_the_ground() {
    let (level, eye) = (level(), [310.0, 290.0]);
    let direction = [0.8, 0.6];
    for spacing in [11.0, 47.0, 83.0, 130.0, 310.0] {
        let ranges: Vec<f64> = (1..=(1500.0 / spacing) as usize).map(|k| k as f64 * spacing).collect();
        let programs = std::array::from_fn(|_| program(&level, eye, direction, &ranges));
        let generator =
            TerrainGenerator { buffer: level.words(), region_size: SIZE, ranges: &ranges, datum: DATUM };
        let mut profile = Profile::<f64>::default();
        generator.run(&programs, &Scene::new().light, &mut profile);
        for (sample, range) in ranges.iter().enumerate() {
            let [x, y] = [0, 1].map(|axis| eye[axis] + direction[axis] * range);
            let (region, place) = level.locate(x, y).unwrap();
            let [height, u, v] = level.height_and_slopes(region, place);
            let along = (u * direction[0] + v * direction[1]) / SIZE;
            let across = (v * direction[0] - u * direction[1]) / SIZE;
            let expected = [height - DATUM, along, across];
            let found = profile.ground(sample).map(|lanes| lanes[4]);
            for (found, expected) in found.into_iter().zip(expected) {
                assert!(
                    (found - expected).abs() < 1e-10,
                    "every {spacing} m, at {range} m: {found}, {expected}"
                );
            }
        }
    }
}

#[test]
fn beyond_the_stored_ground_nothing_is_in_sight() {
    let mut scene = Scene::new();
    let direction = [0.8, 0.6];
    // The edge of the level stands 2200 m north: 250 m of x are 312.5 m of way.
    scene.programs =
        std::array::from_fn(|_| program(&scene.level, [1950.0, 290.0], direction, &scene.ranges));
    assert!((scene.programs[0].end_range - 312.5).abs() < 1e-9);
    let edge = scene.ranges.partition_point(|&range| range <= 312.5);
    for profile in [scene.ideal(), scene.wired(&AnalogParts::ideal())] {
        for sample in 0..1000 {
            let [height, along, across] = profile.ground(sample).map(|lanes| lanes[2]);
            assert_eq!(height == OUT_OF_SIGHT, sample >= edge, "sample {sample}: {height}");
            assert!(sample < edge || (along, across) == (0.0, 0.0));
        }
    }
}
