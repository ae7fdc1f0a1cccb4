//! The third switch against trapezoids, and against the overlay without faults.

use hardware_model::AnalogParts;
use proptest::prelude::{prop_assert, proptest};

use super::{BodyFade, PartsSwitch};
use crate::Run;

/// Lines a second: half a line in 50 ns.
const RATE: f64 = 1e7;
const LINES: usize = 40;

fn switch(change: impl FnOnce(&mut AnalogParts)) -> PartsSwitch {
    let mut parts = AnalogParts::ideal();
    change(&mut parts);
    PartsSwitch::new(RATE, &parts, 1970)
}

fn run(top: f32, bottom: f32, reflectivity: f32) -> Run {
    Run { top, bottom, reflectivity, ramp: 0.0 }
}

fn write(switch: &PartsSwitch, runs: &[Run], ground: f32) -> Vec<f32> {
    let mut row = vec![ground; LINES];
    switch.write(runs, &mut BodyFade::default(), &mut row);
    row
}

/// What is translucent lets its share of the ground through, and an ideal switch errs in nothing.
#[test]
fn a_translucent_run_adds_its_light_to_what_it_lets_through() {
    let mut row = vec![0.5; LINES];
    switch(|_| {}).write_through(&[run(10.25, 12.5, 0.3)], 0.6, &mut BodyFade::default(), &mut row);
    for (line, cover) in [(9, 0.0), (10, 0.75), (11, 1.0), (12, 0.5), (13, 0.0)] {
        let expected = 0.5 * (1.0 - cover * 0.4) + cover * 0.3;
        assert!((row[line] - expected).abs() < 1e-6, "{line}: {} {expected}", row[line]);
    }
}

/// How much is there of what covers `ground` with `face`, and where its middle is (lines from the top).
fn body(row: &[f32], ground: f32, face: f32) -> [f64; 2] {
    let share = |value: &f32| f64::from((value - ground) / (face - ground));
    let area: f64 = row.iter().map(share).sum();
    let moment: f64 = row.iter().enumerate().map(|(line, value)| (line as f64 + 0.5) * share(value)).sum();
    [area, moment / area]
}

proptest! {
    /// Without faults: the share of each line that a run covers.
    #[test]
    fn ideal_parts_lay_runs_as_they_are(tops in proptest::collection::vec((0.1..6.0_f32, 0.0..1.0_f32, 0.0..1.0_f32), 1..6)) {
        let (mut runs, mut at) = (Vec::new(), 0.3);
        for (length, gap, face) in tops {
            let begin = if gap < 0.5 { at } else { at + gap };
            runs.push(run(begin, begin + length, face));
            at = begin + length;
        }
        let row = write(&switch(|_| {}), &runs, 0.5);
        for (line, value) in row.iter().enumerate() {
            let (top, bottom) = (line as f32, line as f32 + 1.0);
            let cover = |run: &Run| (run.bottom.min(bottom) - run.top.max(top)).max(0.0);
            let all: f32 = runs.iter().map(cover).sum();
            let expected = 0.5 * (1.0 - all) + runs.iter().map(|run| cover(run) * run.reflectivity).sum::<f32>();
            prop_assert!((value - expected).abs() < 1e-5, "{line}: {value} {expected}");
        }
    }

    /// A transition softens, and displaces nothing; a comparator's delay moves bodies up by its lines.
    #[test]
    fn edges_are_soft_and_late(top in 8.0..12.0_f32, height in 8.0..15.0_f32, transition in 0.0..600e-9_f64, delay in 0.0..400e-9_f64) {
        let slow = switch(|parts| {
            parts.video_switch.time = transition;
            parts.comparator.delay = delay;
        });
        let [area, middle] = body(&write(&slow, &[run(top, top + height, 0.9)], 0.2), 0.2, 0.9);
        prop_assert!((area - f64::from(height)).abs() < 1e-4, "{area}");
        let expected = f64::from(top + height / 2.0) - delay * RATE;
        // Of the shares of a line the place within it is not known: a twelfth of it over the height.
        prop_assert!((middle - expected).abs() < 0.26 / f64::from(height), "{middle} {expected}");
    }
}

#[test]
fn a_fade_is_a_straight_line_of_its_lines() {
    // 400 ns are four lines, centred on the lower edge at 30: lines 28 to 31.
    let row = write(&switch(|parts| parts.video_switch.time = 400e-9), &[run(10.0, 30.0, 1.0)], 0.0);
    for (line, expected) in
        [(27, 1.0), (28, 0.875), (29, 0.625), (30, 0.375), (31, 0.125), (32, 0.0), (8, 0.125)]
    {
        assert!((row[line] - expected).abs() < 1e-6, "{line}: {}", row[line]);
    }
}

#[test]
fn a_late_gate_holds_the_last_face() {
    let late = switch(|parts| parts.comparator.delay = 200e-9);
    let row = write(&late, &[run(10.0, 20.0, 0.25), run(20.0, 30.0, 0.75)], 0.5);
    // Two lines late: ground at the foot, the upper face two lines longer, the joint of the faces where it was.
    let expected = [(29, 0.5), (28, 0.5), (27, 0.75), (20, 0.75), (19, 0.25), (8, 0.25), (7, 0.5)];
    assert!(expected.iter().all(|&(line, value)| (row[line] - value).abs() < 1e-6), "{row:?}");
}

#[test]
fn level_and_gain_are_those_of_the_part() {
    let step = |change: &dyn Fn(&mut AnalogParts), face: f32| {
        write(&switch(change), &[run(10.0, 30.0, face)], 0.5)[20] - face
    };
    let level = |face: f32| step(&|parts| parts.video_switch.level_mismatch = 0.02, face);
    let gain = |face: f32| step(&|parts| parts.video_switch.gain_mismatch = 0.02, face);
    assert!((level(0.3) - level(0.6)).abs() < 1e-6 && level(0.3).abs() > 1e-4);
    assert!((gain(0.6) - 2.0 * gain(0.3)).abs() < 1e-6 && gain(0.3).abs() > 1e-4);
    assert_eq!(write(&switch(|_| {}), &[], 0.5), [0.5; LINES]);
}

/// Without faults a ramp lays its mean over each line; with a slow switch the product with the fade is integrated.
#[test]
fn a_ramp_goes_through_the_switch() {
    let ramp = Run { top: 10.25, bottom: 20.5, reflectivity: 0.8, ramp: -0.05 };
    let row = write(&switch(|_| {}), &[ramp], 0.0);
    for (line, value) in row.iter().enumerate() {
        let [top, bottom] = [(line as f32).max(ramp.top), (line as f32 + 1.0).min(ramp.bottom)];
        let expected = (bottom - top).max(0.0) * (0.8 - 0.05 * (0.5 * (top + bottom) - ramp.top));
        assert!((value - expected).abs() < 1e-6, "{line}: {value} {expected}");
    }
    // The fade of 400 ns takes four lines; it and the face by sums of small steps.
    let row = write(&switch(|parts| parts.video_switch.time = 4e-7), &[ramp], 0.0);
    let steps = 4000;
    for (line, value) in row.iter().enumerate() {
        let lit = |step: usize| {
            let at = line as f32 + (step as f32 + 0.5) / steps as f32;
            let edge = |from: f32| ((at - from) / 4.0 + 0.5).clamp(0.0, 1.0);
            let gate = edge(ramp.top) - edge(ramp.bottom);
            gate * (0.8 - 0.05 * (at.clamp(ramp.top, ramp.bottom) - ramp.top))
        };
        let expected = (0..steps).map(lit).sum::<f32>() / steps as f32;
        assert!((value - expected).abs() < 1e-4, "{line}: {value} {expected}");
    }
}
