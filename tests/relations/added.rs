//! What is added and changes nothing: a crater without depth, regions cut in four, samples beyond the end, a whole turn.

use std::f64::consts::TAU;

use control_plane::MachineStage;
use features::{Crater, Shape};
use generator::{PlaneKind, Planes};
use hardware_model::{HardwareModel, Settings};
use landscape::{CornerWords, Level};
use lockstep::bounds;
use lunoid_tests::{ComparedScene, Drawn, level_of, random};
use machine::Prepare;
use scenario::{Pose, RangeLaw, Scalar};
use signal::Probe;

use crate::moved::{draw, dyadic};

const SEEDS: std::ops::Range<u64> = 4000..4012;

fn wave<'a>(drawn: &'a Drawn, sweep: u32, name: &str) -> &'a [f64] {
    let mut waves = drawn.waveforms.iter();
    let wave = waves.find(|wave| wave.sweep == sweep && wave.signal.name == name);
    &wave.unwrap_or_else(|| panic!("no {name} of sweep {sweep}")).values
}

/// Signals are the same to the bit. Its circle is a rim all the same, at which strokes are divided and curves end: a line
/// of broken ground is within 0.006 of the mean of its profile (sheet of the sweep memory), so where curves bend, lines
/// may be off.
#[test]
fn a_crater_without_depth() {
    let (mut met, mut largest) = (0, 0.0_f64);
    for seed in SEEDS {
        for scalar in [Scalar::F64, Scalar::F32] {
            let without = ComparedScene { scalar, ..dyadic(seed) };
            let far = 0.3 * without.range.end;
            let centre = [
                without.eye[0] + far * libm::cos(without.heading),
                without.eye[1] + far * libm::sin(without.heading),
            ];
            let crater = Crater::new(centre, Shape::RimmedBowl { r1: 0.3 * far, r2: 0.4 * far }, 0.0, 0.0);
            let with = ComparedScene { craters: vec![crater.unwrap()], ..without.clone() };
            let (without, with) = (draw(&without), draw(&with));
            met += with.counts["features"];
            for sweep in 0..9 {
                for name in ["tg.height", "mu.height", "mu.reflectivity", "dpp.elevation"] {
                    let [a, b] = [&without, &with].map(|drawn| wave(drawn, sweep, name));
                    let same = a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits());
                    assert!(same, "seed {seed}, {scalar:?}: {name} of sweep {sweep} differs");
                }
            }
            let worst = without.picture.iter().zip(&with.picture).map(|(a, b)| f64::from((a - b).abs()));
            largest = worst.fold(largest, f64::max);
        }
    }
    assert!(met > 100, "only {met} sweeps met the crater");
    // Largest found: 0.034.
    assert!(largest <= 0.05, "a pixel is off by {largest}");
}

/// Coefficients of g0p and g1p in ascending powers (5.2).
const BASIS: [[[f64; 6]; 3]; 2] = [
    [[1.0, 0.0, 0.0, -10.0, 15.0, -6.0], [0.0, 1.0, 0.0, -6.0, 8.0, -3.0], [0.0, 0.0, 0.5, -1.5, 1.5, -0.5]],
    [[0.0, 0.0, 0.0, 10.0, -15.0, 6.0], [0.0, 0.0, 0.0, -4.0, 7.0, -3.0], [0.0, 0.0, 0.0, 0.5, -1.0, 0.5]],
];

/// The derivative of order `order` of a basis function at `u`.
fn basis(side: usize, p: usize, order: usize, u: f64) -> f64 {
    let term = |k: usize| {
        let falling: f64 = (0..order).map(|i| k as f64 - i as f64).product();
        falling * BASIS[side][p][k] * (0..k - order).fold(1.0, |power, _| power * u)
    };
    (order..6).map(term).sum()
}

/// The same ground on regions half as long: each polynomial cut in four.
fn quartered(level: &Level) -> Level {
    let [north, east] = level.corners();
    let word = |m: usize, n: usize, p: usize, q: usize| {
        let (k, l) = ((m / 2).min(north - 2), (n / 2).min(east - 2));
        let (u, v) = (0.5 * m as f64 - k as f64, 0.5 * n as f64 - l as f64);
        let mut sum = 0.0;
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            for (a, b) in (0..9).map(|k| (k / 3, k % 3)) {
                let f = level.words()[(k + i) * east + l + j][3 * a + b];
                sum += basis(i, a, p, u) * basis(j, b, q, v) * f;
            }
        }
        sum * [1.0, 0.5, 0.25, 0.125, 0.0625][p + q]
    };
    let corner = |m: usize, n: usize| -> CornerWords { std::array::from_fn(|k| word(m, n, k / 3, k % 3)) };
    level_of(0.5 * level.region_size(), level.origin(), [2 * north - 1, 2 * east - 1], corner)
}

#[test]
fn regions_cut_in_four() {
    for seed in SEEDS {
        let whole = random::scene(seed);
        let cut = ComparedScene { level: quartered(&whole.level), ..whole.clone() };
        let (whole, cut) = (draw(&whole), draw(&cut));
        assert!(cut.counts["folds"] > whole.counts["folds"], "seed {seed}: no more folds than before");
        for sweep in 0..9 {
            for name in ["tg.height", "tg.slope.u", "tg.slope.v", "tg.reflectivity"] {
                let [a, b] = [&whole, &cut].map(|drawn| wave(drawn, sweep, name));
                let scale = a.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
                for (sample, (a, b)) in a.iter().zip(b).enumerate() {
                    let what = format!("seed {seed}: {name}, sweep {sweep}, sample {sample}: {a} and {b}");
                    assert!((a - b).abs() <= 1e-11 * scale, "{what}");
                }
            }
        }
    }
}

/// At a constant rate twice the samples to twice the range are the same places and as many beyond. To rounding: the
/// machine's polynomials are centred in the stretch between two events, and the end of a sweep is one. The last sample of
/// the short sweep has no neighbour to make a top with; a gate may follow rounding.
#[test]
fn samples_appended() {
    for seed in SEEDS {
        for scalar in [Scalar::F64, Scalar::F32] {
            let mut short = ComparedScene { scalar, ..dyadic(seed) };
            short.range.law = RangeLaw::ConstantRate;
            short.samples = 128;
            short.range.end *= 0.5;
            let mut long = short.clone();
            long.samples = 256;
            long.range.end *= 2.0;
            let (short, long) = (draw(&short), draw(&long));
            for wave in short.waveforms.iter().filter(|wave| wave.signal.axis == signal::Axis::Ground) {
                // A rate is a change in a microsecond, and half as many samples a sweep are half as fast.
                if wave.signal.name == "dpp.derivative" || wave.signal.unit == signal::Unit::Gate {
                    continue;
                }
                let mut waves = long.waveforms.iter();
                let after =
                    waves.find(|other| other.sweep == wave.sweep && other.signal == wave.signal).unwrap();
                let before = &wave.values[..wave.values.len() - 1];
                let scale = before.iter().fold(1.0_f64, |largest, value| largest.max(value.abs()));
                for (sample, (a, b)) in before.iter().zip(&after.values).enumerate() {
                    let what = format!("{} of sweep {}, sample {sample}", wave.signal.name, wave.sweep);
                    let allowed = scale * bounds::of(scalar);
                    assert!((a - b).abs() <= allowed, "seed {seed}, {scalar:?}: {what}: {a} and {b}");
                }
            }
        }
    }
}

/// A picture behind a yoke.
fn behind_a_yoke(scene: &ComparedScene, roll: f64, yoke: f64) -> Vec<f32> {
    let stage = scene.stage();
    let settings = Settings { yoke: Some(HardwareModel::ideal().yoke), ..stage.settings.clone() };
    let session = (MachineStage { settings, ..stage }).prepare();
    let mut planes = Planes::new(scene.sweeps as usize, scene.lines as usize, &[PlaneKind::Intensity]);
    let pose = scene.pose();
    let attitude = landscape::Attitude { roll, ..pose.attitude };
    session.frame(1, &Pose { yoke, attitude, ..pose }, &mut planes, &mut Probe::off()).unwrap();
    planes.get(PlaneKind::Intensity).unwrap().to_vec()
}

#[test]
fn a_whole_turn() {
    let mut lit = 0;
    for seed in SEEDS {
        let mut scene = random::scene(seed);
        (scene.sweeps, scene.pitch) = (48, 0.0);
        let level = behind_a_yoke(&scene, 0.1, 0.1);
        let turned = behind_a_yoke(&scene, 0.1 + TAU, 0.1 + TAU);
        let worst = level.iter().zip(&turned).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(worst <= 1e-4, "seed {seed}: a pixel is off by {worst}");
        lit += u32::from(level != behind_a_yoke(&scene, 0.0, 0.0));
    }
    assert!(lit >= 8, "only {lit} pictures show that they are turned");
}
