//! What beam, light, tube and yoke do (A13 to A24).

use std::f64::consts::PI;

use parts::Spread;

use crate::artefacts::detectors::{beam, picture};
use crate::artefacts::figures::{Figure, figure, looked};
use crate::artefacts::look::{Look, median};
use crate::artefacts::scenes::WAVE;

pub fn a13() -> Figure {
    looked(13, |look| {
        let predicted = 0.4 * look.speed();
        figure(
            13,
            "edges of shadow displaced by",
            [beam::displaced_edge(look), predicted, 0.015 * predicted],
            "m",
            "`v t_c`",
        )
    })
}

pub fn a14() -> Figure {
    let found = looked(14, beam::crest_overdraw);
    figure(14, "beam on behind a crest", [found, 0.4, 0.02], "µs", "`t_c`")
}

pub fn a15() -> Figure {
    looked(15, |look| {
        let off = beam::held(look).into_iter().map(|[time, found]| found + 20.0 * time);
        figure(
            15,
            "hold less crest, droop taken off",
            [median(&off.collect::<Vec<_>>()), 200.0, 10.0],
            "mV",
            "`V_p`, with `D` = 20 mV/µs",
        )
    })
}

pub fn a16() -> Figure {
    looked(16, |look| {
        let predicted = chatter_expected(look);
        figure(
            16,
            "half of the sweeps chatter from",
            [beam::chatter_begins(look), predicted, 0.15 * predicted],
            "m",
            "`η'` against noise of `2π B σ/√3`",
        )
    })
}

/// Ground range (m) at which half of the sweeps have met a sample whose noise outdoes the rate of level ground.
fn chatter_expected(look: &Look<'_>) -> f64 {
    let half = look.clean.settings.raster.field.tan_half_height;
    // 10 mV of 10 V in 10 MHz, differentiated (a second).
    let noise = 2.0 * PI * 10e6 * 1e-3 / 3.0_f64.sqrt();
    let range = look.clean.wave(0, "sweep.range");
    let rate = |k: usize| {
        let share = |k: usize| look.scene.eye[2] / range[k] / half;
        (share(k) - share(k + 1)) / look.clean.sample() * 1e6
    };
    let mut quiet = 1.0;
    let met = (range.partition_point(|&range| range < beam::INSIDE)..range.len() - 1).find(|&k| {
        quiet *= 1.0 - 0.5 * libm::erfc(rate(k) / noise / 2.0_f64.sqrt());
        quiet < 0.5
    });
    range[met.unwrap_or(range.len() - 1)]
}

pub fn a17() -> Figure {
    looked(17, |look| {
        let turn = 2.0 * PI * look.speed() / WAVE[0];
        let predicted = libm::atan(turn * 0.5) / turn * look.speed();
        figure(
            17,
            "brightness behind slope by",
            [beam::shade_shift(look), predicted, 0.02 * predicted],
            "m",
            "`v atan(ω Δτ)/ω`, which is `v Δτ` for long waves",
        )
    })
}

pub fn a18() -> Figure {
    looked(18, |look| {
        let step = look.clean.settings.range.end / f64::from(look.clean.settings.raster.samples);
        let half = look.clean.settings.raster.field.tan_half_height;
        let line = |range: f64| 0.5 * 240.0 * (1.0 + look.scene.eye[2] / range / half);
        figure(
            18,
            "lines between two samples at the foot",
            [
                beam::foreground_blur(look),
                240.0
                    - line(
                        2.0 * step
                            * median(
                                &look.sweeps().map(|sweep| look.direction(sweep)[0]).collect::<Vec<_>>(),
                            ),
                    ),
                0.5,
            ],
            "lines",
            "`v dt` over the ground of a line",
        )
    })
}

pub fn a19() -> Figure {
    let found = looked(19, beam::exposure);
    figure(19, "power of the dwell that the charge follows", [found, 1.0, 0.01], "", "charge as `1/(dy/dt)`")
}

pub fn a20() -> Figure {
    let found = looked(20, picture::residue);
    figure(20, "left of the frame before", [100.0 * found, 40.0, 1.0], "%", "`ρ`")
}

pub fn a21() -> Figure {
    looked(21, |look| {
        let spread = Spread::new(1970);
        let [across, along] = ["shift-across", "shift-along"]
            .map(|part| 100.0 * spread.error(&format!("sweep-memory.{part}"), 0, 0.03));
        figure(
            21,
            "picture displaced by",
            [picture::registration(look), libm::hypot(across, along), 0.3],
            "%",
            "the tube's share of 3 % of the height",
        )
    })
}

pub fn a22() -> Figure {
    let found = looked(22, beam::switch_seam);
    figure(22, "edge of shadow takes", [found, 300.0, 15.0], "ns", "`t_vs`")
}

pub fn a23() -> Figure {
    let found = looked(23, picture::roll_steps);
    let damping = 0.05_f64;
    let beyond = libm::exp(-PI * damping / (1.0 - damping * damping).sqrt());
    figure(
        23,
        "horizon swings beyond its step by",
        [found, beyond, 0.05],
        "degrees",
        "`e^(-π ζ/√(1 - ζ²))` of 1 degree",
    )
}

pub fn a24() -> Figure {
    let found = looked(24, picture::lag_of_update);
    figure(24, "showings of one picture", [found, 6.0, 0.0], "", "refresh over update, 60 over 10")
}
