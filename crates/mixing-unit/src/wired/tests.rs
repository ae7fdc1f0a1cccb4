//! The unit of parts against closed forms, and against the ideal one.

use std::array;

use hardware_model::{AnalogParts, Gate, MixingParts};
use parts::{Spread, Tolerance, relative_sigma, time_constant};
use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};
use scenario::TextureInShadow;
use signal::{LANES, Lanes, Real};

use super::{PartsMixer, SwitchScratch};
use crate::{FeatureInput, Inputs, Kink, Mixed, MixingUnit, Toggle, ToggleList};

const SAMPLES: usize = 60;
/// A sample (s).
const H: f64 = 50e-9;

const PRESENCE: MixingParts = MixingParts { gate: Gate::Presence, threshold: 0.0 };

fn parts(change: impl FnOnce(&mut AnalogParts)) -> AnalogParts {
    let mut parts = AnalogParts::ideal();
    change(&mut parts);
    parts
}

fn signal<S: Real>(value: impl Fn(usize) -> f64) -> Vec<Lanes<S>> {
    (0..SAMPLES).map(|sample| Lanes::splat(S::from_f64(value(sample)))).collect()
}

fn mix(parts: &AnalogParts, inputs: &Inputs<'_, f64>) -> Mixed<f64> {
    let mut out = Mixed::default();
    let unit = PartsMixer::new((&PRESENCE, TextureInShadow::On), H, parts, 1970);
    unit.run(inputs, &mut SwitchScratch::default(), &mut out);
    out
}

/// Ground of reflectivity 0.8, and shadow from `begin` to `end` (samples).
fn in_shadow(parts: &AnalogParts, begin: f64, end: f64) -> Vec<f64> {
    let (height, light) = (signal(|k| k as f64), signal(|_| 0.8));
    let toggles = [begin, end].map(|at| Toggle { sample: at as usize + 1, share: at - at.floor() });
    let list = ToggleList { dark_at_start: false, toggles: &toggles };
    let lists = [list; LANES];
    let inputs =
        Inputs { height: &height, reflectivity: &light, features: None, shadow: Some(&lists), texture: None };
    mix(parts, &inputs).reflectivity.iter().map(|value| value[2]).collect()
}

/// Where the missing light has its middle, and how much is missing (samples).
fn hole(light: &[f64]) -> [f64; 2] {
    let missing = |k: usize| 0.8 - light[k];
    let area: f64 = (0..SAMPLES).map(missing).sum();
    let moment: f64 = (0..SAMPLES).map(|k| k as f64 * missing(k)).sum();
    [moment / area, area / 0.8]
}

/// A feature of reflectivity `dim` from `begin` to `end`, on ground of 0.8.
fn feature(parts: &AnalogParts, dim: f64, [begin, end]: [f64; 2]) -> Vec<f64> {
    let (height, light) = (signal(|k| k as f64), signal(|_| 0.8));
    let inside = |k: usize| begin <= k as f64 && k as f64 <= end;
    let present = signal(|k| f64::from(u8::from(inside(k))));
    let video = signal(|k| if inside(k) { dim } else { 0.0 });
    let rim = |at: f64, present: [bool; 2]| Kink {
        sample: at as usize + 1,
        share: at - at.floor(),
        height: 0.0,
        feature: present.map(|is| if is { dim } else { 0.0 }),
        terrain: 0.8,
        present,
    };
    let kinks = array::from_fn(|_| vec![rim(begin, [false, true]), rim(end, [true, false])]);
    let features = FeatureInput { height: &height, present: &present, reflectivity: &video, kinks: &kinks };
    let inputs = Inputs {
        height: &height,
        reflectivity: &light,
        features: Some(features),
        shadow: None,
        texture: None,
    };
    let out = mix(parts, &inputs);
    assert_eq!(out.height[7][1], 14.0);
    assert!(!out.has_breaks());
    out.reflectivity.iter().map(|value| value[2]).collect()
}

proptest! {
    /// A13: a shadow is moved by the delay and keeps its width, between samples too.
    #[test]
    fn a_shadow_comes_late_by_the_comparators_delay(
        begin in 5.0..15.0_f64,
        width in 4.0..15.0_f64,
        seconds in 0.0..800e-9_f64,
        transition in 0.0..150e-9_f64,
    ) {
        let slow = parts(|parts| {
            parts.comparator.delay = seconds;
            parts.video_switch.time = transition;
        });
        let [middle, area] = hole(&in_shadow(&slow, begin, begin + width));
        prop_assert!((area - width).abs() < 1e-9, "{area} {width}");
        let expected = begin + width / 2.0 + (seconds + transition / 2.0) / H;
        // The part of an edge that a sample has lies in its middle: off by an eighth of a step at most, of the whole.
        prop_assert!((middle - expected).abs() < 0.126 / width, "{middle} {expected}");
    }

    #[test]
    fn whatever_comes_in_light_goes_out(
        picks in proptest::collection::vec(0..6_usize, SAMPLES),
        gate in any::<bool>(),
        figure in 0..6_usize,
    ) {
        let odd = |k: usize| [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.4, 0.6, 7.0][picks[k]];
        let light = signal(odd);
        let present = signal(|k| f64::from(u8::from(picks[k] > 2)));
        let none = array::from_fn(|_| Vec::new());
        let features =
            FeatureInput { height: &light, present: &present, reflectivity: &light, kinks: &none };
        let shadow = [ToggleList { dark_at_start: true, toggles: &[] }; LANES];
        let inputs = Inputs {
            height: &light,
            reflectivity: &light,
            features: Some(features),
            shadow: (figure % 2 == 0).then_some(&shadow),
            texture: Some(&light[..20]),
        };
        let time = [0.0, 20e-9, f64::INFINITY][figure / 2];
        let awkward = parts(|parts| {
            parts.comparator.delay = time;
            parts.video_switch.time = time;
            parts.video_switch.level_mismatch = 0.5;
            parts.video_bandwidth = Some(1.0 / (time + 1e-12));
        });
        let gate = if gate { Gate::Presence } else { Gate::SelfKeyed };
        let unit = PartsMixer::<f64>::new((&MixingParts { gate, threshold: 0.1 }, TextureInShadow::Off), H, &awkward, 1);
        let mut out = Mixed::default();
        unit.run(&inputs, &mut SwitchScratch::default(), &mut out);
        prop_assert!(out.reflectivity.iter().all(|value| value.0.iter().all(|value| (0.0..=1.0).contains(value))));
    }

    /// Ideal parts switch where the ideal unit does, within a sample.
    #[test]
    fn ideal_parts_do_what_the_ideal_unit_does(
        ground in proptest::collection::vec(-0.3..1.0_f64, SAMPLES),
        toggles in proptest::collection::vec((0.0..58.0_f64, any::<bool>()), 0..6),
        bound in proptest::collection::vec(1.0..58.0_f64, 2),
    ) {
        let mut places: Vec<f64> = toggles.iter().map(|toggle| toggle.0).collect();
        places.sort_by(f64::total_cmp);
        let toggles: Vec<_> =
            places.iter().map(|&at| Toggle { sample: at as usize + 1, share: at - at.floor() }).collect();
        let lists = [ToggleList { dark_at_start: false, toggles: &toggles }; LANES];
        let (height, light) = (signal(|k| k as f64), signal(|k| ground[k]));
        let [near, far] = [bound[0].min(bound[1]), bound[0].max(bound[1])];
        let present = signal(|k| f64::from(u8::from(near <= k as f64 && k as f64 <= far)));
        let video = signal(|k| 0.5 * present[k][0]);
        let none = array::from_fn(|_| Vec::new());
        let features = FeatureInput { height: &height, present: &present, reflectivity: &video, kinks: &none };
        let inputs = Inputs {
            height: &height,
            reflectivity: &light,
            features: Some(features),
            shadow: Some(&lists),
            texture: None,
        };
        let mut ideal = Mixed::default();
        MixingUnit::new(&PRESENCE, TextureInShadow::On).run(&inputs, &mut ideal);
        let made = mix(&AnalogParts::ideal(), &inputs);
        prop_assert_eq!(&made.height, &ideal.height);
        for k in 0..SAMPLES {
            let clear = places.iter().all(|&at| (at - k as f64).abs() > 0.5);
            let expected = ideal.reflectivity[k][5].max(0.0);
            prop_assert!(!clear || (made.reflectivity[k][5] - expected).abs() < 1e-12, "{k}");
        }
    }
}

#[test]
fn a_switch_fades_over_its_transition_in_a_straight_line() {
    // 0 to 100 % in t_vs: six samples, from the toggle on.
    let slow = parts(|parts| parts.video_switch.time = 6.0 * H);
    let light = in_shadow(&slow, 20.5, 40.5);
    for (k, expected) in [
        (20, 1.0),
        (21, 11.0 / 12.0),
        (24, 5.0 / 12.0),
        (26, 1.0 / 12.0),
        (27, 0.0),
        (40, 0.0),
        (41, 1.0 / 12.0),
    ] {
        assert!((light[k] - 0.8 * expected).abs() < 1e-12, "{k}: {}", light[k]);
    }
}

#[test]
fn a_level_mismatch_is_a_constant_step() {
    // A22: the same pedestal all over a feature, whatever its light.
    let step = |mismatch: f64, dim: f64| {
        let light = feature(&parts(|parts| parts.video_switch.level_mismatch = mismatch), dim, [10.3, 40.6]);
        assert_eq!(light[5], 0.8);
        assert!((12..40).all(|k| (light[k] - light[20]).abs() < 1e-12));
        light[20] - dim
    };
    assert!(step(0.0, 0.3).abs() < 1e-12);
    assert!((step(0.02, 0.3) - 2.0 * step(0.01, 0.3)).abs() < 1e-12);
    assert!((step(0.01, 0.3) - step(0.01, 0.6)).abs() < 1e-12);
    assert!(step(0.01, 0.3).abs() > 1e-4 && step(0.01, 0.3).abs() <= 0.04);
}

#[test]
fn a_rim_keeps_its_place_between_samples() {
    for [begin, end] in [[10.3, 40.6], [10.7, 40.1], [12.5, 39.5]] {
        let light = feature(&AnalogParts::ideal(), 0.3, [begin, end]);
        let missing = light.iter().map(|value| (0.8 - value) / 0.5);
        let area: f64 = missing.clone().sum();
        let middle = missing.enumerate().map(|(k, part)| k as f64 * part).sum::<f64>() / area;
        assert!((area - (end - begin)).abs() < 1e-9, "{begin} {end}: {area}");
        assert!((middle - (end + begin) / 2.0).abs() < 0.01, "{begin} {end}: {middle}");
    }
}

#[test]
fn texture_grains_shadow_behind_the_switch_and_not_before_it() {
    let (light, grain) = (signal::<f64>(|_| 0.5), signal(|_| 0.125));
    let shadow = [ToggleList { dark_at_start: true, toggles: &[] }; LANES];
    let inputs = Inputs {
        height: &light,
        reflectivity: &light,
        features: None,
        shadow: Some(&shadow),
        texture: Some(&grain[..30]),
    };
    for (place, expected) in [(TextureInShadow::On, 0.125), (TextureInShadow::Off, 0.0)] {
        let mut out = Mixed::default();
        let unit = PartsMixer::new((&PRESENCE, place), H, &AnalogParts::ideal(), 1);
        unit.run(&inputs, &mut SwitchScratch::default(), &mut out);
        assert_eq!((out.reflectivity[29][0], out.reflectivity[30][0]), (expected, 0.0));
        unit.run(&Inputs { shadow: None, ..inputs }, &mut SwitchScratch::default(), &mut out);
        assert_eq!((out.reflectivity[29][0], out.reflectivity[30][0]), (0.625, 0.5));
    }
}

#[test]
fn a_late_gate_shows_ground_at_the_near_rim_and_no_seam_at_the_far_one() {
    let late = |seconds: f64| feature(&parts(|parts| parts.comparator.delay = seconds), 0.3, [10.25, 40.25]);
    let missing = |light: &[f64]| light.iter().map(|value| 0.8 - value).sum::<f64>() / 0.5;
    let [clean, moved] = [late(0.0), late(200e-9)];
    assert!((missing(&clean) - 30.0).abs() < 1e-9, "{}", missing(&clean));
    assert!((moved[13] - 0.8).abs() < 1e-12 && (moved[15] - 0.3).abs() < 1e-12);
    assert!(moved[40..].iter().all(|&value| value > 0.3 - 1e-12 && value <= 0.8));
    // The video has ended with its footprint, so what the gate lets through longer is ground.
    assert!((missing(&clean) - missing(&moved) - 4.0).abs() < 0.51);
}

#[test]
fn video_is_smeared_over_two_lags() {
    // A6: 10 to 90 % in 2.2 tau, late by tau.
    let bandwidth = 0.5e6;
    let light = in_shadow(&parts(|parts| parts.video_bandwidth = Some(bandwidth)), 10.5, 58.0);
    let tau = time_constant(bandwidth) / H;
    let crosses = |level: f64| {
        let k = (10..57).find(|&k| light[k] < level).unwrap();
        k as f64 - (level - light[k]) / (light[k - 1] - light[k])
    };
    let spread = crosses(0.08) - crosses(0.72);
    assert!((spread - libm::log(9.0) * tau).abs() < 0.1, "{spread} {tau}");
    let slope = |k: usize| light[k - 1] - light[k];
    let late: f64 = (10..57).map(|k| (k as f64 - 0.5) * slope(k)).sum::<f64>() / 0.8;
    assert!((late - 10.5 - tau).abs() < 0.1, "{late}");
}

#[test]
fn spread_moves_the_edges_of_one_machine_by_the_same() {
    let spread = parts(|parts| {
        parts.spread = true;
        parts.comparator.delay = 200e-9;
    });
    let moved = |begin: f64| hole(&in_shadow(&spread, begin, begin + 8.0))[0] - begin - 4.0;
    assert!((moved(10.2) - moved(20.7)).abs() < 0.02);
    let tolerance = Tolerance { nominal: 200e-9, sigma: relative_sigma::SWITCH_DELAY };
    let drawn = Spread::new(1970).figure("sc.comparator", 0, &tolerance) / H;
    assert!((moved(10.2) - drawn).abs() < 0.02 && (drawn - 4.0).abs() > 0.01, "{} {drawn}", moved(10.2));
}

#[test]
fn nothing_to_mix_is_mixed() {
    let none: [Lanes<f64>; 0] = [];
    let inputs = Inputs { height: &none, reflectivity: &none, features: None, shadow: None, texture: None };
    assert!(mix(&parts(|parts| parts.video_bandwidth = Some(1e6)), &inputs).reflectivity.is_empty());
}
