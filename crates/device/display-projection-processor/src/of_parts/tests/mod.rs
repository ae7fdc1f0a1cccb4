//! The processor of parts against closed forms. Ranges are 1 m and a little more, so that heights are tangents.

mod chatter;
mod edges;
mod extremes;
mod ideal;

use hardware_model::AnalogParts;
use scenario::{Curvature, Occlusion, Projection};
use signal::{Breaks, LANES, Lanes};

use super::{Driven, PartsProcessor, Scratch};
use crate::Deflection;

/// Time of one sample (s).
const H: f64 = 50e-9;
/// Lines of the picture; its field is +-0.25.
const LINES: f64 = 500.0;
const HALF: f64 = 0.25;

const BOTH: [Occlusion; 2] = [Occlusion::Derivative, Occlusion::PeakHold];

fn level() -> Deflection {
    Deflection::new(Projection::Exact, 0.0, 0.0).in_lines(LINES, HALF)
}

/// Ideal parts, but for what `change` does to them.
fn parts(change: impl FnOnce(&mut AnalogParts)) -> AnalogParts {
    let mut parts = AnalogParts::ideal();
    change(&mut parts);
    parts
}

/// Runs the elevation `share` (of full scale, by sample) on all lanes, sweep 0 on.
fn run(occlusion: Occlusion, parts: &AnalogParts, samples: usize, share: impl Fn(f64) -> f64) -> Driven<f64> {
    run_by(occlusion, parts, samples, share).1
}

/// The same with the processor that it went through.
fn run_by(
    occlusion: Occlusion,
    parts: &AnalogParts,
    samples: usize,
    share: impl Fn(f64) -> f64,
) -> (PartsProcessor<f64>, Driven<f64>) {
    let ranges: Vec<f64> = (0..samples).map(|k| 1.0 + 1e-6 * k as f64).collect();
    let height: Vec<_> =
        ranges.iter().enumerate().map(|(k, z)| Lanes::splat(HALF * share(k as f64) * z)).collect();
    let light: Vec<_> = (0..samples).map(|k| Lanes::splat(k as f64 / samples as f64)).collect();
    let processor = PartsProcessor::new((occlusion, Curvature::None), &ranges, LINES, H, parts, 1970);
    let mut out = Driven::default();
    let sweeps = std::array::from_fn(|lane| lane as u64);
    processor.run(
        &height,
        (&light, &Breaks::default()),
        &[level(); LANES],
        &sweeps,
        &mut Scratch::default(),
        &mut out,
    );
    (processor, out)
}

/// The processed elevation (share) of lane 0 at a time, between samples.
fn share_at(out: &Driven<f64>, time: f64) -> f64 {
    let before = (time as usize).min(out.elevation.len() - 2);
    let [a, b] = [before, before + 1].map(|sample| out.elevation[sample][0] / HALF);
    a + (b - a) * (time - before as f64)
}

/// Up to a crest, down, and up again past it: straight lines with corners at samples `top` and `bottom`.
fn hollow(top: f64, bottom: f64, rate: f64) -> impl Fn(f64) -> f64 {
    move |k| {
        let crest = 0.3;
        if k <= top {
            crest - rate * (top - k)
        } else if k <= bottom {
            crest - rate * (k - top)
        } else {
            crest - rate * (bottom - top) + rate * (k - bottom)
        }
    }
}
