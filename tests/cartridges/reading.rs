//! What is read off a run, and whether it is what the cartridge says.

use lunoid_tests::Drawn;
use serde::Deserialize;
use sweep_program::Fan;

use crate::formula::{Along, Horizon, lambert};
use crate::schema::{Expect, Variant};

#[derive(Debug, Clone, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Reading {
    /// A signal at every sample of every sweep. Tolerance: part of full scale.
    Signal { signal: String, formula: Along },
    /// A signal of sweep 0 at some ground ranges, each of which is a sample. Tolerance: in the signal's unit.
    Samples { signal: String, at_m: Vec<f64>, values: Vec<f64> },
    /// Ground ranges at which a ramp of sweep 0 turns, between samples. Tolerance: m.
    Turns { signal: String, at_m: Vec<f64> },
    /// Folds of the frame.
    Folds { count: u64 },
    /// Where ground of one brightness ends, in every column. Tolerance: lines.
    HorizonLine { formula: Horizon },
    /// Brightness of ground, on lines `first..=last` of every column. Tolerance: reflectivity.
    Brightness { first_line: usize, last_line: usize },
    /// Ground that is hidden in the middle column; what is seen lies on both sides. Tolerance: m, at each end.
    Hidden { between_m: [f64; 2] },
    /// Ground range up to which ground is seen in every sweep, `sqrt(2 R H)`. Tolerance: part of it.
    LunoidHorizonRange,
}

/// What is wrong with `drawn`, if `meant` is what was to be drawn.
pub fn fault(expect: &Expect, meant: &Variant, drawn: &Drawn) -> Option<String> {
    let tolerance = expect.tolerance;
    match &expect.read {
        Reading::Signal { signal, formula } => along(meant, drawn, signal, *formula, tolerance),
        Reading::Samples { signal, at_m, values } => {
            let found = at_m.iter().map(|&range| sample(drawn, signal, range)).collect::<Vec<_>>();
            differ(signal, &found, values, tolerance)
        }
        Reading::Turns { signal, at_m } => {
            let turns = turns(wave(drawn, "sweep.range", 0), wave(drawn, signal, 0));
            differ(&format!("turns of {signal}"), &turns, at_m, tolerance)
        }
        Reading::Folds { count } => {
            differ("folds", &[drawn.counts.folds as f64], &[*count as f64], tolerance)
        }
        Reading::HorizonLine { formula } => horizon(meant, drawn, *formula, tolerance),
        Reading::Brightness { first_line, last_line } => {
            let columns = meant.file.sweeps as usize;
            let ground = &drawn.picture[first_line * columns..(last_line + 1) * columns];
            let found: Vec<_> = ground.iter().map(|&value| f64::from(value)).collect();
            differ("brightness", &found, &vec![lambert(meant); found.len()], tolerance)
        }
        Reading::Hidden { between_m } => hidden(meant, drawn, *between_m, tolerance),
        Reading::LunoidHorizonRange => horizon_range(meant, drawn, tolerance),
    }
}

/// The first of two lists' values that are further apart than allowed.
fn differ(what: &str, found: &[f64], expected: &[f64], allowed: f64) -> Option<String> {
    if found.len() != expected.len() {
        return Some(format!("{what}: found {found:?}, expected {expected:?}"));
    }
    let mut pairs = found.iter().zip(expected).enumerate();
    let (index, (found, expected)) = pairs.find(|(_, (found, expected))| {
        let agree = (*found - *expected).abs() <= allowed;
        !agree
    })?;
    Some(format!("{what} [{index}]: found {found}, expected {expected}, allowed {allowed:e}"))
}

fn wave<'a>(drawn: &'a Drawn, signal: &str, sweep: u32) -> &'a [f64] {
    let mut waves = drawn.waveforms.iter();
    let wave = waves.find(|wave| wave.sweep == sweep && wave.signal.name == signal);
    &wave.unwrap_or_else(|| panic!("{signal} of sweep {sweep} was not recorded")).values
}

fn sample(drawn: &Drawn, signal: &str, range: f64) -> f64 {
    let ranges = wave(drawn, "sweep.range", 0);
    let at = ranges.iter().position(|found| (found - range).abs() < 1e-9 * range);
    wave(drawn, signal, 0)[at.unwrap_or_else(|| panic!("no sample at {range} m"))]
}

fn along(meant: &Variant, drawn: &Drawn, signal: &str, formula: Along, tolerance: f64) -> Option<String> {
    let scene = meant.scene();
    let fan = Fan::covering(scene.laws.projection, scene.pitch, &scene.field, scene.sweeps)?;
    let (sin, cos) = quantities::sin_cos(scene.heading);
    (0..scene.sweeps).find_map(|sweep| {
        let direction = fan.direction(sweep, [cos, sin]);
        let value = |&range: &f64| {
            formula.at(meant, range, [0, 1].map(|axis| scene.eye[axis] + range * direction[axis]))
        };
        let expected: Vec<_> = wave(drawn, "sweep.range", sweep).iter().map(value).collect();
        let scale = expected.iter().fold(f64::MIN_POSITIVE, |largest, value| value.abs().max(largest));
        let scale = full_scale(meant).unwrap_or(scale);
        let what = format!("{signal} of sweep {sweep}");
        differ(&what, wave(drawn, signal, sweep), &expected, tolerance * scale)
    })
}

/// Full scale that does not depend on the sweep: a single word's own size.
fn full_scale(meant: &Variant) -> Option<f64> {
    match meant.ground {
        crate::ground::Ground::OneWord { value_m, .. } => Some(value_m.abs()),
        _ => None,
    }
}

/// Where the straight pieces on both sides of a turn meet: they have one speed and opposite signs, and at most one
/// step between them is broken.
fn turns(ranges: &[f64], ramp: &[f64]) -> Vec<f64> {
    let slope = |k: usize| (ramp[k + 1] - ramp[k]) / (ranges[k + 1] - ranges[k]);
    let mut found: Vec<f64> = Vec::new();
    for k in 1..ramp.len() - 2 {
        let (before, after) = (slope(k - 1), slope(k + 1));
        if (before + after).abs() > 1e-6 * before.abs() {
            continue;
        }
        let turn = (ramp[k + 1] - ramp[k] - after * ranges[k + 1] + before * ranges[k]) / (before - after);
        // A turn that falls on a sample has no broken step and is found from both sides.
        if found.last().is_none_or(|last| turn - last > 1e-6 * turn) {
            found.push(turn);
        }
    }
    found
}

fn horizon(meant: &Variant, drawn: &Drawn, formula: Horizon, tolerance: f64) -> Option<String> {
    let scene = meant.scene();
    let (columns, lines) = (scene.sweeps as usize, f64::from(scene.lines));
    let brightness = lambert(meant);
    let line = |column: usize| {
        let of_column = drawn.picture.iter().skip(column).step_by(columns);
        lines - of_column.map(|&value| f64::from(value)).sum::<f64>() / brightness
    };
    let expected = |column: usize| {
        let x = scene.field.tan_half_width * ((2 * column + 1) as f64 / columns as f64 - 1.0);
        0.5 * lines * (1.0 + formula.at(meant, x) / scene.field.tan_half_height)
    };
    let found: Vec<_> = (0..columns).map(line).collect();
    differ("horizon line", &found, &(0..columns).map(expected).collect::<Vec<_>>(), tolerance)
}

fn hidden(meant: &Variant, drawn: &Drawn, [from, to]: [f64; 2], tolerance: f64) -> Option<String> {
    let seen = ranges_seen(meant, drawn);
    if let Some(wrong) = seen.iter().find(|&&range| range > from + tolerance && range < to - tolerance) {
        return Some(format!("ground at {wrong} m is seen; expected it hidden from {from} to {to} m"));
    }
    let (near, far) = (seen.iter().any(|&range| range <= from), seen.iter().any(|&range| range >= to));
    if !(near && far) {
        return Some(format!("expected ground to be seen on both sides of {from} to {to} m"));
    }
    let all = all_ranges(drawn);
    let lost = all.iter().find(|&&range| {
        let outside = range < from - tolerance || range > to + tolerance && range < to + 20.0 * tolerance;
        outside && !seen.contains(&range)
    });
    lost.map(|range| format!("ground at {range} m is hidden; expected it hidden only from {from} to {to} m"))
}

/// Ground ranges seen in the middle column: unblanked samples, or pixels of the range plane.
fn ranges_seen(meant: &Variant, drawn: &Drawn) -> Vec<f64> {
    let (columns, middle) = (meant.file.sweeps as usize, meant.file.sweeps / 2);
    if drawn.waveforms.is_empty() {
        let pixels = drawn.ranges.iter().skip(middle as usize).step_by(columns);
        return pixels.map(|&range| f64::from(range)).filter(|range| range.is_finite()).collect();
    }
    let samples = wave(drawn, "sweep.range", middle).iter().zip(wave(drawn, "dpp.blank", middle));
    samples.filter(|(_, blank)| **blank == 0.0).map(|(&range, _)| range).collect()
}

/// Ground ranges that could be seen; of a generator without samples nothing is known.
fn all_ranges(drawn: &Drawn) -> Vec<f64> {
    if drawn.waveforms.is_empty() { Vec::new() } else { wave(drawn, "sweep.range", 0).to_vec() }
}

fn horizon_range(meant: &Variant, drawn: &Drawn, tolerance: f64) -> Option<String> {
    let expected = (2.0 * landscape::LUNOID_RADIUS * meant.file.eye_m[2]).sqrt();
    (0..meant.file.sweeps).find_map(|sweep| {
        let samples = wave(drawn, "sweep.range", sweep).iter().zip(wave(drawn, "dpp.blank", sweep));
        let seen = samples.filter(|(_, blank)| **blank == 0.0).map(|(&range, _)| range);
        let last = seen.fold(0.0, f64::max);
        differ("farthest ground", &[last], &[expected], tolerance * expected)
    })
}
