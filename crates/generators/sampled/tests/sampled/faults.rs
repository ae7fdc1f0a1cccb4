//! The overlays of one fault each: the sign that each is predicted to have, measured with it and without.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::shots::Shot;
use diagnostics::{Layers, Problems, TomlFile};
use generator::{Generator, PlaneKind};
use quantities::{Rate, radians};
use sampled::ROW;
use scenario::LightPoint;

/// The generator with run parameters (TOML) for mesh and scene, without a fault and with it.
fn pair(fault: &str, run: &str) -> [Arc<dyn Generator>; 2] {
    let gear = ROW.gear.unwrap();
    let mesh = "[sampled]\nground_half_side_m = 2000\nground_cells = 8\n";
    [None, Some(ROW.fault(fault).unwrap())].map(|fault| {
        let problems = Problems::new();
        let layers = [gear.text, mesh, run].into_iter().chain(fault);
        let files = layers.filter_map(|text| TomlFile::parse("layer", text, &problems));
        let configured = (ROW.configure)(&Layers::new(files).root(&problems));
        problems.resolve(configured).unwrap()
    })
}

/// A lamp of 1.5 pixels at a place of the screen (pixels) in a depth (m).
fn lamp(shot: &Shot, id: u32, at: [f64; 2], depth: f64, intensity: f64) -> LightPoint {
    let diameter = 1.5 * depth / 150.0;
    LightPoint { intensity, ..shot.lamp(id, at, depth, diameter) }
}

/// Least and largest light of a lamp that moves over a pixel, over its mean.
fn twinkle(generator: &dyn Generator) -> [f64; 2] {
    let mut shot = Shot::new(20, 20, 150.0);
    let light = |step: u32| {
        let at = [9.5 + f64::from(step % 100) / 100.0, 9.5 + (f64::from(step) * 0.618_034).fract()];
        shot.effects.lights = vec![lamp(&shot, 0, at, 100.0, 0.5)];
        shot.draw_by(generator).sum(PlaneKind::Red) / (0.5 * PI * 1.5 * 1.5 / 4.0)
    };
    let found: Vec<f64> = (0..200).map(light).collect();
    [found.iter().copied().fold(f64::INFINITY, f64::min), found.iter().copied().fold(0.0, f64::max)]
}

/// Six to nine of the pattern's points lie under the disc, whose area is 7.069 of them.
#[test]
fn twinkle_flickers_as_the_pattern_counts() {
    let [without, with] = pair("twinkle", "").map(|generator| twinkle(&*generator));
    assert!(without.iter().all(|share| (share - 1.0).abs() < 1e-3), "{without:?}");
    for (found, points) in with.into_iter().zip([6.0, 9.0]) {
        assert!((found - points / (PI * 1.5 * 1.5)).abs() < 2e-2, "{with:?}");
    }
}

/// Five lamps fill the five slots before a sheet. Each lets 1/2 through, so that what is lost is 1/32 of the sheet's light at most.
#[test]
fn shared_stack_pushes_a_sheet_out_and_states_the_bound() {
    let mut shot = Shot::new(20, 20, 150.0);
    let lamps = (0..5).map(|id| lamp(&shot, id, [10.0, 10.0], 50.0 + f64::from(id), 0.5));
    shot.effects.lights = lamps.collect();
    shot.effects.sheets = vec![shot.filling(0, 80.0, [0.8; 3], 0.5)];
    let [without, with] = pair("shared-stack", "[sampled]\nnormalise = false\n")
        .map(|generator| shot.draw_by(&*generator).counts);
    assert_eq!(without["lost_surfaces"], 0);
    assert!(with["lost_surfaces"] > 0 && with["lost_lights"] == 0, "{with:?}");
    // The brightest feature that could be behind is a lamp of 1/2.
    let bound = 0.8_f64.max(0.5) / 32.0;
    assert!((with["loss_bound_ppm"] as f64 - 1e6 * bound).abs() <= 1e6 * bound * 0.3, "{with:?}");
}

/// Of two lamps of 0.3 in one place the farther one is seen through the nearer: 0.7 times 0.3 of its flux is lost.
#[test]
fn one_light_loses_the_light_of_the_farther_lamp() {
    let mut shot = Shot::new(20, 20, 150.0);
    shot.effects.lights =
        vec![lamp(&shot, 0, [10.3, 9.8], 50.0, 0.3), lamp(&shot, 1, [10.3, 9.8], 60.0, 0.3)];
    let run = "[sampled]\nlights = -1\nnormalise = false\n";
    let [without, with] = pair("one-light", run).map(|generator| shot.draw_by(&*generator));
    let [all, kept] = [&without, &with].map(|frame| frame.sum(PlaneKind::Red));
    assert!((kept / all - 0.3 / (0.3 + 0.7 * 0.3)).abs() < 1e-6, "{kept} of {all}");
    assert_eq!(without.counts["lost_lights"], 0);
    assert!(with.counts["lost_lights"] > 0);
}

/// Twelve sheets over every sub-area: a list of eight places keeps eight of at least twelve triangles.
#[test]
fn short_list_keeps_eight_triangles_a_sub_area() {
    let mut shot = Shot::new(32, 32, 150.0);
    shot.effects.sheets = (0..12).map(|id| shot.filling(id, 60.0 + f64::from(id), [0.5; 3], 0.9)).collect();
    let [without, with] = pair("short-list", "").map(|generator| shot.draw_by(&*generator).counts);
    assert_eq!((without["lost_entries"], with["entries"]), (0, 16 * 8));
    assert_eq!(with["lost_entries"], without["entries"] - 16 * 8);
}

/// Over an empty sky each of 64 sub-areas takes the least time, 8 ticks, and the pixels of the last another 8. A frame has 1000 ticks
/// of the shipped clock, and 250 of the slow one.
#[test]
fn slow_sampler_comes_late_as_its_ticks_say() {
    let mut shot = Shot::new(64, 64, 150.0);
    shot.pose.attitude.pitch = radians(60.0);
    shot.view.update = Rate::new(40_000, 1).unwrap();
    let late = pair("slow-sampler", "").map(|generator| {
        let timed = generator.timed(shot.stage()).unwrap().unwrap();
        let misses = timed.frame(0, &shot.pose).unwrap().misses;
        let rows = misses.into_iter().filter(|missed| missed.deadline.word() == "sub-area");
        rows.map(|missed| missed.sweep).collect::<Vec<_>>()
    });
    let is_late = move |number: &u32, frame: u32| 8 * (number + 1) + 8 > frame * (number / 8 + 1) / 8;
    let expected =
        [1000, 250].map(|frame| (0..64).filter(move |number| is_late(number, frame)).map(|n| n / 8));
    assert_eq!(late, expected.map(Iterator::collect::<Vec<u32>>));
    assert!(late[0].is_empty() && late[1].iter().filter(|row| **row == 7).count() == 8);
}

/// The mean of an edge over all its places in a pixel is shifted by as much as the pattern is off centre, 1/32 pixel in each direction.
#[test]
fn off_centre_shifts_every_edge() {
    let mean = |generator: &dyn Generator| {
        let mut shot = Shot::new(16, 16, 150.0);
        let covered = |step: u32| {
            let edge = 8.0 + (f64::from(step) + 0.5) / 64.0;
            let corners = [[-2.0, -2.0], [edge, -2.0], [edge, 18.0], [-2.0, 18.0]];
            shot.effects.sheets = vec![shot.sheet(0, &corners, 10.0, [1.0; 3], 0.0)];
            shot.draw_by(generator).sum(PlaneKind::Red) / 16.0 - edge
        };
        (0..64).map(covered).sum::<f64>() / 64.0
    };
    let [without, with] =
        pair("off-centre", "[sampled]\npattern = \"16\"\n").map(|generator| mean(&*generator));
    assert!(without.abs() < 1e-3, "{without}");
    assert!((with.abs() - 1.0 / 32.0).abs() < 1e-3, "{with}");
}

/// The nearer lamp lets 0.2 of the farther one's light through; the narrow veil lets all of it through.
#[test]
fn stack_only_lets_a_lamp_shine_through_a_nearer_one() {
    let mut shot = Shot::new(20, 20, 150.0);
    let beam = |id, depth, intensity| LightPoint {
        calligraphic: true,
        ..lamp(&shot, id, [10.0, 10.0], depth, intensity)
    };
    shot.effects.lights = vec![beam(0, 50.0, 0.8), beam(1, 60.0, 0.6)];
    let shares = pair("stack-only", "").map(|generator| {
        let list = generator.prepare(shot.stage()).unwrap().beam_list(0, &shot.pose).unwrap().unwrap();
        list.iter().map(|point| point.display_intensity / point.intensity).collect::<Vec<_>>()
    });
    for (found, expected) in shares.into_iter().zip([[1.0, 0.2], [1.0, 1.0]]) {
        assert!(
            found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-9),
            "{found:?}"
        );
    }
}
