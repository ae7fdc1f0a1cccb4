//! Conditions on waveforms of which everything is known.

use std::f64::consts::PI;
use std::ops::Range;

use proptest::prelude::*;
use signal::{Kind, Signal, Unit, Waveform, Wire};
use trigger::{Condition, Hit, Machine, Search, Trigger, Which};

const RANGE: Signal = Signal::ground("sweep.range", Unit::Metre, "", "");
const HEIGHT: Signal = Signal::ground("tg.height", Unit::Metre, "", "");
const LIGHT: Signal = Signal::ground("tg.reflectivity", Unit::Reflectivity, "", "");
const BLANK: Signal = Signal::ground("dpp.blank", Unit::Gate, "", "");
const HOLD: Signal = Signal::digital("tg.red.hold", Unit::Corner, Kind::Bus, "", "");
const FOLD_X: Signal = Signal::digital("sweep.fold.x", Unit::Number, Kind::Event, "", "");
const FOLD_Y: Signal = Signal::digital("sweep.fold.y", Unit::Number, Kind::Event, "", "");
const LATE: Signal = Signal::digital("dpu.late", Unit::Number, Kind::Event, "", "");
const COARSE: Signal = Signal::digital("dpu.coarse.late", Unit::Number, Kind::Event, "", "");
const WRITE: Signal = Signal::display("sm.write", Unit::Reflectivity, "", "");
const TABLE: [Signal; 10] = [RANGE, HEIGHT, LIGHT, BLANK, HOLD, FOLD_X, FOLD_Y, LATE, COARSE, WRITE];

const SAMPLES: usize = 100;

fn wires() -> Vec<Wire> {
    let there = TABLE.into_iter().filter(|signal| signal.name != COARSE.name);
    let wire = |signal: Signal| match signal.unit {
        Unit::Metre => Wire { signal, full_scale: 200.0, volts: 10.0, datum: 1600.0 },
        _ => Wire { signal, full_scale: 1.0, volts: 10.0, datum: 0.0 },
    };
    there.map(wire).collect()
}

fn trigger_behind(text: &str, saturation: Option<f64>) -> Trigger {
    let condition = Condition::parse(text, &TABLE).unwrap_or_else(|error| panic!("{error}"));
    Trigger::new(&condition, &Machine { wires: &wires(), saturation, sample_us: 0.5 }).unwrap()
}

fn trigger(text: &str) -> Trigger {
    trigger_behind(text, None)
}

fn wave(signal: Signal, values: impl IntoIterator<Item = f64>) -> Waveform {
    Waveform { signal, frame: 0, sweep: 0, times: Vec::new(), values: values.into_iter().collect() }
}

fn told(signal: Signal, changes: &[(f64, f64)]) -> Waveform {
    let (times, values) = changes.iter().copied().unzip();
    Waveform { signal, frame: 0, sweep: 0, times, values }
}

/// A sweep whose sample k is at 2 (k + 1) metres.
fn sweep(waves: impl IntoIterator<Item = Waveform>) -> Vec<Waveform> {
    let range = wave(RANGE, (0..SAMPLES).map(|k| 2.0 * (k as f64 + 1.0)));
    std::iter::once(range).chain(waves).collect()
}

fn found(text: &str, waves: impl IntoIterator<Item = Waveform>) -> Vec<Hit> {
    trigger(text).find(&sweep(waves), 0..SAMPLES)
}

fn places(hits: &[Hit]) -> Vec<(f64, usize)> {
    hits.iter().map(|hit| (hit.time, hit.sample)).collect()
}

/// 1600 m at sample 0, 4 m higher each sample.
fn ramp() -> Waveform {
    wave(HEIGHT, (0..SAMPLES).map(|k| 1600.0 + 4.0 * k as f64))
}

/// High in each of `stretches` of samples.
fn gate(stretches: &[Range<usize>]) -> Waveform {
    let is_high = |k: usize| stretches.iter().any(|stretch| stretch.contains(&k));
    wave(BLANK, (0..SAMPLES).map(|k| f64::from(u8::from(is_high(k)))))
}

#[test]
fn a_ramp_passes_its_levels_between_two_samples() {
    for (text, time, sample) in [
        ("tg.height > 1701", 25.25, 26),
        ("tg.height >= 1700", 25.0, 25),
        ("tg.height > 1700", 25.0, 26),
        ("rising tg.height 1701", 25.25, 26),
        ("tg.height enters 1650..1700", 12.5, 13),
        ("tg.height leaves 1650..1700", 25.0, 26),
        ("tg.height in 1650..1700", 12.5, 13),
        ("tg.height outside 0..1701", 25.25, 26),
        ("tg.height = 1700", 25.0, 25),
        ("tg.height < 5000", 0.0, 0),
        ("slope tg.height > 3.9/sample", 1.0, 1),
        ("slope tg.height in 1.9..2.1/m", 1.0, 1),
        ("slope tg.height >= 8/us", 1.0, 1),
        ("saturation tg.height", 50.0, 50),
    ] {
        let hits = found(text, [ramp()]);
        assert_eq!(hits.len(), 1, "{text}: {hits:?}");
        // Saturation allows for single precision.
        let near = (hits[0].time - time).abs() < 1e-4;
        assert!(near && hits[0].sample == sample, "{text}: {hits:?}");
        assert!((hits[0].range.unwrap() - 2.0 * (time + 1.0)).abs() < 1e-3, "{text}: {hits:?}");
        assert_eq!(hits[0].readings[0].value, 1600.0 + 4.0 * sample as f64, "{text}");
    }
    for text in [
        "falling tg.height 1701",
        "tg.height < 1600",
        "slope tg.height > 4.1/sample",
        "slope tg.height > 2.1/m",
    ] {
        assert_eq!(found(text, [ramp()]), [], "{text}");
    }
}

/// A sine of period 20 with hills of 100 m.
fn waves_of_hills() -> Waveform {
    wave(HEIGHT, (0..SAMPLES).map(|k| 1600.0 + 100.0 * libm::sin(2.0 * PI * (k as f64 + 0.5) / 20.0)))
}

#[test]
fn every_hill_is_climbed_and_left() {
    let count = |text: &str| found(text, [waves_of_hills()]).len();
    assert_eq!((count("rising tg.height 1650"), count("falling tg.height 1650")), (5, 5));
    assert_eq!((count("tg.height > 1650"), count("tg.height < 1650")), (5, 6));
    assert_eq!((count("tg.height enters 1550..1650"), count("tg.height leaves 1550..1650")), (10, 10));
    let middle = found("rising tg.height 1600", [waves_of_hills()]);
    assert_eq!(middle.len(), 4);
    for hit in middle {
        // The sine passes its middle half a sample before each 20th.
        assert!((hit.time - (hit.sample as f64 - 0.5)).abs() < 1e-6 && hit.sample % 20 == 0, "{hit:?}");
    }
}

#[test]
fn hysteresis_passes_over_a_ripple() {
    let ripple = || wave(HEIGHT, (0..SAMPLES).map(|k| 1600.0 + if k % 2 == 0 { -2.0 } else { 2.0 }));
    assert_eq!(found("rising tg.height 1600", [ripple()]).len(), 50);
    assert_eq!(found("rising tg.height 1600 by 1.9", [ripple()]).len(), 50);
    assert_eq!(found("rising tg.height 1600 by 2.1", [ripple()]), []);
    assert_eq!(found("falling tg.height 1600 by 2.1", [ripple()]), []);
    assert_eq!(found("rising tg.height 1601 by 2.5", [ripple()]).len(), 50);
}

#[test]
fn pulses_by_their_width() {
    let gates = || gate(&[0..5, 10..12, 20..23, 30..40, 95..100]);
    let at = |text: &str| places(&found(text, [gates()]));
    assert_eq!(at("dpp.blank shorter 3"), [(12.0, 12)]);
    assert_eq!(at("dpp.blank shorter 3.5 samples"), [(12.0, 12), (23.0, 23)]);
    assert_eq!(at("dpp.blank shorter 7 m"), [(12.0, 12), (23.0, 23)]);
    assert_eq!(at("dpp.blank shorter 1.1 us"), [(12.0, 12)]);
    assert_eq!(at("dpp.blank longer 4"), [(4.0, 4), (34.0, 34)]);
    assert_eq!(at("dpp.blank longer 3.5"), [(3.5, 4), (33.5, 34), (98.5, 99)]);
    assert_eq!(at("blank"), [(10.0, 10), (20.0, 20), (30.0, 30), (95.0, 95)]);
    assert_eq!(at("unblank"), [(5.0, 5), (12.0, 12), (23.0, 23), (40.0, 40)]);
    assert_eq!(at("dpp.blank")[..2], [(0.0, 0), (10.0, 10)]);
}

#[test]
fn events_keep_their_own_instants() {
    let waves = || {
        [
            told(FOLD_X, &[(-0.3, 1.0), (10.25, 0.0), (10.75, 1.0), (40.0, 0.0)]),
            told(FOLD_Y, &[(10.5, 1.0), (70.5, 0.0)]),
            told(LATE, &[(40.0, 511.0), (70.25, 1.0)]),
            told(HOLD, &[(0.0, 3.0), (10.25, 17.0), (10.75, 3.0), (40.0, 17.0), (70.5, 4.0)]),
        ]
    };
    let at = |text: &str| places(&found(text, waves()));
    assert_eq!(at("fold x"), [(-0.3, 0), (10.25, 11), (10.75, 11), (40.0, 40)]);
    assert_eq!(at("fold x = 0"), [(10.25, 11), (40.0, 40)]);
    assert_eq!(at("fold").len(), 6);
    assert_eq!(at("fold y"), at("sweep.fold.y"));
    assert_eq!(at("late-load"), [(40.0, 40), (70.25, 71)]);
    assert_eq!(at("dpu.late > 100"), [(40.0, 40)]);
    // Once a sample, however often; the last instant says when.
    assert_eq!(at("fold x and fold y"), [(10.5, 11)]);
    assert_eq!(at("fold y and fold x"), [(10.5, 11)]);
    assert_eq!(at("fold y and late-load"), [(70.5, 71)]);
    // What comes and goes between two samples is no state, but an edge.
    assert_eq!(at("tg.red.hold = 17"), [(40.0, 40)]);
    assert_eq!(at("rising tg.red.hold 17"), [(10.25, 11), (40.0, 40)]);
    assert_eq!(at("late-load and tg.red.hold = 17"), [(40.0, 40)]);
    let hit = &found("fold and late-load", waves())[0];
    let values: Vec<(&str, f64)> = hit.readings.iter().map(|told| (told.signal.name, told.value)).collect();
    assert_eq!(values, [("sweep.fold.x", 0.0), ("dpu.late", 511.0)]);
}

#[test]
fn clauses_are_met_at_the_same_sample() {
    let waves = || [ramp(), gate(&[10..30, 60..70])];
    let at = |text: &str| places(&found(text, waves()));
    assert_eq!(at("tg.height > 1701 and dpp.blank"), [(25.25, 26), (60.0, 60)]);
    assert_eq!(at("dpp.blank and tg.height > 1701"), at("tg.height > 1701 and dpp.blank"));
    assert_eq!(at("blank and tg.height > 1701"), [(60.0, 60)]);
    assert_eq!(at("rising tg.height 1701 and dpp.blank = 0"), []);
    assert_eq!(at("rising tg.height 1701 and dpp.blank = 1"), [(25.25, 26)]);
}

#[test]
fn saturation_is_that_of_the_amplifiers_or_full_scale() {
    let dark = || wave(LIGHT, (0..SAMPLES).map(|k| if k == 80 { -1.0 } else { 0.5 }));
    let any = found("saturation", [ramp(), dark()]);
    assert_eq!(any.len(), 1);
    assert_eq!((any[0].sample, any[0].readings[0].signal.name), (50, "tg.height"));
    let clipped = trigger_behind("saturation", Some(19.0)).find(&sweep([ramp(), dark()]), 0..SAMPLES);
    assert_eq!(places(&clipped)[0].1, 95);
    let own = found("saturation tg.reflectivity", [dark()]);
    assert_eq!((own.len(), own[0].sample), (1, 80));
    // At -1, full scale of the other sign, while the ramp is at its own: two names are told.
    let two = found("saturation and tg.reflectivity < 0", [ramp(), dark()]);
    assert_eq!((two.len(), two[0].readings.len()), (1, 2));
}

#[test]
fn lines_of_the_display_are_samples_of_their_own() {
    let written = wave(WRITE, (0..30).map(|line| f64::from(line) / 30.0));
    let hits = trigger("sm.write > 0.51").find(&[written], 0..SAMPLES);
    assert_eq!((hits.len(), hits[0].sample, hits[0].range), (1, 16, None));
    assert!(Condition::parse("sm.write > 0.51", &TABLE).unwrap().is_of_display());
    assert_eq!(trigger("sm.write > 0.51").signals(), ["sm.write"]);
}

#[test]
fn only_what_is_named_is_looked_at() {
    assert_eq!(trigger("tg.height > 1 and late-load").signals(), ["tg.height", "dpu.late", "sweep.range"]);
    assert_eq!(trigger("saturation").signals(), ["tg.height", "tg.reflectivity", "sweep.range"]);
}

#[test]
fn what_holds_where_the_trigger_is_armed_is_found_there() {
    let of =
        |text: &str, armed| places(&trigger(text).find(&sweep([ramp(), gate(&[10..30, 98..99])]), armed));
    assert_eq!(of("tg.height > 1701", 50..60), [(50.0, 50)]);
    assert_eq!(of("tg.height > 1701", 20..26), []);
    assert_eq!(of("rising tg.height 1701", 27..60), []);
    assert_eq!(of("dpp.blank", 20..25), [(20.0, 20)]);
    assert_eq!(of("dpp.blank", 99..2000), []);
    assert_eq!(of("dpp.blank", 100..2000), []);
}

/// A mission of noisy sweeps from a seed.
fn mission(seed: u64, sweeps: u64) -> Vec<Vec<Waveform>> {
    let noise = |sweep: u64, k: usize| {
        let mut bits = (seed * 1_000_003 + sweep * 8191 + k as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        bits = (bits ^ (bits >> 31)).wrapping_mul(0xd6e8_feb8_6659_fd93);
        (bits >> 40) as f64 / (1u64 << 24) as f64
    };
    let one = |number: u64| {
        let height = wave(HEIGHT, (0..SAMPLES).map(|k| 1600.0 + 100.0 * noise(number, k)));
        let blank = wave(BLANK, (0..SAMPLES).map(|k| f64::from(u8::from(noise(number, k + 1000) > 0.5))));
        let fold = (0..20).map(|k| (f64::from(k) * 5.0 + 4.0 * noise(number, 2000), f64::from(k % 2)));
        sweep([height, blank, told(FOLD_X, &fold.collect::<Vec<_>>())])
    };
    (0..sweeps).map(one).collect()
}

fn search(trigger: &Trigger, which: Which, sweeps: &[Vec<Waveform>]) -> Vec<(u64, Hit)> {
    let mut search = Search::new(trigger, which, 0..SAMPLES);
    sweeps.iter().flat_map(|waveforms| search.look_at(waveforms)).collect()
}

const TEXTS: [&str; 9] = [
    "tg.height > 1690",
    "rising tg.height 1650 by 20",
    "falling tg.height 1650",
    "tg.height leaves 1610..1690",
    "dpp.blank shorter 3",
    "dpp.blank longer 3 and tg.height > 1630",
    "fold x and tg.height > 1650",
    "slope tg.height < -20/m and dpp.blank",
    "blank and fold x",
];

proptest! {
    #[test]
    fn the_nth_is_the_nth_of_all(seed in 0u64..1000, text in 0..TEXTS.len(), nth in 1u64..60) {
        let (trigger, sweeps) = (trigger(TEXTS[text]), mission(seed, 6));
        let all = search(&trigger, Which::All, &sweeps);
        prop_assert!(all.iter().zip(1..).all(|((number, _), expected)| *number == expected));
        let one = search(&trigger, Which::Nth(nth), &sweeps);
        let expected: Vec<(u64, Hit)> = all.into_iter().filter(|(number, _)| *number == nth).collect();
        prop_assert_eq!(one, expected);
    }

    #[test]
    fn where_a_mission_is_divided_changes_nothing(seed in 0u64..1000, text in 0..TEXTS.len(), at in 0usize..=6) {
        let (trigger, sweeps) = (trigger(TEXTS[text]), mission(seed, 6));
        let hits = |part: &[Vec<Waveform>]| -> Vec<Hit> {
            search(&trigger, Which::All, part).into_iter().map(|(_, hit)| hit).collect()
        };
        let (before, after) = sweeps.split_at(at);
        prop_assert_eq!(hits(&sweeps), [hits(before), hits(after)].concat());
    }

    #[test]
    fn a_hit_is_a_sample_at_which_everything_holds(seed in 0u64..1000, level in 1605.0..1695.0_f64) {
        let text = format!("tg.height > {level} and dpp.blank");
        for sweep in mission(seed, 3) {
            let value = |name: &str, k: usize| sweep.iter().find(|wave| wave.signal.name == name).unwrap().values[k];
            let holds = |k: usize| value("tg.height", k) > level && value("dpp.blank", k) > 0.5;
            let expected: Vec<usize> = (0..SAMPLES).filter(|&k| holds(k) && (k == 0 || !holds(k - 1))).collect();
            let hits = trigger(&text).find(&sweep, 0..SAMPLES);
            prop_assert_eq!(hits.iter().map(|hit| hit.sample).collect::<Vec<_>>(), expected);
            for hit in &hits {
                prop_assert!(hit.time <= hit.sample as f64 && hit.time >= hit.sample as f64 - 1.0);
            }
        }
    }

    #[test]
    fn no_text_makes_the_parser_stumble(text in "([a-z.><=!/ 0-9é-]|tg\\.height|and|rising|in|\\.\\.){0,12}") {
        if let Err(error) = Condition::parse(&text, &TABLE) {
            prop_assert!(error.to_string().lines().count() == 3, "{}", error);
        }
    }
}
