//! Spot of an electron beam, one axis of it: how far it reaches, and where it stands.
//!
//! **Law** (hardware-1969, section 6). Gaussian, sigma `0.375 / n` of the picture's height for n TV lines: half the
//! contrast is left at `n / 2` cycles a height. The weights of a place add up to 1.

/// Deviation of the Gaussian spot (picture heights) of a tube of `tv_lines` TV lines a height: half response at half as
/// many cycles.
pub fn spot_sigma(tv_lines: u32) -> f64 {
    0.375 / f64::from(tv_lines)
}

/// Cells of an axis as a spot sees them that does not stand on their centres.
#[derive(Debug, Clone, PartialEq)]
pub struct Spot {
    taps: usize,
    first: Vec<usize>,
    weights: Vec<f32>,
}

/// Spots from here on (cells) are as wide as their samples show.
const WIDE: f64 = 1.0;

/// Intervals of the integral over the patterns that cells can hold.
const INTERVALS: u32 = 128;

impl Spot {
    /// For `cells` cells and a Gaussian spot of `sigma` cells; cell n is read at `place(n)`. The outermost cells stand
    /// in for what is beyond them.
    pub fn new(cells: usize, sigma: f64, place: impl Fn(f64) -> f64) -> Self {
        let shape = Shape::new(sigma);
        let reach = (4.0 * sigma).ceil().min(cells as f64) as i64 + 1;
        let taps = (2 * reach as usize).min(cells);
        let mut spot = Self { taps, first: Vec::new(), weights: vec![0.0; cells * taps] };
        for (cell, weights) in spot.weights.chunks_exact_mut(taps.max(1)).enumerate() {
            let place = place(cell as f64);
            let nearest = place.floor() as i64 - reach + 1;
            let first = nearest.clamp(0, (cells - taps) as i64);
            for index in nearest..nearest + 2 * reach {
                let within = index.clamp(0, cells as i64 - 1) - first;
                weights[within as usize] += shape.at(index as f64 - place) as f32;
            }
            balance(weights);
            spot.first.push(first as usize);
        }
        spot
    }

    /// Reads a row along this axis.
    pub fn along(&self, row: &[f32], out: &mut [f32]) {
        let windows = self.first.iter().zip(self.weights.chunks_exact(self.taps));
        for (out, (&first, weights)) in out.iter_mut().zip(windows) {
            *out = row[first..][..self.taps].iter().zip(weights).map(|(value, weight)| value * weight).sum();
        }
    }

    /// Row `cell` of this axis out of rows as long as `out`.
    pub fn across(&self, cell: usize, rows: &[f32], out: &mut [f32]) {
        let (length, weights) = (out.len(), &self.weights[cell * self.taps..][..self.taps]);
        out.fill(0.0);
        for (row, &weight) in rows[self.first[cell] * length..].chunks_exact(length).zip(weights) {
            out.iter_mut().zip(row).for_each(|(out, value)| *out += weight * value);
        }
    }
}

/// A spot takes all of what it sees, no less.
fn balance(weights: &mut [f32]) {
    let sum: f32 = weights.iter().sum();
    weights.iter_mut().for_each(|weight| *weight /= sum);
}

/// The weights of a Gaussian spot at distances in cells: the Fourier coefficients of its response to the patterns
/// that cells can hold, up to half a cycle a cell. Of a spot much smaller than a cell some would be below 0; it takes
/// nothing away, so they are 0.
struct Shape {
    sigma: f64,
    response: Vec<f64>,
}

impl Shape {
    fn new(sigma: f64) -> Self {
        let response = |k| {
            let turn = std::f64::consts::PI * sigma * f64::from(k) / f64::from(INTERVALS);
            libm::exp(-0.5 * turn * turn)
        };
        Self { sigma, response: (0..=INTERVALS).map(response).collect() }
    }

    fn at(&self, distance: f64) -> f64 {
        if self.sigma >= WIDE {
            return libm::exp(-0.5 * (distance / self.sigma) * (distance / self.sigma));
        }
        self.coefficient(distance).max(0.0)
    }

    /// By Simpson's rule from 0 to half a cycle a cell.
    fn coefficient(&self, distance: f64) -> f64 {
        let angle = std::f64::consts::PI * distance / f64::from(INTERVALS);
        let terms = (0..=INTERVALS).zip(&self.response).map(|(k, response)| {
            let weight = if k == 0 || k == INTERVALS { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
            weight * response * libm::cos(angle * f64::from(k))
        });
        terms.sum()
    }
}
