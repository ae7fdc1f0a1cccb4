//! How far the circuit's waveforms are from the machine's.

use interpreter::parts::Array;

use crate::OUTPUTS;
use crate::run::Curves;

/// Part of the value, and part of full scale, by which a waveform may be off (trust, section 4).
const ALLOWED: [f64; 2] = [1e-3, 1e-4];
/// Samples beside an edge that the norm skips.
const BESIDE: f64 = 2.0;
/// Instants of a sample at which both are compared.
pub const INSTANTS: u32 = 8;

/// One signal of both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Agreement {
    /// Number of the signal in [`OUTPUTS`].
    pub node: usize,
    /// Waveform norm: the root of the mean square of what each instant is off, as a part of what it may be.
    pub norm: f64,
    /// Largest difference (full scales).
    pub worst: f64,
    /// Instants that are compared.
    pub samples: usize,
    /// Instants beside edges, which are not.
    pub skipped: usize,
}

impl Agreement {
    /// Whether the norm is at most 1, over at least one instant.
    pub fn holds(&self) -> bool {
        self.norm <= 1.0 && self.samples > 0
    }
}

/// The circuit's waveforms against the machine's, which have [`INSTANTS`] values a sample: by node, at every one.
pub fn compare<'a>(array: &Array, curves: &Curves, machine: impl Fn(usize) -> &'a [f64]) -> Vec<Agreement> {
    let edges = edges(array);
    (0..OUTPUTS.len()).map(|node| of_node(array, (node, curves), machine(node), &edges)).collect()
}

/// Instants at which a word or the polarity changes, or a ramp folds (steps from the first sample).
fn edges(array: &Array) -> Vec<f64> {
    let words = array.words.taken.iter().flatten().flatten().map(|word| word.at);
    let turns = array.words.turns.iter().map(|(at, _)| *at);
    let corners = array.corners.iter().flatten();
    let folds = corners.filter(|[_, value]| *value == 0.0 || *value == 1.0).map(|[at, _]| *at);
    let mut edges: Vec<f64> = words.chain(turns).chain(folds).filter(|at| at.is_finite()).collect();
    edges.sort_by(f64::total_cmp);
    edges
}

fn of_node(array: &Array, (node, curves): (usize, &Curves), machine: &[f64], edges: &[f64]) -> Agreement {
    let full_scale = full_scale(array, node);
    let is_beside = |at: f64| {
        let next = edges.partition_point(|edge| *edge < at - BESIDE);
        edges.get(next).is_some_and(|edge| *edge < at + BESIDE)
    };
    let last = (array.accumulators.len() as i64 - 1 + array.begins) as usize;
    let (mut sum, mut worst, mut count, mut skipped) = (0.0, 0.0_f64, 0, 0);
    for (instant, &right) in machine.iter().enumerate().take(INSTANTS as usize * last + 1) {
        let at = instant as f64 / f64::from(INSTANTS);
        if is_beside(at) {
            skipped += 1;
            continue;
        }
        let time = (at - array.begins as f64) * array.figures.step;
        let off = (curves.at(node, time) - right).abs();
        let allowed = ALLOWED[0] * right.abs() + ALLOWED[1] * full_scale;
        sum += (off / allowed) * (off / allowed);
        (worst, count) = (worst.max(off / full_scale), count + 1);
    }
    Agreement { node, norm: (sum / f64::from(count.max(1))).sqrt(), worst, samples: count as usize, skipped }
}

/// Full scale of a node: of ramps and function generators 1.
fn full_scale(array: &Array, node: usize) -> f64 {
    let scales = &array.figures.scales;
    match node {
        0..=3 => 1.0,
        4 => scales.height,
        _ => scales.slope / array.region_size,
    }
}
