//! More of what the hardware report says of some artefacts: proportions, and what they leave alone.

use hardware_model::{HardwareModel, ModelSource};

use crate::artefacts::causes::{faulty, model};
use crate::artefacts::detectors::{array, beam, late, picture};
use crate::artefacts::look::{Look, Run, largest, mean, median};
use crate::artefacts::scene::facing;
use crate::artefacts::scenes::{BOWL, Place, WAVE, turning_at};

/// A scene under the ideal machine with some settings.
fn set<T>(place: Place, settings: &[(&str, &str)], at: impl FnOnce(&Look<'_>) -> T) -> T {
    let sets: Vec<(String, String)> =
        settings.iter().map(|(key, value)| (key.to_string(), value.to_string())).collect();
    let loaded = HardwareModel::load(&ModelSource::BuiltIn("ideal".into()), &[], &sets);
    let scene = place.scene();
    let clean = Run::of(&scene, &model(None));
    let run = Run::of(&scene, &loaded.unwrap_or_else(|e| panic!("{e}")).model);
    at(&Look { scene: &scene, clean: &clean, run: &run })
}

fn near(found: f64, expected: f64, within: f64) {
    assert!((found - expected).abs() <= within, "{found}, expected {expected} within {within}");
}

/// A5: nothing is missing from a turn that the drum can follow.
#[test]
fn a_slow_turn_starves_nobody() {
    let scene = turning_at(|scene, _, time| facing(scene, time, quantities::radians(5.0 * time), 0.0));
    let [clean, run] = [model(None), faulty(5)].map(|model| Run::of(&scene, &model));
    let found = late::drum_starvation(&Look { scene: &scene, clean: &clean, run: &run });
    assert!(found < 2.0, "{found} corners a frame");
}

/// A12: no word is off by more than half a step, and a bit halves the step.
#[test]
fn a_bit_more_halves_the_steps() {
    for (bits, step) in [("6", 1.0), ("7", 0.5), ("8", 0.25), ("9", 0.125)] {
        let errors = set(Place::Rows, &[("multiplying_dac.bits", bits)], |look| {
            array::row_heights(look)
                .into_iter()
                .map(|[found, right]| (found - right).abs())
                .collect::<Vec<_>>()
        });
        let most = largest(errors);
        assert!(most <= 0.5001 * step && most > 0.35 * step, "{bits} bits: {most} m");
    }
}

/// A13: edges move with the delay, down to a small part of a sample; those into shadow as those out of it.
#[test]
fn edges_move_in_proportion_and_shadows_keep_their_width() {
    for delay in [4.0, 40.0, 160.0, 400.0] {
        let text = delay.to_string();
        set(Place::Strips, &[("comparator.delay_ns", &text)], |look| {
            let expected = delay * 1e-3 * look.speed() / look.pace();
            let behind = look.own().flat_map(|sweep| beam::edges(look, sweep)).map(|edge| edge.behind);
            let behind: Vec<f64> = behind.collect();
            // A signal at its samples tells an edge to half a sample, many edges to a part of that.
            behind.iter().for_each(|&behind| near(behind, expected, 0.501));
            near(mean(&behind), expected, 0.15);
        });
    }
}

/// A13: rims of craters move as edges of shadow do. Along a sweep over the centre of a footprint of radius R a comparator sees
/// a slope of `2 v / R`.
#[test]
fn footprints_move_with_the_delay_and_with_the_overdrive() {
    for (delay, overdrive) in [(40.0, 0.0), (160.0, 0.0), (400.0, 0.0), (40.0, 1500.0), (40.0, 4000.0)] {
        let texts = [delay, overdrive].map(|value: f64| value.to_string());
        let sets =
            [("comparator.delay_ns", texts[0].as_str()), ("comparator.overdrive_mv_ns", texts[1].as_str())];
        set(Place::Bowls, &sets, |look| {
            // Millivolts of 1 V times nanoseconds, in full scales times microseconds.
            let slope = 2.0 * look.speed() / BOWL;
            let wait = (2.0 * overdrive * 1e-6 / slope).sqrt();
            let expected = (delay * 1e-3 + wait) * look.speed() / look.pace();
            let behind: Vec<f64> = look.own().flat_map(|sweep| beam::rims(look, sweep)).collect();
            // A signal at its samples tells a rim to half a sample, three of them to a quarter.
            behind.iter().for_each(|&behind| near(behind, expected, 0.501));
            near(mean(&behind), expected, 0.25);
        });
    }
}

/// A14: the beam goes on for the delay, and at a round crest of bend c (full scales a µs²) for `(6 k_od / c)^(1/3)` more.
#[test]
fn the_beam_goes_on_behind_a_crest_in_proportion_to_its_causes() {
    for delay in [100.0, 200.0, 400.0] {
        let text = delay.to_string();
        let found = set(Place::Waves, &[("comparator.delay_ns", &text)], beam::crest_overdraw);
        near(found, delay * 1e-3, 0.017);
    }
    let mut last = 0.0;
    for overdrive in [4.0_f64, 32.0] {
        let text = overdrive.to_string();
        let sets = [("comparator.delay_ns", "100"), ("comparator.overdrive_mv_ns", text.as_str())];
        let [found, expected] = set(Place::Waves, &sets, |look| {
            // Millivolts of 1 V times nanoseconds, in full scales times microseconds.
            let waits =
                beam::crest_bends(look).into_iter().map(|bend| libm::cbrt(6.0 * overdrive * 1e-6 / bend));
            let waits: Vec<f64> = waits.map(|wait| 0.1 + wait.min(0.4)).collect();
            [beam::crest_overdraw(look), median(&waits)]
        });
        near(found, expected, 0.03);
        assert!(found > last + 0.03, "{found} after {last}");
        last = found;
    }
}

/// A6: what a chain is late by beside its trim moves crests: by the phase of its lags, less their delay.
#[test]
fn crests_are_displaced_by_what_the_trim_leaves() {
    let scene = Place::Waves.scene();
    let [clean, run] = [model(None), faulty(6)].map(|model| Run::of(&scene, &model));
    let look = Look { scene: &scene, clean: &clean, run: &run };
    let turn = 2.0 * std::f64::consts::PI * look.speed() / WAVE[0];
    let tau = 1.0 / (2.0 * std::f64::consts::PI * 0.5);
    let late = |tau: f64| libm::atan(turn * tau) / turn - tau;
    let expected = look.speed() * (late(tau) + late(2.0 * tau));
    near(array::ridge_displacement(&look), expected, 0.1 * expected.abs());
    assert!(expected < -2.0, "towards the viewer: {expected} m");
}

/// A20: two frames on the residue is the square, and it lies where the ground was.
#[test]
fn residue_fades_by_its_share_with_every_frame() {
    for residual in [0.08_f64, 0.4] {
        let text = residual.to_string();
        set(Place::Pictures, &[("sweep_memory.erase_residual", &text)], |look| {
            for (age, left) in [(1, residual), (2, residual * residual)] {
                near(picture::residue_after(look, age), left, 1e-3);
            }
        });
    }
}

/// A21: the field of a tube stays, and two tubes take turns.
#[test]
fn two_tubes_have_two_fields_in_turn() {
    let scene = Place::Pictures.scene();
    let [clean, run] = [model(None), faulty(21)].map(|model| Run::of(&scene, &model));
    let look = Look { scene: &scene, clean: &clean, run: &run };
    let spread = parts::Spread::new(1970);
    let lines = f64::from(clean.settings.raster.lines);
    for frame in 0..3 {
        let error = |part| spread.error(&format!("sweep-memory.{part}-along"), frame as u64 % 2, 0.03);
        let (shift, scale) = (lines * error("shift"), error("scale"));
        let line = picture::horizon_line(&clean, frame);
        // The reading beam at line l is at l + shift + scale (l - middle) of what was written.
        let read = (line - shift + scale * 0.5 * lines) / (1.0 + scale);
        // A sharp spot is placed to a tenth of a cell, twice on the way to a line of the picture.
        near(picture::displacement(&look, frame)[0], read - line, 0.25);
    }
}

/// A22: what is lit stays; what is dark is grey by one level.
#[test]
fn a_seam_is_one_step_of_level() {
    let place = Place::Strips.scene();
    let [clean, run] = [model(None), faulty(22)].map(|model| Run::of(&place, &model));
    let look = Look { scene: &place, clean: &clean, run: &run };
    let (mut dark, mut lit) = (Vec::new(), Vec::new());
    for edge in look.own().flat_map(|sweep| beam::edges(&look, sweep)) {
        dark.push(edge.levels[0].min(edge.levels[1]));
        lit.push(edge.levels[0].max(edge.levels[1]));
    }
    near(mean(&lit), libm::sin(place.sun.elevation), 1e-9);
    let level = parts::Spread::new(1970).error("mu.vs2.level", 0, 0.1);
    near(mean(&dark), level, 1e-9);
    near(largest(dark.iter().copied()), mean(&dark), 1e-9);
}

/// A25: behind a flat top the overload goes as the amplifier recovers, by 1/e in a microsecond.
#[test]
fn an_overload_leaves_a_tail() {
    let scene = Place::Rows.scene();
    let [clean, run] = [model(None), faulty(25)].map(|model| Run::of(&scene, &model));
    let look = Look { scene: &scene, clean: &clean, run: &run };
    let top = 0.5 * array::FULL_SCALE;
    let mut points = Vec::new();
    for sweep in look.own() {
        let (error, height) = (look.error(sweep), clean.wave(sweep, "tg.height"));
        let Some(end) = (1..height.len()).find(|&k| height[k - 1] > top && height[k] <= top) else {
            continue;
        };
        let found = run.wave(sweep, "tg.height");
        let tail = (end..height.len()).skip_while(|&k| found[k] > 0.999 * top);
        let tail: Vec<usize> = tail.take_while(|&k| height[k] > -0.9 * top && error[k] > 0.0).collect();
        points.extend(tail.iter().map(|&k| [(k - end) as f64 * clean.sample(), libm::log(error[k])]));
    }
    assert!(points.len() > 50, "{}", points.len());
    near(beam::slope(&points), -1.0, 0.1);
}
