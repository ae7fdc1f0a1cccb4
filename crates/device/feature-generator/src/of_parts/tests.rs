//! The chain against closed forms, and against an integrator that knows nothing of it.

use features::{Crater, Features, Shape};
use hardware_model::{AnalogParts, FeatureChainParts, FeatureParts, Organisation};
use parts::{GateEdge, time_constant};
use proptest::prelude::{prop_assert, prop_assert_eq, proptest};
use signal::{LANES, Lanes};

use super::sub_generator::Chain;
use super::{ChainScratch, PartsFeatures};
use crate::{FeatureGenerator, FeatureProfile, FeatureProgram, Schedule};

const H: f64 = 50e-9;
/// Range of a sample (m).
const STEP: f64 = 0.5;
const SAMPLES: usize = 1200;

/// What one lane puts out, and the same without faults.
struct Seen {
    ranges: Vec<f64>,
    made: FeatureProfile<f64>,
    ideal: FeatureProfile<f64>,
    lit: Vec<Lanes<f64>>,
    gates: Vec<GateEdge>,
}

fn see(craters: Vec<Crater>, azimuth: f64, generator: &PartsFeatures) -> Seen {
    let features = Features::new(craters);
    let ranges: Vec<f64> = (1..=SAMPLES).map(|k| STEP * k as f64).collect();
    let parts = FeatureParts { organisation: Organisation::Scheduled, sub_generators: None };
    let schedule = Schedule {
        features: &features,
        parts,
        region_origin: [-1000.0; 2],
        region_size: 300.0,
        among: None,
        absent: &[],
    };
    let direction = [libm::cos(azimuth), libm::sin(azimuth)];
    let mut program = FeatureProgram::default();
    schedule.write([0.0; 2], direction, [ranges[0], ranges[SAMPLES - 1]], &mut program);
    let programs: [FeatureProgram; LANES] = std::array::from_fn(|_| program.clone());
    let (mut made, mut ideal) = (FeatureProfile::default(), FeatureProfile::default());
    let mut scratch = ChainScratch::default();
    generator.run(&features, &ranges, &programs, &[direction; LANES], &mut scratch, &mut made);
    FeatureGenerator { ranges: &ranges }.run(&features, &programs, &mut ideal);
    let [_, _, gates, ..] = scratch.gates;
    Seen { ranges, made, ideal, lit: scratch.lit, gates }
}

fn bowl(centre: [f64; 2], r1: f64, depth: f64) -> Crater {
    Crater::new(centre, Shape::Bowl { r1 }, depth, 0.0).unwrap()
}

fn rimmed(centre: [f64; 2]) -> Crater {
    Crater::new(centre, Shape::RimmedBowl { r1: 20.0, r2: 30.0 }, 6.0, 1.5).unwrap()
}

fn lag(tau: f64) -> PartsFeatures {
    PartsFeatures::of(H, Chain::of(H, [0.0; 2], 0.0, 1.0, tau))
}

fn generator(error: f64, bandwidth: Option<f64>) -> PartsFeatures {
    let mut analog = AnalogParts::ideal();
    analog.feature = FeatureChainParts { error, bandwidth };
    PartsFeatures::new(
        H,
        &FeatureParts { organisation: Organisation::Scheduled, sub_generators: Some(6) },
        &analog,
        1970,
    )
}

#[test]
fn ideal_parts_are_the_law() {
    let craters = vec![rimmed([200.0, 4.0]), bowl([215.0, -3.0], 9.0, 2.0), bowl([400.0, 1.0], 40.0, 5.0)];
    let seen = see(craters, 0.02, &generator(0.0, None));
    for k in 0..SAMPLES {
        for (made, ideal) in [
            (&seen.made.height, &seen.ideal.height),
            (&seen.made.along, &seen.ideal.along),
            (&seen.made.across, &seen.ideal.across),
        ] {
            assert!((made[k][3] - ideal[k][3]).abs() < 1e-12, "{k}: {} {}", made[k][3], ideal[k][3]);
        }
        assert_eq!(seen.made.present[k], seen.ideal.present[k]);
        assert!(seen.lit[k][3] >= seen.made.present[k][3]);
    }
    assert_eq!(seen.made.kinks[3].len(), seen.ideal.kinks[3].len());
    for (made, ideal) in seen.made.kinks[3].iter().zip(&seen.ideal.kinks[3]) {
        assert_eq!((made.sample, made.share, made.present), (ideal.sample, ideal.share, ideal.present));
        assert!((made.height - ideal.height).abs() < 1e-12);
        for side in 0..2 {
            assert!((made.before[side] - ideal.before[side]).abs() < 1e-12);
            assert!((made.after[side] - ideal.after[side]).abs() < 1e-12);
        }
    }
}

/// A6 on a crater: away from the viewer by v tau, and the floor of a parabola raised by `c (v tau)^2 / 2`.
#[test]
fn a_bowl_lies_farther_by_v_tau() {
    let (r1, depth, middle) = (60.0, 8.0, 300.0);
    let curvature = 2.0 * depth / (r1 * r1);
    for tau in [32e-9, 100e-9, 400e-9] {
        let seen = see(vec![bowl([middle, 0.0], r1, depth)], 0.0, &lag(tau));
        let (v, late) = (STEP / H, STEP / H * tau);
        // Transients of the near rim are over 15 time constants behind it.
        let first = seen.ranges.partition_point(|&z| z < middle - r1 + 15.0 * v * tau);
        let last = seen.ranges.partition_point(|&z| z < middle + r1);
        assert!(last > first + 20);
        for k in first..last {
            let place = seen.ranges[k] - late - middle;
            // Chords of the samples lie a twelfth of c h^2 above the parabola, on average.
            let expected = depth * (place * place / (r1 * r1) - 1.0) + curvature * late * late / 2.0;
            let found = seen.made.height[k][0];
            assert!(
                (found - expected).abs() < curvature * STEP * STEP / 8.0,
                "{tau} {k}: {found} {expected}"
            );
            let slope = curvature * place;
            let found = seen.made.along[k][0];
            assert!(
                (found - slope).abs() < 1e-6,
                "{found} {slope}: a straight line is late and nothing else"
            );
        }
        assert_eq!(seen.made.present, seen.ideal.present, "the gate is the comparator's");
    }
}

/// Behind the rim the tail of a lag, from the very instant at which the sweep crosses it.
#[test]
fn behind_the_footprint_it_decays() {
    let (r1, depth, middle, tau) = (50.3, 8.0, 300.0, 200e-9);
    let seen = see(vec![bowl([middle, 0.0], r1, depth)], 0.0, &lag(tau));
    let exit = &seen.made.kinks[0][1];
    assert!((exit.range - middle - r1).abs() < 1e-9 && exit.before == exit.after, "rims are soft");
    for k in exit.sample..exit.sample + 60 {
        let behind = (seen.ranges[k] - exit.range) / STEP * H;
        let expected = exit.height * libm::exp(-behind / tau);
        assert!((seen.made.height[k][0] - expected).abs() < 1e-12, "{k}");
        assert!(seen.lit[k][0] == 1.0 && seen.made.present[k][0] == 0.0);
    }
    assert_eq!(seen.lit[exit.sample + 200][0], 0.0, "it comes to rest");
}

proptest! {
    /// Against small steps of the differential equation with the law itself at its right side.
    #[test]
    fn as_an_integrator_has_it(
        place in 80.0..120.0_f64, beside in -25.0..25.0_f64, tau in 10e-9..500e-9_f64,
    ) {
        let crater = rimmed([place, beside]);
        let seen = see(vec![crater], 0.0, &lag(tau));
        let law = |time: f64| {
            let z = STEP + STEP * time / H;
            let offset = z - place;
            crater.profile((offset * offset + beside * beside).sqrt())[0]
        };
        let (mut y, mut t, fine) = (law(0.0), 0.0, H / 400.0);
        for k in 1..400_usize {
            for _ in 0..400 {
                // Implicit midpoint: it knows no exponentials.
                y = (y * (1.0 - 0.5 * fine / tau) + law(t + 0.5 * fine) * fine / tau) / (1.0 + 0.5 * fine / tau);
                t += fine;
            }
            // Straight lines between samples: an eighth of c h^2, and the rim is bent by 0.12 a metre.
            prop_assert!((seen.made.height[k][5] - y).abs() < 4e-3, "{k}: {} {y}", seen.made.height[k][5]);
        }
    }

    /// Multipliers that are off: the quadratic form of both squarers, wherever the sweep goes.
    #[test]
    fn squarers_that_are_off_make_ellipses(
        azimuth in 0.0..std::f64::consts::TAU, beside in -30.0..30.0_f64,
        x in -0.05..0.05_f64, y in -0.05..0.05_f64, offset in -0.02..0.02_f64,
    ) {
        let (c, s) = (libm::cos(azimuth), libm::sin(azimuth));
        let centre = [300.0 * c - beside * s, 300.0 * s + beside * c];
        let chain = Chain::of(H, [x, y], offset, 1.02, 0.0);
        let seen = see(vec![bowl(centre, 40.0, 6.0)], azimuth, &PartsFeatures::of(H, chain));
        for k in (400..800).step_by(7) {
            let z = seen.ranges[k];
            let [north, east] = [z * c - centre[0], z * s - centre[1]];
            let square = (1.0 + x) * north * north + (1.0 + y) * east * east + offset * 1600.0;
            let expected = if square < 1600.0 { 1.02 * 6.0 * (square / 1600.0 - 1.0) } else { 0.0 };
            prop_assert!((seen.made.height[k][1] - expected).abs() < 1e-9, "{k}: {} {expected}", seen.made.height[k][1]);
        }
    }
}

#[test]
fn a_machine_is_named_by_its_seed_and_its_sub_generators_differ() {
    let craters = || vec![bowl([200.0, 0.0], 30.0, 5.0), bowl([400.0, 0.0], 30.0, 5.0)];
    let seen = see(craters(), 0.0, &generator(0.01, Some(5e6)));
    let again = see(craters(), 0.0, &generator(0.01, Some(5e6)));
    assert_eq!(seen.made.height, again.made.height);
    let off = |k: usize| seen.made.height[k][0] - seen.ideal.height[k - 1][0];
    assert!(off(400).abs() > 1e-4 && off(400).abs() < 0.5, "{}", off(400));
    assert!(time_constant(5e6) < H);
}

fn threshold(offset: f64) -> PartsFeatures {
    let mut chain = Chain::of(H, [0.0; 2], 0.0, 1.0, 0.0);
    chain.threshold = offset;
    PartsFeatures::of(H, chain)
}

proptest! {
    /// A comparator off by o finds the footprint where `1 - rho^2 / R^2 = o`, and sees its slope there; the ground is as it was.
    #[test]
    fn an_offset_moves_the_rims_of_the_presence_line(
        offset in -0.02..0.02_f64, beside in -30.0..30.0_f64, r1 in 40.0..60.0_f64,
    ) {
        let seen = see(vec![bowl([300.0, beside], r1, 5.0)], 0.0, &threshold(offset));
        let half = (r1 * r1 * (1.0 - offset) - beside * beside).sqrt();
        let [entry, exit] = seen.gates[..] else { panic!("{:?}", seen.gates) };
        for (edge, place) in [(entry, 300.0 - half), (exit, 300.0 + half)] {
            // A thousand-millionth of a sample of half a metre.
            prop_assert!((edge.range - place).abs() < 0.5e-9, "{edge:?} {place}");
            let seen_there = |z: f64| 1.0 - ((z - 300.0) * (z - 300.0) + beside * beside) / (r1 * r1);
            let slope = (seen_there(place + 1e-3) - seen_there(place - 1e-3)) / 2e-3;
            prop_assert!((edge.slope - slope.abs()).abs() < 1e-9, "{edge:?} {slope}");
        }
        for (range, present) in seen.ranges.iter().zip(&seen.made.present) {
            prop_assert_eq!(present[2] == 1.0, 300.0 - half <= *range && *range < 300.0 + half);
        }
        prop_assert_eq!(seen.made.kinks[2].len(), 2);
        for (kink, ideal) in seen.made.kinks[2].iter().zip(&seen.ideal.kinks[2]) {
            prop_assert!((kink.range - ideal.range).abs() < 1e-9);
        }
    }
}

#[test]
fn footprints_that_overlap_are_one_and_a_grazed_one_is_none() {
    let edges = |craters: Vec<Crater>, offset: f64| see(craters, 0.0, &threshold(offset)).gates;
    let three =
        vec![bowl([200.0, 0.0], 30.0, 5.0), bowl([240.0, 0.0], 30.0, 5.0), bowl([400.0, 0.0], 20.0, 5.0)];
    let found: Vec<f64> = edges(three, 1e-12).iter().map(|edge| edge.range).collect();
    for (found, right) in found.iter().zip([170.0, 270.0, 380.0, 420.0]) {
        assert!((found - right).abs() < 1e-9, "{found} {right}");
    }
    assert_eq!(found.len(), 4);
    // The sweep passes at 0.999 of the radius: 0.002 of full scale is all that the comparator sees.
    let grazed = || vec![bowl([200.0, 29.97], 30.0, 5.0)];
    assert_eq!((edges(grazed(), 0.001).len(), edges(grazed(), 0.003).len()), (2, 0));
}

#[test]
fn a_crater_under_the_eye_is_settled() {
    let seen = see(vec![bowl([0.0, 0.0], 30.0, 5.0)], 0.0, &lag(300e-9));
    assert!((seen.made.height[0][0] - seen.ideal.height[0][0]).abs() < 1e-12);
    assert!(seen.made.kinks[0].len() == 1 && seen.made.present[0][0] == 1.0);
}
