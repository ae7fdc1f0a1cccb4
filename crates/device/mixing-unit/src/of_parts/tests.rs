//! The unit of parts against closed forms, and against the ideal one.

use std::array;

use hardware_model::{AnalogParts, Gate, MixingParts};
use parts::{Jump, NearJumps, Spread, Tolerance, relative_sigma, time_constant};
use proptest::prelude::{any, prop_assert, prop_assert_eq, prop_assume, proptest};
use scenario::TextureInShadow;
use signal::{Break, LANES, Lanes, Real};

use super::{PartsMixer, SwitchScratch};
use crate::{FeatureInput, Inputs, Kink, Mixed, MixingUnit, Toggle, ToggleList};

const SAMPLES: usize = 60;
/// Time of one sample (s).
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

/// Lane 2 of what the unit puts out.
struct Seen {
    samples: Vec<f64>,
    jumps: Vec<Jump>,
}

impl Seen {
    fn of(out: &Mixed<f64>) -> Self {
        let jump = |place: &Break<f64>| Jump {
            at: place.sample as f64 - 1.0 + place.share,
            before: place.before,
            after: place.after,
        };
        Self {
            samples: out.reflectivity.iter().map(|value| value[2]).collect(),
            jumps: out.breaks[2].iter().map(jump).collect(),
        }
    }

    /// Just before and just after `time` (samples).
    fn at(&self, time: f64) -> [f64; 2] {
        NearJumps::new(&self.jumps).at(|sample| self.samples[sample], SAMPLES - 1, time)
    }

    /// Ends of the straight pieces: instant, value behind it, value before the next.
    fn pieces(&self) -> Vec<([f64; 2], [f64; 2])> {
        let mut ends: Vec<f64> = (0..SAMPLES).map(|k| k as f64).collect();
        ends.extend(self.jumps.iter().map(|jump| jump.at));
        ends.sort_by(f64::total_cmp);
        ends.windows(2).map(|t| ([t[0], t[1]], [self.at(t[0])[1], self.at(t[1])[0]])).collect()
    }

    /// Where what is missing of `full` has its middle, and how much is missing (samples of `part`).
    fn hole(&self, full: f64, part: f64) -> [f64; 2] {
        let mut sums = [0.0; 2];
        for ([from, to], values) in self.pieces() {
            let [a, b] = values.map(|value| (full - value) / part);
            sums[0] += (to - from) * (a + b) / 2.0;
            sums[1] += (to - from) * (from * (2.0 * a + b) + to * (a + 2.0 * b)) / 6.0;
        }
        [sums[1] / sums[0], sums[0]]
    }
}

fn toggle(at: f64, slope: f64) -> Toggle<f64> {
    Toggle { sample: at as usize + 1, share: at - at.floor(), slope }
}

/// Ground of reflectivity 0.8, and shadow from `begin` to `end` (samples).
fn in_shadow(parts: &AnalogParts, begin: f64, end: f64) -> Seen {
    in_shadow_met_at(parts, [begin, end], [f64::INFINITY; 2])
}

/// The same, its edges met at `slopes` (full scales a step).
fn in_shadow_met_at(parts: &AnalogParts, edges: [f64; 2], slopes: [f64; 2]) -> Seen {
    let (height, light) = (signal(|k| k as f64), signal(|_| 0.8));
    let toggles = [0, 1].map(|side| toggle(edges[side], slopes[side]));
    let list = ToggleList { open_at_start: false, toggles: &toggles };
    let lists = [list; LANES];
    let inputs =
        Inputs { height: &height, reflectivity: &light, features: None, shadow: Some(&lists), texture: None };
    Seen::of(&mix(parts, &inputs))
}

fn hole(seen: &Seen) -> [f64; 2] {
    seen.hole(0.8, 0.8)
}

/// A feature of reflectivity `dim`, growing by `slope` a sample, from `begin` to `end`, on ground of 0.8.
fn feature(parts: &AnalogParts, light: [f64; 2], rims: [f64; 2]) -> Seen {
    feature_found_at(parts, light, rims, None)
}

/// The same; `found`: where its comparator finds its rims, and the slopes at which it meets them (full scales a step).
fn feature_found_at(
    parts: &AnalogParts,
    [dim, slope]: [f64; 2],
    [begin, end]: [f64; 2],
    found: Option<[[f64; 2]; 2]>,
) -> Seen {
    let toggles = found.map(|edges| edges.map(|[at, slope]| toggle(at, slope)));
    let lists = toggles.as_ref().map(|toggles| [ToggleList { open_at_start: false, toggles }; LANES]);
    let (height, light) = (signal(|k| k as f64), signal(|_| 0.8));
    let inside = |k: usize| begin <= k as f64 && k as f64 <= end;
    let present = signal(|k| f64::from(u8::from(inside(k))));
    let video = signal(|k| if inside(k) { dim + slope * k as f64 } else { 0.0 });
    let rim = |at: f64, present: [bool; 2]| Kink {
        sample: at as usize + 1,
        share: at - at.floor(),
        height: 0.0,
        feature: present.map(|is| if is { dim + slope * at } else { 0.0 }),
        terrain: 0.8,
        present,
    };
    let kinks = array::from_fn(|_| vec![rim(begin, [false, true]), rim(end, [true, false])]);
    let features = FeatureInput {
        height: &height,
        present: &present,
        reflectivity: &video,
        lit: &present,
        kinks: &kinks,
        gates: lists.as_ref(),
    };
    let inputs = Inputs {
        height: &height,
        reflectivity: &light,
        features: Some(features),
        shadow: None,
        texture: None,
    };
    let out = mix(parts, &inputs);
    assert_eq!(out.height[7][1], 14.0);
    assert_eq!(out.bends[2].iter().filter(|&&bend| bend).count(), 2, "both rims bend the height");
    Seen::of(&out)
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
        let expected = begin + width / 2.0 + seconds / H;
        prop_assert!((middle - expected).abs() < 1e-9, "{middle} {expected}");
    }

    /// A13: the delay of a comparator on a ramp of slope s is `t_c + sqrt(2 k_od / s)`, at most 500 ns, at edges of shadow and at
    /// rims alike, each by its own slope.
    #[test]
    fn an_edge_met_slowly_comes_later(
        begin in 5.0..15.0_f64,
        width in 20.0..25.0_f64,
        seconds in 40e-9..400e-9_f64,
        overdrive in 0.0..400e-12_f64,
        slopes in proptest::collection::vec(1e-4..0.1_f64, 2),
    ) {
        let slow = parts(|parts| {
            parts.full_scale = 10.0;
            (parts.comparator.delay, parts.comparator.overdrive) = (seconds, overdrive);
        });
        let expected = |slope: f64| {
            let longest = (12.5 * seconds).min(500e-9);
            (seconds + (2.0 * overdrive / (10.0 * slope / H)).sqrt()).min(longest) / H
        };
        let edges = [begin, begin + width];
        let shadow = in_shadow_met_at(&slow, edges, [slopes[0], slopes[1]]);
        for (edge, &slope) in edges.iter().zip(&slopes) {
            let place = edge + expected(slope);
            let found = shadow.jumps.iter().any(|jump| jump.before != jump.after && (jump.at - place).abs() < 1e-9);
            prop_assert!(found, "{place}: {:?}", shadow.jumps);
        }
        let rims = feature_found_at(&slow, [0.3, 0.0], edges, Some([[edges[0], slopes[0]], [edges[1], slopes[1]]]));
        // At the far rim the video has ended before the gate: its near one alone is seen.
        let place = edges[0] + expected(slopes[0]);
        let found = rims.jumps.iter().any(|jump| jump.before - jump.after > 0.49 && (jump.at - place).abs() < 1e-9);
        prop_assert!(found, "{place}: {:?}", rims.jumps);
    }

    /// Without overdrive the gates are those of comparators that know a delay alone, to the bit.
    #[test]
    fn without_overdrive_slopes_and_told_rims_change_no_bit(
        begin in 5.0..15.0_f64,
        width in 4.0..15.0_f64,
        seconds in 0.0..400e-9_f64,
        slopes in proptest::collection::vec(1e-4..0.1_f64, 2),
    ) {
        let slow = parts(|parts| {
            parts.comparator.delay = seconds;
            parts.video_switch.time = 70e-9;
            parts.video_bandwidth = Some(6e6);
        });
        let edges = [begin, begin + width];
        let bits = |seen: Seen| (seen.samples, seen.jumps);
        let met = in_shadow_met_at(&slow, edges, [slopes[0], slopes[1]]);
        prop_assert_eq!(bits(met), bits(in_shadow(&slow, edges[0], edges[1])));
        let told = Some([[edges[0], slopes[0]], [edges[1], slopes[1]]]);
        let found = feature_found_at(&slow, [0.3, 0.01], edges, told);
        prop_assert_eq!(bits(found), bits(feature(&slow, [0.3, 0.01], edges)));
    }

    /// Local shadow begins and ends where its light passes 0 between two samples, in light that runs straight.
    #[test]
    fn local_shadow_begins_between_samples(middle in 20.2..39.8_f64, width in 0.3..12.0_f64, slope in 0.01..0.05_f64) {
        let half = 0.5 * width;
        let light = signal(|k| slope * ((k as f64 - middle).abs() - half));
        let height = signal(|k| k as f64);
        let inputs = Inputs { height: &height, reflectivity: &light, features: None, shadow: None, texture: None };
        let seen = Seen::of(&mix(&AnalogParts::ideal(), &inputs));
        let is_straight = |at: f64| (at.floor() - middle) * (at.ceil() - middle) > 0.0;
        for at in [middle - half, middle + half].into_iter().filter(|&at| is_straight(at)) {
            prop_assert!(seen.jumps.iter().any(|jump| (jump.at - at).abs() < 1e-9), "{at}: {:?}", seen.jumps);
            let sunward = (at - middle).signum();
            for step in [0.05, 0.1] {
                prop_assume!(is_straight(at + sunward * step) && is_straight(at - sunward * step));
                prop_assert!((seen.at(at + sunward * step)[0] - slope * step).abs() < 1e-9);
                prop_assert!(seen.at(at - sunward * step)[0] < 1e-12);
            }
        }
        for jump in &seen.jumps {
            prop_assert!(jump.before == jump.after && jump.after < 1e-12, "light passes 0, and does not jump: {jump:?}");
        }
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
            FeatureInput { height: &light, present: &present, reflectivity: &light, lit: &present, kinks: &none, gates: None };
        let shadow = [ToggleList { open_at_start: true, toggles: &[] }; LANES];
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
            parts.video_switch.delay_mismatch = time;
            parts.video_switch.crosstalk = Some(0.1);
            parts.video_bandwidth = Some(1.0 / (time + 1e-12));
        });
        let gate = if gate { Gate::Presence } else { Gate::SelfKeyed };
        let unit = PartsMixer::<f64>::new((&MixingParts { gate, threshold: 0.1 }, TextureInShadow::Off), H, &awkward, 1);
        let mut out = Mixed::default();
        unit.run(&inputs, &mut SwitchScratch::default(), &mut out);
        let in_light = |value: &f64| (0.0..=1.0).contains(value);
        prop_assert!(out.reflectivity.iter().all(|value| value.0.iter().all(in_light)));
prop_assert!(out.breaks.iter().flatten().all(|place| in_light(&place.before) && in_light(&place.after)));
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
            places.iter().map(|&at| toggle(at, f64::INFINITY)).collect();
        let lists = [ToggleList { open_at_start: false, toggles: &toggles }; LANES];
        let (height, light) = (signal(|k| k as f64), signal(|k| ground[k]));
        let [near, far] = [bound[0].min(bound[1]), bound[0].max(bound[1])];
        let present = signal(|k| f64::from(u8::from(near <= k as f64 && k as f64 <= far)));
        let video = signal(|k| 0.5 * present[k][0]);
        let none = array::from_fn(|_| Vec::new());
        let features =
            FeatureInput { height: &height, present: &present, reflectivity: &video, lit: &present, kinks: &none, gates: None };
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
            let expected = ideal.reflectivity[k][5].max(0.0);
            prop_assert!((made.reflectivity[k][5] - expected).abs() < 1e-12, "{k}");
        }
        // The edge of each shadow lies where it lay, black on its dark side.
        let seen = Seen::of(&made);
        for (index, &at) in places.iter().enumerate() {
            let alone = places.iter().filter(|&&other| (other - at).abs() < 1e-9).count() == 1;
            let dark = seen.at(at)[usize::from(index % 2 == 0)];
            prop_assert!(!alone || at < 1e-9 || dark == 0.0, "{index} at {at}: {dark}");
            let listed = |place: &Break<f64>| (place.sample as f64 - 1.0 + place.share - at).abs() < 1e-9;
            prop_assert!(!alone || at < 1e-9 || made.breaks[5].iter().any(listed));
        }
    }
}

#[test]
fn a_switch_fades_over_its_transition_in_a_straight_line() {
    // 0 to 100 % in t_vs: six samples, the toggle in their middle.
    let light = in_shadow(&parts(|parts| parts.video_switch.time = 6.0 * H), 20.5, 40.5);
    for (at, expected) in
        [(17.5, 1.0), (18.0, 11.0 / 12.0), (20.5, 0.5), (23.25, 1.0 / 24.0), (23.5, 0.0), (30.0, 0.0)]
    {
        let [before, after] = light.at(at);
        assert!(before == after && (before - 0.8 * expected).abs() < 1e-12, "{at}: {before}");
    }
}

/// A transition within one step is there in full: nothing of it is lost between samples.
#[test]
fn a_fade_between_two_samples_survives() {
    let light = in_shadow(&parts(|parts| parts.video_switch.time = 0.4 * H), 20.5, 40.5);
    assert_eq!([light.samples[20], light.samples[21]], [0.8, 0.0]);
    for (at, expected) in [(20.3, 0.8), (20.4, 0.6), (20.5, 0.4), (20.7, 0.0)] {
        assert!((light.at(at)[0] - expected).abs() < 1e-12, "{at}: {:?}", light.at(at));
    }
}

#[test]
fn level_and_gain_are_off_by_a_step_of_their_own() {
    // A22: the same pedestal all over a feature, whatever its light; the gain's in proportion to it.
    let seen = |change: &dyn Fn(&mut AnalogParts), dim: f64| {
        let light = feature(&parts(change), [dim, 0.0], [10.3, 40.6]);
        assert_eq!(light.samples[5], 0.8);
        assert!((11..40).all(|k| (light.samples[k] - light.samples[20]).abs() < 1e-12));
        light.samples[20] - dim
    };
    let level = |mismatch: f64, dim: f64| seen(&|parts| parts.video_switch.level_mismatch = mismatch, dim);
    let gain = |mismatch: f64, dim: f64| seen(&|parts| parts.video_switch.gain_mismatch = mismatch, dim);
    assert!(level(0.0, 0.3).abs() < 1e-12);
    assert!((level(0.02, 0.3) - 2.0 * level(0.01, 0.3)).abs() < 1e-12);
    assert!((level(0.01, 0.3) - level(0.01, 0.6)).abs() < 1e-12);
    assert!(level(0.01, 0.3).abs() > 1e-4 && level(0.01, 0.3).abs() <= 0.04);
    assert!((gain(0.01, 0.6) - 2.0 * gain(0.01, 0.3)).abs() < 1e-12 && gain(0.01, 0.3).abs() > 1e-4);
}

#[test]
fn the_two_ways_of_a_switch_are_apart_by_their_delay() {
    let late = |seconds: f64| {
        feature(&parts(|parts| parts.video_switch.delay_mismatch = seconds), [0.1, 0.01], [10.3, 40.6])
    };
    let (clean, moved) = (late(0.0), late(15e-9));
    for k in 12..40 {
        assert!((clean.samples[k] - moved.samples[k] - 0.01 * 15e-9 / H).abs() < 1e-12, "{k}");
    }
    // The gate has not moved: between it and the video's own rim the ground goes on.
    assert!((moved.at(10.31)[0] - 0.8).abs() < 1e-12 && moved.at(10.61)[0] < 0.3);
}

/// What is off gets through by its frequency: 50 dB below at 5 MHz are 70 dB at half a megahertz.
#[test]
fn crosstalk_goes_with_the_frequency() {
    let leaks = |megahertz: f64| {
        let wave = move |k: usize| {
            0.5 + 0.4 * libm::sin(2.0 * std::f64::consts::PI * megahertz * 1e6 * H * k as f64)
        };
        let (height, light, grain) = (signal(|k| k as f64), signal(wave), signal(|_| 0.5));
        let shadow = [ToggleList { open_at_start: true, toggles: &[] }; LANES];
        let inputs = Inputs {
            height: &height,
            reflectivity: &light,
            features: None,
            shadow: Some(&shadow),
            texture: Some(&grain),
        };
        let switch = parts(|parts| parts.video_switch.crosstalk = Some(libm::pow(10.0, -2.5)));
        // Black cuts half of the leak off; behind the adder the other half is left.
        let light = Seen::of(&mix(&switch, &inputs)).samples;
        light.iter().skip(3).fold(0.0_f64, |most, value| most.max(value - 0.5)) / 0.4
    };
    let [slow, slower] = [0.5, 0.25].map(leaks);
    assert!((slow / libm::pow(10.0, -3.5) - 1.0).abs() < 0.03, "{slow}");
    assert!((slow / slower - 2.0).abs() < 0.05, "{slow} {slower}");
}

#[test]
fn a_rim_keeps_its_place_between_samples() {
    for [begin, end] in [[10.3, 40.6], [10.7, 40.1], [12.5, 39.5]] {
        let [middle, area] = feature(&AnalogParts::ideal(), [0.3, 0.0], [begin, end]).hole(0.8, 0.5);
        assert!((area - (end - begin)).abs() < 1e-9, "{begin} {end}: {area}");
        assert!((middle - (end + begin) / 2.0).abs() < 1e-9, "{begin} {end}: {middle}");
    }
}

#[test]
fn texture_grains_shadow_behind_the_switch_and_not_before_it() {
    let (light, grain) = (signal::<f64>(|_| 0.5), signal(|_| 0.125));
    let shadow = [ToggleList { open_at_start: true, toggles: &[] }; LANES];
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
    let late =
        |seconds: f64| feature(&parts(|parts| parts.comparator.delay = seconds), [0.3, 0.0], [10.25, 40.25]);
    let (clean, moved) = (late(0.0), late(200e-9));
    assert!((clean.hole(0.8, 0.5)[1] - 30.0).abs() < 1e-9);
    let near = |at: f64, light: f64| assert!((moved.at(at)[0] - light).abs() < 1e-12, "{at}");
    for (at, light) in [(14.24, 0.8), (14.26, 0.3)] {
        near(at, light);
    }
    // The video has ended with its footprint, so what the gate lets through longer is ground.
    for (at, light) in [(40.24, 0.3), (40.26, 0.8), (44.0, 0.8)] {
        near(at, light);
    }
    assert!((moved.hole(0.8, 0.5)[1] - 26.0).abs() < 1e-9);
}

/// A6: behind an edge an exponential, 10 to 90 % in 2.2 tau, exact at the samples wherever between them the edge lies.
#[test]
fn the_amplifier_is_a_lag_from_the_instant_of_the_edge_on() {
    for (bandwidth, edge) in [(0.5e6, 10.5), (0.5e6, 10.125), (12e6, 10.4), (3e6, 10.0)] {
        let light = in_shadow(&parts(|parts| parts.video_bandwidth = Some(bandwidth)), edge, 58.0);
        let tau = time_constant(bandwidth) / H;
        let decay = |at: f64| 0.8 * libm::exp(-(at - edge).max(0.0) / tau);
        for (k, value) in light.samples.iter().enumerate().take(57) {
            assert!((value - decay(k as f64)).abs() < 1e-12, "{bandwidth} {edge} {k}: {value}");
        }
        for jump in light.jumps.iter().filter(|jump| jump.at < 57.0) {
            assert!((jump.before - decay(jump.at)).abs() < 1e-12);
            // What is left of the jump by the line of the same area: a sixth of the square of steps over time constants.
            assert!(jump.after <= jump.before && jump.after >= 0.75 * jump.before, "{bandwidth}: {jump:?}");
        }
        // From the next sample on chords lie above it by little: what is drawn has its area within an eighth of a time constant.
        let drawn: f64 = light
            .pieces()
            .iter()
            .filter(|(t, _)| t[0] >= edge && t[1] < 57.0)
            .map(|(t, v)| (t[1] - t[0]) * (v[0] + v[1]) / 2.0)
            .sum();
        let expected = 0.8 * tau;
        assert!(
            drawn >= 0.99 * expected && drawn < 1.125 * expected,
            "{bandwidth} {edge}: {drawn} {expected}"
        );
    }
}

#[test]
fn spread_moves_the_edges_of_one_machine_by_the_same() {
    let spread = parts(|parts| {
        parts.spread = true;
        parts.comparator.delay = 200e-9;
    });
    let moved = |begin: f64| hole(&in_shadow(&spread, begin, begin + 8.0))[0] - begin - 4.0;
    assert!((moved(10.2) - moved(20.7)).abs() < 1e-9);
    let tolerance = Tolerance { nominal: 200e-9, sigma: relative_sigma::SWITCH_DELAY };
    let drawn = Spread::new(1970).figure("sc.comparator", 0, &tolerance) / H;
    assert!((moved(10.2) - drawn).abs() < 1e-9 && (drawn - 4.0).abs() > 0.01, "{} {drawn}", moved(10.2));
}

#[test]
fn nothing_to_mix_is_mixed() {
    let none: [Lanes<f64>; 0] = [];
    let inputs = Inputs { height: &none, reflectivity: &none, features: None, shadow: None, texture: None };
    assert!(mix(&parts(|parts| parts.video_bandwidth = Some(1e6)), &inputs).reflectivity.is_empty());
}

/// Gates are told behind their comparators: late by their delay, and fading about that instant.
#[test]
fn gates_are_told_behind_their_comparators() {
    let ground = signal::<f64>(|_| 0.8);
    let toggles = [toggle(10.3, f64::INFINITY), toggle(30.6, f64::INFINITY)];
    let shadow = array::from_fn(|_| ToggleList { open_at_start: false, toggles: &toggles });
    let features = FeatureInput {
        height: &ground,
        present: &ground,
        reflectivity: &ground,
        lit: &ground,
        kinks: &array::from_fn(|_| Vec::new()),
        gates: Some(&shadow),
    };
    let inputs = Inputs {
        height: &ground,
        reflectivity: &ground,
        features: Some(features),
        shadow: Some(&shadow),
        texture: None,
    };
    let of = |parts: &AnalogParts| {
        PartsMixer::<f64>::new((&PRESENCE, TextureInShadow::On), H, parts, 1970).gates(&inputs, 2)
    };
    let open = |gate: &[f64]| -> Vec<usize> { (0..SAMPLES).filter(|&sample| gate[sample] == 1.0).collect() };
    let prompt = of(&parts(|parts| parts.comparator.delay = 0.0));
    // Eight samples late, and a fade of two samples about that.
    let late = of(&parts(|parts| {
        parts.comparator.delay = 8.0 * H;
        parts.video_switch.time = 2.0 * H;
    }));
    for (gates, from, to) in [(&prompt, 11, 31), (&late, 19, 39)] {
        for gate in [&gates.present, &gates.gates[0], &gates.gates[1]] {
            assert_eq!(open(gate), (from..to).collect::<Vec<_>>());
        }
    }
    for fade in &late.fades {
        assert_eq!((fade[17], fade[21]), (0.0, 1.0));
        assert!((fade[18] - 0.35).abs() < 1e-9 && (fade[19] - 0.85).abs() < 1e-9, "{:?}", &fade[16..22]);
    }
}
