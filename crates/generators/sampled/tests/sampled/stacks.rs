//! Check values of stacks, through whole pictures (specification of the sampled generator).

use crate::shots::{Shot, is_same};
use scenario::{LightPoint, Sheet};

const FAWN: [f64; 3] = [0.9, 0.8, 0.6];
const SLATE: [f64; 3] = [0.2, 0.2, 0.3];
const GROUND: [f64; 3] = [0.4, 0.35, 0.3];

/// A small screen high above the ground, whose lamps are drawn as they are, without normalising.
fn plain() -> Shot {
    let mut shot = Shot::new(11, 9, 20.0);
    shot.pose.eye[2] = 100.0;
    shot.run.sampling.normalise = false;
    shot
}

/// A lamp in the middle that covers the screen.
fn wide_lamp(shot: &Shot, id: u32, depth: f64, intensity: f64, colour: [f64; 3]) -> LightPoint {
    LightPoint { intensity, colour, ..shot.lamp(id, [5.5, 4.5], depth, 2.0 * depth) }
}

fn check(shot: &Shot, expected: [f64; 3]) {
    let frame = shot.draw();
    for index in 0..11 * 9 {
        let found = frame.colour(index);
        assert!(found.iter().zip(expected).all(|(found, expected)| is_same(*found, expected)), "{found:?}");
    }
}

#[test]
fn three_sheets_one_before_another() {
    for (shares, colours, expected) in [
        ([0.7, 0.5, 0.0], [FAWN, SLATE, GROUND], [0.48, 0.4325, 0.39]),
        ([0.5, 0.7, 0.0], [SLATE, FAWN, GROUND], [0.375, 0.3425, 0.345]),
    ] {
        let mut shot = plain();
        let sheet = |k: usize| shot.filling(k as u32, 10.0 * (k + 1) as f64, colours[k], shares[k]);
        shot.effects.sheets = [2, 0, 1].map(sheet).to_vec();
        check(&shot, expected);
    }
}

#[test]
fn a_lamp_between_two_sheets() {
    let mut shot = plain();
    shot.effects.sheets = vec![shot.filling(0, 10.0, FAWN, 0.7), shot.filling(1, 30.0, GROUND, 0.0)];
    shot.effects.lights = vec![wide_lamp(&shot, 0, 20.0, 0.35, [1.0, 0.9, 0.7])];
    check(&shot, [0.697, 0.61975, 0.488]);
}

#[test]
fn the_nearest_are_kept_when_slots_are_few() {
    let grey = |level: f64| [level; 3];
    let mut shot = plain();
    let sheet = |(id, depth, share, level): (u32, f64, f64, f64)| -> Sheet {
        shot.filling(id, depth, grey(level), share)
    };
    let sheets = [
        (1, 10.0, 0.7, 0.9),
        (6, 12.0, 0.9, 0.6),
        (2, 20.0, 0.5, 0.2),
        (5, 30.0, 0.0, 0.4),
        (7, 40.0, 0.0, 0.1),
    ];
    shot.effects.sheets = sheets.map(sheet).to_vec();
    // The table has colours; a lamp adds its intensity times its colour.
    let lamps = [(3, 15.0, 0.35, 1.0), (4, 18.0, 0.8, 0.5)];
    shot.effects.lights = lamps
        .map(|(id, depth, intensity, level)| wide_lamp(&shot, id, depth, intensity, grey(level)))
        .to_vec();
    for (translucent, lights, expected) in [(4, 1, 0.65535), (1, 1, 0.697), (4, 2, 0.72087), (4, 0, 0.501)] {
        shot.run.sampling.translucent = Some(translucent);
        shot.run.sampling.lights = Some(lights);
        check(&shot, grey(expected));
    }
}
