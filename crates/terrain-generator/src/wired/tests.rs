use hardware_model::AnalogParts;
use landscape::{Level, Photometry, Sun, SweepLight};
use quantities::unit_interval;
use signal::LANES;
use sweep_program::SweepProgram;

use super::{ArrayState, PartsArray, Wired};
use crate::programs::program;
use crate::{OUT_OF_SIGHT, Polynomials, Profile, TerrainGenerator};

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
        let level = level();
        let ranges: Vec<f64> = (1..=1000).map(|k| f64::from(k) * 1.5).collect();
        let direction = |lane: usize| {
            let (sin, cos) = quantities::sin_cos(0.2 + 0.17 * lane as f64);
            [cos, sin]
        };
        let mut programs =
            std::array::from_fn(|lane| program(&level, [310.0, 290.0], direction(lane), &ranges));
        for program in &mut programs {
            // Instants as the sweep generator gives them: between samples.
            for step in &mut program.steps {
                step.time.0 = step.range / 1.5 - 1.0;
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
        self.generator().run_by(&mut Polynomials, &self.programs, &self.light, &mut profile);
        profile
    }

    fn wired(&self, parts: &AnalogParts) -> Profile<f64> {
        let array = PartsArray::new(STEP, &self.level, parts, 3, "tg");
        let mut profile = Profile::default();
        let mut wired = Wired { array: &array, state: &mut ArrayState::default(), address: 0 };
        self.generator().run_by(&mut wired, &self.programs, &self.light, &mut profile);
        profile
    }
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
    // generators that turn there.
    assert!(slow > 5.0 * fast && fast > 6.0 * faster && slow < 0.1, "{slow} {fast} {faster}");
}
