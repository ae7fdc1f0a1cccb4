//! What comes late (A1 to A5, A26).

use quantities::{degrees, radians};
use timing::{Deadline, Missed};

use crate::artefacts::detectors::late;
use crate::artefacts::figures::{Figure, figure, looked};
use crate::artefacts::look::{Look, mean};
use crate::artefacts::scene::SWEEP;
use crate::artefacts::scenes::{Place, TURN};

/// Sets of a sweep that came too late, by the timing record.
fn late_sets<'a>(look: &'a Look<'_>, sweep: u32) -> impl Iterator<Item = &'a Missed> {
    let timing = look.run.frames[0].timing.as_ref().expect("a timed scene");
    let transfers = timing.misses.iter().filter(|missed| missed.deadline == Deadline::TRANSFER);
    transfers.filter(move |missed| missed.sweep == sweep)
}

/// The corner that the register had before: two columns or rows behind, across its own axis.
fn stale_corner(missed: &Missed, corner: [i64; 2]) -> [i64; 2] {
    match missed.register.as_deref() {
        Some("x-first") => [corner[0], corner[1] - 2],
        _ => [corner[0] - 2, corner[1]],
    }
}

/// The error of the late sets of a sweep at a sample, by the law of stale corners.
fn predicted_error(look: &Look<'_>, sweep: u32, sample: usize, lasts: impl Fn(&Missed) -> f64) -> f64 {
    let place = look.place(sweep, sample as f64);
    let time = sample as f64;
    let active = late_sets(look, sweep).filter(|missed| missed.due <= time && time < lasts(missed));
    active
        .filter_map(|missed| {
            let corner = missed.region?;
            Some(late::stale_error(look, corner, stale_corner(missed, corner), place))
        })
        .sum()
}

/// Largest error of a profile, and the rms of what the law of stale corners leaves of it, against it.
fn explained(look: &Look<'_>, lasts: impl Fn(&Missed) -> f64 + Copy) -> [f64; 2] {
    let (mut left, mut square) = (0.0, 0.0);
    for sweep in look.own() {
        for (sample, error) in look.error(sweep).into_iter().enumerate() {
            let rest = error - predicted_error(look, sweep, sample, lasts);
            left += rest * rest;
            square += error * error;
        }
    }
    [square, left]
}

pub fn a1() -> Figure {
    looked(1, |look| {
        let [square, left] = explained(look, |missed| missed.came.unwrap_or(f64::INFINITY));
        figure(
            1,
            "error explained by the late sets of the record",
            [100.0 * (1.0 - left / square), 100.0, 2.0],
            "%",
            "`Δf S0(e_x) S0(e_y)` from stop to arrival",
        )
    })
}

pub fn a2() -> Figure {
    looked(2, |look| {
        let [square, left] = explained(look, |_| f64::INFINITY);
        figure(
            2,
            "error explained by the late sets of the record",
            [100.0 * (1.0 - left / square), 100.0, 2.0],
            "%",
            "the same while the corner counts",
        )
    })
}

pub fn a3() -> Figure {
    let found = looked(3, late::mirror_ghost);
    figure(
        3,
        "ground beyond the first row that is its mirror image",
        [100.0 * found, 100.0, 1.0],
        "%",
        "`z - 2 (z - z_b)`",
    )
}

pub fn a4() -> Figure {
    looked(4, |look| {
        let count: Vec<f64> = look.own().map(|sweep| late_sets(look, sweep).count() as f64).collect();
        let expected = mean(&look.own().map(|sweep| near_corners(look, sweep, 0.3)).collect::<Vec<_>>());
        figure(
            4,
            "late sets a sweep",
            [mean(&count), expected, 0.01 * expected],
            "",
            "boundaries of both axes passed within `t_u`: on the average `R v t_u sin 2θ / d²`",
        )
    })
}

/// How often a sweep passes boundaries of both axes within `time` (µs) of one another, by its line over the ground.
fn near_corners(look: &Look<'_>, sweep: u32, time: f64) -> f64 {
    let (direction, size) = (look.direction(sweep), look.scene.region());
    let end = look.clean.settings.range.end;
    let passed = |axis: usize| {
        let (from, rate) = (look.scene.eye[axis] / size, direction[axis] / size);
        let first = from.ceil() as i64;
        let lines = first..(from + end * rate).ceil() as i64;
        lines.map(move |line| (line as f64 - from) / rate / look.speed()).collect::<Vec<f64>>()
    };
    let [north, east] = [passed(0), passed(1)];
    let near = |at: &f64| east.iter().filter(|other| (*other - at).abs() < time).count();
    north.iter().map(near).sum::<usize>() as f64
}

pub fn a5() -> Figure {
    let found = looked(5, late::drum_starvation);
    let scene = Place::Turn.scene();
    let rate = 3000.0 * 3000.0 * radians(TURN) / (2.0 * 200.0 * 200.0);
    let served = 1.0 / (0.5 * 0.068 + 18.0 / 0.118e6);
    let seen = 2.0 * degrees(libm::atan(scene.field.tan_half_width)) / TURN;
    let expected = (rate - served) * seen;
    figure(
        5,
        "corners missing a frame at 50 degrees/s",
        [found, expected, 0.2 * expected],
        "",
        "`(R² ω / 2d² - 1/latency)` times the time in view",
    )
}

pub fn a26() -> Figure {
    let found = looked(26, late::queue_jitter);
    let sweeps = 31.0;
    let predicted = 1.0 - (sweeps * SWEEP / 200e-6).floor() / sweeps;
    figure(
        26,
        "sweeps repeated",
        [100.0 * found, 100.0 * predicted, 0.01],
        "%",
        "`1 - ⌊n T/t_setup⌋/n` of n sweeps",
    )
}
