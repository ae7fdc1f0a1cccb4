//! The inner wires: what the colours add is the height, of the algebra and of the array of parts.

use hardware_model::AnalogParts;
use signal::LANES;

use super::{DATUM, SIZE, STEP, Scene, level};
use crate::of_parts::{ArrayState, PartsArray, PartsTerrain};
use crate::programs::program;
use crate::{Inside, OUT_OF_SIGHT, Profile, TerrainGenerator};

/// What the four colours add to the height at a sample.
fn sum(inside: &Inside, sample: usize) -> f64 {
    inside.colours.iter().map(|share| share[sample]).sum()
}

#[test]
fn shares_of_the_colours_are_the_height() {
    let scene = Scene::new();
    let profile = scene.ideal();
    for lane in 0..LANES {
        let inside = scene.generator().inside(&scene.programs[lane]);
        assert_eq!(inside.colours[3].len(), 1000);
        for sample in 0..1000 {
            let height = profile.height[sample][lane] + DATUM;
            assert!((sum(&inside, sample) - height).abs() < 1e-11, "lane {lane}, sample {sample}");
            // What g0 of X has not, g0 of 1 - X has.
            for [near, far] in [[0, 1], [2, 3]] {
                let both = inside.functions[near][0][sample] + inside.functions[far][0][sample];
                assert!((both - 1.0).abs() < 1e-14, "lane {lane}, sample {sample}: {both}");
            }
        }
    }
}

#[test]
fn an_array_of_ideal_parts_has_the_same_wires() {
    let scene = Scene::new();
    let array = PartsArray::<f64>::new(STEP, &scene.level, &AnalogParts::ideal(), 3, "tg");
    let mut state = ArrayState::default();
    for lane in [0, 5] {
        let mut wired = PartsTerrain { array: &array, state: &mut state, address: 0 };
        let found = wired.inside(&scene.generator(), &scene.programs, lane);
        let algebra = scene.generator().inside(&scene.programs[lane]);
        // The array works above the middle of the stored heights: one number for a level.
        let middle = sum(&algebra, 0) - sum(&found, 0);
        for sample in 0..1000 {
            let apart = sum(&algebra, sample) - sum(&found, sample) - middle;
            assert!(apart.abs() < 1e-9, "lane {lane}, sample {sample}: {apart}");
            for (of_parts, of_law) in found.functions.iter().flatten().zip(algebra.functions.iter().flatten())
            {
                assert!((of_parts[sample] - of_law[sample]).abs() < 1e-9, "lane {lane}, sample {sample}");
            }
        }
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
