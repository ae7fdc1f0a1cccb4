//! Diode function generator: a broken line with rounded knees.
//!
//! **Law** (sections 3.3 and 6). n equal segments over the input 0..=1. The knees lie off the function so that the
//! error has equal ripple: about `max |f''| / (16 n^2)`, with signs that alternate between the
//! knee and the middle of a segment. A knee with slope jump J at x_k is rounded to
//! `J V ln(1 + e^((x - x_k) / V))`, the law of a diode of width V. Beyond 0..=1 the end segments go on.
//! **Parameters.** [`FunctionLaw`].
//! **State and timing.** None; the bandwidth is a [`crate::LagStep`] behind it.
//! **Method.** One table of start and rise, [`FINE`] cells to a segment where knees are rounded, one where they are not;
//! a look-up is one product and one cell. Cells follow the rounded line to `J V / 32` of the square of cell over V.
//! **Our choices.** Segments of equal length: the steps in slope stand at k/n, as the artefact of facets wants them.
//! With [`Ends::Trimmed`] the end knees are set last, as a technician does, and the end segments pay: up to 3/2 of the
//! error where the function is most curved there.

use signal::Real;

/// Cells of the table to a segment with rounded knees.
pub const FINE: usize = 64;

/// What the ends of the line do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ends {
    /// Equal ripple up to the ends.
    Free,
    /// Deviations from the function at input 0 and 1 (full scales): the residue that trimming leaves.
    Trimmed([f64; 2]),
}

/// What a function generator is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FunctionLaw {
    /// Segments n, at least 1 (held so).
    pub segments: usize,
    /// Width V of the knees (share of the input's full scale).
    pub rounding: f64,
    /// Rule for the two ends of the line.
    pub ends: Ends,
}

/// The diode function generator as a table of cells.
#[derive(Debug, Clone, PartialEq)]
pub struct FunctionGenerator<S> {
    cells: S,
    /// Start and rise of each cell.
    pub(crate) table: Vec<[S; 2]>,
}

impl<S: Real> FunctionGenerator<S> {
    /// The line for `f`, a function of 0..=1.
    pub fn new(law: &FunctionLaw, f: impl Fn(f64) -> f64) -> Self {
        let line = Line::fitted(law, f);
        let per_segment = if law.rounding > 0.0 { FINE } else { 1 };
        let cells = line.segments() * per_segment;
        let at: Vec<f64> = (0..=cells).map(|i| line.value(i, per_segment)).collect();
        let table = at.windows(2).map(|pair| [S::from_f64(pair[0]), S::from_f64(pair[1] - pair[0])]);
        Self { cells: S::from_f64(cells as f64), table: table.collect() }
    }

    /// Outputs at the ends of the cells, at equal distances over 0..=1.
    pub fn points(&self) -> Vec<f64> {
        let starts = self.table.iter().map(|[start, _]| start.to_f64());
        let last = self.table.last().map(|[start, rise]| start.to_f64() + rise.to_f64());
        starts.chain(last).collect()
    }

    /// The output for input `z`.
    #[inline]
    pub fn value(&self, z: S) -> S {
        let place = z * self.cells;
        // `as` holds what is below 0 at 0.
        let cell = (place.to_f64() as usize).min(self.table.len() - 1);
        let [start, rise] = self.table[cell];
        start + rise * (place - S::from_f64(cell as f64))
    }
}

/// The knees, before they become a table.
struct Line {
    knees: Vec<f64>,
    rounding: f64,
    /// What trimming adds at both ends, a straight line between.
    trim: [f64; 2],
}

/// Places in a segment at which the fit looks for its largest error.
const PLACES: usize = 32;
/// Rounds of the fit: segments hand what is too much to their neighbours.
const ROUNDS: usize = 40;

impl Line {
    fn fitted(law: &FunctionLaw, f: impl Fn(f64) -> f64) -> Self {
        let n = law.segments.max(1);
        let exact: Vec<f64> = (0..=n).map(|k| f(k as f64 / n as f64)).collect();
        let sags: Vec<Vec<f64>> = (0..n).map(|k| sags(&f, &exact, k)).collect();
        let mut shift = eased(halved(&sags), &sags);
        if let Ends::Trimmed([first, last]) = law.ends {
            (shift[0], shift[n]) = (first, last);
        }
        let knees: Vec<f64> = exact.iter().zip(&shift).map(|(exact, shift)| exact + shift).collect();
        let mut line = Self { knees, rounding: law.rounding, trim: [0.0; 2] };
        if let Ends::Trimmed(_) = law.ends {
            // Rounded knees reach the ends by a tail.
            line.trim = [line.knees[0] - line.value(0, 1), line.knees[n] - line.value(n, 1)];
        }
        line
    }

    fn segments(&self) -> usize {
        self.knees.len() - 1
    }

    /// The rounded line at `place / per_segment` segments.
    fn value(&self, place: usize, per_segment: usize) -> f64 {
        let n = self.segments();
        let x = place as f64 / per_segment as f64;
        let k = (place / per_segment).min(n - 1);
        let straight = self.knees[k] + (self.knees[k + 1] - self.knees[k]) * (x - k as f64);
        let z = x / n as f64;
        straight + self.rounded(x) + self.trim[0] * (1.0 - z) + self.trim[1] * z
    }

    /// What rounding adds at `x` (segments): `J V ln(1 + e^(-|x - x_k| / V))` for every inner knee.
    fn rounded(&self, x: f64) -> f64 {
        if self.rounding == 0.0 {
            return 0.0;
        }
        let width = self.rounding * self.segments() as f64;
        let knees = self.knees.windows(3).zip(1..);
        knees.fold(0.0, |sum, (three, k)| {
            let jump = three[2] - 2.0 * three[1] + three[0];
            sum + jump * width * libm::log1p(libm::exp(-(x - f64::from(k)).abs() / width))
        })
    }
}

/// Chord less function over segment `k`.
fn sags(f: &impl Fn(f64) -> f64, exact: &[f64], k: usize) -> Vec<f64> {
    let n = (exact.len() - 1) as f64;
    let sag = |i: usize| {
        let s = i as f64 / PLACES as f64;
        exact[k] + (exact[k + 1] - exact[k]) * s - f((k as f64 + s) / n)
    };
    (0..=PLACES).map(sag).collect()
}

/// Shifts of the knees by half the sag of the segments beside them.
fn halved(sags: &[Vec<f64>]) -> Vec<f64> {
    let most: Vec<f64> = sags.iter().map(|sags| worst(sags, 0.0, 0.0)).collect();
    let shift = |k: usize| {
        let beside = &most[k.saturating_sub(1)..(k + 1).min(most.len())];
        -beside.iter().sum::<f64>() / (2.0 * beside.len() as f64)
    };
    (0..=sags.len()).map(shift).collect()
}

/// The same with the most curved segments at half their sag, which their milder neighbours pay for within that bound.
fn eased(mut shift: Vec<f64>, sags: &[Vec<f64>]) -> Vec<f64> {
    let bound = sags.iter().flatten().fold(0.0_f64, |most, sag| most.max(sag.abs())) / 2.0;
    for _ in 0..ROUNDS {
        for (k, sags) in sags.iter().enumerate() {
            let worst = worst(sags, shift[k], shift[k + 1]);
            let beyond = worst - worst.clamp(-bound, bound);
            for shift in &mut shift[k..k + 2] {
                *shift = (*shift - beyond).clamp(-bound, bound);
            }
        }
    }
    shift
}

/// The inner error of a segment that is largest without regard to sign.
fn worst(sags: &[f64], start: f64, end: f64) -> f64 {
    let error = |i: usize| sags[i] + start + (end - start) * i as f64 / PLACES as f64;
    (1..PLACES)
        .map(error)
        .fold(0.0, |worst: f64, error| if error.abs() > worst.abs() { error } else { worst })
}

#[cfg(test)]
mod tests {
    use super::{Ends, FunctionGenerator, FunctionLaw};

    /// Largest error of the broken line for a function with `|f''|` up to `bend`: `bend / (16 n^2)`.
    fn segment_error(bend: f64, segments: usize) -> f64 {
        let n = segments.max(1) as f64;
        bend / (16.0 * n * n)
    }

    /// The function generators of the report: g0, g1, g2.
    const BASIS: [fn(f64) -> f64; 3] = [
        |z| (1.0 - z) * (1.0 - z) * (1.0 - z) * (1.0 + z * (3.0 + 6.0 * z)),
        |z| z * (1.0 - z) * (1.0 - z) * (1.0 - z) * (1.0 + 3.0 * z),
        |z| 0.5 * z * z * (1.0 - z) * (1.0 - z) * (1.0 - z),
    ];

    /// Largest second derivative over 0..=1.
    fn bend(f: fn(f64) -> f64) -> f64 {
        let e = 1e-4;
        let second = |z: f64| (f(z + e) - 2.0 * f(z) + f(z - e)) / (e * e);
        (0..=1000).map(|i| second(f64::from(i) / 1000.0).abs()).fold(0.0, f64::max)
    }

    fn generator(segments: usize, rounding: f64, ends: Ends, f: fn(f64) -> f64) -> FunctionGenerator<f64> {
        FunctionGenerator::new(&FunctionLaw { segments, rounding, ends }, f)
    }

    fn largest_error(generator: &FunctionGenerator<f64>, f: fn(f64) -> f64) -> f64 {
        let off = |i: i32| (generator.value(f64::from(i) / 1e4) - f(f64::from(i) / 1e4)).abs();
        (0..=10_000).map(off).fold(0.0, f64::max)
    }

    #[test]
    fn equal_ripple_meets_the_segment_error() {
        assert!((bend(BASIS[0]) - 5.7735).abs() < 1e-3);
        for f in BASIS {
            for n in [6, 10, 20, 24] {
                let error = largest_error(&generator(n, 0.0, Ends::Free, f), f);
                let share = error / segment_error(bend(f), n);
                // g2 is most curved at its end alone, so coarse segments do better than the formula.
                assert!(share <= 1.0 && share > 0.49, "{n} segments: {share}");
            }
        }
    }

    #[test]
    fn every_knee_lies_off_by_the_curvature_there() {
        let (n, f) = (20, BASIS[0]);
        let g = generator(n, 0.0, Ends::Free, f);
        for k in 1..n {
            let z = k as f64 / n as f64;
            let second = -60.0 * z * (1.0 - z) * (1.0 - 2.0 * z);
            let off = g.value(z) - f(z) + segment_error(second, n);
            assert!(off.abs() < 0.06 * segment_error(5.7735, n), "knee {k}: {off:e}");
        }
    }

    #[test]
    fn trimmed_ends_have_their_residue_and_cost_half_as_much_again() {
        for f in BASIS {
            for rounding in [0.0, 0.005, 0.2] {
                let g = generator(20, rounding, Ends::Trimmed([0.0, 5e-4]), f);
                assert!((g.value(0.0) - f(0.0)).abs() < 1e-15);
                assert!((g.value(1.0) - f(1.0) - 5e-4).abs() < 1e-15);
            }
            let error = largest_error(&generator(20, 0.0, Ends::Trimmed([0.0; 2]), f), f);
            assert!(error < 1.52 * segment_error(bend(f), 20), "{error}");
        }
    }

    #[test]
    fn slope_jumps_are_those_of_the_reference() {
        for (n, jump) in [(10, 0.58), (20, 0.29)] {
            let g = generator(n, 0.0, Ends::Free, BASIS[0]);
            let slope = |k: usize| {
                let at = |share: f64| g.value((k as f64 + share) / n as f64);
                (at(0.9) - at(0.1)) * n as f64 / 0.8
            };
            let most = (1..n).map(|k| (slope(k) - slope(k - 1)).abs()).fold(0.0, f64::max);
            assert!((most - jump).abs() < 0.04 * jump + 0.01, "{n} segments: {most}");
        }
    }

    #[test]
    fn knees_are_softplus() {
        // One knee, from slope -1 to slope 1.
        let (width, law) = (0.02, |x: f64| (x - 0.5).abs());
        let sharp = generator(2, 0.0, Ends::Trimmed([0.0; 2]), law);
        let round = generator(2, width, Ends::Trimmed([0.0; 2]), law);
        for i in 0..=1000 {
            let x = f64::from(i) / 1000.0;
            let softplus = 2.0 * width * libm::log1p(libm::exp(-(x - 0.5).abs() / width));
            // Cells of 1/128: J V / 32 (cell / V)^2.
            assert!((round.value(x) - sharp.value(x) - softplus).abs() < 2.1 * width / 32.0 * 0.1526, "{x}");
        }
        assert!((sharp.value(0.3) - 0.2).abs() < 1e-12);
    }

    #[test]
    fn beyond_the_ends_the_end_segments_go_on() {
        let g = generator(10, 0.0, Ends::Free, |x| 3.0 * x);
        assert!((g.value(-0.1) + 0.3).abs() < 1e-12 && (g.value(1.2) - 3.6).abs() < 1e-12);
        assert!((generator(0, 0.0, Ends::Free, |x| 3.0 * x).value(0.5) - 1.5).abs() < 1e-12);
    }
}
