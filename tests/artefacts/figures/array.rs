//! What the array bends (A6 to A12, A25).

use std::f64::consts::PI;

use parts::Spread;

use crate::detectors::{array, late};
use crate::figures::{Figure, figure, looked};
use crate::look::{largest, mean, median};
use crate::scenes::{PLATEAU, WAVE};

/// Time constant of a bandwidth (µs).
fn tau(megahertz: f64) -> f64 {
    1.0 / (2.0 * PI * megahertz)
}

pub fn a6() -> Figure {
    looked(6, |look| {
        let lost = array::ridge_smear(look);
        let turn = 2.0 * PI * look.speed() / WAVE[0];
        // The multipliers, and an amplifier with one input at its summing point.
        let left = [tau(0.5), 2.0 * tau(0.5)].map(|tau| 1.0 / (1.0 + turn * tau * turn * tau).sqrt());
        let height = array::wave_height(look);
        let predicted = height * (1.0 - left[0] * left[1]);
        figure(
            6,
            "crests lowered by",
            [lost, predicted, 0.05 * predicted],
            "m",
            "`h (1 - H(2π v/λ))`, which is `h'' (v τ)²/2` for long waves",
        )
    })
}

pub fn a7() -> Figure {
    looked(7, |look| {
        let fastest = look.own().map(|sweep| largest(array::rates(look, sweep)));
        figure(
            7,
            "fastest rate of the height",
            [median(&fastest.collect::<Vec<_>>()), 2.0, 0.005],
            "V/µs",
            "`SR`",
        )
    })
}

/// What a second-order smoother of 1/w = `time` (µs) lacks of a ramp at its group delay.
fn deviation(time: f64, damping: f64) -> f64 {
    let (w, wd) = (1.0 / time, (1.0 - damping * damping).sqrt() / time);
    let step = |t: f64| {
        1.0 - libm::exp(-damping * w * t) * (libm::cos(wd * t) + damping * w / wd * libm::sin(wd * t))
    };
    let (end, steps) = (2.0 * damping / w, 10_000);
    (0..steps).map(|k| step((f64::from(k) + 0.5) * end / f64::from(steps)) * end / f64::from(steps)).sum()
}

pub fn a8() -> Figure {
    looked(8, |look| {
        let predicted = 2.0 * deviation(0.3, 0.8) * look.speed();
        figure(
            8,
            "ramp short of its stop by",
            [array::fold_shortfall(look), predicted, 0.03 * predicted],
            "m",
            "`2 v` times the smoother's answer to a ramp, at its delay",
        )
    })
}

pub fn a9() -> Figure {
    looked(9, |look| {
        // The line is seen at samples: the last one before the strobe lies half a step before it, in the middle of all.
        let predicted = 2.0 * look.speed() * (0.2 - 0.5 * look.clean.sample());
        figure(
            9,
            "line behind a boundary, in ground",
            [array::bright_fringe(look), predicted, 0.01 * predicted],
            "m",
            "`2 v (t_off - dt/2)`",
        )
    })
}

pub fn a10() -> Figure {
    looked(10, |look| {
        let predicted = quilt();
        figure(
            10,
            "line of two regions in the height of the plateau",
            [array::quilting(look), predicted, 0.1 * predicted],
            "m",
            "`h (ε1 - ε2)/2` times the first harmonic of S0",
        )
    })
}

/// First harmonic of the plateau under the gains that the lot of 1970 has for the heights of its four colours.
fn quilt() -> f64 {
    let spread = Spread::new(1970);
    // Terms 6 ap + bq: near and far converter of either axis, order 0.
    let gain = |term: u64| spread.error("tg.mdac.gain", term, 0.02);
    let steps = 10_000;
    let harmonic: f64 = (0..steps)
        .map(|k| {
            let z = (f64::from(k) + 0.5) / f64::from(steps);
            (1.0 - 2.0 * late::smooth(z)) * libm::cos(PI * z) * 2.0 / f64::from(steps)
        })
        .sum();
    0.5 * (gain(3) - gain(21)).abs() * PLATEAU * harmonic
}

pub fn a11() -> Figure {
    looked(11, |look| {
        let knee = 1.0 / array::SEGMENTS;
        let bend = (late::smooth(2.0 * knee) - 2.0 * late::smooth(knee)) / knee;
        figure(
            11,
            "break of slope at the first and last knee",
            [array::facets(look), bend, 0.1 * bend],
            "a region",
            "`n (S0(2/n) - 2 S0(1/n))`, about `S0''/n`",
        )
    })
}

pub fn a12() -> Figure {
    looked(12, |look| {
        let errors: Vec<f64> = array::row_heights(look)
            .into_iter()
            .map(|[_, right]| (right / array::LEAST).round() * array::LEAST - right)
            .map(|error| error * error)
            .collect();
        let predicted = mean(&errors).sqrt();
        figure(
            12,
            "error of the heights of the rows, rms",
            [array::coefficient_steps(look), predicted, 1e-3],
            "m",
            "nearest step of a word of 6 bits",
        )
    })
}

pub fn a25() -> Figure {
    looked(25, |look| {
        let tops = look.own().map(|sweep| largest(look.run.wave(sweep, "tg.height").iter().copied()));
        let volts = mean(&tops.collect::<Vec<_>>()) / array::FULL_SCALE * 10.0;
        figure(25, "height of the flat tops", [volts, 5.0, 1e-3], "V", "`V_sat`")
    })
}
