//! Ways to work out the heights of a stretch.

use landscape::basis::values;
use signal::Real;
use terrain_generator::array;

use super::stretch::Stretch;

/// How heights are worked out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// 36 products of function generators and words, one by one.
    Products,
    /// Three signals at once, six terms in Y to each of six in X: what the machine does where a stretch is a sample or two.
    Array,
    /// Powers of the place along the stretch: what the machine does.
    Powers,
    /// The same polynomial as a Chebyshev sum up to this degree.
    Chebyshev(usize),
    /// A Chebyshev sum as short as leaves out no more than this (m).
    ChebyshevWithin(f64),
}

/// A stretch made ready for a method: coefficients in the scalar of the run. What the machine does once a segment is not in
/// the time of an evaluation.
#[derive(Debug, Clone)]
pub struct Ready<S> {
    coefficients: Vec<S>,
    words: [[S; 9]; 4],
}

impl<S: Real> Ready<S> {
    /// Makes a method ready for a stretch.
    pub fn new(method: Method, stretch: &Stretch) -> Self {
        let powers = &stretch.segment.height;
        let coefficients = match method {
            Method::Products | Method::Array => Vec::new(),
            Method::Powers => powers.to_vec(),
            Method::Chebyshev(degree) => chebyshev(powers)[..=degree].to_vec(),
            Method::ChebyshevWithin(tolerance) => within(&chebyshev(powers), tolerance).to_vec(),
        };
        let words = stretch.hold.map(|words| words.map(S::from_f64));
        Self { coefficients: coefficients.into_iter().map(S::from_f64).collect(), words }
    }

    /// Degree of the sum.
    pub fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    /// Heights at the samples of the stretch (m).
    pub fn heights(&self, method: Method, stretch: &Stretch, out: &mut Vec<f64>) {
        let places = || stretch.points.iter().map(|point| S::from_f64(point.place));
        match method {
            Method::Products => {
                out.extend(stretch.points.iter().map(|point| self.products(stretch, point.ramps)))
            }
            Method::Array => {
                out.extend(
                    stretch
                        .points
                        .iter()
                        .map(|point| array(stretch.hold.each_ref(), stretch.polarity, point.ramps)[0]),
                );
            }
            Method::Powers => out.extend(places().map(|place| self.horner(place))),
            Method::Chebyshev(_) | Method::ChebyshevWithin(_) => {
                out.extend(places().map(|place| self.clenshaw(place)));
            }
        }
    }

    fn products(&self, stretch: &Stretch, ramps: [f64; 2]) -> f64 {
        let fed = |axis: usize| {
            // g_1p(z) is what a generator of g_0p makes of 1 - z, with the opposite sign for p = 1.
            let mut g = values(ramps[axis]);
            g[1] *= stretch.polarity[axis];
            g[4] *= stretch.polarity[axis];
            g.map(S::from_f64)
        };
        let ([gx, gy], mut sum) = ([fed(0), fed(1)], S::ZERO);
        for (colour, words) in self.words.iter().enumerate() {
            let (a, b) = (3 * (colour & 1), 3 * (colour >> 1));
            for (word, &value) in words.iter().enumerate() {
                sum += gx[a + word / 3] * gy[b + word % 3] * value;
            }
        }
        sum.to_f64()
    }

    fn horner(&self, place: S) -> f64 {
        self.coefficients.iter().rev().fold(S::ZERO, |sum, &c| sum * place + c).to_f64()
    }

    /// Returns the height at `place` by Clenshaw's recurrence (m).
    fn clenshaw(&self, place: S) -> f64 {
        let (twice, mut next, mut after) = (place + place, S::ZERO, S::ZERO);
        let Some((&constant, rest)) = self.coefficients.split_first() else { return 0.0 };
        for &c in rest.iter().rev() {
            (next, after) = (c + twice * next - after, next);
        }
        (constant + place * next - after).to_f64()
    }
}

/// Chebyshev coefficients of a sum of powers over -1..=1.
fn chebyshev(powers: &[f64; 11]) -> [f64; 11] {
    // Horner's rule on Chebyshev sums: x T_k is half of T_(k-1) and T_(k+1) together, x T_0 is T_1.
    let mut sum = [0.0; 11];
    for &c in powers.iter().rev() {
        let mut times = [0.0; 11];
        for k in 0..10 {
            if k == 0 {
                times[1] += sum[0];
            } else {
                times[k - 1] += 0.5 * sum[k];
                times[k + 1] += 0.5 * sum[k];
            }
        }
        times[0] += c;
        sum = times;
    }
    sum
}

/// The shortest start whose rest adds up to no more than `tolerance`.
fn within(sum: &[f64; 11], tolerance: f64) -> &[f64] {
    let (mut kept, mut left_out) = (sum.len(), 0.0);
    while kept > 1 && left_out + sum[kept - 1].abs() <= tolerance {
        left_out += sum[kept - 1].abs();
        kept -= 1;
    }
    &sum[..kept]
}

#[cfg(test)]
mod tests {
    use super::{chebyshev, within};

    #[test]
    fn powers_become_chebyshev_sums() {
        // x^4 = 3/8 + T_2 / 2 + T_4 / 8.
        let mut powers = [0.0; 11];
        powers[4] = 1.0;
        let sum = chebyshev(&powers);
        assert_eq!(sum[..5], [0.375, 0.0, 0.5, 0.0, 0.125]);
        assert_eq!(within(&sum, 0.2).len(), 3);
        assert_eq!(within(&sum, 0.0).len(), 5);
    }
}
