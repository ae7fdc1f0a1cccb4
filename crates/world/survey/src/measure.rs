//! A finished fit against the samples: residuals, extremes, behaviour in voids.

use landscape::Level;
use rayon::prelude::*;

use crate::Grid;
use crate::fit::{Axis, Fit, Place, across_line, both, dot, lacking};
use crate::patch::Patch;
use crate::report::{LevelReport, VoidBounds, Worst};

/// How far into a void the bounds are taken (regions).
const REACH: usize = 3;

/// Fitted heights and residuals at the samples of a level, and its figures.
pub fn measure(patch: &Patch, places: &[Place], fit: &Fit) -> (Grid, Grid, LevelReport) {
    let [north, east] = &fit.axes;
    let near_edge = void_regions(&lacking(patch, &fit.axes), north.regions(), east.regions());
    let row = east.samples();
    let mut fitted = vec![f64::NAN; north.samples() * row];
    let mut residuals = fitted.clone();
    let parts: Vec<Tally> = fitted
        .par_chunks_mut(row)
        .zip(residuals.par_chunks_mut(row))
        .enumerate()
        .map_init(
            || Line::new(east),
            |scratch, (line, (fitted, residuals))| {
                scratch.evaluate(&fit.level, north, east, line);
                fitted.copy_from_slice(&scratch.heights);
                tally(patch, places, scratch, (north, east), line, &near_edge, residuals)
            },
        )
        .collect();
    let total = parts.into_iter().fold(Tally::default(), Tally::and);
    let grid =
        |values| Grid { lines: north.samples(), columns: row, first: patch.first, step: patch.step, values };
    let report = figures(fit, &total, near_edge.iter().filter(|near| **near).count());
    (grid(fitted), grid(residuals), report)
}

/// Regions (north, east) without a single sample.
pub fn empty_regions(patch: &Patch, axes: &[Axis; 2]) -> Vec<[u32; 2]> {
    let east = axes[1].regions();
    let empty = |(index, share): (usize, &f64)| {
        (*share == 1.0).then_some([(index / east) as u32, (index % east) as u32])
    };
    lacking(patch, axes).iter().enumerate().filter_map(empty).collect()
}

/// Regions without samples that lie at most [`REACH`] regions from one with samples.
fn void_regions(lacking: &[f64], north: usize, east: usize) -> Vec<bool> {
    let empty: Vec<bool> = lacking.iter().map(|share| *share == 1.0).collect();
    let mut reached: Vec<bool> = empty.iter().map(|empty| !empty).collect();
    for _ in 0..REACH {
        let before = reached.clone();
        for (index, reached) in reached.iter_mut().enumerate() {
            let (m, n) = (index / east, index % east);
            let rows = m.saturating_sub(1)..(m + 2).min(north);
            let columns = n.saturating_sub(1)..(n + 2).min(east);
            *reached = rows.into_iter().any(|m| columns.clone().any(|n| before[m * east + n]));
        }
    }
    reached.iter().zip(&empty).map(|(reached, empty)| *reached && *empty).collect()
}

/// One line of the fitted ground.
struct Line {
    corners: Vec<[f64; 3]>,
    slopes: Vec<[f64; 3]>,
    heights: Vec<f64>,
    /// Steepness at each sample, rise over run.
    steepness: Vec<f64>,
}

impl Line {
    fn new(east: &Axis) -> Self {
        let corners = vec![[0.0; 3]; east.regions() + 1];
        let values = vec![0.0; east.samples()];
        Self { slopes: corners.clone(), corners, heights: values.clone(), steepness: values }
    }

    fn evaluate(&mut self, level: &Level, north: &Axis, east: &Axis, line: usize) {
        let row = level.corners()[1];
        let strip = north.starts.partition_point(|start| *start <= line) - 1;
        let south = &level.words()[strip * row..][..row];
        let far = &level.words()[(strip + 1) * row..][..row];
        across_line(&north.weights[line], south, far, &mut self.corners);
        across_line(&north.slopes[line], south, far, &mut self.slopes);
        let six = |c: &[[f64; 3]], n: usize| both(c[n], c[n + 1]);
        for region in 0..east.regions() {
            let (values, north_slopes) = (six(&self.corners, region), six(&self.slopes, region));
            for column in east.of_region(region) {
                let (gv, dv) = (&east.weights[column], &east.slopes[column]);
                let (hu, hv) = (dot(gv, &north_slopes), dot(dv, &values));
                self.heights[column] = dot(gv, &values);
                self.steepness[column] = (hu * hu + hv * hv).sqrt() / level.region_size();
            }
        }
    }
}

/// Sums and extremes, over one line or over all.
#[derive(Clone, Default)]
struct Tally {
    used: (usize, f64),
    held_out: (usize, f64),
    void: usize,
    worst: Option<Worst>,
    height: Option<[f64; 2]>,
    slope: f64,
    void_height: Option<[f64; 2]>,
    void_slope: f64,
}

impl Tally {
    fn and(self, other: Self) -> Self {
        let plus = |a: (usize, f64), b: (usize, f64)| (a.0 + b.0, a.1 + b.1);
        let size = |worst: &Option<Worst>| worst.map_or(-1.0, |worst| worst.residual.abs());
        Self {
            used: plus(self.used, other.used),
            held_out: plus(self.held_out, other.held_out),
            void: self.void + other.void,
            worst: if size(&other.worst) > size(&self.worst) { other.worst } else { self.worst },
            height: join(self.height, other.height),
            slope: self.slope.max(other.slope),
            void_height: join(self.void_height, other.void_height),
            void_slope: self.void_slope.max(other.void_slope),
        }
    }
}

fn join(a: Option<[f64; 2]>, b: Option<[f64; 2]>) -> Option<[f64; 2]> {
    match (a, b) {
        (Some(a), Some(b)) => Some([a[0].min(b[0]), a[1].max(b[1])]),
        (a, b) => a.or(b),
    }
}

fn tally(
    patch: &Patch,
    places: &[Place],
    fitted: &Line,
    (north, east): (&Axis, &Axis),
    line: usize,
    near_edge: &[bool],
    residuals: &mut [f64],
) -> Tally {
    let strip = north.starts.partition_point(|start| *start <= line) - 1;
    let mut out = Tally::default();
    for region in 0..east.regions() {
        let in_void = near_edge[strip * east.regions() + region];
        for column in east.of_region(region) {
            let (height, slope) = (fitted.heights[column], fitted.steepness[column]);
            out.height = join(out.height, Some([height; 2]));
            out.slope = out.slope.max(slope);
            if in_void {
                out.void_height = join(out.void_height, Some([height; 2]));
                out.void_slope = out.void_slope.max(slope);
            }
            let sample = line * patch.count[1] + column;
            let residual = patch.heights[sample] - height;
            residuals[column] = residual;
            if residual.is_nan() {
                out.void += 1;
                continue;
            }
            let sum = if places[sample] == Place::Used { &mut out.used } else { &mut out.held_out };
            *sum = (sum.0 + 1, sum.1 + residual * residual);
            if out.worst.is_none_or(|worst| residual.abs() > worst.residual.abs()) {
                let (in_file, place) = (patch.in_file(line, column), patch.place(line, column));
                out.worst = Some(Worst { residual, in_file, place });
            }
        }
    }
    out
}

fn figures(fit: &Fit, total: &Tally, void_regions: usize) -> LevelReport {
    let corners = fit.level.corners();
    let rms = |(count, sum): (usize, f64)| (sum / count.max(1) as f64).sqrt();
    let nowhere = Worst { residual: 0.0, in_file: [0; 2], place: [0.0; 2] };
    LevelReport {
        region_size: fit.level.region_size(),
        corners,
        coefficients: 9 * corners[0] * corners[1],
        used: total.used.0,
        void: total.void,
        held_out: total.held_out.0,
        rms: rms(total.used),
        worst: total.worst.unwrap_or(nowhere),
        held_out_rms: (total.held_out.0 > 0).then(|| rms(total.held_out)),
        condition_of_axes: fit.condition_of_axes,
        condition_of_voids: fit.condition_of_voids,
        iterations: fit.iterations,
        relative_residual: fit.relative_residual,
        height: total.height.unwrap_or_default(),
        slope: total.slope,
        in_voids: total.void_height.map(|height| VoidBounds {
            regions: void_regions,
            height,
            slope: total.void_slope,
        }),
    }
}
