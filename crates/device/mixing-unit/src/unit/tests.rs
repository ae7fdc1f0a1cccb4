//! The order of fig. 28, switch by switch.

use std::array;

use hardware_model::{Gate, MixingParts};
use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};
use scenario::TextureInShadow;
use signal::{LANES, Lanes};

use super::{Mixed, MixingUnit};
use crate::{FeatureInput, Inputs, Kink, Toggle, ToggleList, terrain_alone};

const SAMPLES: usize = 8;

fn unit(gate: Gate, texture_in_shadow: TextureInShadow) -> MixingUnit {
    MixingUnit::new(&MixingParts { gate, threshold: 0.0 }, texture_in_shadow)
}

fn presence() -> MixingUnit {
    unit(Gate::Presence, TextureInShadow::On)
}

fn signal(value: impl Fn(usize) -> f64) -> Vec<Lanes<f64>> {
    (0..SAMPLES).map(|sample| Lanes::splat(value(sample))).collect()
}

fn lane(signal: &[Lanes<f64>]) -> Vec<f64> {
    signal.iter().map(|value| value[3]).collect()
}

/// Terrain of height `k` and reflectivity `0.1 k`.
struct Terrain {
    height: Vec<Lanes<f64>>,
    reflectivity: Vec<Lanes<f64>>,
}

fn terrain() -> Terrain {
    Terrain { height: signal(|k| k as f64), reflectivity: signal(|k| 0.1 * k as f64) }
}

impl Terrain {
    fn inputs(&self) -> Inputs<'_, f64> {
        let (height, reflectivity) = (&self.height, &self.reflectivity);
        Inputs { height, reflectivity, features: None, shadow: None, texture: None }
    }
}

fn mix(unit: &MixingUnit, inputs: &Inputs<'_, f64>) -> Mixed<f64> {
    let mut out = Mixed::default();
    unit.run(inputs, &mut out);
    out
}

/// A feature from the middle of step 3 to the middle of step 5, dark in its first half.
struct Feature {
    height: Vec<Lanes<f64>>,
    present: Vec<Lanes<f64>>,
    reflectivity: Vec<Lanes<f64>>,
    kinks: [Vec<Kink<f64>>; LANES],
}

fn feature() -> Feature {
    let inside = |k| (3..5).contains(&k);
    let kink = |sample, feature, terrain, present| Kink {
        sample,
        share: 0.5,
        height: sample as f64 - 0.5,
        feature,
        terrain,
        present,
    };
    let kinks = vec![kink(3, [0.0, -0.4], 0.25, [false, true]), kink(5, [0.9, 0.0], 0.45, [true, false])];
    Feature {
        height: signal(|k| if inside(k) { -1.0 } else { 0.0 }),
        present: signal(|k| f64::from(u8::from(inside(k)))),
        reflectivity: signal(|k| [0.0, 0.0, 0.0, -0.3, 0.8, 0.0, 0.0, 0.0][k]),
        kinks: array::from_fn(|_| kinks.clone()),
    }
}

impl Feature {
    fn input(&self) -> Option<FeatureInput<'_, f64>> {
        let Self { height, present, reflectivity, kinks } = self;
        Some(FeatureInput { height, present, reflectivity, lit: present, kinks, gates: None })
    }
}

fn dark(toggles: &[Toggle<f64>]) -> [ToggleList<'_, f64>; LANES] {
    [ToggleList { open_at_start: false, toggles }; LANES]
}

fn toggle(sample: usize, share: f64) -> Toggle<f64> {
    Toggle { sample, share, slope: f64::INFINITY }
}

fn about(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-12, "{found} against {expected}");
}

#[test]
fn terrain_alone_is_two_wires() {
    let terrain = terrain();
    let wires = terrain_alone(&terrain.height, &terrain.reflectivity);
    let mixed = mix(&presence(), &terrain.inputs());
    assert_eq!(mixed.composite().height, wires.height);
    assert_eq!(mixed.composite().reflectivity, wires.reflectivity);
    assert!(!mixed.has_breaks());
}

#[test]
fn features_lie_on_terrain() {
    let (terrain, feature) = (terrain(), feature());
    let inputs = Inputs { features: feature.input(), ..terrain.inputs() };
    let mixed = mix(&presence(), &inputs);
    assert_eq!(lane(&mixed.height), [0.0, 1.0, 2.0, 2.0, 3.0, 5.0, 6.0, 7.0]);
    let expected = [0.0, 0.1, 0.2, -0.3, 0.8, 0.5, 0.6, 0.7];
    lane(&mixed.reflectivity).into_iter().zip(expected).for_each(|(found, expected)| about(found, expected));
    let [near, far] = mixed.breaks[3].as_slice() else { panic!("{:?}", mixed.breaks[3]) };
    assert_eq!((near.sample, near.height, near.before, near.after), (3, 2.5, 0.25, -0.4));
    assert_eq!((far.sample, far.height, far.before, far.after), (5, 4.5, 0.9, 0.45));
    assert_eq!(mixed.bends[3], [true, true]);
    assert_eq!(inputs.vs1_gate(&presence().vs1, 3), [0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
}

#[test]
fn a_self_keyed_switch_shows_terrain_through_the_dark_wall() {
    let (terrain, feature) = (terrain(), feature());
    let inputs = Inputs { features: feature.input(), ..terrain.inputs() };
    let mixed = mix(&unit(Gate::SelfKeyed, TextureInShadow::On), &inputs);
    about(mixed.reflectivity[3][0], 0.3);
    about(mixed.reflectivity[4][0], 0.8);
    assert_eq!((mixed.breaks[0][0].before, mixed.breaks[0][0].after), (0.25, 0.25));
}

#[test]
fn whole_signals_are_switched_like_single_values() {
    let (terrain, feature) = (terrain(), feature());
    let inputs = Inputs { features: feature.input(), ..terrain.inputs() };
    for (gate, threshold) in [(Gate::Presence, 0.9), (Gate::SelfKeyed, 0.8), (Gate::SelfKeyed, -0.5)] {
        let unit = MixingUnit::new(&MixingParts { gate, threshold }, TextureInShadow::Off);
        let mixed = mix(&unit, &inputs);
        for sample in 0..SAMPLES {
            let [c, s, present] = [&terrain.reflectivity, &feature.reflectivity, &feature.present]
                .map(|signal| signal[sample][0]);
            assert_eq!(mixed.reflectivity[sample][0], unit.vs1.output(c, s, present));
        }
    }
}

#[test]
fn shadow_lies_on_both_and_ends_between_samples() {
    let (terrain, feature) = (terrain(), feature());
    let toggles = [toggle(2, 0.25), toggle(4, 0.5), toggle(7, 0.5)];
    let shadow = dark(&toggles);
    let inputs = Inputs { features: feature.input(), shadow: Some(&shadow), ..terrain.inputs() };
    let mixed = mix(&presence(), &inputs);
    assert_eq!(lane(&mixed.reflectivity)[2..4], [0.0, 0.0]);
    assert_eq!(mixed.reflectivity[7][0], 0.0);
    let places: Vec<_> =
        mixed.breaks[0].iter().map(|place| (place.sample, place.before, place.after)).collect();
    let expected = [(2, 0.125, 0.0), (3, 0.0, 0.0), (4, 0.0, 0.25), (5, 0.9, 0.45), (7, 0.65, 0.0)];
    assert_eq!(places.len(), expected.len());
    for (found, expected) in places.iter().zip(expected) {
        assert_eq!(found.0, expected.0);
        about(found.1, expected.1);
        about(found.2, expected.2);
    }
    assert_eq!(mixed.bends[0], [false, true, false, true, false]);
    assert_eq!(inputs.vs2_gate(0), [0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
}

#[test]
fn an_edge_in_the_step_of_a_rim_lies_on_its_own_side() {
    let (terrain, feature) = (terrain(), feature());
    // Before the rim the terrain is straight; behind it the wall goes from -0.4 through -0.3 and 0.8 on a parabola.
    for (share, expected, bends) in [(0.2, 0.22, [false, true]), (0.75, -0.3875, [true, false])] {
        let toggles = [toggle(3, share)];
        let shadow = dark(&toggles);
        let inputs = Inputs { features: feature.input(), shadow: Some(&shadow), ..terrain.inputs() };
        let mixed = mix(&presence(), &inputs);
        assert_eq!(mixed.bends[0][..2], bends);
        let edge = mixed.breaks[0][usize::from(bends[0])];
        about(edge.before, expected);
        assert_eq!((edge.share, edge.after), (share, 0.0));
    }
}

#[test]
fn an_edge_lies_on_the_curve_between_samples() {
    let curved =
        Terrain { height: signal(|k| (k * k) as f64), reflectivity: signal(|k| 0.01 * (k * k) as f64) };
    let toggles = [toggle(4, 0.3)];
    let shadow = dark(&toggles);
    let mixed = mix(&presence(), &Inputs { shadow: Some(&shadow), ..curved.inputs() });
    about(mixed.breaks[0][0].height, 3.3 * 3.3);
    about(mixed.breaks[0][0].before, 0.033 * 3.3);
}

#[test]
fn texture_grains_shadow_as_reported_or_leaves_it_black() {
    let reflectivity = signal(|k| if k < 3 { -0.2 } else { 0.5 });
    let terrain = Terrain { reflectivity, ..terrain() };
    let texture: Vec<_> = signal(|k| 0.1 * k as f64)[..6].to_vec();
    let toggles = [toggle(4, 0.5)];
    let shadow = dark(&toggles);
    let inputs = Inputs { shadow: Some(&shadow), texture: Some(&texture), ..terrain.inputs() };
    let reported = mix(&presence(), &inputs);
    let expected = [0.0, 0.1, 0.2, 0.8, 0.4, 0.5, 0.0, 0.0];
    lane(&reported.reflectivity)
        .into_iter()
        .zip(expected)
        .for_each(|(found, expected)| about(found, expected));
    about(reported.breaks[0][0].after, 0.35);
    let black = mix(&unit(Gate::Presence, TextureInShadow::Off), &inputs);
    let expected = [-0.2, -0.1, 0.0, 0.8, 0.0, 0.0, 0.0, 0.0];
    lane(&black.reflectivity).into_iter().zip(expected).for_each(|(found, expected)| about(found, expected));
    assert_eq!(black.breaks[0][0].after, 0.0);
}

#[test]
fn reflectivity_ends_at_one() {
    let terrain = Terrain { reflectivity: signal(|_| 0.9), ..terrain() };
    let texture = signal(|_| 0.3);
    let toggles = [toggle(4, 0.5)];
    let shadow = dark(&toggles);
    let inputs = Inputs { shadow: Some(&shadow), texture: Some(&texture), ..terrain.inputs() };
    let mixed = mix(&presence(), &inputs);
    assert_eq!((mixed.reflectivity[0][0], mixed.breaks[0][0].before), (1.0, 1.0));
}

proptest! {
    #[test]
    fn every_sample_has_the_gate_of_the_toggles_before_it(
        start in any::<bool>(),
        places in proptest::collection::vec((1..SAMPLES, 0.0..=1.0f64), 0..12),
    ) {
        let mut toggles: Vec<_> = places.iter().map(|&(sample, share)| toggle(sample, share)).collect();
        toggles.sort_by(|a, b| (a.sample, a.share).partial_cmp(&(b.sample, b.share)).unwrap());
        let (terrain, feature) = (terrain(), feature());
        let shadow = [ToggleList { open_at_start: start, toggles: &toggles }; LANES];
        let inputs = Inputs { features: feature.input(), shadow: Some(&shadow), ..terrain.inputs() };
        let mixed = mix(&presence(), &inputs);
        let lit = mix(&presence(), &Inputs { shadow: None, ..inputs });
        for sample in 0..SAMPLES {
            let passed = toggles.iter().filter(|toggle| toggle.sample <= sample).count();
            let dark = start ^ (passed % 2 == 1);
            let expected = if dark { 0.0 } else { lit.reflectivity[sample][0] };
            prop_assert_eq!(mixed.reflectivity[sample][0], expected);
        }
        let breaks = &mixed.breaks[0];
        prop_assert_eq!(breaks.len(), toggles.len() + 2);
        prop_assert!(breaks.is_sorted_by(|a, b| (a.sample, a.share) <= (b.sample, b.share)));
        prop_assert!(breaks.iter().all(|place| place.before.is_finite() && place.height.is_finite()));
    }
}
