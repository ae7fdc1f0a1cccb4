//! What the array bends (A6 to A12, A25), and what two of them make of one another (A27).

use std::f64::consts::{LN_2, PI};

use parts::Spread;

use crate::artefacts::detectors::{array, late};
use crate::artefacts::figures::{Figure, figure, looked};
use crate::artefacts::look::{Look, largest, mean, median};
use crate::artefacts::scenes::{LIFT, OVER, PLATEAU, WAVE};

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

/// Answer to a ramp of slope 1 of a second-order smoother of 1/w = `time` (µs), `t` (µs) after the ramp begins.
fn to_a_ramp(t: f64, time: f64, damping: f64) -> f64 {
    let (w, wd) = (1.0 / time, (1.0 - damping * damping).sqrt() / time);
    let step = |t: f64| {
        1.0 - libm::exp(-damping * w * t) * (libm::cos(wd * t) + damping * w / wd * libm::sin(wd * t))
    };
    let (end, steps) = (t.max(0.0), 4_000);
    (0..steps).map(|k| step((f64::from(k) + 0.5) * end / f64::from(steps)) * end / f64::from(steps)).sum()
}

/// What the ramp lacks of its place (µs of its way) `t` (µs) after a fold: the smoother's answer to the corner, which the ramps'
/// lead brings forward by the smoother's delay. Before and behind come the corners of the folds `period` (µs) earlier, in turn.
fn behind_corners(t: f64, period: f64) -> f64 {
    let (time, damping) = (0.3, 0.8);
    let corner = |t: f64| to_a_ramp(t + 2.0 * damping * time, time, damping) - t.max(0.0);
    corner(t) - corner(t + period) + corner(t + 2.0 * period)
}

/// The shortfall of a sweep as the detector sees it: led back from the two samples beside the fold, and less what stands in the middle
/// between two folds.
fn shortfall(look: &Look<'_>, sweep: u32) -> f64 {
    let north = look.direction(sweep)[0];
    let (dt, period) = (look.clean.sample(), look.scene.region() / look.speed() / north);
    let at = |samples: f64| 2.0 * look.speed() * behind_corners(samples * dt, period);
    let middle = mean(&array::BETWEEN.map(|k| at(-(k as f64 + 1.0))).collect::<Vec<_>>());
    let [before, behind] = [-1.0, 1.0].map(|side| 2.0 * at(side) - at(2.0 * side));
    (before - middle).min(behind + middle)
}

pub fn a8() -> Figure {
    looked(8, |look| {
        let predicted = median(&look.own().map(|sweep| shortfall(look, sweep)).collect::<Vec<_>>());
        figure(
            8,
            "ramp short of its stop by",
            [array::fold_shortfall(look), predicted, 0.01 * predicted],
            "m",
            "`2 v` times the smoother's answer to a ramp, at its delay, less what is left of the fold before",
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
        // What is seen at samples goes straight between them: a rounded knee is seen flatter still.
        let step = look.pace() / look.scene.region();
        let flatter = 2.0 * ROUNDING * LN_2 + step * step / (24.0 * ROUNDING);
        let bend = knee() * (1.0 - flatter / array::REACH);
        figure(
            11,
            "break of slope at the first and last knee",
            [array::facets(look), bend, 0.01 * bend],
            "a region",
            "`n (S0(2/n) - 2 S0(1/n) + m/2)`, flatter by the rounding of the knee and by samples",
        )
    })
}

/// Width of the knees of the overlay (share of full scale).
const ROUNDING: f64 = 0.005;

/// Jump of slope at the first knee: both knees of the second segment lie off the function by half of its largest sag.
fn knee() -> f64 {
    let segment = 1.0 / array::SEGMENTS;
    let [first, second] = [segment, 2.0 * segment].map(late::smooth);
    let sag = |share: f64| first + (second - first) * share - late::smooth(segment * (1.0 + share));
    let largest = largest((0..=1000).map(|k| sag(f64::from(k) / 1000.0)));
    (second - 2.0 * first + 0.5 * largest) / segment
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

pub fn a27() -> Figure {
    let predicted = 100.0 * 1.875 * LIFT / OVER.blend;
    figure(
        27,
        "slope that the light lacks in the middle of the blend",
        [looked(27, array::blend_band), predicted, 0.01],
        "%",
        "`15/8 (h_coarse - h_fine)/(z2 - z1)`",
    )
}
