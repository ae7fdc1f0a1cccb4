use hardware_model::AnalogParts;
use landscape::{CornerWords, GroupLight, Level, Photometry, Sun, SweepLight};
use quantities::unit_interval;
use signal::LANES;
use sweep_program::SweepProgram;

mod inside;
mod plain;
mod when;

use super::{ArrayState, PartsArray, PartsTerrain};
use crate::programs::program;
use crate::terms::{TERMS, word_of};
use crate::{OUT_OF_SIGHT, Profile, TerrainGenerator};

const SIZE: f64 = 200.0;
const STEP: f64 = 50e-9;
const DATUM: f64 = 7.0;

fn level() -> Level {
    let word = |index: usize, k: usize| 20.0 * (2.0 * unit_interval(4, &[index as u64, k as u64]) - 1.0);
    let words = (0..144).map(|index| std::array::from_fn(|k| word(index, k))).collect();
    Level::new(SIZE, [0.0; 2], [12, 12], words).unwrap()
}

struct Scene {
    level: Level,
    ranges: Vec<f64>,
    programs: [SweepProgram; LANES],
    light: [SweepLight; LANES],
}

impl Scene {
    fn new() -> Self {
        Self::beginning_at(1.5)
    }

    /// Sweeps of 1000 samples, 1.5 m apart, from this range (m).
    fn beginning_at(first: f64) -> Self {
        let level = level();
        let ranges: Vec<f64> = (0..1000).map(|k| first + f64::from(k) * 1.5).collect();
        let direction = |lane: usize| {
            let (sin, cos) = quantities::sin_cos(0.2 + 0.17 * lane as f64);
            [cos, sin]
        };
        let mut programs =
            std::array::from_fn(|lane| program(&level, [310.0, 290.0], direction(lane), &ranges));
        for program in &mut programs {
            // Instants as the sweep generator gives them: between samples.
            for step in &mut program.steps {
                step.time.0 = (step.range - first) / 1.5;
            }
        }
        let sun = Sun { azimuth: 1.0, elevation: 0.3 };
        let light =
            std::array::from_fn(|lane| SweepLight::new(&sun, 1.0, Photometry::Lambert, direction(lane)));
        Self { level, ranges, programs, light }
    }

    fn generator(&self) -> TerrainGenerator<'_> {
        TerrainGenerator { buffer: self.level.words(), region_size: SIZE, ranges: &self.ranges, datum: DATUM }
    }

    fn ideal(&self) -> Profile<f64> {
        let mut profile = Profile::default();
        self.generator().run(&self.programs, &self.light, &mut profile);
        profile
    }

    fn wired(&self, parts: &AnalogParts) -> Profile<f64> {
        let array = PartsArray::new(STEP, &self.level, parts, 3, "tg");
        let mut profile = Profile::default();
        let mut wired = PartsTerrain { array: &array, state: &mut ArrayState::default(), address: 0 };
        self.generator().trace_by(&mut wired, &self.programs, &mut profile);
        self.generator().reflect(&GroupLight::new(&self.light), 0..self.ranges.len(), &mut profile);
        profile
    }
}

/// What D/A `index` multiplies by for these words.
fn weight(array: &PartsArray<f64>, words: &CornerWords, index: usize) -> f64 {
    array.number(words, word_of(index % TERMS)[1]).1 * array.factors[index]
}

/// Largest differences of height and slopes where both are in sight.
fn apart(a: &Profile<f64>, b: &Profile<f64>) -> [f64; 3] {
    let mut most = [0.0_f64; 3];
    for sample in 0..a.height.len() {
        let pairs = a.ground(sample).into_iter().zip(b.ground(sample));
        for (most, (a, b)) in most.iter_mut().zip(pairs) {
            for lane in 0..LANES {
                *most = most.max((a[lane] - b[lane]).abs());
            }
        }
    }
    most
}

#[test]
fn ideal_parts_are_the_algebra() {
    let scene = Scene::new();
    let (ideal, wired) = (scene.ideal(), scene.wired(&AnalogParts::ideal()));
    let [height, along, across] = apart(&ideal, &wired);
    assert!(height < 1e-10 && along < 1e-11 && across < 1e-11, "{height} {along} {across}");
    assert!(wired.height[999][7] == OUT_OF_SIGHT || scene.programs[7].end_range >= 1500.0);
}

#[test]
fn fast_parts_come_near_the_algebra() {
    let scene = Scene::new();
    let ideal = scene.ideal();
    let with_bandwidth = |bandwidth: f64| {
        let mut parts = AnalogParts::ideal();
        parts.function_generator.bandwidth = Some(bandwidth);
        parts.multiplier.bandwidth = Some(bandwidth);
        parts.multiplying_dac.bandwidth = Some(bandwidth);
        parts.amplifier.gain_bandwidth = Some(7.0 * bandwidth);
        parts.summer_inputs = Some(6);
        apart(&ideal, &scene.wired(&parts))[0]
    };
    let [slow, fast, faster] = [4e6, 40e6, 400e6].map(with_bandwidth);
    // The delay is trimmed out. What is left is the shortfall at folds, of first order in the lag of the function
    // generators that turn there, and that of ramps which set out from rest at the first range.
    assert!(slow > 2.5 * fast && fast > 6.0 * faster && slow < 0.12, "{slow} {fast} {faster}");
}

/// A sweep begins in the middle of the ground. A preset array has settled there; one without is still on its way from the foot.
#[test]
fn a_preset_array_has_settled_at_the_first_range() {
    let scene = Scene::beginning_at(450.0);
    let first = |preset: bool| {
        let wired = scene.wired(&parts(|parts| {
            parts.sweep.preset = preset;
            parts.function_generator.bandwidth = Some(4e6);
            parts.multiplying_dac.bandwidth = Some(4e6);
        }));
        (0..LANES).map(|lane| error_of(&scene, &wired, lane)[0].abs()).fold(0.0, f64::max)
    };
    let [preset, jumps] = [true, false].map(first);
    assert!(jumps > 0.5 && preset < 0.1 * jumps, "{preset} m with the preset, {jumps} m without");
}

/// Strobes that come late are of the folds of the sweep: those before its first range have acted in retrace.
#[test]
fn a_preset_array_has_the_words_of_the_first_range() {
    let scene = Scene::beginning_at(450.0);
    let wired = scene.wired(&parts(|parts| parts.sweep.strobe_offset = 100.0 * STEP));
    for lane in 0..LANES {
        let error = error_of(&scene, &wired, lane);
        assert!(error[0].abs() < 1e-9, "lane {lane}: {} m", error[0]);
        assert!(error.iter().any(|error| error.abs() > 1.0), "lane {lane}: late strobes do harm");
    }
}

fn parts(change: impl FnOnce(&mut AnalogParts)) -> AnalogParts {
    let mut parts = AnalogParts::ideal();
    change(&mut parts);
    parts
}

/// Height error of a lane against the algebra (m).
fn error_of(scene: &Scene, wired: &Profile<f64>, lane: usize) -> Vec<f64> {
    let ideal = scene.ideal();
    let last = scene.ranges.partition_point(|&range| range <= scene.programs[lane].end_range);
    (0..last).map(|sample| wired.height[sample][lane] - ideal.height[sample][lane]).collect()
}

/// Artefact 12: an error of at most half a step of each word times its basis function, which halves with each bit.
#[test]
fn coarse_words_err_by_half_a_step() {
    let scene = Scene::new();
    let scale = super::Scale::of(&scene.level);
    let largest = |bits: u32| {
        let wired = scene.wired(&parts(|parts| parts.multiplying_dac.bits = Some(bits)));
        (0..LANES).flat_map(|lane| error_of(&scene, &wired, lane)).fold(0.0, |most: f64, e| most.max(e.abs()))
    };
    let errors = [6, 8, 10, 12].map(largest);
    for (bits, error) in [6, 8, 10, 12].into_iter().zip(errors) {
        // Four corners, nine words each, and the foot that the datum is trimmed to.
        let half_a_step = scale.height / f64::from(1 << bits);
        assert!(error > half_a_step && error < 12.0 * half_a_step, "{bits}: {error}, {half_a_step}");
    }
    assert!(errors.windows(2).all(|pair| pair[0] / pair[1] > 2.0 && pair[0] / pair[1] < 8.0), "{errors:?}");
}

/// Artefact 10: gains of the D/As differ by colour, and colours come round every two regions. The error is continuous
/// where regions meet, for a corner stays in its own converters.
#[test]
fn unequal_gains_are_quilted_with_two_regions() {
    let mut scene = Scene::new();
    let flat = vec![[100.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]; 144];
    let mut tilted = flat;
    tilted[0][0] = -100.0;
    scene.level = Level::new(SIZE, [0.0; 2], [12, 12], tilted).unwrap();
    let wired = scene.wired(&parts(|parts| parts.multiplying_dac.gain_error = 0.02));
    let error = error_of(&scene, &wired, 0);
    let steps = error.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    assert!(steps.fold(0.0, f64::max) < 0.2, "an error of gain has no steps");
    // Along the direction of lane 0 the pattern comes again after two regions north.
    let [cos, _] = scene.programs[0].start.direction;
    let period = 2.0 * SIZE / cos / 1.5;
    let power = |samples: f64| {
        let angle = |k: usize| 2.0 * std::f64::consts::PI * k as f64 / samples;
        let sum =
            |wave: fn(f64) -> f64| error.iter().enumerate().map(|(k, e)| e * wave(angle(k))).sum::<f64>();
        let [c, s] = [sum(libm::cos), sum(libm::sin)];
        c * c + s * s
    };
    let others = [0.37, 0.63, 0.8, 1.31, 1.7].map(|share| power(period * share));
    assert!(others.iter().all(|&other| power(period) > 1.5 * other), "{} of {others:?}", power(period));
}

/// Artefact 25: a sum beyond what its amplifier gives is flat.
#[test]
fn high_ground_is_clipped() {
    let scene = Scene::new();
    let scale = super::Scale::of(&scene.level);
    let clipped = parts(|parts| {
        parts.amplifier.saturation = Some(0.25);
        parts.summer_inputs = None;
    });
    let (ideal, wired) = (scene.ideal(), scene.wired(&clipped));
    let mut clips = 0;
    for lane in 0..LANES {
        let last = scene.ranges.partition_point(|&range| range <= scene.programs[lane].end_range);
        let trim = wired.height[0][lane] - ideal.height[0][lane];
        for sample in 0..last {
            let (right, found) = (
                ideal.height[sample][lane] + DATUM - scale.datum,
                wired.height[sample][lane] + DATUM - scale.datum - trim,
            );
            assert!(found <= 0.2501 * scale.height && found >= -0.2501 * scale.height, "{found}");
            clips += usize::from(right.abs() > 0.26 * scale.height);
        }
    }
    assert!(clips > 500, "{clips}");
}

/// Artefact 7: no wire is faster than its amplifier.
#[test]
fn slow_amplifiers_limit_the_slope() {
    let scene = Scene::new();
    let scale = super::Scale::of(&scene.level);
    // A fiftieth of full scale a microsecond.
    let wired = scene.wired(&parts(|parts| parts.amplifier.slew = Some(2e4)));
    let most = 2e4 * STEP * scale.height * (1.0 + 1e-9);
    let mut steepest = 0.0_f64;
    for lane in 0..LANES {
        let last = scene.ranges.partition_point(|&range| range <= scene.programs[lane].end_range);
        for sample in 1..last {
            steepest = steepest.max((wired.height[sample][lane] - wired.height[sample - 1][lane]).abs());
        }
    }
    assert!(steepest <= most && steepest > 0.99 * most, "{steepest} of {most}");
}

/// Artefact 11: a broken line of n segments bends n times a region.
#[test]
fn broken_lines_err_by_their_segments() {
    let scene = Scene::new();
    let largest = |segments: u32| {
        let wired = scene.wired(&parts(|parts| parts.function_generator.segments = Some(segments)));
        (0..LANES).flat_map(|lane| error_of(&scene, &wired, lane)).fold(0.0, |most: f64, e| most.max(e.abs()))
    };
    let [coarse, fine] = [10, 20].map(largest);
    // Error of a segment goes with the square of its length.
    assert!(coarse / fine > 2.5 && coarse / fine < 6.0 && fine > 0.0, "{coarse} {fine}");
}

/// Artefact 9: a strobe beside its fold leaves a step at every crossing, the larger the farther beside it.
#[test]
fn strobes_beside_their_folds_leave_fringes() {
    let scene = Scene::new();
    let largest = |offset: f64| {
        let wired = scene.wired(&parts(|parts| parts.sweep.strobe_offset = offset));
        (0..LANES).flat_map(|lane| error_of(&scene, &wired, lane)).fold(0.0, |most: f64, e| most.max(e.abs()))
    };
    let errors = [0.0, 100e-9, 200e-9, 400e-9].map(largest);
    assert!(errors[0] < 1e-9 && errors.windows(2).all(|pair| pair[1] > 1.3 * pair[0]), "{errors:?}");
}

/// The parts beyond the matrix of artefacts: each leaves an error of its size, and the smaller the part's the smaller.
#[test]
fn errors_go_with_the_figures_of_their_parts() {
    let scene = Scene::new();
    let wired = |change: &dyn Fn(&mut AnalogParts)| {
        scene.wired(&parts(|parts| {
            parts.full_scale = 10.0;
            parts.sweep.dac_bits = Some(24);
            change(parts);
        }))
    };
    let clean = wired(&|_| {});
    let largest = |change: &dyn Fn(&mut AnalogParts)| apart(&wired(change), &clean)[0];
    let full_scale = super::Scale::of(&scene.level).height;
    let scale_error = [0.002, 0.004].map(|e| largest(&|parts| parts.multiplier.scale_error = e));
    let feedthrough = [0.005, 0.01].map(|e| largest(&|parts| parts.multiplier.feedthrough = e));
    let past_dacs = [0.003, 0.006].map(|e| largest(&|parts| parts.multiplying_dac.feedthrough = e));
    let bent_ramps = [0.0005, 0.001].map(|e| largest(&|parts| parts.sweep.nonlinearity = e));
    for [small, large] in [scale_error, feedthrough, past_dacs, bent_ramps] {
        assert!(small > 1e-6 * full_scale && small < 0.05 * full_scale, "{small} of {full_scale}");
        assert!((large / small - 2.0).abs() < 0.1, "{small} {large}");
    }
    // Rounded knees lie off a broken line by J V ln 2 at most, and J is 0.29 with twenty segments.
    let knees = [0.0, 0.05].map(|volts| {
        largest(&|parts| {
            parts.function_generator.segments = Some(20);
            parts.function_generator.rounding = volts;
        })
    });
    assert!(knees[1] != knees[0] && (knees[1] - knees[0]).abs() < 0.02 * full_scale, "{knees:?}");
}

/// A word that takes longer to act than the chain to come to it is late, like a strobe beside its fold.
#[test]
fn slow_words_are_strobes_beside_their_folds() {
    let scene = Scene::new();
    let tears = [200e-9, 400e-9].map(|seconds| {
        let wired = scene.wired(&parts(|parts| parts.multiplying_dac.switching = seconds));
        (0..LANES).flat_map(|lane| error_of(&scene, &wired, lane)).fold(0.0, |most: f64, e| most.max(e.abs()))
    });
    // Tears go with the third power of their lateness: 10 e^3 - 15 e^4 + 6 e^5.
    assert!(tears[0] > 1e-3 && (5.0..9.0).contains(&(tears[1] / tears[0])), "{tears:?}");
    let within = parts(|parts| {
        parts.multiplying_dac.switching = 20e-9;
        parts.multiplier.bandwidth = Some(5e6);
    });
    let trimmed = parts(|parts| parts.multiplier.bandwidth = Some(5e6));
    assert_eq!(apart(&scene.wired(&within), &scene.wired(&trimmed)), [0.0; 3], "the chain takes longer");
}

/// A25: the tail behind an overload has the recovery of its amplifiers.
#[test]
fn overload_takes_the_recovery_of_the_amplifier() {
    let scene = Scene::new();
    let clipped = |recovery: f64| {
        scene.wired(&parts(|parts| {
            parts.amplifier.saturation = Some(0.25);
            parts.amplifier.recovery = recovery;
            parts.summer_inputs = None;
        }))
    };
    let (plain, late) = (clipped(0.0), clipped(2e-6));
    let tails = (0..LANES)
        .flat_map(|lane| error_of(&scene, &late, lane).into_iter().zip(error_of(&scene, &plain, lane)));
    let longest = tails.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(longest > 0.01 * super::Scale::of(&scene.level).height, "{longest}");
}
