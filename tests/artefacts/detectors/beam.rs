//! What the projection processor, the light and the write beam do (A13 to A19, A22).

use crate::artefacts::detectors::array::harmonic;
use crate::artefacts::look::{Look, largest, mean, median};
use crate::artefacts::scenes::{BOWL, BOWLS, STRIPS, WAVE};

/// Edge of a strip of shadow as it is drawn (samples): where the light leaves its level, and where it has arrived.
#[derive(Debug, Clone, Copy)]
pub struct Edge {
    /// Samples behind the true edge at which the light is half way.
    pub behind: f64,
    /// Samples that it takes, if it changes evenly.
    pub width: f64,
    /// Light before and behind.
    pub levels: [f64; 2],
}

/// Edges of the strips in a sweep, against where they lie.
pub fn edges(look: &Look<'_>, sweep: u32) -> Vec<Edge> {
    let light = look.run.wave(sweep, "mu.reflectivity");
    let north = look.direction(sweep)[0];
    let edge = |&ahead: &f64| {
        let at = ahead / north / look.pace() - 1.0;
        let settled = |time: f64| {
            let middle = time as usize;
            mean(&light[middle - 20..middle + 20])
        };
        let levels = [settled(at - 60.0), settled(at + 110.0)];
        let way = |sample: usize| (light[sample] - levels[0]) / (levels[1] - levels[0]);
        // Moments of the change, each step of it in the middle of its sample, which adds a twelfth to the width's square.
        let (mut middle, mut square) = (0.0, 0.0);
        for sample in at as usize - 40..at as usize + 90 {
            let (change, place) = (way(sample) - way(sample - 1), sample as f64 - 0.5 - at);
            middle += change * place;
            square += change * place * place;
        }
        let width = (12.0 * (square - middle * middle) - 1.0).max(0.0).sqrt();
        Edge { behind: middle, width, levels }
    };
    STRIPS.iter().flatten().map(edge).collect()
}

/// Samples by which the near rims of the bowls of a sweep are behind their place: where the light of the ground ends.
pub fn rims(look: &Look<'_>, sweep: u32) -> Vec<f64> {
    let light = look.run.wave(sweep, "mu.reflectivity");
    let (ground, north) = (light[10], look.direction(sweep)[0]);
    let place = |sample: f64| look.range_at(sample);
    let rim = |&ahead: &f64| {
        // The centre lies straight ahead, a little beside the sweep.
        let [middle, beside] = [ahead * north, ahead * (1.0 - north * north).sqrt()];
        let near = middle - (BOWL * BOWL - beside * beside).sqrt();
        let begin = light
            .iter()
            .enumerate()
            .position(|(sample, &light)| place(sample as f64) > near - 1.0 && (light - ground).abs() > 1e-9);
        // It lies in the step before the first sample that sees it.
        begin.expect("a bowl") as f64 - 0.5 - (near / look.pace() - 1.0)
    };
    BOWLS.iter().map(rim).collect()
}

/// A13: by how much the edges of shadow are behind their place (m): those into the dark and those out of it, alike.
pub fn displaced_edge(look: &Look<'_>) -> f64 {
    let edges: Vec<f64> = look.own().flat_map(|sweep| edges(look, sweep)).map(|edge| edge.behind).collect();
    let side = |first: usize| mean(&edges.iter().skip(first).step_by(2).copied().collect::<Vec<_>>());
    let [into, out] = [side(0), side(1)];
    if (into - out).abs() > 1.0 { 0.0 } else { 0.5 * (into + out) * look.pace() }
}

/// A22: time of an edge of shadow from one level to the other (ns).
pub fn switch_seam(look: &Look<'_>) -> f64 {
    let widths = look.own().flat_map(|sweep| edges(look, sweep)).map(|edge| edge.width);
    median(&widths.collect::<Vec<_>>()) * look.clean.sample() * 1e3
}

/// Stretches of the clean sweep that are hidden for long, first sample and last.
pub fn hidden(look: &Look<'_>, sweep: u32) -> Vec<[usize; 2]> {
    let blank = look.clean.wave(sweep, "dpp.blank");
    let mut found = Vec::new();
    let mut since = None;
    for (sample, &gate) in blank.iter().enumerate() {
        match (gate == 1.0, since) {
            (true, None) => since = Some(sample),
            (false, Some(first)) => {
                since = None;
                if (sample - first) as f64 * look.clean.sample() > 2.0 {
                    found.push([first, sample]);
                }
            }
            _ => {}
        }
    }
    found
}

/// The run's own crest near where the clean sweep has one.
fn crest(look: &Look<'_>, elevation: &[f64], first: usize) -> usize {
    let reach = (1.5 / look.clean.sample()) as usize;
    let near = first.saturating_sub(reach)..(first + reach).min(elevation.len());
    near.reduce(|best, sample| if elevation[sample] > elevation[best] { sample } else { best })
        .unwrap_or(first)
}

/// Bends of the elevation at the crests of the clean sweeps (full scales a µs²), downwards.
pub fn crest_bends(look: &Look<'_>) -> Vec<f64> {
    let (half, sample) = (look.run.settings.raster.field.tan_half_height, look.clean.sample());
    let reach = (0.2 / sample) as usize;
    let bends = look.own().flat_map(|sweep| {
        let elevation = look.clean.wave(sweep, "dpp.elevation");
        hidden(look, sweep).into_iter().map(move |[first, _]| {
            let top = crest(look, elevation, first);
            let bend = elevation[top - reach] - 2.0 * elevation[top] + elevation[top + reach];
            let time = reach as f64 * sample;
            -bend / (time * time) / half
        })
    });
    bends.collect()
}

/// A14: how long the beam stays on behind a crest (µs).
pub fn crest_overdraw(look: &Look<'_>) -> f64 {
    let sample = look.clean.sample();
    let mut over = Vec::new();
    for sweep in look.own() {
        let [elevation, blank] = ["dpp.elevation", "dpp.blank"].map(|name| look.run.wave(sweep, name));
        for [first, _] in hidden(look, sweep) {
            let crest = crest(look, elevation, first);
            let behind = (crest + 1..blank.len()).take((1.0 / sample) as usize);
            over.push(behind.filter(|&k| blank[k] == 0.0).count() as f64 * sample);
        }
    }
    median(&over)
}

/// What the sample-and-hold has, less the crest that it holds, so long after it (µs): pairs of time and millivolts.
pub fn held(look: &Look<'_>) -> Vec<[f64; 2]> {
    let half = look.run.settings.raster.field.tan_half_height;
    let sample = look.clean.sample();
    let mut found = Vec::new();
    for sweep in look.own() {
        let [elevation, hold] = ["dpp.elevation", "dpp.hold"].map(|name| look.run.wave(sweep, name));
        for [first, last] in hidden(look, sweep) {
            let crest = crest(look, elevation, first);
            for time in [1.0, 2.0, 3.0] {
                let at = crest + (time / sample) as usize;
                if at < last {
                    found.push([time, (hold[at] - elevation[crest]) / half * 1e4]);
                }
            }
        }
    }
    found
}

/// A15: what the hold is off by, 1 to 3 µs behind a crest (mV of 10 V).
pub fn hold_error(look: &Look<'_>) -> f64 {
    median(&held(look).into_iter().map(|[_, millivolts]| millivolts).collect::<Vec<_>>()).abs()
}

/// A16: changes of the blanking over level ground (a µs).
pub fn chatter(look: &Look<'_>) -> f64 {
    let rates = look.sweeps().map(|sweep| {
        let blank = look.run.wave(sweep, "dpp.blank");
        let toggles = blank.windows(2).filter(|pair| pair[0] != pair[1]).count();
        toggles as f64 / (blank.len() as f64 * look.run.sample())
    });
    median(&rates.collect::<Vec<_>>())
}

/// From here on level ground is in the picture (m).
pub const INSIDE: f64 = 8.0;

/// Ground range (m) at which half of the sweeps have begun to chatter.
pub fn chatter_begins(look: &Look<'_>) -> f64 {
    let begins = look.sweeps().map(|sweep| {
        let blank = look.run.wave(sweep, "dpp.blank");
        let range = look.run.wave(sweep, "sweep.range");
        let inside = range.partition_point(|&range| range < INSIDE);
        let first = blank[inside..].iter().position(|&gate| gate == 1.0).unwrap_or(blank.len() - 1 - inside);
        range[inside + first]
    });
    median(&begins.collect::<Vec<_>>())
}

/// A17: by how much brightness is behind slope (m), by the phases of the waves.
pub fn shade_shift(look: &Look<'_>) -> f64 {
    let lags = look.own().map(|sweep| {
        let phase = |name| {
            let [cos, sin] = harmonic(look, sweep, look.run.wave(sweep, name));
            libm::atan2(sin, cos)
        };
        // The sun is ahead: what rises is dark.
        let turn = phase("tg.reflectivity") - phase("tg.slope.u") - std::f64::consts::PI;
        let turn = turn - (turn / (2.0 * std::f64::consts::PI)).round() * 2.0 * std::f64::consts::PI;
        turn / (2.0 * std::f64::consts::PI) * WAVE[0] / look.direction(sweep)[0]
    });
    median(&lags.collect::<Vec<_>>()).max(0.0)
}

/// A18: lines that the beam skips between two samples at the foot of the picture.
pub fn foreground_blur(look: &Look<'_>) -> f64 {
    let lines = f64::from(look.run.settings.raster.lines);
    let steps = look.sweeps().map(|sweep| {
        let place = look.run.wave(sweep, "dpp.y");
        let foot = place.windows(2).filter(|pair| pair[0] > 0.7 * lines);
        largest(foot.map(|pair| pair[0].min(lines) - pair[1]))
    });
    median(&steps.collect::<Vec<_>>())
}

/// A19: power of the time that the beam stays in a line with which its charge grows.
pub fn exposure(look: &Look<'_>) -> f64 {
    let powers = look.sweeps().map(|sweep| power_of_dwell(look, sweep));
    median(&powers.collect::<Vec<_>>()).max(0.0)
}

/// Level of a whole charge, against white.
const SATURATED: f64 = 1.581_976_7;

fn power_of_dwell(look: &Look<'_>, sweep: u32) -> f64 {
    let [place, level] = ["dpp.y", "sm.write"].map(|name| look.run.wave(sweep, name));
    let mut points = Vec::new();
    for (line, &level) in level.iter().enumerate() {
        let dwell = reached(place, line as f64) - reached(place, line as f64 + 1.0);
        if dwell >= 3.0 && level > 0.0 && level < 0.9 * SATURATED {
            points.push([libm::log(dwell), libm::log(-libm::log1p(-level / SATURATED))]);
        }
    }
    slope(&points)
}

/// When the beam, on its way up, reaches a line (samples): straight between samples.
fn reached(place: &[f64], line: f64) -> f64 {
    let next = place.partition_point(|&place| place > line);
    match (next.checked_sub(1).map(|before| place[before]), place.get(next)) {
        (Some(before), Some(after)) => next as f64 - 1.0 + (before - line) / (before - after),
        _ => next as f64,
    }
}

/// Slope of the straight line of least squares; 0 if there is none.
pub fn slope(points: &[[f64; 2]]) -> f64 {
    let [x, y] = [0, 1].map(|axis| mean(&points.iter().map(|point| point[axis]).collect::<Vec<_>>()));
    let product =
        |a: usize, b: usize| points.iter().map(|p| (p[a] - [x, y][a]) * (p[b] - [x, y][b])).sum::<f64>();
    let square = product(0, 0);
    if square > 0.0 { product(0, 1) / square } else { 0.0 }
}
